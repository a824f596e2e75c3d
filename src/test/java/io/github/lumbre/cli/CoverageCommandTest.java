package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code lumbre coverage}. */
class CoverageCommandTest {
  @Test
  void eachNumberOfSamplesAndEachTargetHasALine() {
    Outcome outcome =
        Outcome.of(
            ("coverage scenes/camera-pinhole.json --size 8x8 --seeds 3 -s 2,4 --reference 64"
                    + " --target-error 60%")
                .split(" "));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.out().lines())
        .satisfiesExactly(
            line -> assertThat(line).matches("2 samples   [0-3] of 3 beyond .*"),
            line -> assertThat(line).matches("4 samples   [0-3] of 3 beyond .*"),
            line -> assertThat(line).matches("60 %        [0-3] of 3 beyond .*"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--seeds 1",
        "-s 1",
        "-s 8,4",
        "--size 7x9",
        "--reference 7",
        "--target-error 0%"
      })
  void valuesOutOfRangeAreRefused(String flags) {
    Outcome outcome = Outcome.of(("coverage scenes/camera-pinhole.json " + flags).split(" "));
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    String flag = flags.startsWith("-s ") ? "--samples" : flags.split(" ")[0];
    assertThat(outcome.err()).contains(flag);
  }
}
