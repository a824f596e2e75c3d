package io.github.lumbre.image.format.pfm;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.PictureEncoder;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Writes portable float maps: a text header, then little-endian floats, rows from the bottom to the
 * top (Debevec 2001, "PFM: Portable FloatMap Image Format").
 */
public final class PfmWriter {
  private PfmWriter() {}

  public static void write(Image image, OutputStream out) throws IOException {
    // A negative scale means little-endian.
    String header = "PF\n" + image.width() + " " + image.height() + "\n-1.0\n";
    out.write(header.getBytes(StandardCharsets.US_ASCII));
    int values = 3 * image.width();
    ByteBuffer row = ByteBuffer.allocate(4 * values).order(ByteOrder.LITTLE_ENDIAN);
    for (int y = image.height() - 1; y >= 0; y--) {
      row.clear();
      for (int i = 0; i < values; i++) {
        row.putFloat(PictureEncoder.finite(image.rgb()[y * values + i]));
      }
      out.write(row.array());
    }
  }
}
