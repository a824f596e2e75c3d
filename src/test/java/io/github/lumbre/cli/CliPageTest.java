package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * {@code docs/cli.md} matches the declared commands. To regenerate it: {@code ./mvnw test
 * -Dtest=CliPageTest -Dlumbre.write=true}.
 */
class CliPageTest {
  private static final Path PAGE = Path.of("docs", "cli.md");

  private static final String HEAD =
"""
# The command line

Every command, its flags by group, and its exit codes. `lumbre help COMMAND` prints the same.

```sh
./lumbre render scenes/cornell-box.json -o box.png
./lumbre help render
```

## Exit codes

All commands use the same codes. Each command below lists its own meanings.

""";

  @Test
  void pageIsWhatTheCommandsDeclare() throws IOException {
    String expected = page();
    if (Boolean.getBoolean("lumbre.write")) {
      Files.writeString(PAGE, expected);
    }
    assertThat(Files.readString(PAGE)).isEqualTo(expected);
  }

  private static String page() {
    CommandLine program = Lumbre.commandLine();
    StringBuilder page = new StringBuilder(HEAD);
    Set<ExitCode> codes = EnumSet.complementOf(EnumSet.of(ExitCode.SAVED));
    codes(ExitCode.meanings(codes, ""), page);
    Lumbre.SECTIONS.forEach(
        (heading, commands) -> {
          page.append("## ").append(heading).append("\n\n");
          commands.forEach(type -> append(program.getSubcommands().get(Lumbre.nameOf(type)), page));
        });
    return page.toString();
  }

  private static void append(CommandLine command, StringBuilder page) {
    CommandSpec spec = command.getCommandSpec();
    UsageMessageSpec usage = spec.usageMessage();
    page.append("### ").append(spec.qualifiedName()).append("\n\n");
    page.append(String.join(" ", usage.header())).append("\n\n");
    String synopsis = new Help(spec, Help.defaultColorScheme(Ansi.OFF)).synopsis(0).strip();
    page.append("```\n").append(synopsis.replaceAll("\\s+", " ")).append("\n```\n\n");
    if (usage.description().length > 0) {
      page.append(plain(usage.description())).append("\n\n");
    }
    parameters(spec, page);
    HelpLayout.divided(spec).forEach((heading, flags) -> flags(heading, flags, page));
    if (!usage.exitCodeList().isEmpty()) {
      codes(usage.exitCodeList(), page);
    }
    Map<String, CommandLine> subcommands = new TreeMap<>(command.getSubcommands());
    subcommands.values().forEach(subcommand -> append(subcommand, page));
  }

  private static void codes(Map<String, String> meanings, StringBuilder page) {
    page.append("| exit code | meaning |\n|--:|---|\n");
    meanings.forEach((code, meaning) -> page.append("| " + code + " | " + meaning + " |\n"));
    page.append("\n");
  }

  private static void parameters(CommandSpec spec, StringBuilder page) {
    List<PositionalParamSpec> shown =
        spec.positionalParameters().stream().filter(p -> !p.hidden()).toList();
    if (!shown.isEmpty()) {
      page.append("| argument | meaning |\n|---|---|\n");
      shown.forEach(p -> page.append("| `" + p.paramLabel() + "` | " + meaning(p) + " |\n"));
      page.append("\n");
    }
  }

  private static void flags(String heading, List<OptionSpec> flags, StringBuilder page) {
    if (flags.isEmpty()) {
      return;
    }
    page.append("| " + (heading.isEmpty() ? "flag" : heading) + " | meaning |\n|---|---|\n");
    for (OptionSpec flag : flags) {
      String names = String.join(", ", flag.names());
      String label = flag.arity().max() == 0 ? "" : " " + flag.paramLabel();
      page.append("| `" + (names + label).replace("|", "\\|") + "` | " + meaning(flag) + " |\n");
    }
    page.append("\n");
  }

  private static String meaning(ArgSpec arg) {
    return plain(arg.description()).replace("|", "\\|");
  }

  /** Returns the lines of a description as one line, as picocli prints them. */
  private static String plain(String[] lines) {
    return List.of(lines).stream()
        .collect(Collectors.joining(" "))
        .replace("%n", " ")
        .replace("%%", "%")
        .strip();
  }
}
