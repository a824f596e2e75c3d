package io.github.lumbre.spark;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.Serializable;

/**
 * Consecutive samples of all pixels of a tile.
 *
 * @param x left edge of the tile in the full frame, in pixels
 * @param y top edge of the tile in the full frame, in pixels
 * @param first index of the first sample of each pixel
 * @param count samples per pixel, at least 1
 */
record WorkUnit(int x, int y, int width, int height, int first, int count) implements Serializable {
  /** Returns the tile. */
  Crop tile() {
    return new Crop(x, y, width, height);
  }

  /** Returns the number of samples over all pixels. */
  long samples() {
    return (long) width * height * count;
  }

  @Override
  public String toString() {
    return "samples %d to %d of %dx%d pixels at %d,%d"
        .formatted(first, first + count - 1, width, height, x, y);
  }
}
