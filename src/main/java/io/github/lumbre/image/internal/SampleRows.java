package io.github.lumbre.image.internal;

/** The rows of a quantized picture. */
public interface SampleRows {
  /** The number of columns. */
  int width();

  int height();

  /** The number of values of a pixel: 1 for gray, 3 for RGB, 4 for RGB with straight alpha. */
  int bands();

  /** The bits of a value, 8 or 16. */
  int bits();

  /**
   * Reads a row.
   *
   * @param y row from the top
   * @param row receives the values, 0 to 2^bits - 1, all channels of a pixel together
   */
  void read(int y, int[] row);
}
