package io.github.lumbre.image.format.tga;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * The header of a TGA file (Truevision TGA File Format Specification, version 2.0, tables of fields
 * 1 to 5).
 *
 * @param type 1 with a palette, 2 of colors, 3 of gray; 8 more if packed in runs
 * @param depth bits per pixel
 * @param descriptor bits of alpha, order of rows and columns
 * @param first index of the palette's first color
 * @param colors number of colors of the palette; 0 if there is none
 * @param colorDepth bits per color of the palette
 * @param width in pixels
 * @param height in pixels
 * @param palette position of the palette
 */
record TgaHeader(
    int type,
    int depth,
    int descriptor,
    int first,
    int colors,
    int colorDepth,
    int width,
    int height,
    int palette) {
  static final int BYTES = 18;

  private static final int PALETTE = 1;
  private static final int GRAY = 3;
  private static final int PACKED = 8;
  private static final int ALPHA_BITS = 0x0f;
  private static final int RIGHT_TO_LEFT = 0x10;
  private static final int TOP_DOWN = 0x20;
  private static final int INTERLEAVED = 0xc0;

  /** Reads the header of a file of at least {@link #BYTES} bytes. */
  static TgaHeader of(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    boolean hasPalette = file[1] == 1;
    return new TgaHeader(
        file[2] & 0xff,
        file[16] & 0xff,
        file[17] & 0xff,
        in.getShort(3) & 0xffff,
        hasPalette ? in.getShort(5) & 0xffff : 0,
        file[7] & 0xff,
        in.getShort(12) & 0xffff,
        in.getShort(14) & 0xffff,
        BYTES + (file[0] & 0xff));
  }

  /** Returns whether the fields suit each other and a kind of picture that is supported. */
  boolean isSupported() {
    boolean isKnown = (type & ~PACKED) >= PALETTE && (type & ~PACKED) <= GRAY;
    boolean isGray = kind() == GRAY;
    return isKnown
        && (!isMapped() || colors > 0)
        && (isMapped() || isGray ? depth == 8 || depth == 16 : isColor(depth))
        && (colors == 0 || isColor(colorDepth))
        && (descriptor & INTERLEAVED) == 0;
  }

  private static boolean isColor(int bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
  }

  private int kind() {
    return type & ~PACKED;
  }

  /** Returns whether pixels are indices into the palette. */
  boolean isMapped() {
    return kind() == PALETTE;
  }

  /** Returns whether pixels are packed in runs. */
  boolean isPacked() {
    return (type & PACKED) != 0;
  }

  /** Returns whether the first row is the upper one. */
  boolean isTopDown() {
    return (descriptor & TOP_DOWN) != 0;
  }

  /** Returns whether the first column is the right one. */
  boolean isRightToLeft() {
    return (descriptor & RIGHT_TO_LEFT) != 0;
  }

  int pixelBytes() {
    return (depth + 7) / 8;
  }

  int colorBytes() {
    return (colorDepth + 7) / 8;
  }

  /** Returns the bits of a gray value or a color, of a pixel or of the palette. */
  int valueDepth() {
    return isMapped() ? colorDepth : depth;
  }

  /** Returns the position of the first pixel. */
  int data() {
    return palette + colors * colorBytes();
  }

  /**
   * Returns the channels of the picture: gray, gray and alpha, RGB or RGBA. Bits beyond gray or RGB
   * are alpha if the descriptor counts bits of alpha.
   */
  int channels() {
    boolean hasAlpha = (descriptor & ALPHA_BITS) != 0 && valueDepth() % 16 == 0;
    return (kind() == GRAY ? 1 : 3) + (hasAlpha ? 1 : 0);
  }
}
