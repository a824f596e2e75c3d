package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.IntStream;

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

  /** Returns the index of the first render with at least 95 % of the final rate; empty if none. */
  OptionalInt firstWarm() {
    double limit = Interval.median(array(warmSeconds)) / WARM;
    return IntStream.range(0, seconds.size()).filter(i -> seconds.get(i) <= limit).findFirst();
  }

  /** Returns the time before the first warm render: {@code 1.24 s}, or {@code > 3.10 s} if none. */
  String text() {
    if (seconds.isEmpty()) {
      return "-";
    }
    OptionalInt warm = firstWarm();
    int cold = warm.orElse(seconds.size());
    double elapsed = seconds.stream().limit(cold).mapToDouble(Double::doubleValue).sum();
    return String.format(Locale.ROOT, warm.isPresent() ? "%.2f s" : "> %.2f s", elapsed);
  }

  private static double[] array(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
