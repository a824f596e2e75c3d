package io.github.lumbre.render.stopping;

/**
 * The schedule of the error checks of a render that stops at a target error, and the confidence of
 * each, so that all of them together have the requested confidence.
 *
 * <p>Stopping at the first check that passes favors lucky checks. The checks therefore share the
 * probability α of any of them being wrong (a spending rule: Lan &amp; DeMets 1983, with
 * Bonferroni's bound). Nine tenths of α belong to the checks from 32 samples per pixel on, of which
 * the j-th spends a fraction of 1 / (j (j + 1)). The three early checks, after 4, 8 and 16 samples,
 * share the remaining tenth.
 *
 * <p>An early check also requires enough samples to find all light that matters. Light that no
 * sample has found adds at most 1 to the relative squared error of a pixel. To hide an error ε, it
 * must therefore cover a fraction of at least ε² of the pixels. {@link #isEarlyEnough} requires 256
 * samples in that fraction.
 */
final class StoppingSchedule {
  /** From this number of samples per pixel on, checks take place in frames of any size. */
  static final int ANY_FRAME = 32;

  private static final int FIRST = 4;
  private static final int EARLY_LOOKS = 3;
  private static final double EARLY_SHARE = .1;

  /**
   * The smallest number of samples in the smallest part of the picture that can hide an error as
   * large as the target.
   */
  private static final double FEWEST_IN_PART = 256;

  private StoppingSchedule() {}

  /**
   * Returns a number that grows whenever a check is due: after 4, 8, 16, 32, 48, 64, 96, 128, ...
   * samples per pixel; 0 before the first.
   *
   * @param samples mean number of samples per pixel
   */
  static int due(double samples) {
    if (samples < FIRST) {
      return 0;
    }
    if (isEarly(samples)) {
      return 1 + Math.getExponent(samples / FIRST);
    }
    int octave = Math.getExponent(samples / ANY_FRAME);
    boolean isUpperHalf = samples >= 1.5 * Math.scalb((double) ANY_FRAME, octave);
    return 1 + EARLY_LOOKS + 2 * octave + (isUpperHalf ? 1 : 0);
  }

  /** Returns whether a check after the given number of samples per pixel is an early one. */
  static boolean isEarly(double samples) {
    return samples < ANY_FRAME;
  }

  /**
   * Returns whether a number of samples per pixel is enough for a check; always true from 32 on.
   *
   * @param samples mean number of samples per pixel
   * @param pixels number of pixels of the frame
   * @param targetError relative root mean squared error
   */
  static boolean isEarlyEnough(double samples, double pixels, double targetError) {
    return !isEarly(samples) || samples * pixels * targetError * targetError >= FEWEST_IN_PART;
  }

  /** Returns the confidence of each early check. */
  static double earlyConfidence(double confidence) {
    return 1 - (1 - confidence) * EARLY_SHARE / EARLY_LOOKS;
  }

  /**
   * Returns the confidence of a check that is not early.
   *
   * @param confidence confidence of all checks together, in (0,1)
   * @param number number of the check, 1 for the first one after at least 32 samples per pixel
   */
  static double confidence(double confidence, int number) {
    double share = (1 - EARLY_SHARE) / ((double) number * (number + 1));
    return 1 - (1 - confidence) * share;
  }
}
