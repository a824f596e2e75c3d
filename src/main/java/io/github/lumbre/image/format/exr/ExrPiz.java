package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;

/**
 * Unpacks a block of PIZ compression: 16-bit values are replaced by their numbers among those that
 * occur, transformed by a Haar wavelet and Huffman-coded ("Technical Introduction to OpenEXR",
 * openexr.com; Kainz, Bogart and Hess 2004, "The OpenEXR Image File Format"). Not reusable.
 */
final class ExrPiz {
  private static final int VALUES = 1 << 16;
  private static final int BITMAP_BYTES = VALUES / 8;

  /** With fewer different values than this, the wavelet does not need modular arithmetic. */
  private static final int SMALL_VALUES = 1 << 14;

  private final ByteBuffer in;
  private final List<ExrChannel> channels;
  private final int width;
  private final int height;
  private final short[] values;

  ExrPiz(byte[] packed, ExrBlock block) {
    in = ExrBytes.little(packed);
    channels = block.channels();
    width = block.width();
    height = block.height();
    values = new short[block.bytes() / Short.BYTES];
  }

  /** Returns the bytes of the block: for each line, the bytes of one channel after the other. */
  byte[] unpacked() throws ImageFormatException {
    short[] table = new short[VALUES];
    int max = readTable(table);
    int length = in.getInt();
    if (length != in.remaining()) {
      throw ExrBytes.wrongSize();
    }
    new ExrHuffman(in).decode(values);
    int start = 0;
    for (ExrChannel channel : channels) {
      int size = channel.type().bytes() / 2;
      for (int part = 0; part < size; part++) {
        undoWavelet(start + part, size, max);
      }
      start += size * width * height;
    }
    for (int i = 0; i < values.length; i++) {
      values[i] = table[values[i] & 0xffff];
    }
    return interleaved();
  }

  /** Reads the values that occur, in ascending order and always with 0; returns the last number. */
  private int readTable(short[] table) throws ImageFormatException {
    byte[] bitmap = new byte[BITMAP_BYTES];
    int first = in.getShort() & 0xffff;
    int last = in.getShort() & 0xffff;
    if (last >= BITMAP_BYTES) {
      throw malformed("OpenEXR is damaged: a block names values beyond 16 bits");
    }
    if (first <= last) {
      in.get(bitmap, first, last - first + 1);
    }
    int count = 0;
    for (int value = 0; value < VALUES; value++) {
      if (value == 0 || (bitmap[value >> 3] >> (value & 7) & 1) != 0) {
        table[count++] = (short) value;
      }
    }
    return count - 1;
  }

  /**
   * Undoes the two-dimensional wavelet of one channel, from the coarsest level to the finest. At a
   * level, averages lie {@code 2·step} apart and differences {@code step} beside and below them.
   *
   * @param start index of the first value
   * @param dx distance of neighbors in a line
   * @param max the largest value
   */
  private void undoWavelet(int start, int dx, int max) {
    boolean isSmall = max < SMALL_VALUES;
    int dy = dx * width;
    for (int step = Integer.highestOneBit(Math.min(width, height)) >> 1; step >= 1; step >>= 1) {
      int right = dx * step;
      int below = dy * step;
      int y = 0;
      for (; y + 2 * step <= height; y += 2 * step) {
        Interrupts.check();
        int x = 0;
        for (; x + 2 * step <= width; x += 2 * step) {
          int at = start + dy * y + dx * x;
          undo(at, at + below, isSmall);
          undo(at + right, at + right + below, isSmall);
          undo(at, at + right, isSmall);
          undo(at + below, at + below + right, isSmall);
        }
        if ((width & step) != 0) {
          int at = start + dy * y + dx * x;
          undo(at, at + below, isSmall);
        }
      }
      if ((height & step) != 0) {
        for (int x = 0; x + 2 * step <= width; x += 2 * step) {
          int at = start + dy * y + dx * x;
          undo(at, at + right, isSmall);
        }
      }
    }
  }

  /** Replaces an average and a difference by the two values. */
  private void undo(int average, int difference, boolean isSmall) {
    if (isSmall) {
      int d = values[difference];
      int a = values[average] + (d & 1) + (d >> 1);
      values[average] = (short) a;
      values[difference] = (short) (a - d);
      return;
    }
    int d = values[difference] & 0xffff;
    int b = (values[average] & 0xffff) - (d >> 1) & 0xffff;
    values[average] = (short) (d + b - 0x8000);
    values[difference] = (short) b;
  }

  private byte[] interleaved() {
    ByteBuffer out =
        ByteBuffer.allocate(Short.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int y = 0; y < height; y++) {
      int start = 0;
      for (ExrChannel channel : channels) {
        int line = width * channel.type().bytes() / 2;
        for (int i = 0; i < line; i++) {
          out.putShort(values[start + y * line + i]);
        }
        start += line * height;
      }
    }
    return out.array();
  }
}
