package io.github.lumbre.image.format.dds;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * How a DDS file stores pixels (Microsoft, "Programming Guide for DDS" and DXGI_FORMAT).
 *
 * @param block 1 to 7 for BC1 to BC7; 0 if pixels are stored one by one
 * @param bytes of a block, or of a pixel
 * @param channels of the decoded picture, 1 to 4
 * @param masks of the channels in a pixel that is not in a block
 */
record DdsFormat(int block, int bytes, int channels, int... masks) {
  private static final int HAS_ALPHA = 0x1;
  private static final int HAS_CODE = 0x4;
  private static final int HAS_RGB = 0x40;
  private static final int HAS_GRAY = 0x20000;
  private static final int DX10 = code("DX10");

  private static int code(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24;
  }

  /** Returns whether a file has the longer header, whose format is a number. */
  static boolean isExtended(ByteBuffer file) {
    return (file.getInt(80) & HAS_CODE) != 0 && file.getInt(84) == DX10;
  }

  /**
   * Reads the format from a header.
   *
   * @throws ImageFormatException if it is not supported
   */
  static DdsFormat of(ByteBuffer file) throws ImageFormatException {
    int flags = file.getInt(80);
    if (isExtended(file)) {
      return numbered(file.getInt(128));
    }
    if ((flags & HAS_CODE) != 0) {
      return coded(file.getInt(84));
    }
    int bits = file.getInt(88);
    if ((flags & (HAS_RGB | HAS_GRAY)) == 0 || bits < 8 || bits > 32 || bits % 8 != 0) {
      throw unsupported("pixels of " + bits + " bits with the flags " + flags);
    }
    int channels = (flags & HAS_GRAY) != 0 ? 1 : 3;
    int alpha = (flags & HAS_ALPHA) != 0 ? file.getInt(104) : 0;
    return stored(bits / 8, channels, file.getInt(92), file.getInt(96), file.getInt(100), alpha);
  }

  private static DdsFormat stored(
      int bytes, int channels, int red, int green, int blue, int alpha) {
    return channels == 1
        ? new DdsFormat(0, bytes, alpha == 0 ? 1 : 2, red, alpha)
        : new DdsFormat(0, bytes, alpha == 0 ? 3 : 4, red, green, blue, alpha);
  }

  private static DdsFormat coded(int code) throws ImageFormatException {
    byte[] letters = {(byte) code, (byte) (code >> 8), (byte) (code >> 16), (byte) (code >> 24)};
    String name = new String(letters, StandardCharsets.US_ASCII);
    return switch (name) {
      case "DXT1" -> compressed(1);
      case "DXT3" -> compressed(2);
      case "DXT5" -> compressed(3);
      case "ATI1", "BC4U" -> compressed(4);
      case "ATI2", "BC5U" -> compressed(5);
      default ->
          throw unsupported(
              name.matches("[A-Z0-9]{4}") ? "the format " + name : "the format " + code);
    };
  }

  private static DdsFormat numbered(int number) throws ImageFormatException {
    return switch (number) {
      case 27, 28, 29 -> stored(4, 3, 0xff, 0xff00, 0xff0000, 0xff000000);
      case 60, 61 -> stored(1, 1, 0xff, 0, 0, 0);
      case 70, 71, 72 -> compressed(1);
      case 73, 74, 75 -> compressed(2);
      case 76, 77, 78 -> compressed(3);
      case 79, 80 -> compressed(4);
      case 82, 83 -> compressed(5);
      case 87, 90, 91 -> stored(4, 3, 0xff0000, 0xff00, 0xff, 0xff000000);
      case 88, 92, 93 -> stored(4, 3, 0xff0000, 0xff00, 0xff, 0);
      case 97, 98, 99 -> compressed(7);
      case 81 -> throw unsupported("the format BC4_SNORM");
      case 84 -> throw unsupported("the format BC5_SNORM");
      case 94, 95, 96 -> throw unsupported("the format BC6H");
      default -> throw unsupported("the DXGI format " + Integer.toUnsignedLong(number));
    };
  }

  private static DdsFormat compressed(int block) {
    return new DdsFormat(
        block, block == 1 || block == 4 ? 8 : 16, block == 4 ? 1 : block == 5 ? 3 : 4);
  }

  private static ImageFormatException unsupported(String found) {
    return malformed(
        "DDS has " + found + ", expected BC1 to BC5, BC7, or gray, RGB or RGBA; save it as a PNG");
  }

  /** Returns the bytes of a row of blocks or pixels. */
  long rowBytes(int width) {
    return (long) bytes * (block == 0 ? width : (width + 3) / 4);
  }
}
