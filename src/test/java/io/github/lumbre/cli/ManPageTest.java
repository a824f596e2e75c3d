package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.base.ExitCode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Tests manual pages, and formats them with man where it is installed. */
class ManPageTest {
  private static final Path MAN = Path.of("/usr/bin/man");

  @TempDir private Path folder;

  static List<String> commands() {
    return List.copyOf(Lumbre.commandLine().getSubcommands().keySet());
  }

  private static String page(String... command) {
    String[] args = new String[command.length + 1];
    args[0] = "man";
    System.arraycopy(command, 0, args, 1, command.length);
    return Outcome.of(args).out();
  }

  @Test
  void programListsItsCommands() {
    String page = page();
    assertThat(page).startsWith(".TH \"LUMBRE\" 1 ");
    for (String command : commands()) {
      assertThat(page).contains("\\fBlumbre\\-" + command + "\\fR(1)");
    }
  }

  @ParameterizedTest
  @MethodSource("commands")
  void pagesHaveEveryFlag(String command) {
    CommandLine program = Lumbre.commandLine().getSubcommands().get(command);
    String page = page(command);
    for (OptionSpec flag : program.getCommandSpec().options()) {
      String name = "\\fB" + flag.longestName().replace("-", "\\-") + "\\fR";
      assertThat(page.contains(name)).as(flag.longestName()).isNotEqualTo(flag.hidden());
    }
  }

  @Test
  void manFormatsThemWithoutAWarning() throws Exception {
    assumeTrue(Files.isExecutable(MAN), "needs man");
    for (String command : List.of("render", "views", "check", "help")) {
      String text = formatted(page(command));
      assertThat(text).contains("lumbre-" + command + " - ");
    }
    assertThat(formatted(page("render"))).contains("-o, --output OUT").contains("EXIT STATUS");
  }

  private String formatted(String page) throws Exception {
    Path file = Files.writeString(folder.resolve("page.1"), page, StandardCharsets.UTF_8);
    ProcessBuilder man =
        new ProcessBuilder(MAN.toString(), "--warnings", "-E", "ascii", "-l", file.toString());
    man.environment().put("LC_ALL", "C.UTF-8");
    Path warnings = folder.resolve("warnings");
    Process process = man.redirectError(warnings.toFile()).start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).isZero();
    assertThat(warnings).hasContent("");
    return text.replaceAll("\\s+", " ");
  }

  @Test
  void otherCommandsAreRefused() {
    Outcome outcome = Outcome.of("man", "draw");
    assertThat(outcome.exitCode()).isEqualTo(ExitCode.USAGE.number());
    assertThat(outcome.err()).contains("COMMAND: expected one of render, ").contains("found 'draw'");
  }
}
