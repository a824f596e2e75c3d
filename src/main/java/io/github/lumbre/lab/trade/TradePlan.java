package io.github.lumbre.lab.trade;

import java.util.List;

/**
 * How much a study renders.
 *
 * @param ladder numbers of samples per pixel, ascending
 * @param leastSeeds of each setting, at least 2, whatever the time
 * @param mostSeeds of each setting, as many as the time allows
 * @param referenceSamples per pixel, at least
 * @param exactSamples per pixel of the renders of which only the time counts
 * @param seconds after which nothing further begins that would end beyond
 * @param targetRelativeMse until which the usual setting goes on with more samples than the ladder
 *     has, and the reference until its own is an eighth of that; 0 if they are not to
 */
public record TradePlan(
    List<Integer> ladder,
    int leastSeeds,
    int mostSeeds,
    int referenceSamples,
    int exactSamples,
    double seconds,
    double targetRelativeMse) {
  /** The most samples per pixel of anything. */
  static final int LIMIT = 1 << 20;

  /** How many times less than the error to be reached the reference's own is to be, squared. */
  static final double REFERENCE_MARGIN = 8;

  public TradePlan {
    ladder = List.copyOf(ladder);
    if (ladder.isEmpty() || leastSeeds < 2 || mostSeeds < leastSeeds || referenceSamples < 2) {
      throw new IllegalArgumentException("plan: expected samples and at least two seeds");
    }
  }

  /** Tells whether the usual setting is to reach an error. */
  boolean hasTarget() {
    return targetRelativeMse > 0;
  }

  /** Returns the most samples per pixel of a setting, those for a target error not counted. */
  public int mostSamples() {
    return ladder.get(ladder.size() - 1);
  }
}
