package io.github.lumbre.lab.trade;

import java.util.List;

/**
 * The amount of work of a study.
 *
 * @param ladder numbers of samples per pixel, ascending
 * @param leastSeeds minimum number of seeds of each setting, at least 2, regardless of the time
 * @param mostSeeds maximum number of seeds of each setting, within the time
 * @param referenceSamples minimum number of samples per pixel of the reference
 * @param exactSamples samples per pixel of the renders that compare only times
 * @param seconds time limit; work that would exceed it is not started
 * @param targetRelativeMse squared error down to which the baseline is rendered beyond the ladder,
 *     and the reference down to 1/8 of it; 0 for no target
 */
public record TradePlan(
    List<Integer> ladder,
    int leastSeeds,
    int mostSeeds,
    int referenceSamples,
    int exactSamples,
    double seconds,
    double targetRelativeMse) {
  /** The largest number of samples per pixel of any render. */
  static final int LIMIT = 1 << 20;

  /** The ratio of the target squared error to the squared error of the reference. */
  static final double REFERENCE_MARGIN = 8;

  public TradePlan {
    ladder = List.copyOf(ladder);
    if (ladder.isEmpty() || leastSeeds < 2 || mostSeeds < leastSeeds || referenceSamples < 2) {
      throw new IllegalArgumentException("plan: expected samples and at least two seeds");
    }
  }

  /** Returns whether there is a target error. */
  boolean hasTarget() {
    return targetRelativeMse > 0;
  }

  /** Returns the largest number of samples per pixel of the ladder. */
  public int mostSamples() {
    return ladder.get(ladder.size() - 1);
  }
}
