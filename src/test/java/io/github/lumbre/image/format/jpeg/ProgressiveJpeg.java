package io.github.lumbre.image.format.jpeg;

import java.io.ByteArrayOutputStream;

/**
 * Writes progressive JPEG files of medium gray with any number of scans, all allowed by ITU-T T.81,
 * annex G: 64 coefficients, each bit by bit.
 */
public final class ProgressiveJpeg {
  private static final int LONGEST_RUN_BITS = 14;
  private static final int HIGHEST_BIT = 13;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private int bits;
  private int bitCount;

  private ProgressiveJpeg() {}

  /**
   * Returns a file.
   *
   * @param blocks the number of 8x8 blocks per side
   * @param scans the number of scans, 1 to 896
   */
  public static byte[] gray(int blocks, int scans) {
    ProgressiveJpeg file = new ProgressiveJpeg();
    file.header(8 * blocks);
    for (int scan = 0; scan < scans; scan++) {
      int coefficient = scan / (HIGHEST_BIT + 1);
      int bit = HIGHEST_BIT - scan % (HIGHEST_BIT + 1);
      int approximation = (bit == HIGHEST_BIT ? 0 : bit + 1) << 4 | bit;
      file.bytes(0xff, 0xda, 0, 8, 1, 1, 0, coefficient, coefficient, approximation);
      if (coefficient == 0) {
        file.zeros(blocks * blocks);
      } else {
        file.endOfBlocks(blocks * blocks);
      }
      file.flush();
    }
    file.bytes(0xff, 0xd9);
    return file.out.toByteArray();
  }

  private void header(int side) {
    bytes(0xff, 0xd8, 0xff, 0xdb, 0, 67, 0);
    for (int i = 0; i < 64; i++) {
      bytes(1);
    }
    bytes(0xff, 0xc2, 0, 11, 8, side >> 8, side, side >> 8, side, 1, 1, 0x11, 0);
    // One DC code of one bit for a difference of zero.
    bytes(0xff, 0xc4, 0, 20, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    // Fifteen AC codes of four bits each for end-of-band runs.
    bytes(0xff, 0xc4, 0, 34, 0x10, 0, 0, 0, 15, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int run = 0; run <= LONGEST_RUN_BITS; run++) {
      bytes(run << 4);
    }
  }

  private void zeros(int count) {
    for (int i = 0; i < count; i++) {
      bits(0, 1);
    }
  }

  private void endOfBlocks(int blocks) {
    int left = blocks;
    while (left > 0) {
      int run = Math.min(LONGEST_RUN_BITS, 31 - Integer.numberOfLeadingZeros(left));
      bits(run, 4);
      bits(0, run);
      left -= 1 << run;
    }
  }

  private void bits(int value, int count) {
    for (int i = count - 1; i >= 0; i--) {
      bits = bits << 1 | value >> i & 1;
      if (++bitCount == 8) {
        bytes(bits);
        if ((bits & 0xff) == 0xff) {
          bytes(0);
        }
        bitCount = 0;
      }
    }
  }

  private void flush() {
    while (bitCount != 0) {
      bits(1, 1);
    }
  }

  private void bytes(int... values) {
    for (int value : values) {
      out.write(value);
    }
  }
}
