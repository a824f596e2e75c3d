package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.lab.metrics.Interval;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the time to reach an error, measured or extrapolated. */
class TimeToErrorTest {
  /** Three seeds whose squared error is a power of the samples. */
  private static List<TimeToError.Cost> rows(double exponent, int... ladder) {
    List<TimeToError.Cost> rows = new ArrayList<>();
    for (int samples : ladder) {
      double error = Math.pow(samples, exponent);
      double cpu = .5 * samples;
      rows.add(new TimeToError.Cost(samples, List.of(error, error, error), List.of(cpu, cpu, cpu)));
    }
    return rows;
  }

  @Test
  void powerLawsAreFollowedBetweenSamples() {
    TimeToError cost = TimeToError.of(rows(-1.3, 1, 4, 16, 64), Math.pow(20, -1.3));
    assertThat(cost.samples().value()).isCloseTo(20, within(1e-9));
    assertThat(cost.cpuSeconds().value()).isCloseTo(10, within(1e-9));
    assertThat(cost.isExtrapolated()).isFalse();
    assertThat(cost.samples().low()).isCloseTo(20, within(1e-9));
  }

  @Test
  void beyondTheLastSamplesErrorIsInverse() {
    // At 16 samples, it is 16^-1.3; an eighth of it takes eight times as many samples.
    TimeToError cost = TimeToError.of(rows(-1.3, 1, 4, 16), Math.pow(16, -1.3) / 8);
    assertThat(cost.samples().value()).isCloseTo(128, within(1e-9));
    assertThat(cost.isExtrapolated()).isTrue();
  }

  @Test
  void everySeedIsToReachTheError() {
    List<Double> seconds = List.of(1., 1., 1.);
    List<TimeToError.Cost> rows =
        List.of(
            new TimeToError.Cost(4, List.of(.2, .2, .2), seconds),
            new TimeToError.Cost(16, List.of(.02, .02, .11), seconds));
    assertThat(TimeToError.of(rows, .1).isExtrapolated()).isTrue();
    assertThat(TimeToError.of(rows, .11).isExtrapolated()).isFalse();
  }

  /** The process clock ticks 100 times per second, so short renders take 0 s or 0.01 s. */
  @Test
  void timesTooShortForTheClockAreThoseOfTheMostSamplesInProportion() {
    List<TimeToError.Cost> rows =
        List.of(
            new TimeToError.Cost(2, List.of(.4, .4, .4, .4), List.of(0., .01, 0., 0.)),
            new TimeToError.Cost(8, List.of(.1, .1, .1, .1), List.of(.02, .02, .02, .02)));
    TimeToError cost = TimeToError.of(rows, .2);
    assertThat(cost.samples().value()).isCloseTo(4, within(1e-9));
    assertThat(cost.cpuSeconds().value()).isCloseTo(.01, within(1e-9));
  }

  @Test
  void gainsAreRatiosOfErrorTimesTime() {
    List<Double> two = List.of(2.0, 4.0, 8.0);
    List<Double> one = List.of(1.0, 2.0, 4.0);
    Interval ratio = Interval.ofRatios(two, one);
    assertThat(ratio.value()).isCloseTo(2, within(1e-12));
    assertThat(ratio.low()).isCloseTo(2, within(1e-12));
    Interval mean = Interval.ofGeometricMean(List.of(1.0, 4.0));
    assertThat(mean.value()).isCloseTo(2, within(1e-12));
    assertThat(mean.low() * mean.high()).isCloseTo(4, within(1e-9));
  }
}
