package io.github.lumbre.image.format.webp;

/** The prediction transform of the lossless format (RFC 9649, sec. 3.5.1). Pixels are ARGB. */
final class LosslessPrediction {
  private static final int BLACK = 0xff000000;
  private static final int LEFT = 1;
  private static final int ABOVE = 2;

  private LosslessPrediction() {}

  /** Adds the predictions to a row of pixels, after all rows above. */
  static void addTo(int[] pixels, int y, LosslessTransform transform) {
    int row = y * transform.width();
    for (int x = 0; x < transform.width(); x++) {
      int mode = y == 0 ? x == 0 ? 0 : LEFT : x == 0 ? ABOVE : transform.block(x, y) >> 8 & 0xf;
      int prediction = prediction(pixels, row + x, transform.width(), mode);
      pixels[row + x] = sum(pixels[row + x], prediction);
    }
  }

  private static int prediction(int[] pixels, int at, int width, int mode) {
    if (mode == 0 || mode > 13) {
      return BLACK;
    }
    if (mode == LEFT) {
      return pixels[at - 1];
    }
    int above = pixels[at - width];
    if (mode == ABOVE) {
      return above;
    }
    int left = pixels[at - 1];
    int corner = pixels[at - width - 1];
    // In the last column, this is the first pixel of the present row.
    int right = pixels[at - width + 1];
    return switch (mode) {
      case 3 -> right;
      case 4 -> corner;
      case 5 -> mean(mean(left, right), above);
      case 6 -> mean(left, corner);
      case 7 -> mean(left, above);
      case 8 -> mean(corner, above);
      case 9 -> mean(above, right);
      case 10 -> mean(mean(left, corner), mean(above, right));
      case 11 -> nearer(left, above, corner);
      case 12 -> gradient(left, above, corner, 1);
      default -> {
        int mean = mean(left, above);
        yield gradient(mean, mean, corner, 2);
      }
    };
  }

  /** Returns the sums of the four channels, each modulo 256. */
  static int sum(int first, int second) {
    int outer = (first & 0xff00ff00) + (second & 0xff00ff00);
    int inner = (first & 0xff00ff) + (second & 0xff00ff);
    return outer & 0xff00ff00 | inner & 0xff00ff;
  }

  private static int mean(int first, int second) {
    return ((first ^ second) >>> 1 & 0x7f7f7f7f) + (first & second);
  }

  /** Returns the neighbor that is nearer to left + above - corner. */
  private static int nearer(int left, int above, int corner) {
    int difference = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      int c = corner >> shift & 0xff;
      difference += Math.abs((left >> shift & 0xff) - c) - Math.abs((above >> shift & 0xff) - c);
    }
    return difference <= 0 ? above : left;
  }

  /** Returns the first pixel plus a fraction of the second minus the third, for each channel. */
  private static int gradient(int first, int second, int third, int divisor) {
    int sum = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      int difference = ((second >> shift & 0xff) - (third >> shift & 0xff)) / divisor;
      sum |= Vp8Plane.clamped((first >> shift & 0xff) + difference) << shift;
    }
    return sum;
  }
}
