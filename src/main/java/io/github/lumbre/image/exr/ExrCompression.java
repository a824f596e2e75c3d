package io.github.lumbre.image.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** The lossless compressions of OpenEXR, in the order of their codes. */
enum ExrCompression {
  NONE(1),
  RLE(1),
  ZIPS(1),
  ZIP(16),
  PIZ(32);

  private final int lines;

  ExrCompression(int lines) {
    this.lines = lines;
  }

  /** Returns the compression of a code in a file. */
  static ExrCompression of(byte code) throws ImageFormatException {
    if (code < 0 || code >= values().length) {
      throw malformed(
          "OpenEXR: expected no compression, RLE, ZIPS, ZIP or PIZ, found "
              + (code >= 5 && code <= 9
                  ? new String[] {"PXR24", "B44", "B44A", "DWAA", "DWAB"}[code - 5]
                  : "code " + code)
              + "; save the picture with ZIP compression");
    }
    return values()[code];
  }

  /** Returns the number of scan lines in a block. */
  int lines() {
    return lines;
  }

  /**
   * Returns the uncompressed bytes of a block; blocks that did not shrink are stored as they were.
   *
   * @param header of the part
   * @param width of the block
   * @param height of the block
   */
  byte[] unpacked(byte[] packed, ExrHeader header, int width, int height)
      throws ImageFormatException, DataFormatException {
    int size = header.bytesPerPixel() * width * height;
    if (packed.length == size) {
      return packed;
    }
    return switch (this) {
      case NONE -> throw wrongSize();
      case RLE -> merged(repeated(packed, size));
      case ZIPS, ZIP -> merged(inflated(packed, size));
      case PIZ -> new ExrPiz(packed, header.channels(), width, height).unpacked();
    };
  }

  private static ImageFormatException wrongSize() {
    return malformed("OpenEXR is damaged: a block is too short or too long");
  }

  private static byte[] repeated(byte[] packed, int size) throws ImageFormatException {
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

  private static byte[] inflated(byte[] packed, int size)
      throws ImageFormatException, DataFormatException {
    byte[] bytes = new byte[size];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      boolean isAll = inflater.inflate(bytes) == size;
      if (!isAll || inflater.inflate(new byte[1]) != 0 || !inflater.finished()) {
        throw wrongSize();
      }
    } finally {
      inflater.end();
    }
    return bytes;
  }

  /** Undoes the splitting into even and odd bytes, and into differences. */
  private static byte[] merged(byte[] split) {
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
