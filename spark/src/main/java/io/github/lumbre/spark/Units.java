package io.github.lumbre.spark;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.List;

/** Divides what a pass lacks into units of about the same work. */
final class Units {
  /** The smallest and the largest side of a tile, in pixels. */
  private static final int SMALLEST = 16;

  static final int LARGEST = 256;

  private final Film film;
  private final SampleTarget target;
  private final long samplesPerUnit;
  private final List<WorkUnit> units = new ArrayList<>();

  private Units(Film film, SampleTarget target, long samplesPerUnit) {
    this.film = film;
    this.target = target;
    this.samplesPerUnit = samplesPerUnit;
  }

  /**
   * Returns the units that bring each pixel to its target, those of one tile in the order of their
   * samples.
   *
   * <p>A tile's first unit starts where its pixels are; no other unit has a power of two strictly
   * between its ends, so that {@link Film#addAll} keeps the estimate of the noise exact.
   *
   * @param samplesPerUnit samples over all pixels that a unit should have, at least 1
   */
  static List<WorkUnit> of(Film film, SampleTarget target, long samplesPerUnit) {
    Units all = new Units(film, target, samplesPerUnit);
    Crop window = film.window();
    int missing = Math.max(1, target.samples(window.x(), window.y()) - film.fewestSamples());
    int side = side(samplesPerUnit / missing);
    for (int y = 0; y < window.height(); y += side) {
      for (int x = 0; x < window.width(); x += side) {
        all.divide(
            window.x() + x,
            window.y() + y,
            Math.min(side, window.width() - x),
            Math.min(side, window.height() - y));
      }
    }
    return all.units;
  }

  /** Returns the next number of samples that has equally many of each pose. */
  private int whole(int samples) {
    return samples + Math.floorMod(-samples, film.poses());
  }

  /** Returns the largest power of two whose square is at most a number of pixels, within limits. */
  private static int side(long pixels) {
    int side = SMALLEST;
    while (side < LARGEST && 4L * side * side <= pixels) {
      side *= 2;
    }
    return side;
  }

  /**
   * Adds the units of a tile; halves it as long as its pixels have different numbers of samples.
   */
  private void divide(int x, int y, int width, int height) {
    int have = film.samples(x, y);
    int want = whole(target.samples(x, y));
    for (int row = y; row < y + height; row++) {
      for (int column = x; column < x + width; column++) {
        if (film.samples(column, row) != have || whole(target.samples(column, row)) != want) {
          boolean isWide = width >= height;
          int w = isWide ? width / 2 : width;
          int h = isWide ? height : height / 2;
          divide(x, y, w, h);
          divide(
              isWide ? x + w : x,
              isWide ? y : y + h,
              width - (isWide ? w : 0),
              height - (isWide ? 0 : h));
          return;
        }
      }
    }
    // All poses of a scene in motion.
    int poses = film.poses();
    long most = Math.max(1, samplesPerUnit / ((long) width * height * poses)) * poses;
    for (int first = have; first < want; ) {
      int end = (int) Math.min(want, first + most);
      if (first > 0) {
        // Not beyond the next power of two.
        end = Math.min(end, first < 1 << 29 ? 2 * Integer.highestOneBit(first) : end);
      }
      units.add(new WorkUnit(x, y, width, height, film.firstSample() + first, end - first));
      first = end;
    }
  }
}
