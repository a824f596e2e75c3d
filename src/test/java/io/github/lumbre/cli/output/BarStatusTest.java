package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** Tests the text of the progress bar. */
class BarStatusTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static BarStatus samples(long done, long total, double seconds) {
    return new BarStatus(done, total, seconds, NONE, NONE, NONE);
  }

  @Test
  void lineHasShareTimeLeftAndRate() {
    assertThat(samples(250, 1000, 50).line(79))
        .isEqualTo(" 25 % [==========>                             ] 0:02:30 left, 5 samples/s");
    assertThat(samples(0, 1000, 0).line(60))
        .isEqualTo("  0 % [>                                      ] 0 samples/s");
    assertThat(samples(1000, 1000, 50).line(40)).isEqualTo("100 % 0:00:00 left, 20 samples/s");
  }

  @Test
  void lineNeverExceedsTheWindow() {
    BarStatus status =
        new BarStatus(
            5_000_000, 9_000_000, 7000, NONE, OptionalDouble.of(.031), OptionalDouble.of(.02));
    for (int columns = 0; columns < 200; columns++) {
      assertThat(status.line(columns)).hasSizeLessThanOrEqualTo(columns);
    }
    assertThat(status.line(25)).isEqualTo(" 55 % 1:33:20 left");
    assertThat(status.line(150))
        .endsWith("] 1:33:20 left, 714 samples/s, noise 3.1 % (target 2.0 %)");
  }

  @Test
  void openNumberOfSamplesIsMeasuredByTime() {
    BarStatus status = new BarStatus(700, 0, 15, OptionalDouble.of(45), NONE, NONE);
    assertThat(status.line(60)).startsWith(" 25 % [").endsWith("0:00:45 left, 47 samples/s");
  }

  @Test
  void limitThatComesFirstCounts() {
    BarStatus byTime = new BarStatus(100, 1000, 15, OptionalDouble.of(15), NONE, NONE);
    assertThat(byTime.line(60)).startsWith(" 50 %").contains("0:00:15 left");
    BarStatus bySamples = new BarStatus(750, 1000, 15, OptionalDouble.of(45), NONE, NONE);
    assertThat(bySamples.line(60)).startsWith(" 75 %").contains("0:00:05 left");
  }

  @Test
  void openNumberOfSamplesIsMeasuredByTheSquaredError() {
    BarStatus status =
        new BarStatus(100, 0, 10, NONE, OptionalDouble.of(.04), OptionalDouble.of(.02));
    assertThat(status.line(100)).startsWith(" 25 %").contains("0:00:30 left", "noise 4.0 %");
  }

  @Test
  void unknownEndHasNoShare() {
    assertThat(samples(100, 0, 10).line(60)).startsWith("  ? % [>").endsWith("] 10 samples/s");
  }
}
