package io.github.lumbre.cli;

import io.github.lumbre.cli.Completion.Flag;
import java.util.List;

/** The script that completes commands, flags, values of flags and file names in fish. */
final class FishCompletion {
  private FishCompletion() {}

  static String of(List<Completion> commands) {
    StringBuilder script = new StringBuilder();
    script.append("# Completion for lumbre in fish: lumbre completion --shell fish | source\n");
    script.append("complete -c lumbre -e\n");
    for (Completion command : commands) {
      boolean isProgram = command.name().isEmpty();
      String after =
          isProgram ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + command.name();
      String start = "complete -c lumbre -n '" + after + "'";
      if (!isProgram) {
        script.append("complete -c lumbre -n __fish_use_subcommand -f -a ").append(command.name());
        script.append(" -d ").append(quoted(command.header())).append("\n");
      }
      if (!command.takesFiles()) {
        script.append(start).append(" -f");
        script.append(isProgram || command.words().isEmpty() ? "" : words(command.words()));
        script.append("\n");
      }
      command.flags().forEach(flag -> append(start, flag, script));
    }
    return script.toString();
  }

  private static void append(String start, Flag flag, StringBuilder script) {
    script.append(start);
    for (String name : flag.names()) {
      boolean isLong = name.startsWith("--");
      script.append(isLong ? " -l " : " -s ").append(name.substring(isLong ? 2 : 1));
    }
    switch (flag.kind()) {
      case NONE -> {}
      case WORDS -> script.append(" -x").append(flag.words().isEmpty() ? "" : words(flag.words()));
      case LIST -> {
        String list = "(__fish_append , " + String.join(" ", flag.words()) + ")";
        script.append(" -x -a ").append(quoted(list));
      }
      case FILES ->
          script.append(" -r -F").append(flag.words().isEmpty() ? "" : words(flag.words()));
    }
    script.append(" -d ").append(quoted(flag.meaning())).append("\n");
  }

  private static String words(List<String> words) {
    return " -a " + quoted(String.join(" ", words));
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
