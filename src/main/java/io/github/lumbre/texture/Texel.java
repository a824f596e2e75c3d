package io.github.lumbre.texture;

/**
 * Which texel of a repeating texture a point lies in. A point that is not finite counts as (0, 0).
 */
final class Texel {
  private Texel() {}

  /** Returns the column, counted from the left; counts points that are not finite. */
  static int column(TexturePoint p, int width) {
    if (!isFinite(p)) {
      UnreadablePoints.count();
      return 0;
    }
    return index(p.u(), width);
  }

  /** Returns the row, counted from the <b>top</b>. */
  static int row(TexturePoint p, int height) {
    return height - 1 - (isFinite(p) ? index(p.v(), height) : 0);
  }

  private static int index(double u, int size) {
    return Math.min((int) (size * fraction(u)), size - 1);
  }

  static boolean isFinite(TexturePoint p) {
    return Double.isFinite(p.u()) && Double.isFinite(p.v());
  }

  /** Returns u - floor(u), in [0,1]: of a tiny negative u it rounds to 1. */
  static double fraction(double u) {
    return u - Math.floor(u);
  }
}
