package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;
import java.util.Arrays;

/** Decodes the alpha of a lossy picture (RFC 9649, sec. 2.7.1.2). */
final class AlphaPlane {
  private static final int RAW = 0;
  private static final int LOSSLESS = 1;
  private static final int HORIZONTAL = 1;
  private static final int VERTICAL = 2;

  private AlphaPlane() {}

  /**
   * Returns a value for each pixel, 255 for opaque ones.
   *
   * @param from the position of the chunk's data in the file
   * @param end the position after them
   */
  static byte[] decode(byte[] file, int from, int end, int width, int height)
      throws ImageFormatException {
    if (from == end) {
      throw malformed("WebP has alpha without data");
    }
    int method = file[from] & 3;
    byte[] alpha;
    if (method == RAW) {
      if (width * height > end - from - 1) {
        throw malformed("WebP has alpha that is truncated");
      }
      alpha = Arrays.copyOfRange(file, from + 1, from + 1 + width * height);
    } else if (method == LOSSLESS) {
      int[] pixels =
          LosslessDecoder.decode(
              new LowBits(file, from + 1, end, WebpFile.TRUNCATED), width, height);
      alpha = new byte[pixels.length];
      for (int i = 0; i < alpha.length; i++) {
        alpha[i] = (byte) (pixels[i] >> 8);
      }
    } else {
      throw malformed("WebP has alpha with the unknown compression " + method);
    }
    addPredictions(alpha, width, file[from] >> 2 & 3);
    return alpha;
  }

  private static void addPredictions(byte[] alpha, int width, int filter) {
    for (int i = 1; i < alpha.length && filter > 0; i++) {
      int x = i % width;
      if (x == 0) {
        Interrupts.check();
      }
      int left = alpha[Math.max(0, i - 1)] & 0xff;
      int above = alpha[Math.max(0, i - width)] & 0xff;
      int prediction;
      if (x == 0 || filter == VERTICAL && i >= width) {
        prediction = above;
      } else if (filter == HORIZONTAL || i < width) {
        prediction = left;
      } else {
        prediction = Vp8Plane.clamped(left + above - (alpha[i - width - 1] & 0xff));
      }
      alpha[i] += (byte) prediction;
    }
  }
}
