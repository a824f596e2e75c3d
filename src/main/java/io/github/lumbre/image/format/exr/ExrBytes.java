package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Undoes the steps that several compressions of OpenEXR have in common. */
final class ExrBytes {
  /** The bytes after which inflating notices interrupts. */
  private static final int INTERRUPT_BYTES = 1 << 22;

  private ExrBytes() {}

  static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  static ImageFormatException wrongSize() {
    return malformed("OpenEXR is damaged: a block is too short or too long");
  }

  /** Returns deflated data that have a given size when they are inflated. */
  static byte[] inflated(byte[] packed, int size) throws ImageFormatException, DataFormatException {
    byte[] bytes = new byte[size];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      for (int at = 0, count = 1; at < size && count > 0; at += count) {
        Interrupts.check();
        count = inflater.inflate(bytes, at, Math.min(INTERRUPT_BYTES, size - at));
      }
      if (inflater.getBytesWritten() != size
          || inflater.inflate(new byte[1]) != 0
          || !inflater.finished()) {
        throw wrongSize();
      }
    } finally {
      inflater.end();
    }
    return bytes;
  }

  /** Returns run-length encoded data that have a given size when they are repeated. */
  static byte[] repeated(byte[] packed, int size) throws ImageFormatException {
    byte[] bytes = new byte[size];
    int to = 0;
    int from = 0;
    while (from < packed.length) {
      int count = packed[from++];
      int length = count < 0 ? -count : count + 1;
      if (length > size - to) {
        throw wrongSize();
      }
      if (count < 0) {
        System.arraycopy(packed, from, bytes, to, length);
        from += length;
      } else {
        Arrays.fill(bytes, to, to + length, packed[from++]);
      }
      to += length;
    }
    if (to != size) {
      throw wrongSize();
    }
    return bytes;
  }

  /** Undoes the splitting into even and odd bytes, and into differences. */
  static byte[] merged(byte[] split) {
    int size = split.length;
    for (int i = 1; i < size; i++) {
      split[i] = (byte) (split[i - 1] + split[i] - 128);
    }
    byte[] raw = new byte[size];
    int half = (size + 1) / 2;
    for (int i = 0; i < size; i++) {
      raw[i] = split[(i & 1) == 0 ? i / 2 : half + i / 2];
    }
    return raw;
  }
}
