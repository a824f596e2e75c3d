package io.github.lumbre.texture.internal;

/**
 * The four texels around a point of a texture, and the point's position between their centers.
 *
 * @param x0 the column of the left two texels, counted from the left
 * @param x1 the column of the right two texels
 * @param y0 the row of two texels, counted from the <b>top</b>
 * @param y1 the row of the other two
 * @param s the weight of the right two texels, in [0,1]
 * @param t the weight of the other two texels, in [0,1]
 */
record Bilinear(int x0, int x1, int y0, int y1, double s, double t) {
  /**
   * Returns the texels around a point of a repeating texture, the lower two first. A point that is
   * not finite is counted as invalid and replaced with (0, 0).
   */
  static Bilinear around(double u, double v, int width, int height) {
    boolean isReadable = Texel.isFinite(u, v);
    if (!isReadable) {
      InvalidCoordinates.count();
    }
    // Count from the centers of the left column and the bottom row.
    double column = width * (isReadable ? Texel.fraction(u) : 0) - .5;
    double row = height * (isReadable ? Texel.fraction(v) : 0) - .5;
    double left = Math.floor(column);
    double bottom = Math.floor(row);
    int x0 = left < 0 ? width - 1 : (int) left;
    int y0 = bottom < 0 ? 0 : height - 1 - (int) bottom;
    return new Bilinear(
        x0,
        x0 + 1 < width ? x0 + 1 : 0,
        y0,
        y0 > 0 ? y0 - 1 : height - 1,
        column - left,
        row - bottom);
  }

  /**
   * Interpolates bilinearly between four values: left and right of the one row, then of the other.
   */
  double blend(double v00, double v10, double v01, double v11) {
    return mix(mix(v00, v10, s), mix(v01, v11, s), t);
  }

  /** Returns a + t (b - a). */
  static double mix(double a, double b, double t) {
    return a + t * (b - a);
  }
}
