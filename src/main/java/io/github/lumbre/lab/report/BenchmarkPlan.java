package io.github.lumbre.lab.report;

import java.math.BigDecimal;

/**
 * How the rows of a benchmark are rendered and timed.
 *
 * @param share of each row's samples, in (0,1]
 * @param threads at least 1
 * @param warmup how many renders of one sample per pixel come before each row, untimed
 * @param repeat how many times each row is rendered and timed, at least 1
 */
public record BenchmarkPlan(BigDecimal share, int threads, int warmup, int repeat) {
  /** Tells whether every sample of the report's is rendered. */
  boolean isFull() {
    return share.compareTo(BigDecimal.ONE) == 0;
  }

  /** Returns all of it as sentences. */
  String sentences() {
    String samples =
        isFull()
            ? "Each row is rendered with all its samples."
            : "Each row is rendered with "
                + share.movePointRight(2).stripTrailingZeros().toPlainString()
                + " % of its samples (rounded up, at least 1);"
                + " the time of all samples is extrapolated in proportion.";
    String warm =
        warmup == 0
            ? "No warm-up."
            : "Warm-up before each row: " + renders(warmup) + " of 1 sample per pixel.";
    String timed =
        repeat == 1 ? "Time: of 1 render," : "Time: the median of " + renders(repeat) + ",";
    return samples + " " + warm + " " + timed + " without reading the scene.";
  }

  private static String renders(int count) {
    return count == 1 ? "1 render" : count + " renders";
  }
}
