package io.github.lumbre.image.format.webp;

import java.util.Arrays;

/**
 * The samples of luma or of a chroma, of whole macroblocks, with a row above and a column to the
 * left that predictions read (RFC 6386, sec. 12.2 and 12.3). Mutable.
 */
final class Vp8Plane {
  private static final byte ABOVE = 127;
  private static final byte LEFT = (byte) 129;

  private final byte[] samples;
  private final int stride;

  Vp8Plane(int width, int height) {
    stride = width + 1;
    samples = new byte[stride * (height + 1)];
    Arrays.fill(samples, 0, stride, ABOVE);
    for (int y = 0; y < height; y++) {
      samples[at(-1, y)] = LEFT;
    }
  }

  /** Returns the position of a sample; x and y are at least -1. */
  int at(int x, int y) {
    return (y + 1) * stride + x + 1;
  }

  /** Returns the distance of the positions of two rows. */
  int stride() {
    return stride;
  }

  /** Returns the sample at a position: 0 to 255. */
  int get(int at) {
    return samples[at] & 0xff;
  }

  /** Sets the sample at a position to the nearest number from 0 to 255. */
  void set(int at, int value) {
    samples[at] = (byte) clamped(value);
  }

  /** Adds to the sample at a position. */
  void add(int at, int difference) {
    set(at, get(at) + difference);
  }

  /** Returns the nearest number from 0 to 255. */
  static int clamped(int value) {
    return (value & ~0xff) == 0 ? value : value < 0 ? 0 : 255;
  }
}
