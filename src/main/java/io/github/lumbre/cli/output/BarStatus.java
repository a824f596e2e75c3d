package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * The progress of a render, formatted as one line. Immutable.
 *
 * @param done samples
 * @param total samples; 0 if another limit ends the render
 * @param seconds elapsed since the start of the render
 * @param secondsLeft until a time limit ends it
 * @param error current estimate of the relative error
 * @param targetError relative error that ends the render
 * @param scale what the samples are compared with
 */
record BarStatus(
    long done,
    long total,
    double seconds,
    OptionalDouble secondsLeft,
    OptionalDouble error,
    OptionalDouble targetError,
    Scale scale) {
  private static final int MOST_CELLS = 40;
  private static final int LEAST_CELLS = 8;

  /** The largest share shown while a render is still running. */
  private static final double ALMOST = .99;

  /** Errors in percent that two digits show without an exponent; larger ones have no fraction. */
  private static final double LEAST_SHOWN = 1e-4;

  private static final double MOST_OF_TWO_DIGITS = 99.5;
  private static final double MOST_SHOWN = 9999;

  /**
   * What the samples of a render are compared with.
   *
   * @param pixels 0 if unknown
   * @param before samples that the picture has already
   * @param firstPass samples that are rendered whatever the time limit is
   * @param isForecast whether the total is an estimate
   * @param measured samples of the render at which the error was estimated; 0 if unknown
   */
  record Scale(long pixels, long before, long firstPass, boolean isForecast, long measured) {
    static final Scale UNKNOWN = new Scale(0, 0, 0, false, 0);

    /** Returns this scale with an estimated total. */
    Scale forecast() {
      return new Scale(pixels, before, firstPass, true, measured);
    }

    /** Returns this scale after the error was estimated. */
    Scale measuredAt(long samples) {
      return new Scale(pixels, before, firstPass, isForecast, samples);
    }
  }

  /** Creates the progress of a render of unknown scale. */
  BarStatus(
      long done,
      long total,
      double seconds,
      OptionalDouble secondsLeft,
      OptionalDouble error,
      OptionalDouble targetError) {
    this(done, total, seconds, secondsLeft, error, targetError, Scale.UNKNOWN);
  }

  /**
   * Returns {@code 42 % [=====> ] 0:00:12 left, 1.5 M samples/s, noise 3.1 % (target 2.0 %)},
   * without the last parts if they do not fit. A render whose end is not known has no share: {@code
   * 3.4 samples per pixel, 0:00:12, 1.5 M samples/s}.
   *
   * @param columns maximum length of the line
   */
  String line(int columns) {
    if (isOpen() && scale.pixels > 0) {
      List<String> parts = openParts();
      while (parts.size() > 1 && columns < length(parts) - 2) {
        parts.remove(parts.size() - 1);
      }
      return cut(String.join(", ", parts), columns);
    }
    String percent = isOpen() ? "  ? %" : String.format(Locale.ROOT, "%3.0f %%", 100 * floored());
    List<String> parts = parts();
    int room = columns - percent.length();
    while (!parts.isEmpty() && room < length(parts)) {
      parts.remove(parts.size() - 1);
    }
    int cells = Math.min(MOST_CELLS, room - length(parts) - 3);
    String bar = cells < LEAST_CELLS ? "" : " [" + bar(cells) + "]";
    String rest = parts.isEmpty() ? "" : " " + String.join(", ", parts);
    return cut(percent + bar + rest, columns);
  }

  static String cut(String text, int columns) {
    return text.substring(0, Math.min(text.length(), Math.max(columns, 0)));
  }

  private static int length(List<String> parts) {
    return parts.stream().mapToInt(part -> part.length() + 2).sum();
  }

  private List<String> parts() {
    List<String> parts = new ArrayList<>();
    OptionalDouble left = timeLeft();
    if (left.isPresent()) {
      parts.add(ProgressBar.clock(left.getAsDouble()) + " left");
    }
    addRateAndNoise(parts);
    return parts;
  }

  private List<String> openParts() {
    double mean = (double) (scale.before + done) / scale.pixels;
    List<String> parts = new ArrayList<>();
    parts.add(
        String.format(Locale.ROOT, mean < 10 ? "%.1f" : "%.0f", mean) + " samples per pixel");
    parts.add(ProgressBar.clock(seconds));
    addRateAndNoise(parts);
    return parts;
  }

  private void addRateAndNoise(List<String> parts) {
    parts.add(Numbers.rate(done, seconds) + " samples/s");
    if (targetError.isPresent() && error.isPresent() && Double.isFinite(error.getAsDouble())) {
      parts.add(
          "noise %s (target %s)"
              .formatted(percent(error.getAsDouble()), percent(targetError.getAsDouble())));
    }
  }

  private static String percent(double share) {
    double percent = 100 * share;
    if (percent > MOST_SHOWN) {
      return "over %.0f %%".formatted(MOST_SHOWN);
    }
    boolean hasTwoDigits = percent >= LEAST_SHOWN && percent < MOST_OF_TWO_DIGITS;
    String format = hasTwoDigits ? "%.2g %%" : percent < LEAST_SHOWN ? "%.6f %%" : "%.0f %%";
    return String.format(Locale.ROOT, format, percent);
  }

  private String bar(int cells) {
    int full = (int) (fraction() * cells);
    return "=".repeat(full) + (full < cells ? ">" + " ".repeat(cells - full - 1) : "");
  }

  private double floored() {
    return Math.floor(100 * fraction()) / 100;
  }

  /** Returns whether the end of the render cannot be estimated. */
  private boolean isOpen() {
    return total == 0 && secondsLeft.isEmpty() && ofError() == 0;
  }

  /** Returns the finished share, by the limit that will end the render first. */
  private double fraction() {
    return Math.min(1, Math.max(Math.max(ofSamples(), ofTime()), ofError()));
  }

  private double ofSamples() {
    double share = total == 0 ? 0 : (double) done / total;
    return scale.isForecast ? Math.min(ALMOST, share) : share;
  }

  private double ofTime() {
    double left = timeLimit();
    return left == 0 ? 1 : Double.isInfinite(left) ? 0 : seconds / (seconds + left);
  }

  /** Returns the seconds until the time limit, or until the first pass ends, which may be later. */
  private double timeLimit() {
    double left = Math.max(0, secondsLeft.orElse(Double.POSITIVE_INFINITY));
    if (done >= scale.firstPass) {
      return left;
    }
    double ofFirstPass =
        done == 0 ? Double.POSITIVE_INFINITY : seconds * (scale.firstPass - done) / done;
    return left == 0 || done > 0 ? Math.max(left, ofFirstPass) : left;
  }

  /**
   * Returns the finished share by the target error; 0 if the number of samples is known. The
   * squared error is inversely proportional to the number of samples.
   */
  private double ofError() {
    double found = error.orElse(Double.POSITIVE_INFINITY);
    double ratio = targetError.orElse(0) / found;
    if (total > 0 || ratio == 0) {
      return 0;
    }
    double since =
        scale.measured > 0 ? (double) (scale.before + done) / (scale.before + scale.measured) : 1;
    double share = ratio * ratio;
    return since > 1 ? Math.min(Math.max(ALMOST, share), share * since) : Math.min(1, share);
  }

  private OptionalDouble timeLeft() {
    double share = Math.max(ofSamples(), ofError());
    boolean isLate = scale.isForecast && done >= total;
    double ofRate =
        share > 0 && !isLate ? Math.max(0, seconds / share - seconds) : Double.POSITIVE_INFINITY;
    double left = Math.min(ofRate, timeLimit());
    return Double.isFinite(left) ? OptionalDouble.of(left) : OptionalDouble.empty();
  }
}
