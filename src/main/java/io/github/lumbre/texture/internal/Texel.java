package io.github.lumbre.texture.internal;

/**
 * Finds the texel of a repeating texture that contains a point. A point that is not finite is
 * replaced with (0, 0).
 */
final class Texel {
  private Texel() {}

  /** Returns the column, counted from the left. Also counts invalid points. */
  static int column(double u, double v, int width) {
    if (!isFinite(u, v)) {
      InvalidCoordinates.count();
      return 0;
    }
    return index(u, width);
  }

  /** Returns the row, counted from the <b>top</b>. Does not count invalid points. */
  static int row(double u, double v, int height) {
    return height - 1 - (isFinite(u, v) ? index(v, height) : 0);
  }

  private static int index(double u, int size) {
    return Math.min((int) (size * fraction(u)), size - 1);
  }

  static boolean isFinite(double u, double v) {
    return Double.isFinite(u) && Double.isFinite(v);
  }

  /** Returns u - floor(u), in [0,1]. For tiny negative u, the result rounds to 1. */
  static double fraction(double u) {
    return u - Math.floor(u);
  }
}
