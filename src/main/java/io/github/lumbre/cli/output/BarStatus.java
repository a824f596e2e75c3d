package io.github.lumbre.cli.output;

import io.github.lumbre.lab.Numbers;
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
 */
record BarStatus(
    long done,
    long total,
    double seconds,
    OptionalDouble secondsLeft,
    OptionalDouble error,
    OptionalDouble targetError) {
  private static final int MOST_CELLS = 40;
  private static final int LEAST_CELLS = 8;

  /**
   * Returns {@code 42 % [=====> ] 0:00:12 left, 1.5 M samples/s, noise 3.1 % (target 2.0 %)},
   * without the last parts if they do not fit.
   *
   * @param columns maximum length of the line
   */
  String line(int columns) {
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
    parts.add(Numbers.rate(done, seconds) + " samples/s");
    if (targetError.isPresent() && error.isPresent() && Double.isFinite(error.getAsDouble())) {
      parts.add(
          String.format(
              Locale.ROOT,
              "noise %.2g %% (target %.2g %%)",
              100 * error.getAsDouble(),
              100 * targetError.getAsDouble()));
    }
    return parts;
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
    return total == 0 ? 0 : (double) done / total;
  }

  private double ofTime() {
    double left = Math.max(0, secondsLeft.orElse(Double.POSITIVE_INFINITY));
    return left == 0 ? 1 : seconds / (seconds + left);
  }

  /**
   * Returns the finished share by the target error; 0 if the number of samples is known. The
   * squared error is inversely proportional to the number of samples.
   */
  private double ofError() {
    double found = error.orElse(Double.POSITIVE_INFINITY);
    double ratio = targetError.orElse(0) / found;
    return total == 0 && ratio > 0 ? Math.min(1, ratio * ratio) : 0;
  }

  private OptionalDouble timeLeft() {
    double share = Math.max(ofSamples(), ofError());
    double ofRate = share > 0 ? Math.max(0, seconds / share - seconds) : Double.POSITIVE_INFINITY;
    double left = Math.min(ofRate, Math.max(0, secondsLeft.orElse(Double.POSITIVE_INFINITY)));
    return Double.isFinite(left) ? OptionalDouble.of(left) : OptionalDouble.empty();
  }
}
