package io.github.lumbre.image.internal;

import java.awt.image.BufferedImage;

/** Turns pictures for display into pictures of Java. Stateless. */
public final class DisplayPicture {
  private static final int WITH_ALPHA = 4;

  private DisplayPicture() {}

  /**
   * Returns a picture of bytes.
   *
   * @param rows of 8 bits: red, green and blue, or these with straight alpha
   */
  public static BufferedImage of(SampleRows rows) {
    int type =
        rows.bands() == WITH_ALPHA ? BufferedImage.TYPE_4BYTE_ABGR : BufferedImage.TYPE_3BYTE_BGR;
    BufferedImage picture = new BufferedImage(rows.width(), rows.height(), type);
    int[] row = new int[rows.bands() * rows.width()];
    for (int y = 0; y < rows.height(); y++) {
      rows.read(y, row);
      picture.getRaster().setPixels(0, y, rows.width(), 1, row);
    }
    return picture;
  }
}
