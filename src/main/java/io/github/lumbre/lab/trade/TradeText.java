package io.github.lumbre.lab.trade;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Formats the numbers of a study for its page and tables. */
final class TradeText {
  private TradeText() {}

  /** Returns the root of a squared error as a percentage; negative values count as 0. */
  static String rootPercent(double squared) {
    return Numbers.percent(Math.sqrt(Math.max(0, squared)));
  }

  static String number(double value) {
    if (value == 0) {
      return "0";
    }
    return value >= 1000 && value < 1e6
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.format(Locale.ROOT, "%.3g", value);
  }

  static String seconds(double value) {
    return number(value) + " s";
  }

  static String seconds(Interval time) {
    return String.format(Locale.ROOT, "%.3g s ± %.2g", time.value(), time.high() - time.value());
  }

  /** Returns a bias that was detected, or the bound of one that was not. */
  static String bias(TradeRow.Bias bias, String ifNotDetected) {
    return bias.isDetected()
        ? rootPercent(bias.squared())
        : ifNotDetected + "< " + rootPercent(bias.high());
  }

  /** Returns the convergence exponent of rows as text; empty with fewer than two rows. */
  static String slope(List<TimeToError.Cost> rows) {
    if (rows.size() < 2) {
      return "";
    }
    double[] x = rows.stream().mapToDouble(row -> Elementary.log(row.samples())).toArray();
    double mean = Arrays.stream(x).sum() / x.length;
    double products = 0;
    double squares = 0;
    for (int i = 0; i < x.length; i++) {
      double error = Interval.ofMean(rows.get(i).relativeMse()).value();
      products += (x[i] - mean) * Elementary.log(error);
      squares += (x[i] - mean) * (x[i] - mean);
    }
    return String.format(Locale.ROOT, "%.2f", products / squares);
  }
}
