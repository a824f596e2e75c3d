package io.github.lumbre.measure;

import java.util.List;

/**
 * How much a study renders.
 *
 * @param ladder numbers of samples per pixel, ascending
 * @param leastSeeds of each setting, at least 2, whatever the time
 * @param mostSeeds of each setting, as many as the time allows
 * @param referenceSamples per pixel
 * @param exactSamples per pixel of the renders of which only the time counts
 * @param seconds after which no further seed begins that would end beyond
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

  /** Returns the most samples per pixel of a setting. */
  public int mostSamples() {
    return ladder.get(ladder.size() - 1);
  }
}
