package io.github.lumbre.lab.trade;

import io.github.lumbre.math.Elementary;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A logarithmic axis.
 *
 * @param low value at its beginning, positive
 * @param high value at its end, larger
 * @param from coordinate of its beginning
 * @param to coordinate of its end
 */
record LogAxis(double low, double high, double from, double to) {
  /** What is left free at either end, as a share of the values' range in logarithms. */
  private static final double MARGIN = .04;

  private static final int[] COARSE = {1};
  private static final int[] FINE = {1, 2, 5};
  private static final int[] FINEST = {1, 2, 3, 4, 5, 7};

  /** What lies closer together than so many times is shown close together. */
  private static final double LEAST_SPAN = 3;

  /** Over more than so many times its low end an axis has coarse marks, and fine ones. */
  private static final double MUCH = 150;

  private static final double LITTLE = 5;

  /** A mark. */
  record Tick(double at, String text) {}

  /** Returns an axis over all values that are positive. */
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

  /** Returns the coordinate of a value; of one beyond the axis, its end. */
  double at(double value) {
    double place = value <= low ? 0 : Elementary.log(value / low) / Elementary.log(high / low);
    return from + Math.min(place, 1) * (to - from);
  }

  /** Returns the marks: powers of ten, and on short axes multiples of those. */
  List<Tick> ticks() {
    double span = high / low;
    int[] digits = span > MUCH ? COARSE : span > LITTLE ? FINE : FINEST;
    List<Tick> ticks = new ArrayList<>();
    int first = (int) Math.floor(Elementary.log(low) / Elementary.log(10));
    int last = (int) Math.ceil(Elementary.log(high) / Elementary.log(10));
    for (int decade = first; decade <= last; decade++) {
      for (int digit : digits) {
        BigDecimal value = BigDecimal.valueOf(digit).scaleByPowerOfTen(decade);
        if (value.doubleValue() >= low && value.doubleValue() <= high) {
          ticks.add(new Tick(at(value.doubleValue()), text(value, decade)));
        }
      }
    }
    return ticks;
  }

  private static String text(BigDecimal value, int decade) {
    return Math.abs(decade) <= 4 ? value.toPlainString() : value.toString();
  }
}
