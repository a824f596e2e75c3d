package io.github.lumbre.lab.metrics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests confidence intervals of medians. */
class IntervalTest {
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
}
