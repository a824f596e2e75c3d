package io.github.lumbre.image.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageReader;
import java.util.Arrays;
import java.util.List;

/** Joins pictures of one size into one picture, in rows from the top left. Stateless. */
public final class ContactSheet {
  private ContactSheet() {}

  /**
   * Returns the sheet. Gaps and cells without a picture are white, or transparent if any picture
   * has alpha.
   *
   * @param pictures at least one, all of the same size
   * @param columns pictures per row, at least 1
   * @param gap width of the gaps between two pictures in pixels, at least 0
   * @throws IllegalArgumentException if the sizes differ, or the sheet has more than 2^28 pixels
   */
  public static Image of(List<Image> pictures, int columns, int gap) {
    if (pictures.isEmpty() || columns < 1 || gap < 0) {
      throw new IllegalArgumentException(
          "pictures, columns, gap: expected at least 1, 1 and 0, found %d, %d, %d"
              .formatted(pictures.size(), columns, gap));
    }
    int width = pictures.get(0).width();
    int height = pictures.get(0).height();
    if (pictures.stream().anyMatch(p -> p.width() != width || p.height() != height)) {
      throw new IllegalArgumentException("pictures: expected one size, found several");
    }
    int rows = (pictures.size() + columns - 1) / columns;
    long sheetWidth = (long) columns * (width + gap) - gap;
    long sheetHeight = (long) rows * (height + gap) - gap;
    if (sheetWidth * sheetHeight > ImageReader.MAX_PIXELS) {
      throw new IllegalArgumentException(
          "pictures: expected a sheet of at most 2^28 pixels, found " + sheetWidth * sheetHeight);
    }
    boolean hasAlpha = pictures.stream().anyMatch(Image::hasAlpha);
    int pixels = (int) (sheetWidth * sheetHeight);
    float[] rgb = new float[3 * pixels];
    float[] alpha = new float[hasAlpha ? pixels : 0];
    Arrays.fill(rgb, hasAlpha ? 0 : 1);
    for (int i = 0; i < pictures.size(); i++) {
      int left = i % columns * (width + gap);
      int start = left + i / columns * (height + gap) * (int) sheetWidth;
      copy(pictures.get(i), rgb, alpha, start, (int) sheetWidth);
    }
    return new Image((int) sheetWidth, (int) sheetHeight, rgb, alpha);
  }

  /**
   * Copies a picture into a sheet.
   *
   * @param alpha of the sheet; empty if it has none
   * @param start index of the sheet's pixel for the top left corner of the picture
   * @param stride width of the sheet
   */
  private static void copy(Image picture, float[] rgb, float[] alpha, int start, int stride) {
    int width = picture.width();
    for (int y = 0; y < picture.height(); y++) {
      int row = start + y * stride;
      System.arraycopy(picture.rgb(), 3 * y * width, rgb, 3 * row, 3 * width);
      for (int x = 0; x < width && alpha.length > 0; x++) {
        alpha[row + x] = picture.alpha(x, y);
      }
    }
  }
}
