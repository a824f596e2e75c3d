package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;

/**
 * Pixels that are spread evenly over the full frame, in columns and rows.
 *
 * @param width width of the full frame in pixels
 * @param height height of the full frame in pixels
 * @param columns number of columns, at least 1
 * @param rows number of rows, at least 1
 */
record PilotGrid(int width, int height, int columns, int rows) {
  /** Returns a grid of at most the given number of pixels, at least 1. */
  static PilotGrid of(RenderSettings settings, int most) {
    int width = settings.width();
    int height = settings.height();
    if ((long) width * height <= most) {
      return new PilotGrid(width, height, width, height);
    }
    double side = Math.sqrt(most * settings.aspect());
    int columns = (int) Math.max(1, Math.min(Math.min(width, most), side));
    int rows = Math.max(1, Math.min(height, most / columns));
    return new PilotGrid(width, height, columns, rows);
  }

  /** Returns the column, in the full frame, of the pixels of a column. */
  int x(int column) {
    return (int) ((2L * column + 1) * width / (2L * columns));
  }

  /** Returns the row, in the full frame, of the pixels of a row. */
  int y(int row) {
    return (int) ((2L * row + 1) * height / (2L * rows));
  }
}
