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

  private static BarStatus scaled(
      long done, long total, double seconds, OptionalDouble left, BarStatus.Scale scale) {
    return new BarStatus(done, total, seconds, left, NONE, NONE, scale);
  }

  @Test
  void largeErrorsHaveNoExponent() {
    for (double error : new double[] {.995, 1.5, 12, 1e9, 1e-9}) {
      BarStatus status =
          new BarStatus(100, 0, 10, NONE, OptionalDouble.of(error), OptionalDouble.of(.02));
      assertThat(status.line(120)).doesNotContainPattern("[0-9]e[+-]");
    }
    BarStatus status =
        new BarStatus(100, 0, 10, NONE, OptionalDouble.of(1.5), OptionalDouble.of(.02));
    assertThat(status.line(120)).endsWith("noise 150 % (target 2.0 %)");
  }

  @Test
  void unknownEndOfAFilmShowsSamplesPerPixelAndTime() {
    BarStatus.Scale scale = new BarStatus.Scale(1000, 0, 1000, false, 0);
    assertThat(scaled(400, 0, 10, NONE, scale).line(79))
        .isEqualTo("0.4 samples per pixel, 0:00:10, 40 samples/s");
    assertThat(scaled(400, 0, 10, NONE, scale).line(33))
        .isEqualTo("0.4 samples per pixel, 0:00:10");
    BarStatus.Scale resumed = new BarStatus.Scale(1000, 12_000, 0, false, 0);
    assertThat(scaled(2000, 0, 10, NONE, resumed).line(79)).startsWith("14 samples per pixel, ");
  }

  /** The time of 5 s is over, and the first pass takes 30 s more. */
  @Test
  void firstPassesThatOutlastTheTimeLimitAreNotDone() {
    BarStatus.Scale scale = new BarStatus.Scale(1000, 0, 1000, false, 0);
    assertThat(scaled(250, 0, 10, OptionalDouble.of(-5), scale).line(79))
        .startsWith(" 25 % [")
        .contains("] 0:00:30 left, ");
    assertThat(scaled(0, 0, 10, OptionalDouble.of(-5), scale).line(79)).startsWith("  0 % [>");
    assertThat(scaled(1000, 0, 10, OptionalDouble.of(30), scale).line(79)).startsWith(" 25 % [");
  }

  @Test
  void forecastsThatWereTooLowDoNotEnd() {
    BarStatus.Scale scale = new BarStatus.Scale(1000, 0, 0, true, 0);
    assertThat(scaled(9000, 8000, 10, NONE, scale).line(79))
        .startsWith(" 99 % [")
        .doesNotContain("left");
  }

  /** The squared error of 0.04 at 100 samples halves at 200: half of the 400 that are needed. */
  @Test
  void theShareGrowsBetweenTwoEstimatesOfTheError() {
    OptionalDouble error = OptionalDouble.of(.04);
    BarStatus.Scale scale = new BarStatus.Scale(10, 0, 0, false, 100);
    OptionalDouble target = OptionalDouble.of(.02);
    assertThat(new BarStatus(200, 0, 20, NONE, error, target, scale).line(100))
        .startsWith(" 50 %")
        .contains("0:00:20 left");
    assertThat(new BarStatus(4000, 0, 400, NONE, error, target, scale).line(100))
        .startsWith(" 99 %");
  }
}
