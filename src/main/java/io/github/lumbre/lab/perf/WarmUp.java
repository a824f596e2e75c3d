package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * How fast a scene's first renders were, while the virtual machine was still compiling.
 *
 * @param seconds of each render, in order
 * @param warmSeconds of renders of the same work when all is compiled; none if there were no others
 */
record WarmUp(List<Double> seconds, List<Double> warmSeconds) {
  /** The share of the final rate at which a render counts as warm. */
  private static final double WARM = .95;

  WarmUp {
    seconds = List.copyOf(seconds);
    warmSeconds = List.copyOf(warmSeconds);
  }

  /** Returns which render is the first at 95 % of the final rate or more; empty if none is. */
  OptionalInt firstWarm() {
    double limit = Interval.median(array(warmSeconds)) / WARM;
    return IntStream.range(0, seconds.size()).filter(i -> seconds.get(i) <= limit).findFirst();
  }

  /** Returns how long it took until then: {@code 1.24 s}, or {@code > 3.10 s} if that was never. */
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
