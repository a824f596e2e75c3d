package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine;

/**
 * {@code docs/cli.md} matches the declared commands. To regenerate it: {@code ./mvnw test
 * -Dtest=CliPageTest -Dlumbre.write=true}.
 */
class CliPageTest {
  private static final Path PAGE = Path.of("docs", "cli.md");

  private static final String HEAD =
"""
# The command line

Every command, its flags and its exit codes. Flags that several commands have stand once, under [shared flags](#shared-flags).
`lumbre COMMAND --help` lists the flags that people use, `lumbre COMMAND --help all` all of them.

```sh
./lumbre render scenes/cornell-box.json -o box.png
./lumbre render --help
```

## Exit codes

All commands use the same codes. Each command below lists its own, with what they mean there if that is more.

""";

  @Test
  void pageIsWhatTheCommandsDeclare() throws IOException {
    String expected = page();
    if (Boolean.getBoolean("lumbre.write")) {
      Files.writeString(PAGE, expected);
    }
    assertThat(Files.readString(PAGE)).isEqualTo(expected);
  }

  private final StringBuilder page = new StringBuilder();
  private final Map<String, String> meanings =
      ExitCode.meanings(EnumSet.complementOf(EnumSet.of(ExitCode.SAVED)), "");

  /** The flags by their headings, each with the number of commands that have it. */
  private final Map<String, Map<String, Integer>> shared = new LinkedHashMap<>();

  private String page() {
    CommandLine program = Lumbre.commandLine();
    count(program);
    page.append(HEAD);
    codes(meanings);
    Lumbre.SECTIONS.forEach(
        (heading, commands) -> {
          page.append("## ").append(heading).append("\n\n");
          commands.forEach(type -> append(program.getSubcommands().get(Lumbre.nameOf(type))));
        });
    page.append("## Shared flags\n\n");
    shared.forEach(
        (heading, rows) -> {
          List<String> several = rows.keySet().stream().filter(r -> rows.get(r) > 1).toList();
          if (!several.isEmpty()) {
            page.append("### ").append(titled(heading)).append("\n\n");
            table(several);
          }
        });
    return page.toString().stripTrailing() + "\n";
  }

  private static String titled(String heading) {
    return heading.isEmpty() ? "Many commands" : heading;
  }

  private void count(CommandLine command) {
    for (CommandLine subcommand : command.getSubcommands().values()) {
      HelpLayout.divided(subcommand.getCommandSpec())
          .forEach(
              (heading, flags) -> {
                Map<String, Integer> rows =
                    shared.computeIfAbsent(heading, key -> new LinkedHashMap<>());
                flags.forEach(flag -> rows.merge(row(flag), 1, Integer::sum));
              });
      count(subcommand);
    }
  }

  private void append(CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    UsageMessageSpec usage = spec.usageMessage();
    page.append("### ").append(spec.qualifiedName()).append("\n\n");
    page.append(String.join(" ", usage.header())).append("\n\n");
    String synopsis = new Help(spec, Help.defaultColorScheme(Ansi.OFF)).synopsis(0).strip();
    page.append("```\n").append(synopsis.replaceAll("\\s+", " ")).append("\n```\n\n");
    if (usage.description().length > 0) {
      page.append(HelpLayout.plain(usage.description())).append("\n\n");
    }
    parameters(spec);
    flags(HelpLayout.divided(spec));
    if (!usage.exitCodeList().isEmpty()) {
      ownCodes(usage.exitCodeList());
    }
    Map<String, CommandLine> subcommands = new TreeMap<>(command.getSubcommands());
    subcommands.values().forEach(this::append);
  }

  /** Lists the codes of a command, and those that mean more there than elsewhere. */
  private void ownCodes(Map<String, String> own) {
    page.append("[Exit codes](#exit-codes): " + String.join(", ", own.keySet()) + "\n\n");
    Map<String, String> others = new LinkedHashMap<>(own);
    others.entrySet().removeIf(code -> code.getValue().equals(meanings.get(code.getKey())));
    if (!others.isEmpty()) {
      codes(others);
    }
  }

  private void codes(Map<String, String> codes) {
    page.append("| exit code | meaning |\n|--:|---|\n");
    codes.forEach((code, meaning) -> page.append("| " + code + " | " + meaning + " |\n"));
    page.append("\n");
  }

  private void parameters(CommandSpec spec) {
    List<PositionalParamSpec> shown =
        spec.positionalParameters().stream().filter(p -> !p.hidden()).toList();
    if (!shown.isEmpty()) {
      page.append("| argument | meaning |\n|---|---|\n");
      shown.forEach(p -> page.append("| `" + p.paramLabel() + "` | " + meaning(p) + " |\n"));
      page.append("\n");
    }
  }

  /** Writes the flags that a command has alone, and the names of the others. */
  private void flags(Map<String, List<OptionSpec>> divided) {
    List<String> own = new ArrayList<>();
    StringBuilder others = new StringBuilder();
    divided.forEach(
        (heading, flags) -> {
          List<String> names = new ArrayList<>();
          for (OptionSpec flag : flags) {
            if (shared.get(heading).get(row(flag)) > 1) {
              names.add("`" + flag.longestName() + "`");
            } else {
              own.add(row(flag));
            }
          }
          if (!names.isEmpty()) {
            String link = titled(heading).toLowerCase(Locale.ROOT).replace(' ', '-');
            others.append("* [" + titled(heading) + "](#" + link + "): ");
            others.append(String.join(", ", names)).append("\n");
          }
        });
    if (!own.isEmpty()) {
      table(own);
    }
    page.append(others).append(others.isEmpty() ? "" : "\n");
  }

  private void table(List<String> rows) {
    page.append("| flag | meaning |\n|---|---|\n");
    rows.forEach(page::append);
    page.append("\n");
  }

  private static String row(OptionSpec flag) {
    String names = String.join(", ", flag.names());
    String label = flag.arity().max() == 0 ? "" : " " + flag.paramLabel();
    return "| `" + (names + label).replace("|", "\\|") + "` | " + meaning(flag) + " |\n";
  }

  private static String meaning(ArgSpec arg) {
    return HelpLayout.plain(arg.description()).replace("|", "\\|");
  }
}
