package io.github.lumbre.render;

/**
 * Where the passes over a picture end: after 1, 2, 4, ... samples per pixel up to 64, then after
 * each further 64. A picture whose render is stopped has about as many samples in every pixel, and
 * after a whole pass samples of even spread.
 */
public final class Passes {
  /** The most samples per pixel in one pass. */
  public static final int LONGEST = 64;

  private Passes() {}

  /**
   * Returns how many samples per pixel there are after the next pass.
   *
   * @param done samples per pixel so far, at least 0
   * @param goal samples per pixel at the end, more than {@code done}
   */
  public static int next(int done, int goal) {
    int end =
        done < LONGEST
            ? Math.max(1, 2 * Integer.highestOneBit(done))
            : (done / LONGEST + 1) * LONGEST;
    return Math.min(end, goal);
  }
}
