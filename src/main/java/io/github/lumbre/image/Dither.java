package io.github.lumbre.image;

/**
 * Ordered dithering of an 8-bit picture for display, so that smooth gradients have no bands: a fixed
 * pattern of 8x8 thresholds decides which of the two steps around a value is written (Bayer, <i>An
 * optimum method for two-level rendition of continuous-tone pictures</i>, 1973). The mean of 8x8
 * pixels of one value is that value within .02 of a step; values that lie on a step keep it, such as
 * white and flat backgrounds. Alpha is rounded.
 *
 * <p>The pattern is placed by the full frame, so that parts of a picture have the same pixels as the
 * whole.
 *
 * @param left column of the full frame that is the picture's first one
 * @param top row of the full frame that is the picture's first one
 */
public record Dither(int left, int top) {
  /** The dithering of a full frame. */
  public static final Dither FULL_FRAME = new Dither(0, 0);

  /**
   * Returns which part of the way to the next step a value must have reached to be written as that
   * step: (2 k + 1) / 128 with each k from 0 to 63 once in 8x8 pixels.
   *
   * @param x column of the picture
   * @param y row of the picture
   */
  public double threshold(int x, int y) {
    int column = x + left;
    int row = y + top;
    int rank = 0;
    for (int bit = 0; bit < 3; bit++) {
      int differs = (column ^ row) >> bit & 1;
      rank = rank << 2 | differs << 1 | row >> bit & 1;
    }
    return (2 * rank + 1) / 128.0;
  }
}
