package io.github.lumbre.image.format.exr;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Unpacks the channels of DWA compression that are given as coefficients of cosines. The lowest
 * coefficients of a channel's squares of 8x8 pixels follow each other; the higher ones have runs of
 * zeros. The transformed values are luminance and chroma by Rec. 709, or one channel, to the power
 * 1/2.2 up to 1 and logarithmic above. Mutable.
 */
final class ExrDwaCosines {
  /** A higher coefficient whose first byte is this states a run of zeros by its second byte. */
  private static final int ZEROS = 0xff;

  private static final short NAN = 0x7e00;

  private final ExrBlock block;
  private final short[] higher;
  private final short[] lowest;
  private final ByteBuffer out;
  private final int lineBytes;
  private final int across;
  private final int squares;
  private final ExrDct[] planes = {new ExrDct(), new ExrDct(), new ExrDct()};
  private int higherAt;
  private int lowestAt;

  /**
   * @param out receives the bytes of the block
   */
  ExrDwaCosines(ExrBlock block, short[] higher, short[] lowest, byte[] out) {
    this.block = block;
    this.higher = higher;
    this.lowest = lowest;
    this.out = ExrBytes.little(out);
    lineBytes = block.lineBytes();
    across = ExrDct.squares(block.width());
    squares = squares(block);
  }

  /** Returns the number of squares of a channel. */
  static int squares(ExrBlock block) {
    return Math.multiplyExact(ExrDct.squares(block.width()), ExrDct.squares(block.height()));
  }

  /**
   * Reads a channel, or three that are stored as luminance and chroma.
   *
   * @param group their places in the block's list
   * @param starts for each channel of the block, the place of its first byte in a line
   */
  void read(int[] group, int[] starts) {
    for (int square = 0; square < squares; square++) {
      if (square % across == 0) {
        Interrupts.check();
      }
      for (int i = 0; i < group.length; i++) {
        readSquare(planes[i], lowest[lowestAt + i * squares + square]);
      }
      if (group.length == 3) {
        toRgb(planes[0].values, planes[1].values, planes[2].values);
      }
      for (int i = 0; i < group.length; i++) {
        ExrChannel channel = block.channels().get(group[i]);
        boolean isLinear = group.length == 1 && channel.isLinear();
        put(planes[i].values, square, channel.type(), isLinear, starts[group[i]]);
      }
    }
    lowestAt += group.length * squares;
  }

  private void readSquare(ExrDct square, short first) {
    Arrays.fill(square.values, 0);
    float mean = ExrChannel.ofHalf(first);
    square.set(0, mean);
    boolean isEven = true;
    for (int i = 1; i < ExrDct.SIZE; ) {
      short next = higher[higherAt++];
      int zeros = next & 0xff;
      if ((next >> Byte.SIZE & 0xff) != ZEROS) {
        square.set(i++, ExrChannel.ofHalf(next));
        isEven = false;
      } else {
        // No zeros end the square.
        i += zeros == 0 ? ExrDct.SIZE : zeros;
      }
    }
    if (isEven) {
      Arrays.fill(square.values, mean / ExrDct.SIDE);
    } else {
      square.transform();
    }
  }

  private static void toRgb(float[] r, float[] g, float[] b) {
    for (int i = 0; i < r.length; i++) {
      float luminance = r[i];
      float blue = g[i];
      float red = b[i];
      r[i] = luminance + 1.5747f * red;
      g[i] = luminance - .1873f * blue - .4682f * red;
      b[i] = luminance + 1.8556f * blue;
    }
  }

  private void put(float[] values, int square, ExrChannel.Type type, boolean isLinear, int start) {
    int left = square % across * ExrDct.SIDE;
    int top = square / across * ExrDct.SIDE;
    int width = Math.min(ExrDct.SIDE, block.width() - left);
    int height = Math.min(ExrDct.SIDE, block.height() - top);
    for (int y = 0; y < height; y++) {
      int to = start + (top + y) * lineBytes + type.bytes() * left;
      for (int x = 0; x < width; x++, to += type.bytes()) {
        float value = values[ExrDct.SIDE * y + x];
        short half = isLinear ? stored(value) : Light.of(value);
        if (type == ExrChannel.Type.HALF) {
          out.putShort(to, half);
        } else {
          out.putFloat(to, ExrChannel.ofHalf(half));
        }
      }
    }
  }

  private static short stored(float value) {
    return Float.isNaN(value) ? NAN : ExrChannel.toHalf(value);
  }

  /** Linear light of stored values; a class, so that other files make no table. */
  private static final class Light {
    /** By the bits of positive halves. */
    private static final short[] TABLE = new short[0x7c00];

    static {
      for (int i = 0; i < TABLE.length; i++) {
        double value = ExrChannel.ofHalf((short) i);
        double light = value <= 1 ? StrictMath.pow(value, 2.2) : StrictMath.exp(2.2 * (value - 1));
        TABLE[i] = ExrChannel.toHalf((float) light);
      }
    }

    private Light() {}

    /** Returns the half of the light; 0 if the value is not finite. */
    static short of(float value) {
      if (!Float.isFinite(value)) {
        return 0;
      }
      short half = ExrChannel.toHalf(value);
      return (short) (TABLE[half & 0x7fff] | half & 0x8000);
    }
  }
}
