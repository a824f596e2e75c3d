package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.output.ExitCodes;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import picocli.CommandLine.Command;

/** Commands name their exit codes by constants, whose texts their help prints. */
class ExitsTest {
  private static Stream<Class<?>> commands() {
    return Lumbre.SECTIONS.values().stream()
        .flatMap(List::stream)
        .filter(Subcommand.class::isAssignableFrom);
  }

  @Test
  void eachCommandNamesItsCodesInTheirOrder() {
    assertThat(commands())
        .hasSizeGreaterThan(20)
        .allSatisfy(
            command -> {
              assertThat(command.getAnnotation(Exits.class).value())
                  .doesNotContain(ExitCode.USAGE, ExitCode.INTERNAL)
                  .isSorted();
              assertThat(command.getAnnotation(Command.class).exitCodeList()).isEmpty();
            });
  }

  @Test
  void numbersAreThoseThatScriptsRelyOn() {
    assertThat(Stream.of(ExitCode.values()).map(ExitCode::number).distinct())
        .containsExactly(
            ExitCodes.OK,
            ExitCodes.WARNINGS,
            ExitCodes.USAGE,
            ExitCodes.SCENE,
            ExitCodes.ASSET,
            ExitCodes.LIMIT,
            ExitCodes.OUTPUT,
            ExitCodes.INTERNAL,
            ExitCodes.HUNG_UP,
            ExitCodes.INTERRUPTED,
            ExitCodes.TERMINATED);
  }
}
