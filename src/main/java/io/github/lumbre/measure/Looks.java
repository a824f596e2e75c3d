package io.github.lumbre.measure;

/**
 * When a render that is to reach an error looks at it, and how sure each look must be so that all
 * of them together are as sure as was asked for.
 *
 * <p>Stopping at the first look that is good enough favours lucky looks. So the j-th of them is
 * allowed to be wrong with a probability of α / (j (j + 1)), which sum up to α, the probability of
 * any being wrong (a spending rule: Lan &amp; DeMets 1983, with Bonferroni's bound).
 */
final class Looks {
  /** Fewer samples a pixel may all have missed what matters. */
  static final int FIRST = 32;

  private Looks() {}

  /**
   * Returns a number that grows whenever a look is due: after 32, 48, 64, 96, 128, ... samples per
   * pixel; 0 before the first.
   *
   * @param samples per pixel, in the mean
   */
  static int due(double samples) {
    if (samples < FIRST) {
      return 0;
    }
    int octave = Math.getExponent(samples / FIRST);
    return 1 + 2 * octave + (samples >= 1.5 * Math.scalb((double) FIRST, octave) ? 1 : 0);
  }

  /**
   * Returns how sure a look must be.
   *
   * @param confidence of all looks together, in (0,1)
   * @param number of the look, 1 or more
   */
  static double confidence(double confidence, int number) {
    return 1 - (1 - confidence) / ((double) number * (number + 1));
  }
}
