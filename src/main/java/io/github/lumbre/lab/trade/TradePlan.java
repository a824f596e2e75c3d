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
 */
public record TradePlan(
    List<Integer> ladder,
    int leastSeeds,
    int mostSeeds,
    int referenceSamples,
    int exactSamples,
    double seconds) {
  public TradePlan {
    ladder = List.copyOf(ladder);
    if (ladder.isEmpty() || leastSeeds < 2 || mostSeeds < leastSeeds || referenceSamples < 2) {
      throw new IllegalArgumentException("plan: expected samples and at least two seeds");
    }
  }

  /** Returns the largest number of samples per pixel of the ladder. */
  public int mostSamples() {
    return ladder.get(ladder.size() - 1);
  }
}
