package generator;

import java.io.IOException;
import java.nio.file.Path;

/** Maps that repeat without a seam: normal maps of heights over the unit square, and masks. */
final class TilingMaps {
  private static final int SIZE = 512;

  /** A height over the unit square, in units of its side; repeats beyond it. */
  interface Height {
    double at(double u, double v);
  }

  private TilingMaps() {}

  static void write(Path folder) throws IOException {
    Png.write(folder.resolve("checker-normal.png"), normals(TilingMaps::checker));
    Png.write(folder.resolve("brick-normal.png"), normals(TilingMaps::brick));
    Png.write(folder.resolve("tile-normal.png"), normals(TilingMaps::tile));
    Png.write(folder.resolve("hexagon-normal.png"), normals(TilingMaps::hexagon));
    Png.write(folder.resolve("fabric-normal.png"), normals(TilingMaps::fabric));
    Png.write(folder.resolve("star.png"), star(128));
  }

  static Raster normals(Height height) {
    Raster raster = new Raster(SIZE, SIZE);
    double e = .5 / SIZE;
    for (int y = 0; y < SIZE; y++) {
      for (int x = 0; x < SIZE; x++) {
        double u = (x + .5) / SIZE;
        double v = (SIZE - y - .5) / SIZE;
        double du = (height.at(u + e, v) - height.at(u - e, v)) / (2 * e);
        double dv = (height.at(u, v + e) - height.at(u, v - e)) / (2 * e);
        double scale = 1 / Math.sqrt(1 + du * du + dv * dv);
        raster.set(x, y, Raster.normal(-du * scale, -dv * scale, scale));
      }
    }
    return raster;
  }

  static double fraction(double a) {
    return a - Math.floor(a);
  }

  /** The distance from the edge of a rectangle of w x h at a place within it. */
  private static double inset(double x, double y, double w, double h) {
    return Math.min(Math.min(x, w - x), Math.min(y, h - y));
  }

  /** 4 x 4 squares, every other one raised. */
  private static double checker(double u, double v) {
    int i = (int) Math.floor(u * 4);
    int j = (int) Math.floor(v * 4);
    double d = inset(fraction(u * 4), fraction(v * 4), 1, 1) / 4;
    return (i + j & 1) == 0 ? .016 * Shapes.step(0, .022, d) : 0;
  }

  /** 4 bricks across in 8 courses, each a little tilted and rough. */
  private static double brick(double u, double v) {
    int course = Math.floorMod((int) Math.floor(v * 8), 8);
    double along = u * 4 + (course % 2) * .5;
    int number = Math.floorMod((int) Math.floor(along), 4);
    double d = inset(fraction(along) / 4, fraction(v * 8) / 8, 1 / 4.0, 1 / 8.0);
    double lift = .9 + .2 * Shapes.hash(number, course, 5) / 2147483648.0;
    double tilt = (Shapes.hash(number, course, 7) / 2147483648.0 - .5) * (fraction(along) - .5);
    double rough = .0016 * wrapped(u, v, 48) + .003 * wrapped(u, v, 20);
    double face = Shapes.step(.004, .016, d + .006 * (wrapped(u, v, 40) - .5));
    return face * (.012 * lift + .012 * tilt + rough) + .001 * wrapped(u, v, 64);
  }

  /** Smooth noise of so many cells over the unit square, which it repeats. */
  static double wrapped(double u, double v, int cells) {
    double x = fraction(u) * cells;
    double y = fraction(v) * cells;
    int i = (int) x;
    int j = (int) y;
    double s = Shapes.step(0, 1, x - i);
    double t = Shapes.step(0, 1, y - j);
    double low = lattice(i, j, cells) * (1 - s) + lattice(i + 1, j, cells) * s;
    double high = lattice(i, j + 1, cells) * (1 - s) + lattice(i + 1, j + 1, cells) * s;
    return low * (1 - t) + high * t;
  }

  private static double lattice(int i, int j, int cells) {
    return Shapes.hash(i % cells, j % cells, cells) / 2147483648.0;
  }

  /** 4 x 4 pillowed tiles with joints between them. */
  private static double tile(double u, double v) {
    double d = inset(fraction(u * 4), fraction(v * 4), 1, 1) / 4;
    return d < .006 ? 0 : .016 * Math.sqrt(Shapes.step(.004, .034, d));
  }

  /** Plates of six sides, 8 across in 10 rows, so that they are only a little out of shape. */
  private static double hexagon(double u, double v) {
    double row = Math.sqrt(3) / 2;
    double d = Shapes.honeycomb(u * 8, v * 10 * row) / 8;
    return .012 * Shapes.step(.003, .016, d) + .006 * Shapes.step(.02, .06, d);
  }

  /** A plain weave of 16 x 16 threads each way. */
  private static double fabric(double u, double v) {
    double x = u * 16;
    double y = v * 16;
    int over = (int) Math.floor(x) + (int) Math.floor(y) & 1;
    double across = fraction(over == 0 ? y : x) - .5;
    double along = fraction(over == 0 ? x : y) - .5;
    double thread = Math.sqrt(Math.max(0, 1 - 4.4 * across * across));
    double strands = .06 * StrictMath.cos(2 * Math.PI * (across * 5 + along * .8));
    double bow = StrictMath.cos(Math.PI * along);
    return .011 * thread * (.45 + .55 * bow + strands * bow);
  }

  /** A white star of five points on black. */
  private static Raster star(int size) {
    Raster raster = new Raster(size, size);
    double inner = .382;
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        double px = (x + .5) / size * 2 - 1;
        double py = 1 - (y + .5) / size * 2 + .05;
        double a = StrictMath.atan2(px, py) / (2 * Math.PI) * 5;
        double turn = Math.abs(a - Math.rint(a)) * 2 * Math.PI / 5;
        double r = StrictMath.hypot(px, py) / .98;
        double ex = inner * StrictMath.cos(Math.PI / 5) - 1;
        double ey = inner * StrictMath.sin(Math.PI / 5);
        double qx = r * StrictMath.cos(turn) - 1;
        double qy = r * StrictMath.sin(turn);
        raster.set(x, y, ex * qy - ey * qx > 0 ? 0xffffff : 0);
      }
    }
    return raster;
  }
}
