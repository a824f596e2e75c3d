package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.math.internal.Elementary;
import java.util.List;
import java.util.Locale;

/** Formats the numbers of a study for its page and tables. */
final class TradeText {
  private TradeText() {}

  /** Returns a setting's display name. */
  static String label(String knob, String value) {
    return switch (knob) {
      case "sampler" -> value + " samples";
      case "lights" -> "light selection: " + value;
      case "strategy" -> technique(value);
      case "roulette" -> "Russian roulette " + value.replace("from", "from vertex");
      case "split" -> "path split into " + value;
      case "mode" -> value + " tracing";
      case "filter" -> "texture filter: " + value;
      case "clamp" -> "samples clamped to " + value;
      case "adaptive" -> "adaptive sampling";
      case "denoise" -> "denoised (" + value + ")";
      default -> knob + " " + value;
    };
  }

  private static String technique(String value) {
    return switch (value) {
      case "light" -> "light sampling only";
      case "bsdf" -> "BSDF sampling only";
      default -> "MIS: " + value + " heuristic";
    };
  }

  /** Returns the root of a squared error as a percentage; negative values count as 0. */
  static String rootPercent(double squared) {
    return Markdown.percent(Math.sqrt(Math.max(0, squared)));
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

  /** Returns a ratio with its interval. */
  static String ratio(Interval ratio) {
    return String.format(
        Locale.ROOT, "%.2f (%.2f to %.2f)", ratio.value(), ratio.low(), ratio.high());
  }

  static String count(double value) {
    return value >= 1e9
        ? String.format(Locale.ROOT, "%.3g G", value / 1e9)
        : value >= 1e6
            ? String.format(Locale.ROOT, "%.3g M", value / 1e6)
            : String.format(Locale.ROOT, "%.0f", value);
  }

  /** Returns the convergence exponent of rows as text; empty with fewer than two rows. */
  static String slope(List<TimeToError.Cost> rows) {
    if (rows.size() < 2) {
      return "";
    }
    double n = rows.size();
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (TimeToError.Cost row : rows) {
      double lx = Elementary.log(row.samples());
      double ly = Elementary.log(Interval.ofMean(row.relativeMse()).value());
      sx += lx;
      sy += ly;
      sxx += lx * lx;
      sxy += lx * ly;
    }
    return String.format(Locale.ROOT, "%.2f", (n * sxy - sx * sy) / (n * sxx - sx * sx));
  }
}
