package generator;

import java.io.IOException;
import java.nio.file.Path;

/** A plate of raised lozenges with its colours, and normal maps of plaster and of rings. */
final class ReliefMaps {
  private static final int SIZE = 512;
  private static final int CELLS = 6;

  private ReliefMaps() {}

  static void writeAll(Path folder) throws IOException {
    Png.write(folder.resolve("tread-plate.png"), treadPlateColours());
    Png.write(
        folder.resolve("tread-plate-normal.png"), TilingMaps.normals(ReliefMaps::treadPlate));
    Png.write(folder.resolve("plaster-normal.png"), TilingMaps.normals(ReliefMaps::plaster));
    Png.write(folder.resolve("rings-normal.png"), TilingMaps.normals(ReliefMaps::rings));
  }

  /** Lozenges that lean left and right by turns, with a fine roughness over all. */
  private static double treadPlate(double u, double v) {
    double rough = .0006 * TilingMaps.wrapped(u, v, 64) + .0012 * TilingMaps.wrapped(u, v, 24);
    return .014 * lozenge(u, v) + rough;
  }

  /** 1 on a lozenge, 0 between them. */
  private static double lozenge(double u, double v) {
    int i = (int) Math.floor(u * CELLS);
    int j = (int) Math.floor(v * CELLS);
    double x = TilingMaps.fraction(u * CELLS) - .5;
    double y = TilingMaps.fraction(v * CELLS) - .5;
    boolean left = (i + j & 1) == 0;
    double along = left ? x + y : x - y;
    double across = left ? x - y : x + y;
    double width = .24 * (1 - along * along / .64);
    return width <= 0 ? 0 : Shapes.step(0, .55, 1 - Math.abs(across) / width);
  }

  /** Steel: brighter where the lozenges are worn, brown where dirt has settled. */
  private static Raster treadPlateColours() {
    Raster raster = new Raster(SIZE, SIZE);
    for (int row = 0; row < SIZE; row++) {
      for (int column = 0; column < SIZE; column++) {
        double u = (column + .5) / SIZE;
        double v = (SIZE - row - .5) / SIZE;
        double worn = lozenge(u, v) * (.4 + .6 * TilingMaps.wrapped(u, v, 5));
        double dirt = Shapes.step(.5, .85, TilingMaps.wrapped(u + .37, v + .21, 7));
        double grain = TilingMaps.wrapped(u, v, 96) * .2;
        int steel = mix(0x4A4B4E, 0xC4C4C2, .12 + grain + .7 * worn);
        raster.set(column, row, mix(steel, 0x6B5444, .55 * dirt * (1 - .7 * worn)));
      }
    }
    return raster;
  }

  /** Creases of several sizes, as of plaster thrown at a wall. */
  private static double plaster(double u, double v) {
    double sum = 0;
    double size = .03;
    for (int cells = 7; cells <= 56; cells *= 2) {
      sum += size * Math.abs(2 * TilingMaps.wrapped(u, v, cells) - 1);
      size *= .45;
    }
    return sum;
  }

  /** Ripples about the middle of a panel with a flat rim. */
  private static double rings(double u, double v) {
    double r = Math.sqrt((u - .5) * (u - .5) + (v - .5) * (v - .5));
    return .012 * StrictMath.cos(2 * Math.PI * 18 * r) * Shapes.step(.46, .40, r);
  }

  /** The colour the share {@code t} of the way from one 0xRRGGBB to another. */
  private static int mix(int from, int to, double t) {
    int colour = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int a = from >> shift & 255;
      int b = to >> shift & 255;
      colour = colour << 8 | (int) Math.rint(a + (b - a) * Math.max(0, Math.min(1, t)));
    }
    return colour;
  }
}
