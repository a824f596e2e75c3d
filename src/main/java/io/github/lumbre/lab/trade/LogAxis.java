package io.github.lumbre.lab.trade;

import io.github.lumbre.math.internal.Elementary;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A logarithmic axis.
 *
 * @param low value at its start, positive
 * @param high value at its end, larger
 * @param from coordinate of its start
 * @param to coordinate of its end
 */
record LogAxis(double low, double high, double from, double to) {
  /** The margin at either end, as a share of the logarithmic range of the values. */
  private static final double MARGIN = .04;

  /** The smallest ratio of the axis's ends, so that close values are drawn close together. */
  private static final double LEAST_SPAN = 3;

  /** A tick mark. */
  record Tick(double at, String text) {}

  /** Returns an axis over all positive finite values. */
  static LogAxis over(DoubleStream values, double from, double to) {
    DoubleSummaryStatistics range =
        values.filter(v -> v > 0 && Double.isFinite(v)).summaryStatistics();
    if (range.getCount() == 0) {
      return new LogAxis(1, 10, from, to);
    }
    double span = range.getMax() / range.getMin();
    double stretch = Math.max(Elementary.pow(span, MARGIN) * 1.1, Math.sqrt(LEAST_SPAN / span));
    return new LogAxis(range.getMin() / stretch, range.getMax() * stretch, from, to);
  }

  /** Returns the coordinate of a value, clamped to the axis. */
  double at(double value) {
    double place = value <= low ? 0 : Elementary.log(value / low) / Elementary.log(high / low);
    return from + Math.min(place, 1) * (to - from);
  }

  /** Returns the tick marks: powers of ten, and on short axes also multiples of them. */
  List<Tick> ticks() {
    double span = high / low;
    List<Integer> digits =
        span > 150 ? List.of(1) : span > 5 ? List.of(1, 2, 5) : List.of(1, 2, 3, 4, 5, 7);
    List<Tick> ticks = new ArrayList<>();
    int first = (int) Math.floor(Elementary.log(low) / Elementary.log(10));
    int last = (int) Math.ceil(Elementary.log(high) / Elementary.log(10));
    for (int decade = first; decade <= last; decade++) {
      for (int digit : digits) {
        BigDecimal value = BigDecimal.valueOf(digit).scaleByPowerOfTen(decade);
        if (value.doubleValue() >= low && value.doubleValue() <= high) {
          String text = Math.abs(decade) <= 4 ? value.toPlainString() : value.toString();
          ticks.add(new Tick(at(value.doubleValue()), text));
        }
      }
    }
    return ticks;
  }
}
