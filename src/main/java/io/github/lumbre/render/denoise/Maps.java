package io.github.lumbre.render.denoise;

/**
 * Some rows of planes of values, with a border of one pixel of zeros around each plane.
 *
 * <p>Maps are not synchronized: threads that work on different rows may share them.
 */
final class Maps {
  private final int width;
  private final int top;
  private final int stride;
  private final float[][] planes;

  /**
   * @param width pixels in a row
   * @param top the first row
   * @param rows number of rows
   * @param count number of planes
   */
  Maps(int width, int top, int rows, int count) {
    this.width = width;
    this.top = top;
    this.stride = width + 2;
    planes = new float[count][Math.multiplyExact(rows + 2, stride)];
  }

  int width() {
    return width;
  }

  /** Returns the distance of a pixel from the one above it. */
  int stride() {
    return stride;
  }

  int count() {
    return planes.length;
  }

  float[] plane(int index) {
    return planes[index];
  }

  /** Returns the index of a row's first pixel; rows may be one above or below those it has. */
  int at(int row) {
    return (row - top + 1) * stride + 1;
  }
}
