package io.github.lumbre.cli;

import io.github.lumbre.cli.option.Choices;
import io.github.lumbre.cli.option.FlagConverters;
import io.github.lumbre.model.Models;
import io.github.lumbre.stage.Stage.View;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The script that completes commands, flags, values of flags and file names in bash, and in zsh
 * with its {@code bashcompinit}.
 */
final class CompletionScript {
  /** Names that flags with other values accept too. */
  private static final Map<String, List<String>> NAMES =
      Map.of(
          "--sky", List.of("relief", "studio", "white", "sun"),
          "--view", List.copyOf(View.standard().keySet()),
          "--background", List.of("sky", "transparent", "white", "black"));

  private static final String MODELS = Models.NAMES.replace(",", "") + " .vrm";

  /** The endings of the files that parameters with these labels name. */
  private static final Map<String, String> ENDINGS =
      Map.of("SCENE", ".json " + MODELS, "MODEL", MODELS, "FILM", ".film");

  /** Labels that list all values, such as {@code y|z}. */
  private static final String LIST_OF_VALUES = "[a-z0-9]+(\\|[a-z0-9]+)+";

  /** Everything but the commands. File names are what the shell completes if there is no answer. */
  private static final String SCRIPT =
      """
      #!/usr/bin/env bash
      # Completion for lumbre in bash and zsh: source <(lumbre completion)

      if [ -n "${ZSH_VERSION-}" ]; then
        autoload -Uz compinit bashcompinit
        type compdef >/dev/null 2>&1 || compinit
        bashcompinit
      fi

      _lumbre() {
        local word=${COMP_WORDS[COMP_CWORD]} flag=${COMP_WORDS[COMP_CWORD-1]} before=
        local command= kind=files words= flags= ends= file
        COMPREPLY=()
        if [ "$COMP_CWORD" -gt 1 ]; then
          command=${COMP_WORDS[1]}
        fi
        # bash makes three words of --flag=value, zsh one.
        if [ "$word" = '=' ]; then
          word=
        elif [ "$flag" = '=' ]; then
          flag=${COMP_WORDS[COMP_CWORD-2]}
        fi
        case $word in
          --*=*) flag=${word%%=*} before=${word%%=*}= word=${word#*=} ;;
        esac

        case $command in
      COMMANDS  esac

        case $kind:$word in
          files:-*) kind=words words=$flags ;;
          list:*) before=$before${word%"${word##*,}"} word=${word##*,} ;;
        esac
        if [ "$kind" != files ]; then
          type compopt >/dev/null 2>&1 && compopt +o default
          COMPREPLY=($(compgen -P "$before" -W "$words" -- "$word"))
        elif [ -n "$words" ]; then
          type compopt >/dev/null 2>&1 && compopt -o filenames
          COMPREPLY=($(compgen -W "$words" -- "$word"))
          local IFS=$'\\n'
          COMPREPLY+=($(compgen -f -- "$word"))
        elif [ -n "$ends" ]; then
          type compopt >/dev/null 2>&1 && compopt -o filenames
          local IFS=$'\\n'
          for file in $(compgen -f -- "$word"); do
            case " $ends " in
              *" .${file##*.} "*) COMPREPLY+=("$file") ;;
              *) [ ! -d "$file" ] || COMPREPLY+=("$file") ;;
            esac
          done
        fi
      }

      complete -o default -F _lumbre lumbre
      """;

  private CompletionScript() {}

  static String of(CommandSpec program) {
    StringBuilder commands = new StringBuilder();
    append("", program, commands);
    program
        .subcommands()
        .forEach((name, command) -> append(name, command.getCommandSpec(), commands));
    return SCRIPT.replace("COMMANDS", commands);
  }

  /** Appends the case of a command: what may stand after it and after each of its flags. */
  private static void append(String name, CommandSpec command, StringBuilder script) {
    script.append("    '").append(name).append("')\n");
    String names =
        command.options().stream()
            .filter(option -> !option.hidden())
            .flatMap(option -> Arrays.stream(option.names()))
            .collect(Collectors.joining(" "));
    script.append("      flags='").append(names).append("'\n");
    String words = "words='" + String.join(" ", subcommands(command)) + "'";
    if (!takesFiles(command)) {
      String other = "        *) kind=words " + words + " ;;\n";
      script.append("      case $word in\n        -*) ;;\n").append(other).append("      esac\n");
    } else {
      script.append("      ends='").append(endings(command)).append("'\n");
    }
    Map<String, List<String>> flagsByValues = new LinkedHashMap<>();
    for (OptionSpec option : command.options()) {
      if (!option.hidden() && option.arity().max() > 0) {
        flagsByValues
            .computeIfAbsent(values(option), values -> new ArrayList<>())
            .addAll(List.of(option.names()));
      }
    }
    if (!flagsByValues.isEmpty()) {
      script.append("      case $flag in\n");
      flagsByValues.forEach(
          (values, flags) ->
              script
                  .append("        ")
                  .append(String.join(" | ", flags))
                  .append(") ")
                  .append(values)
                  .append(" ;;\n"));
      script.append("      esac\n");
    }
    script.append("      ;;\n");
  }

  private static List<String> subcommands(CommandSpec command) {
    boolean isHelp = command.userObject() instanceof HelpCommand;
    Map<String, CommandLine> named = (isHelp ? command.parent() : command).subcommands();
    return List.copyOf(named.keySet());
  }

  private static boolean takesFiles(CommandSpec command) {
    return command.positionalParameters().stream().anyMatch(CompletionScript::isFile);
  }

  /** Returns the assignments that name the values of a flag. */
  private static String values(OptionSpec option) {
    String kind = "words";
    List<String> values = NAMES.getOrDefault(option.longestName(), List.of());
    Optional<Choices> named = choices(option);
    if (named.isPresent()) {
      kind = named.get().isList() ? "list" : kind;
      values = named.get().choices();
    } else if (option.paramLabel().matches(LIST_OF_VALUES)) {
      values = List.of(option.paramLabel().split("\\|"));
    } else if (isFile(option)) {
      kind = "files";
    }
    return "kind=" + kind + " words='" + String.join(" ", values) + "' ends=";
  }

  /** Returns the named values of a flag; empty if it takes others. */
  static Optional<Choices> choices(OptionSpec option) {
    return option.converters().length == 1 && option.converters()[0] instanceof Choices choices
        ? Optional.of(choices)
        : Stream.concat(Stream.of(option.type()), Stream.of(option.auxiliaryTypes()))
            .flatMap(type -> FlagConverters.choices(type).stream())
            .findFirst();
  }

  /** Returns the endings of the files that a command reads, such as {@code .json}; none: any. */
  private static String endings(CommandSpec command) {
    return command.positionalParameters().stream()
        .map(ArgSpec::paramLabel)
        .distinct()
        .map(label -> ENDINGS.getOrDefault(label, ""))
        .collect(Collectors.joining());
  }

  private static boolean isFile(ArgSpec arg) {
    return arg.type() == Path.class
        || List.of(arg.auxiliaryTypes()).contains(Path.class)
        || arg.paramLabel().contains("FILE");
  }
}
