package io.github.lumbre.image.format.ktx;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;

/** Texels that are written block by block. Mutable. */
final class TexelBlocks {
  /** The width and height of a block. */
  static final int SIDE = 4;

  private final int width;
  private final int height;
  private final int channels;
  private final KtxMetadata orientation;
  private final byte[] values;

  TexelBlocks(int width, int height, int channels, KtxMetadata orientation) {
    this.width = width;
    this.height = height;
    this.channels = channels;
    this.orientation = orientation;
    values = new byte[Math.multiplyExact(channels, width * height)];
  }

  /** Returns the number of blocks that cover a number of texels. */
  static int count(int texels) {
    return (texels + SIDE - 1) / SIDE;
  }

  int columns() {
    return count(width);
  }

  int rows() {
    return count(height);
  }

  boolean hasAlpha() {
    return channels == 4;
  }

  /** Fills the picture from texels, row by row. */
  void fill(KtxInput in, int stored) {
    for (int y = 0; y < height; y++) {
      Interrupts.check();
      for (int x = 0; x < width; x++) {
        int from = in.from() + (y * width + x) * stored;
        System.arraycopy(in.file(), from, values, index(x, y), stored);
      }
    }
  }

  /** Fills the picture from UASTC blocks. */
  void fillFromBlocks(KtxInput in) throws ImageFormatException {
    UastcBlock block = new UastcBlock();
    int at = 0;
    for (int row = 0; row < rows(); row++) {
      Interrupts.check();
      for (int column = 0; column < columns(); column++) {
        put(column, row, block.decode(in, at), 0, channels);
        at += UastcBlock.BYTES;
      }
    }
  }

  /**
   * Writes channels of a block; texels outside the picture are dropped.
   *
   * @param texels 16, row by row, with red in the lowest byte and alpha in the highest
   * @param first channel
   * @param end channel after the last
   */
  void put(int column, int row, int[] texels, int first, int end) {
    int right = Math.min(SIDE, width - column * SIDE);
    int bottom = Math.min(SIDE, height - row * SIDE);
    for (int y = 0; y < bottom; y++) {
      for (int x = 0; x < right; x++) {
        int to = index(column * SIDE + x, row * SIDE + y);
        int texel = texels[y * SIDE + x];
        for (int channel = first; channel < end; channel++) {
          values[to + channel] = (byte) (texel >> Byte.SIZE * channel);
        }
      }
    }
  }

  private int index(int x, int y) {
    int column = orientation.isLeft() ? width - 1 - x : x;
    int row = orientation.isUp() ? height - 1 - y : y;
    return (row * width + column) * channels;
  }

  Pixels pixels() {
    return Pixels.of(width, height, channels, values);
  }
}
