package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A part of a file. Numbers are little-endian; positions are from the first byte of the part.
 *
 * @param from index of the first byte
 * @param size in bytes
 * @param name of the part, for messages
 */
record KtxInput(byte[] file, int from, int size, String name) {
  KtxInput part(long start, long length, String title) throws ImageFormatException {
    if (start < 0 || length < 0 || length > size || start > size - length) {
      throw malformed(
          "KTX is damaged: expected %s of %s bytes from byte %s on, found %d bytes in all"
              .formatted(title, Long.toUnsignedString(length), Long.toUnsignedString(start), size));
    }
    return new KtxInput(file, from + (int) start, (int) length, title);
  }

  /** Returns an unsigned number of 1 or 2 bytes, or a signed one of 4. */
  int number(int at, int bytes) throws ImageFormatException {
    require(at, bytes);
    ByteBuffer buffer = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    return switch (bytes) {
      case Byte.BYTES -> buffer.get(from + at) & 0xff;
      case Short.BYTES -> buffer.getShort(from + at) & 0xffff;
      default -> buffer.getInt(from + at);
    };
  }

  /** Returns an unsigned number of 4 bytes. */
  long word(int at) throws ImageFormatException {
    return Integer.toUnsignedLong(number(at, Integer.BYTES));
  }

  /** Returns a number of 8 bytes, negative if it needs all bits. */
  long longWord(int at) throws ImageFormatException {
    return word(at) | word(at + Integer.BYTES) << Integer.SIZE;
  }

  private void require(int at, int bytes) throws ImageFormatException {
    if (at < 0 || at > size - bytes) {
      throw malformed("KTX is damaged: %s ends at its byte %d".formatted(name, size));
    }
  }
}
