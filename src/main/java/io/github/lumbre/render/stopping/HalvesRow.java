package io.github.lumbre.render.stopping;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PixelHalves;
import java.util.Optional;

/**
 * The halves of the samples of a row of pixels, and their means.
 *
 * @param halves the halves from left to right; empty if those of a pixel are unknown
 * @param means the mean of all samples of each pixel, three values per pixel
 */
record HalvesRow(PixelHalves[] halves, double[] means) {
  /** The row above the first and below the last. */
  static final HalvesRow NONE = new HalvesRow(new PixelHalves[0], new double[0]);

  /** Returns the row of a film with the given y coordinate in the full frame. */
  static HalvesRow of(Film film, int y) {
    int width = film.window().width();
    PixelHalves[] halves = new PixelHalves[width];
    double[] means = new double[3 * width];
    for (int x = 0; x < width; x++) {
      Optional<PixelHalves> both = film.halves(film.window().x() + x, y);
      if (both.isEmpty()) {
        return NONE;
      }
      halves[x] = both.get();
      Rgb mean = halves[x].mean();
      means[3 * x] = mean.r();
      means[3 * x + 1] = mean.g();
      means[3 * x + 2] = mean.b();
    }
    return new HalvesRow(halves, means);
  }

  boolean isKnown() {
    return halves.length > 0;
  }

  int width() {
    return halves.length;
  }

  PixelHalves halves(int x) {
    return halves[x];
  }

  /**
   * Returns the mean of the up to eight pixels around a pixel, without the pixel itself; black if
   * there are none.
   */
  static Rgb surroundings(HalvesRow above, HalvesRow row, HalvesRow below, int x) {
    double[] sum = new double[3];
    int count = 0;
    for (int i = Math.max(0, x - 1); i <= Math.min(row.width() - 1, x + 1); i++) {
      count += above.addTo(sum, i) + below.addTo(sum, i) + (i == x ? 0 : row.addTo(sum, i));
    }
    double each = 1.0 / Math.max(1, count);
    return new Rgb(each * sum[0], each * sum[1], each * sum[2]);
  }

  /** Adds the mean of a pixel to a sum, and returns the number of added pixels: 0 or 1. */
  private int addTo(double[] sum, int x) {
    if (!isKnown()) {
      return 0;
    }
    for (int c = 0; c < 3; c++) {
      sum[c] += means[3 * x + c];
    }
    return 1;
  }
}
