package io.github.lumbre.lab.report;

import java.math.BigDecimal;

/**
 * The plan of a benchmark: how its rows are rendered and timed.
 *
 * @param share share of each row's samples that is rendered, in (0,1]
 * @param threads number of threads, at least 1
 * @param warmup number of untimed renders with 1 sample per pixel before each row
 * @param repeat number of timed renders of each row, at least 1
 */
public record BenchmarkPlan(BigDecimal share, int threads, int warmup, int repeat) {
  /** Returns whether all of the report's samples are rendered. */
  boolean isFull() {
    return share.compareTo(BigDecimal.ONE) == 0;
  }

  String sentences() {
    String samples =
        isFull()
            ? "Each row is rendered with all of its samples."
            : "Each row is rendered with "
                + share.movePointRight(2).stripTrailingZeros().toPlainString()
                + " % of its samples (rounded up, at least 1);"
                + " the time of all samples is extrapolated in proportion.";
    String warm =
        warmup == 0
            ? "No warm-up."
            : "Warm-up before each row: " + renders(warmup) + " of 1 sample per pixel.";
    String timed = repeat == 1 ? "Time: 1 render," : "Time: median of " + renders(repeat) + ",";
    return samples + " " + warm + " " + timed + " without loading the scene.";
  }

  private static String renders(int count) {
    return count == 1 ? "1 render" : count + " renders";
  }
}
