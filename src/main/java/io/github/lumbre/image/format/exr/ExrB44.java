package io.github.lumbre.image.format.exr;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Unpacks B44 and B44A compression: squares of 4x4 halves are a start and 15 differences of 6 bits,
 * or one value; other numbers are stored as they are ("Technical Introduction to OpenEXR",
 * openexr.com). Not reusable.
 */
final class ExrB44 {
  private static final int SIDE = 4;
  private static final int DIFFERENCE_BITS = 6;

  /** Half of the range of differences, which is added to them. */
  private static final int BIAS = 32;

  /** From here on, a shift marks a square of equal values, whose differences are left out. */
  private static final int EQUAL = 13;

  private static final short MINUS_INFINITY = (short) 0xfc00;

  private final ByteBuffer in;
  private final ExrBlock block;
  private final ByteBuffer out;
  private final int lineBytes;

  /** The values of a square, as numbers that are in the order of the halves. */
  private final short[] square = new short[SIDE * SIDE];

  /** The last bits of {@link #in} that were read but not used, at the lower end. */
  private int bits;

  private int bitCount;

  ExrB44(byte[] packed, ExrBlock block) {
    in = ByteBuffer.wrap(packed);
    this.block = block;
    lineBytes = block.lineBytes();
    out = ExrBytes.little(new byte[block.bytes()]);
  }

  byte[] unpacked() {
    int start = 0;
    for (ExrChannel channel : block.channels()) {
      int bytes = channel.type().bytes() * block.width();
      for (int y = 0; y < block.height(); y += channel.type() == ExrChannel.Type.HALF ? SIDE : 1) {
        Interrupts.check();
        if (channel.type() == ExrChannel.Type.HALF) {
          readSquares(start, y, channel.isLinear());
        } else {
          in.get(out.array(), start + y * lineBytes, bytes);
        }
      }
      start += bytes;
    }
    return out.array();
  }

  /**
   * Reads the squares of four lines.
   *
   * @param start the place of the channel's first byte in a line
   */
  private void readSquares(int start, int top, boolean isLinear) {
    int height = Math.min(SIDE, block.height() - top);
    for (int left = 0; left < block.width(); left += SIDE) {
      readSquare();
      int width = Math.min(SIDE, block.width() - left);
      for (int y = 0; y < height; y++) {
        int to = start + (top + y) * lineBytes + Short.BYTES * left;
        for (int x = 0; x < width; x++) {
          short half = half(square[SIDE * y + x]);
          out.putShort(to + Short.BYTES * x, isLinear ? logarithm(half) : half);
        }
      }
    }
  }

  private void readSquare() {
    square[0] = in.getShort();
    bitCount = 0;
    int shift = next();
    if (shift >= EQUAL) {
      Arrays.fill(square, square[0]);
      return;
    }
    for (int i = SIDE; i < square.length; i += SIDE) {
      square[i] = (short) (square[i - SIDE] + (next() - BIAS << shift));
    }
    for (int x = 1; x < SIDE; x++) {
      for (int i = x; i < square.length; i += SIDE) {
        square[i] = (short) (square[i - 1] + (next() - BIAS << shift));
      }
    }
  }

  private int next() {
    if (bitCount < DIFFERENCE_BITS) {
      bits = bits << Byte.SIZE | in.get() & 0xff;
      bitCount += Byte.SIZE;
    }
    bitCount -= DIFFERENCE_BITS;
    return bits >> bitCount & (1 << DIFFERENCE_BITS) - 1;
  }

  /** Returns the half of a number in the order of halves: negative ones count down to 0. */
  private static short half(short ordered) {
    return (short) (ordered < 0 ? ordered & 0x7fff : ~ordered);
  }

  /** Returns 8 ln x, the value of a channel that is marked as perceptually linear. */
  private static short logarithm(short half) {
    float x = ExrChannel.ofHalf(half);
    if (!Float.isFinite(x) || x < 0) {
      return 0;
    }
    return x == 0 ? MINUS_INFINITY : ExrChannel.toHalf(8 * (float) StrictMath.log(x));
  }
}
