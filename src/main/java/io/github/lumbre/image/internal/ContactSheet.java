package io.github.lumbre.image.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageReader;
import java.util.Arrays;
import java.util.List;

/**
 * A picture of cells of one size, in rows from the top left. Gaps and what no picture covers are
 * white, or transparent if any picture has alpha. Mutable; for one thread.
 */
public final class ContactSheet {
  private final Grid grid;
  private final float[] rgb;

  /** Alpha of the sheet; empty if it has none. */
  private final float[] alpha;

  /**
   * The places of the cells.
   *
   * @param cells number of cells, at least 1
   * @param columns cells per row, at least 1
   * @param width width of a cell in pixels, at least 1
   * @param height height of a cell in pixels, at least 1
   * @param gap width of the gaps between two cells in pixels, at least 0
   */
  public record Grid(int cells, int columns, int width, int height, int gap) {
    /**
     * @throws IllegalArgumentException if a number is out of range
     */
    public Grid {
      if (cells < 1 || columns < 1 || width < 1 || height < 1 || gap < 0) {
        throw new IllegalArgumentException(
            "cells, columns, width, height, gap: expected at least 1, 1, 1, 1 and 0, found"
                + " %d, %d, %d, %d, %d".formatted(cells, columns, width, height, gap));
      }
    }

    /** Returns the number of rows. */
    public int rows() {
      return (cells + columns - 1) / columns;
    }

    /** Returns the width of the sheet in pixels. */
    public long sheetWidth() {
      return (long) columns * (width + gap) - gap;
    }

    /** Returns the height of the sheet in pixels. */
    public long sheetHeight() {
      return (long) rows() * (height + gap) - gap;
    }

    /** Returns the number of pixels of the sheet; {@link Long#MAX_VALUE} if that is too large. */
    public long pixels() {
      return sheetWidth() > Long.MAX_VALUE / sheetHeight()
          ? Long.MAX_VALUE
          : sheetWidth() * sheetHeight();
    }

    /** Returns the column of the sheet at which a cell begins. */
    public int left(int cell) {
      return cell % columns * (width + gap);
    }

    /** Returns the row of the sheet at which a cell begins. */
    public int top(int cell) {
      return cell / columns * (height + gap);
    }
  }

  /**
   * Creates an empty sheet.
   *
   * @param hasAlpha whether a picture has alpha
   * @throws IllegalArgumentException if the sheet has more than 2^28 pixels
   */
  public ContactSheet(Grid grid, boolean hasAlpha) {
    if (grid.pixels() > ImageReader.MAX_PIXELS) {
      throw new IllegalArgumentException(
          "pictures: expected a sheet of at most 2^28 pixels, found " + grid.pixels());
    }
    this.grid = grid;
    int pixels = (int) grid.pixels();
    rgb = new float[3 * pixels];
    alpha = new float[hasAlpha ? pixels : 0];
    Arrays.fill(rgb, hasAlpha ? 0 : 1);
  }

  /**
   * Returns the sheet of pictures without free cells between them.
   *
   * @param pictures at least one, all of the same size
   * @param columns pictures per row, at least 1
   * @param gap width of the gaps between two pictures in pixels, at least 0
   * @throws IllegalArgumentException if the sizes differ, or the sheet has more than 2^28 pixels
   */
  public static Image of(List<Image> pictures, int columns, int gap) {
    if (pictures.isEmpty()) {
      throw new IllegalArgumentException("pictures: expected at least 1, found 0");
    }
    int width = pictures.get(0).width();
    int height = pictures.get(0).height();
    if (pictures.stream().anyMatch(p -> p.width() != width || p.height() != height)) {
      throw new IllegalArgumentException("pictures: expected one size, found several");
    }
    ContactSheet sheet =
        new ContactSheet(
            new Grid(pictures.size(), columns, width, height, gap),
            pictures.stream().anyMatch(Image::hasAlpha));
    for (int i = 0; i < pictures.size(); i++) {
      sheet.put(i, 0, 0, pictures.get(i));
    }
    return sheet.image();
  }

  /**
   * Copies a picture into a cell.
   *
   * @param x column of the cell at which the picture begins
   * @param y row of the cell at which the picture begins
   * @throws IllegalArgumentException if the picture is not inside the cell, or has alpha and the
   *     sheet has none
   */
  public void put(int cell, int x, int y, Image picture) {
    boolean isInside = x >= 0 && y >= 0;
    if (!isInside || x > grid.width - picture.width() || y > grid.height - picture.height()) {
      throw new IllegalArgumentException(
          "picture: expected one inside of %dx%d, found %dx%d at %d,%d"
              .formatted(grid.width, grid.height, picture.width(), picture.height(), x, y));
    }
    if (picture.hasAlpha() && alpha.length == 0) {
      throw new IllegalArgumentException("picture: expected one without alpha");
    }
    int stride = (int) grid.sheetWidth();
    int start = grid.left(cell) + x + (grid.top(cell) + y) * stride;
    int width = picture.width();
    for (int row = 0; row < picture.height(); row++) {
      int to = start + row * stride;
      System.arraycopy(picture.rgb(), 3 * row * width, rgb, 3 * to, 3 * width);
      for (int column = 0; column < width && alpha.length > 0; column++) {
        alpha[to + column] = picture.alpha(column, row);
      }
    }
  }

  /** Returns the sheet. Call it once, at the end. */
  public Image image() {
    return new Image((int) grid.sheetWidth(), (int) grid.sheetHeight(), rgb, alpha);
  }
}
