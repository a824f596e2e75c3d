package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.Flip;
import java.util.Locale;

/**
 * How a picture differs from a golden one of the same size.
 *
 * @param flip mean of LDR-FLIP over all pixels
 * @param tile mean of LDR-FLIP in the worst tile
 * @param left column of the worst tile's first pixel
 * @param top row of the worst tile's first pixel
 * @param pixels number of pixels with other values
 */
record Difference(double flip, double tile, int left, int top, int pixels) {
  static boolean haveSameSize(GoldenFile.Encoded actual, GoldenFile.Encoded expected) {
    Image found = actual.image();
    Image wanted = expected.image();
    return found.width() == wanted.width() && found.height() == wanted.height();
  }

  /** Returns the difference of two pictures of the same size. */
  static Difference of(GoldenFile.Encoded actual, GoldenFile.Encoded expected) {
    Image found = actual.image();
    double[] tiles = Flip.tiles(found, expected.image(), GoldenPictures.TILE);
    int worst = 0;
    for (int i = 1; i < tiles.length; i++) {
      worst = tiles[i] > tiles[worst] ? i : worst;
    }
    int across = (found.width() + GoldenPictures.TILE - 1) / GoldenPictures.TILE;
    return new Difference(
        Flip.mean(found, expected.image()),
        tiles[worst],
        worst % across * GoldenPictures.TILE,
        worst / across * GoldenPictures.TILE,
        expected.differences(actual));
  }

  /**
   * Returns whether the difference is allowed.
   *
   * @param tolerance with 0, no difference is
   */
  boolean isWithin(double tolerance) {
    return tolerance > 0 && flip <= tolerance && tile <= tileTolerance(tolerance);
  }

  private static double tileTolerance(double tolerance) {
    return Math.min(1, GoldenPictures.TILE_FACTOR * tolerance);
  }

  /** Returns the difference in words. */
  String text(double tolerance, Image picture) {
    return String.format(
        Locale.ROOT,
        "mean FLIP %.4f, tolerance %.4f; in the tile at pixel (%d,%d) %.4f, tolerance %.4f;"
            + " %d of %d pixels differ",
        flip,
        tolerance,
        left,
        top,
        tile,
        tileTolerance(tolerance),
        pixels,
        picture.width() * picture.height());
  }
}
