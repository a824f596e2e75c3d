package io.github.lumbre.render.internal;

/**
 * The lengths of the passes of a render. Passes end after 1, 2, 4, … samples per pixel up to 64,
 * then after each further 64. If a render is stopped, all pixels have similar sample counts; after
 * a complete pass, their samples are evenly distributed.
 */
public final class Passes {
  /** The maximum number of samples per pixel in one pass. */
  public static final int LONGEST = 64;

  private Passes() {}

  /**
   * Returns the number of samples per pixel after the next pass.
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
