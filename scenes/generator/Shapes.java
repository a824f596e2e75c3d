package generator;

/** Profiles that reliefs and colours are put together from. */
final class Shapes {
  private Shapes() {}

  /** A groove of the given half width: 0 away from it, -depth in its middle. */
  static double groove(double distance, double halfWidth, double depth) {
    double q = distance / halfWidth;
    return Math.abs(q) >= 1 ? 0 : -depth * (1 - q * q) * (1 - q * q);
  }

  /** A round knob: 0 from its radius outwards. */
  static double knob(double distance, double radius, double height) {
    double q = distance / radius;
    return Math.abs(q) >= 1 ? 0 : height * Math.sqrt(1 - q * q);
  }

  /** 0 below {@code from}, 1 above {@code to}, smooth between. */
  static double step(double from, double to, double value) {
    double t = Math.max(0, Math.min(1, (value - from) / (to - from)));
    return t * t * (3 - 2 * t);
  }

  /** The distance from the edge of the honeycomb cell, for cells one unit across the flats. */
  static double honeycomb(double u, double v) {
    double row = Math.sqrt(3);
    double au = u - Math.rint(u);
    double av = v - row * Math.rint(v / row);
    double bu = u - Math.floor(u) - .5;
    double bv = v - row * Math.floor(v / row) - row / 2;
    boolean first = au * au + av * av < bu * bu + bv * bv;
    double x = Math.abs(first ? au : bu);
    double y = Math.abs(first ? av : bv);
    return .5 - Math.max(x, x / 2 + y * row / 2);
  }

  /** The distance from {@code value} to the nearest multiple of {@code period}. */
  static double toMultiple(double value, double period) {
    return Math.abs(value - period * Math.rint(value / period));
  }

  /** A whole number in [0, 2^31) that depends on the cell alone. */
  static int hash(int x, int y, int z) {
    int h = x * 0x8da6b343 ^ y * 0xd8163841 ^ z * 0xcb1ab31f;
    h = (h ^ h >>> 16) * 0x7feb352d;
    h = (h ^ h >>> 15) * 0x846ca68b;
    return (h ^ h >>> 16) & 0x7fffffff;
  }

  /** Smooth noise in [0, 1) with a feature size of one unit. */
  static double noise(double x, double y, double z) {
    int ix = (int) Math.floor(x);
    int iy = (int) Math.floor(y);
    int iz = (int) Math.floor(z);
    double sum = 0;
    for (int c = 0; c < 8; c++) {
      int dx = c & 1;
      int dy = c >> 1 & 1;
      int dz = c >> 2;
      double wx = step(0, 1, x - ix);
      double wy = step(0, 1, y - iy);
      double wz = step(0, 1, z - iz);
      double weight = (dx == 1 ? wx : 1 - wx) * (dy == 1 ? wy : 1 - wy) * (dz == 1 ? wz : 1 - wz);
      sum += weight * hash(ix + dx, iy + dy, iz + dz) / 2147483648.0;
    }
    return sum;
  }
}
