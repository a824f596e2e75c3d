package io.github.lumbre.image;

import java.util.Arrays;
import java.util.List;

/** Joins pictures of one size into one picture, in rows from the top left. Stateless. */
public final class ContactSheet {
  private ContactSheet() {}

  /**
   * Returns the sheet. Cells of the last row without a picture are white, or transparent if any
   * picture has alpha.
   *
   * @param pictures at least one, all of the same size
   * @param columns pictures per row, at least 1
   * @throws IllegalArgumentException if the sizes differ, or the sheet has more than 2^28 pixels
   */
  public static Image of(List<Image> pictures, int columns) {
    if (pictures.isEmpty() || columns < 1) {
      throw new IllegalArgumentException(
          "pictures, columns: expected at least 1, found " + pictures.size() + ", " + columns);
    }
    int width = pictures.get(0).width();
    int height = pictures.get(0).height();
    int rows = (pictures.size() + columns - 1) / columns;
    long pixels = (long) width * columns * height * rows;
    if (pixels > ImageReader.MAX_PIXELS) {
      throw new IllegalArgumentException(
          "pictures: expected a sheet of at most 2^28 pixels, found " + pixels);
    }
    float[] rgb = new float[(int) (3 * pixels)];
    boolean hasAlpha = pictures.stream().anyMatch(Image::hasAlpha);
    float[] alpha = new float[hasAlpha ? (int) pixels : 0];
    for (int i = 0; i < pictures.size(); i++) {
      Image picture = pictures.get(i);
      if (picture.width() != width || picture.height() != height) {
        throw new IllegalArgumentException("pictures: expected one size, found several");
      }
      int start = i / columns * height * width * columns + i % columns * width;
      for (int y = 0; y < height; y++) {
        int row = start + y * width * columns;
        System.arraycopy(picture.rgb(), 3 * y * width, rgb, 3 * row, 3 * width);
        for (int x = 0; x < width && hasAlpha; x++) {
          alpha[row + x] = picture.alpha(x, y);
        }
      }
    }
    if (!hasAlpha) {
      int inLastRow = pictures.size() - columns * (rows - 1);
      whiten(rgb, width * columns, height * (rows - 1), width * inLastRow);
    }
    return new Image(width * columns, height * rows, rgb, alpha);
  }

  /** Makes the pixels below and to the right of a point white. */
  private static void whiten(float[] rgb, int width, int top, int left) {
    for (int y = top; y < rgb.length / 3 / width; y++) {
      Arrays.fill(rgb, 3 * (y * width + left), 3 * (y + 1) * width, 1);
    }
  }
}
