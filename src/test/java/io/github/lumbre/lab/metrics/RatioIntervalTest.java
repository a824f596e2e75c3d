package io.github.lumbre.lab.metrics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.lab.metrics.RatioInterval.Verdict;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests confidence intervals of ratios. */
class RatioIntervalTest {
  private final SplittableRandom random = new SplittableRandom(4);

  @Test
  void ratioIsThatOfGeometricMeans() {
    RatioInterval interval = RatioInterval.of(List.of(1.0, 4.0), List.of(3.0, 12.0));
    assertThat(interval.ratio()).isCloseTo(3, within(1e-12));
    // Both logarithms have the variance 2 ln(2)^2, hence 2 degrees and an error of sqrt(2) ln(2).
    double half = 4.3027 * Math.sqrt(2) * Math.log(2);
    assertThat(interval.high()).isCloseTo(3 * Math.exp(half), within(.02));
    assertThat(interval.low()).isCloseTo(3 * Math.exp(-half), within(1e-4));
  }

  @Test
  void exchangeInvertsTheInterval() {
    List<Double> a = List.of(1.0, 1.1, 1.05);
    List<Double> b = List.of(2.0, 2.3, 1.9, 2.1);
    RatioInterval forth = RatioInterval.of(a, b);
    RatioInterval back = RatioInterval.of(b, a);
    assertThat(back.ratio()).isCloseTo(1 / forth.ratio(), within(1e-12));
    assertThat(back.low()).isCloseTo(1 / forth.high(), within(1e-12));
  }

  @Test
  void intervalHoldsTheTruthAsOftenAsItSays() {
    // With 1000 trials, the standard error is 0.7 %, so the test would detect a 90 % interval.
    int trials = 1000;
    int held = 0;
    for (int i = 0; i < trials; i++) {
      RatioInterval interval = RatioInterval.of(times(5, 1, .02), times(8, 1.3, .1));
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
  void onlyWhatIsSureIsCalledADifference() {
    assertThat(verdict(.8, .99)).isEqualTo(Verdict.FASTER);
    assertThat(verdict(1.01, 1.2)).isEqualTo(Verdict.SLOWER);
    assertThat(verdict(.99, 1.2)).isEqualTo(Verdict.NO_DIFFERENCE);
    assertThat(verdict(1, 1)).hasToString("no difference");
  }

  private static Verdict verdict(double low, double high) {
    return new RatioInterval(Math.sqrt(low * high), low, high).verdict();
  }

  @Test
  void equalTimesLeaveNoDoubt() {
    RatioInterval interval = RatioInterval.of(List.of(2.0, 2.0), List.of(3.0, 3.0));
    assertThat(interval.low()).isEqualTo(interval.high()).isCloseTo(1.5, within(1e-12));
    assertThat(interval.verdict()).isEqualTo(Verdict.SLOWER);
  }

  @Test
  void oneRepetitionTellsNothing() {
    assertThatThrownBy(() -> RatioInterval.of(List.of(1.0), List.of(1.0, 2.0)))
        .hasMessage("repetitions: expected at least 2, found 1");
  }
}
