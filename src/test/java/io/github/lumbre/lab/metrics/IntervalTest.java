package io.github.lumbre.lab.metrics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests confidence intervals of medians and ratios. */
class IntervalTest {
  private final SplittableRandom random = new SplittableRandom(4);

  /** The ranks are from tables of the sign test: 1 of 6 and 8, 2 of 9, 4 of 15, 6 of 20. */
  @Test
  void medianLiesBetweenRanks() {
    assertThat(median(6)).isEqualTo(new Interval(3.5, 1, 6));
    assertThat(median(8)).isEqualTo(new Interval(4.5, 1, 8));
    assertThat(median(9)).isEqualTo(new Interval(5, 2, 8));
    assertThat(median(15)).isEqualTo(new Interval(8, 4, 12));
    assertThat(median(20)).isEqualTo(new Interval(10.5, 6, 15));
  }

  private static Interval median(int count) {
    List<Double> falling = IntStream.range(0, count).mapToObj(i -> (double) count - i).toList();
    return Interval.ofMedian(falling);
  }

  @Test
  void fewValuesHaveNoInterval() {
    assertThatThrownBy(() -> median(5)).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void ratioIsTheGeometricMeanOfPairs() {
    Interval interval = Interval.ofRatios(List.of(3.0, 48.0), List.of(1.0, 4.0));
    assertThat(interval.value()).isCloseTo(6, within(1e-12));
    // The logarithms are apart by ln(4): 1 degree of freedom, and an error of ln(2).
    double half = 12.7062 * Math.log(2);
    assertThat(interval.high()).isCloseTo(6 * Math.exp(half), within(2.));
    assertThat(interval.low()).isCloseTo(6 * Math.exp(-half), within(1e-6));
  }

  @Test
  void intervalHoldsTheTruthAsOftenAsItSays() {
    // With 1000 trials, the standard error is 0.7 %, so the test would detect a 90 % interval.
    int trials = 1000;
    int held = 0;
    for (int i = 0; i < trials; i++) {
      Interval interval = Interval.ofRatios(times(8, 1.3, .1), times(8, 1, .02));
      held += interval.low() <= 1.3 && 1.3 <= interval.high() ? 1 : 0;
    }
    assertThat(held / (double) trials).isBetween(.925, .975);
  }

  private List<Double> times(int count, double median, double spread) {
    return Stream.generate(() -> median * Math.exp(spread * normal())).limit(count).toList();
  }

  /** Returns a standard normal number (Box and Muller 1958). */
  private double normal() {
    double radius = Math.sqrt(-2 * Math.log(1 - random.nextDouble()));
    return radius * Math.cos(2 * Math.PI * random.nextDouble());
  }

  @Test
  void equalRatiosLeaveNoDoubt() {
    Interval interval = Interval.ofRatios(List.of(3.0, 3.0), List.of(2.0, 2.0));
    assertThat(interval.low()).isEqualTo(interval.high()).isCloseTo(1.5, within(1e-12));
  }
}
