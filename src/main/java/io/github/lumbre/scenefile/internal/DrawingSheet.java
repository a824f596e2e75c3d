package io.github.lumbre.scenefile.internal;

import java.util.Optional;

/**
 * How lines are drawn on the pictures of a model.
 *
 * @param isAlone whether pictures show nothing but lines on white paper, which need no light
 * @param hasHidden whether hidden lines are dashed; otherwise they are left out
 * @param isInMillimeters whether vectors are in millimeters, instead of pixels
 * @param paper the size of the sheet; empty for that of the picture
 */
public record DrawingSheet(
    boolean isAlone, boolean hasHidden, boolean isInMillimeters, Optional<Paper> paper) {
  /** The side of a pixel in millimeters, as of CSS: 1/96 inch. */
  public static final double PIXEL = 25.4 / 96;

  /**
   * A sheet of paper, or a part of one.
   *
   * @param width in millimeters
   * @param height in millimeters
   */
  public record Paper(double width, double height) {
    /** Returns the number of pixels across. */
    public int columns() {
      return pixels(width);
    }

    /** Returns the number of rows of pixels. */
    public int rows() {
      return pixels(height);
    }

    /** Returns the least number of pixels that cover a length. */
    private static int pixels(double length) {
      return (int) Math.ceil(length / PIXEL - 1e-9);
    }
  }
}
