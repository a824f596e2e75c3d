package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;
import static io.github.lumbre.image.format.exr.ExrBytes.inflated;
import static io.github.lumbre.image.format.exr.ExrBytes.merged;
import static io.github.lumbre.image.format.exr.ExrBytes.repeated;

import io.github.lumbre.image.ImageFormatException;
import java.util.zip.DataFormatException;

/** The compressions of OpenEXR that are read, in the order of their codes. */
enum ExrCompression {
  NONE(1, 1),
  RLE(1, ExrCompression.MAX_RUN),
  ZIPS(1, ExrCompression.MAX_INFLATION),
  ZIP(16, ExrCompression.MAX_INFLATION),
  PIZ(32, ExrCompression.MAX_INFLATION),
  PXR24(16, 4 * ExrCompression.MAX_INFLATION / 3),
  B44(32, ExrCompression.MAX_RUN),
  B44A(32, ExrCompression.MAX_RUN),
  DWAA(32, ExrCompression.MAX_RUN * ExrCompression.MAX_INFLATION),
  DWAB(256, ExrCompression.MAX_RUN * ExrCompression.MAX_INFLATION);

  /**
   * The largest number of bytes that one byte of deflated data can inflate to (zlib technical
   * notes).
   */
  private static final int MAX_INFLATION = 1032;

  /** The largest number of bytes that one byte of run-length encoded data can stand for. */
  private static final int MAX_RUN = 64;

  /** The compressions whose codes follow and which are not read (OpenEXR 3.4). */
  private static final String[] OTHERS = {"HTJ2K256", "HTJ2K32"};

  private final int lines;
  private final int maxInflation;

  ExrCompression(int lines, int maxInflation) {
    this.lines = lines;
    this.maxInflation = maxInflation;
  }

  static ExrCompression of(byte code) throws ImageFormatException {
    int other = code - values().length;
    if (code < 0 || other >= 0) {
      throw malformed(
          "OpenEXR: expected no compression, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA or DWAB,"
              + " found "
              + (other >= 0 && other < OTHERS.length ? OTHERS[other] : "code " + code)
              + "; save the picture with ZIP compression");
    }
    return values()[code];
  }

  /** Returns the number of scan lines in a block. */
  int lines() {
    return lines;
  }

  /** Returns the largest number of bytes of pixels that one byte of a file can stand for. */
  long maxInflation() {
    return maxInflation;
  }

  /**
   * Returns the uncompressed bytes of a block; blocks that did not shrink are stored as they were.
   */
  byte[] unpacked(byte[] packed, ExrBlock block) throws ImageFormatException, DataFormatException {
    int size = block.bytes();
    if (packed.length == size) {
      return packed;
    }
    return switch (this) {
      case NONE -> throw ExrBytes.wrongSize();
      case RLE -> merged(repeated(packed, size));
      case ZIPS, ZIP -> merged(inflated(packed, size));
      case PIZ -> new ExrPiz(packed, block).unpacked();
      case PXR24 -> ExrPxr24.unpacked(packed, block);
      case B44, B44A -> new ExrB44(packed, block).unpacked();
      case DWAA, DWAB -> new ExrDwa(packed, block).unpacked();
    };
  }
}
