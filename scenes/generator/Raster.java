package generator;

/** A picture of 0xRRGGBB texels, row 0 at the top. Mutable. */
final class Raster {
  final int width;
  final int height;
  private final int[] texels;

  Raster(int width, int height) {
    this.width = width;
    this.height = height;
    texels = new int[width * height];
  }

  int get(int x, int y) {
    return texels[y * width + x];
  }

  void set(int x, int y, int rgb) {
    texels[y * width + x] = rgb;
  }

  /** A normal with components in [-1, 1] as a texel: byte 128 is 0, byte 255 is 1. */
  static int normal(double x, double y, double z) {
    return encode(x) << 16 | encode(y) << 8 | encode(z);
  }

  private static int encode(double a) {
    return Math.max(1, Math.min(255, (int) Math.rint(128 + 127 * a)));
  }
}
