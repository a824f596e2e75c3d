package io.github.lumbre.image.format.pfm;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Reads portable float maps in either byte order, in color or gray (Debevec 2001, "PFM: Portable
 * FloatMap Image Format"). The absolute value of the scale is ignored, because programs disagree
 * about its meaning.
 */
public final class PfmReader {
  private static final int MAX_TOKEN = 64;

  private final byte[] file;
  private int position = 2;

  private PfmReader(byte[] file) {
    this.file = file;
  }

  public static boolean startsIn(byte[] file) {
    return file.length > 2
        && file[0] == 'P'
        && (file[1] == 'F' || file[1] == 'f')
        && Character.isWhitespace(file[2]);
  }

  /** Reads a file that {@link #startsIn} recognizes. */
  public static LinearPicture read(byte[] file, long maxPixels) throws ImageFormatException {
    return new PfmReader(file).read(maxPixels);
  }

  private LinearPicture read(long maxPixels) throws ImageFormatException {
    int channels = file[1] == 'F' ? 3 : 1;
    try {
      int width = Integer.parseInt(token());
      int height = Integer.parseInt(token());
      double scale = Double.parseDouble(token());
      if (width < 0 || height < 0 || scale == 0 || !Double.isFinite(scale)) {
        throw malformed("PFM: its header is damaged");
      }
      PictureLimits.checkSize(width, height);
      PictureLimits.checkPixels(width, height, maxPixels);
      // One white-space character ends the header.
      position = Math.min(position + 1, file.length);
      if (file.length - position != 4L * channels * width * height) {
        throw malformed(
            "PFM: expected %d bytes of pixels, found %d"
                .formatted(4L * channels * width * height, file.length - position));
      }
      ByteOrder order = scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
      return pixels(
          width,
          height,
          channels,
          ByteBuffer.wrap(file, position, file.length - position).order(order));
    } catch (NumberFormatException e) {
      throw malformed("PFM: its header is damaged");
    }
  }

  private static LinearPicture pixels(int width, int height, int channels, ByteBuffer in)
      throws ImageFormatException {
    float[] rgb = LinearReader.raster(width, height, 3);
    for (int y = height - 1; y >= 0; y--) {
      for (int i = 3 * y * width; i < 3 * (y + 1) * width; i++) {
        rgb[i] = channels == 1 && i % 3 != 0 ? rgb[i - 1] : in.getFloat();
      }
    }
    return new LinearPicture(width, height, rgb, new float[0]);
  }

  private String token() {
    while (position < file.length && Character.isWhitespace(file[position])) {
      position++;
    }
    int start = position;
    while (position < file.length
        && position - start < MAX_TOKEN
        && !Character.isWhitespace(file[position])) {
      position++;
    }
    return new String(file, start, position - start, StandardCharsets.US_ASCII);
  }
}
