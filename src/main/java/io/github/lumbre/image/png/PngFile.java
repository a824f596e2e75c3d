package io.github.lumbre.image.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.CRC32;

/**
 * The structure of a PNG file, read without decoding it (PNG specification, third edition).
 *
 * @param width in pixels
 * @param height in pixels
 * @param transparency of colors
 * @param content the file without the chunks that decoding does not need, see {@link PngContent}.
 *     Without them, no profile or gamma can change the values, and no compressed text can exhaust
 *     memory
 */
public record PngFile(int width, int height, PngTransparency transparency, byte[] content) {
  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int IHDR = 0x49484452;
  private static final int PLTE = 0x504c5445;
  static final int IDAT = 0x49444154;
  private static final int IEND = 0x49454e44;
  private static final int TRNS = 0x74524e53;
  private static final int HEADER_BYTES = 13;

  /** The largest number of colors of a palette. */
  private static final int MAX_COLORS = 256;

  static final int FRAME_BYTES = 12;

  /**
   * The largest number of bytes that one byte of deflated data can inflate to (zlib technical
   * notes).
   */
  private static final long MAX_INFLATION = 1032;

  public static boolean startsIn(byte[] file) {
    return file.length >= Long.BYTES && ByteBuffer.wrap(file).getLong() == SIGNATURE;
  }

  /**
   * Reads the structure of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if the chunks are damaged, or the picture exceeds the limits or is
   *     larger than its data can hold
   */
  public static PngFile read(byte[] file) throws ImageFormatException {
    ByteBuffer in = ByteBuffer.wrap(file);
    PngContent content = new PngContent(file);
    ByteBuffer header = header(file);
    int width = header.getInt();
    int height = header.getInt();
    PictureLimits.checkSize(width, height);
    int depth = header.get();
    int colorType = header.get();
    int bits = bitsPerPixel(depth, colorType);
    byte[] transparency = {};
    long deflated = 0;
    int type;
    in.position(Long.BYTES);
    do {
      int start = in.position();
      int length = chunkLength(in);
      type = in.getInt(start + 4);
      if (type == IHDR && start != Long.BYTES) {
        throw malformed("PNG has two headers");
      }
      if (type == IHDR || type == PLTE || type == IDAT || type == IEND) {
        checkSum(file, start, length);
        content.add(type, start, length);
        deflated += type == IDAT ? length : 0;
      }
      if (type == TRNS) {
        checkSum(file, start, length);
        transparency =
            Arrays.copyOfRange(file, start + 8, start + 8 + Math.min(length, MAX_COLORS));
      }
      in.position(start + length + FRAME_BYTES);
    } while (type != IEND);
    if ((long) width * height * bits / 8 > MAX_INFLATION * deflated) {
      throw malformed("PNG data are too short for " + width + "x" + height + " pixels");
    }
    return new PngFile(
        width, height, new PngTransparency(colorType, depth, transparency), content.bytes());
  }

  private static ByteBuffer header(byte[] file) throws ImageFormatException {
    ByteBuffer in = ByteBuffer.wrap(file).position(Long.BYTES);
    if (chunkLength(in) != HEADER_BYTES || in.getInt(in.position() + 4) != IHDR) {
      throw malformed("PNG does not begin with its header");
    }
    return in.position(Long.BYTES + 8);
  }

  private static int chunkLength(ByteBuffer in) throws ImageFormatException {
    if (in.remaining() < FRAME_BYTES) {
      throw malformed("PNG is truncated");
    }
    int length = in.getInt(in.position());
    if (length < 0 || length > in.remaining() - FRAME_BYTES) {
      throw malformed("PNG is truncated");
    }
    return length;
  }

  private static void checkSum(byte[] file, int start, int length) throws ImageFormatException {
    CRC32 crc = new CRC32();
    crc.update(file, start + 4, length + 4);
    if ((int) crc.getValue() != ByteBuffer.wrap(file).getInt(start + 8 + length)) {
      throw malformed("PNG is damaged: wrong checksum at byte " + start);
    }
  }

  private static int bitsPerPixel(int depth, int colorType) throws ImageFormatException {
    int channels =
        switch (colorType) {
          case 0, 3 -> 1;
          case 2 -> 3;
          case 4 -> 2;
          case 6 -> 4;
          default -> throw malformed("PNG has the unknown color type " + colorType);
        };
    return channels * depth;
  }
}
