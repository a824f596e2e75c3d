package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.format.zstd.Zstandard;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** How the bytes of a level were compressed (KTX File Format 2.0, section 3.9), in file order. */
enum KtxCompression {
  NONE(1),
  /** Of ETC1S alone: the streams of codes, which give no bytes of their own. */
  BASIS_LZ(Integer.MAX_VALUE),
  /** A block of 128 KiB that repeats a byte has four bytes. */
  ZSTANDARD(1 << 15),
  /** zlib technical notes. */
  ZLIB(1032);

  private static final int STEP = 1 << 16;

  /** The largest number of bytes that one byte can stand for. */
  private final int maxRatio;

  KtxCompression(int maxRatio) {
    this.maxRatio = maxRatio;
  }

  /**
   * Returns a scheme by its number.
   *
   * @throws ImageFormatException if it is unknown, or does not go with the coding
   */
  static KtxCompression of(int number, KtxCoding coding) throws ImageFormatException {
    if (number < 0 || number >= values().length) {
      throw malformed("KTX has the supercompression scheme %d, expected 0 to 3".formatted(number));
    }
    KtxCompression found = values()[number];
    if (coding.isEtc1s() != (found == BASIS_LZ)) {
      throw malformed("KTX has %s with %s, expected BASIS_LZ with ETC1S".formatted(coding, found));
    }
    return found;
  }

  /** Checks that compressed bytes are enough for a number of bytes. */
  void requireEnough(KtxInput level, int bytes) throws ImageFormatException {
    if (this == NONE ? bytes != level.size() : bytes > (long) level.size() * maxRatio) {
      throw malformed("KTX has %d bytes at level 0 for %d bytes".formatted(level.size(), bytes));
    }
  }

  /** Returns whether decoding takes memory for the bytes of a level. */
  boolean hasOwnBytes() {
    return this == ZSTANDARD || this == ZLIB;
  }

  /** Returns a number of bytes, in an array of their own if they were compressed. */
  KtxInput decoded(KtxInput level, int bytes) throws ImageFormatException {
    if (this == NONE) {
      return level;
    }
    int end = level.from() + level.size();
    byte[] decoded =
        this == ZLIB
            ? inflated(level, bytes)
            : Zstandard.decode(level.file(), level.from(), end, bytes);
    return new KtxInput(decoded, 0, bytes, "level 0");
  }

  private static byte[] inflated(KtxInput level, int bytes) throws ImageFormatException {
    byte[] inflated = new byte[bytes];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(level.file(), level.from(), level.size());
      int at = 0;
      for (int more = 1; more > 0; at += more) {
        Interrupts.check();
        more = inflater.inflate(inflated, at, Math.min(STEP, bytes - at));
      }
      if (at < bytes || inflater.inflate(new byte[1]) > 0) {
        throw malformed("KTX is damaged: expected " + bytes + " inflated bytes");
      }
      return inflated;
    } catch (DataFormatException e) {
      throw new ImageFormatException(
          ImageFormatException.Kind.MALFORMED, "KTX is damaged: zlib: " + e.getMessage(), e);
    } finally {
      inflater.end();
    }
  }
}
