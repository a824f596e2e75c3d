package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Tests what is suggested for flags and commands that do not exist. */
class SuggestionsTest {
  private final CommandLine program = new CommandLine(new Small());
  private final CommandSpec near = program.getSubcommands().get("near").getCommandSpec();
  private final Suggestions suggestions =
      new Suggestions(program.getSubcommands().keySet(), () -> program);

  @Command(subcommands = {Near.class, Far.class})
  static final class Small {}

  @Command(name = "near")
  static final class Near {
    @Option(names = "--hide")
    private String hide;

    @Option(names = "-s")
    private String letter;
  }

  @Command(name = "far")
  static final class Far {
    @Option(names = "--size")
    private String size;
  }

  @Test
  void aFlagOfAnotherCommandIsNotASpellingOfOneHere() {
    assertThat(suggestions.forFlag("--size", near))
        .isEqualTo("; --size is a flag of 'lumbre far'");
    assertThat(suggestions.forFlag("--width=8", near))
        .isEqualTo("; --size is a flag of 'lumbre far'");
  }

  @Test
  void similarFlagsAreSuggested() {
    assertThat(suggestions.forFlag("--hids", near)).isEqualTo("; did you mean --hide?");
    assertThat(suggestions.forFlag("--HIDE=1", near)).isEqualTo("; did you mean --hide?");
  }

  @ParameterizedTest
  @ValueSource(strings = {"--ride-on", "--fine", "-x", "--x", "--"})
  void nothingIsSuggestedForOtherWords(String flag) {
    assertThat(suggestions.forFlag(flag, near)).isEmpty();
  }

  @Test
  void similarCommandsAreSuggested() {
    assertThat(suggestions.forCommand("nearr")).isEqualTo("; did you mean near?");
    assertThat(suggestions.forCommand("wander")).isEmpty();
  }
}
