package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** Help texts fit terminals of any width. */
class HelpWidthTest {
  private static List<CommandLine> commands(int width) {
    CommandLine program = Lumbre.commandLine();
    program.setHelpFactory(new HelpWidth(Optional.of(width)));
    List<CommandLine> all = new ArrayList<>(program.getSubcommands().values());
    all.addAll(program.getSubcommands().get("trade").getSubcommands().values());
    all.add(program);
    return all;
  }

  @ParameterizedTest
  @CsvSource({"10, 40", "40, 40", "55, 55", "71, 71", "72, 72", "80, 80", "100, 100", "250, 100"})
  void linesFit(int terminal, int width) {
    for (CommandLine command : commands(terminal)) {
      assertThat(command.getUsageMessage().lines())
          .allMatch(line -> line.length() <= width || !line.strip().contains(" "));
    }
  }

  @ParameterizedTest
  @CsvSource({"40", "60"})
  void narrowTextsSayTheSame(int width) {
    List<CommandLine> narrow = commands(width);
    List<CommandLine> wide = commands(100);
    for (int i = 0; i < wide.size(); i++) {
      assertThat(letters(narrow.get(i))).isEqualTo(letters(wide.get(i)));
    }
  }

  /** Returns the sorted letters: short lists of flags have another order. */
  private static String letters(CommandLine command) {
    return command
        .getUsageMessage()
        .chars()
        .filter(c -> !Character.isWhitespace(c))
        .sorted()
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
        .toString();
  }

  @Test
  void continuedLinesKeepTheirColumn() {
    assertThat(HelpWidth.wrapped("  render      Render a scene to a picture.\n", 30))
        .isEqualTo("  render      Render a scene\n              to a picture.\n");
    assertThat(HelpWidth.wrapped("  lumbre render scene.json -s 16\n", 26))
        .isEqualTo("  lumbre render scene.json\n    -s 16\n");
    assertThat(HelpWidth.wrapped("wordswithoutspace end", 10))
        .isEqualTo("wordswithoutspace\nend\n");
  }
}
