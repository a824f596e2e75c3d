package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.Locale;

/**
 * The times of a scene's first renders, while the JIT is still compiling.
 *
 * @param seconds time of each render, in order
 * @param warmSeconds times of renders of the same work after compilation; may be empty
 */
record WarmUp(List<Double> seconds, List<Double> warmSeconds) {
  /** The share of the final rate from which a render is warm. */
  private static final double WARM = .95;

  WarmUp {
    seconds = List.copyOf(seconds);
    warmSeconds = List.copyOf(warmSeconds);
  }

  /**
   * Returns the time before the first render with at least 95 % of the final rate: {@code 1.24 s},
   * or {@code > 3.10 s} if there is none.
   */
  String text() {
    if (seconds.isEmpty()) {
      return "-";
    }
    double limit = Interval.median(warmSeconds.stream().mapToDouble(s -> s).toArray()) / WARM;
    List<Double> cold = seconds.stream().takeWhile(s -> s > limit).toList();
    double elapsed = cold.stream().mapToDouble(s -> s).sum();
    String form = cold.size() < seconds.size() ? "%.2f s" : "> %.2f s";
    return String.format(Locale.ROOT, form, elapsed);
  }
}
