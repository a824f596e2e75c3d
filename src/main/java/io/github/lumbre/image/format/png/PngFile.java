package io.github.lumbre.image.format.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.Inflater;

/**
 * The structure of a PNG file, read without decoding it (PNG specification, third edition).
 *
 * @param width in pixels
 * @param height in pixels
 * @param depth bits per sample
 * @param colorType as in the header
 * @param isInterlaced whether the pixels are stored in seven passes
 * @param palette red, green and blue of each index; empty without a palette
 * @param transparency of colors
 * @param file the bytes of the file, with an end chunk
 */
public record PngFile(
    int width,
    int height,
    int depth,
    int colorType,
    boolean isInterlaced,
    byte[] palette,
    PngTransparency transparency,
    byte[] file) {
  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int IHDR = 0x49484452;
  private static final int PLTE = 0x504c5445;
  static final int IDAT = 0x49444154;
  static final int IEND = 0x49454e44;
  private static final int TRNS = 0x74524e53;
  private static final int TEXT = 0x74455874;
  private static final int UNICODE_TEXT = 0x69545874;
  static final int PALETTE = 3;
  private static final int HEADER_BYTES = 13;

  /** The largest number of colors of a palette. */
  private static final int MAX_COLORS = 256;

  static final int FRAME_BYTES = 12;

  /** The checksum of a chunk that ends a file. */
  private static final int END_SUM = 0xae426082;

  /**
   * The largest number of bytes that one byte of deflated data can inflate to (zlib technical
   * notes).
   */
  private static final long MAX_INFLATION = 1032;

  public static boolean startsIn(byte[] file) {
    return file.length >= Long.BYTES && ByteBuffer.wrap(file).getLong() == SIGNATURE;
  }

  /** Reads the structure of a file that {@link #startsIn} recognizes; see {@link #read}. */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    PngFile png = read(file);
    int bytes = png.channels() * (png.depth > Byte.SIZE ? Short.BYTES : 1);
    return new EncodedPicture(png.width, png.height, bytes, png::decode);
  }

  /**
   * Reads the structure of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if the chunks are damaged, or the picture exceeds the limits or is
   *     larger than its data can hold
   */
  private static PngFile read(byte[] stored) throws ImageFormatException {
    byte[] file = ended(stored);
    ByteBuffer in = ByteBuffer.wrap(file);
    ByteBuffer header = header(file);
    int width = header.getInt();
    int height = header.getInt();
    PictureLimits.checkSize(width, height);
    int depth = header.get() & 0xff;
    int colorType = header.get() & 0xff;
    requireDepth(depth, colorType);
    int interlacing = interlacing(header);
    byte[] palette = {};
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
        if (type == PLTE) {
          requirePalette(colorType, deflated, palette);
          palette = palette(file, start + 8, length, depth, colorType);
        }
        deflated += type == IDAT ? length : 0;
      }
      if (type == TRNS) {
        checkSum(file, start, length);
        transparency =
            Arrays.copyOfRange(file, start + 8, start + 8 + Math.min(length, MAX_COLORS));
      }
      in.position(start + length + FRAME_BYTES);
    } while (type != IEND);
    if (colorType == PALETTE && palette.length == 0) {
      throw malformed("PNG has no palette");
    }
    PngFile png =
        new PngFile(
            width,
            height,
            depth,
            colorType,
            interlacing == 1,
            palette,
            new PngTransparency(colorType, depth, transparency),
            file);
    if ((long) width * height * png.samples() * depth / 8 > MAX_INFLATION * deflated) {
      throw malformed("PNG data are too short for " + width + "x" + height + " pixels");
    }
    return png;
  }

  /**
   * Returns the texts in a file that {@link #startsIn} recognizes by their keywords, without
   * compressed ones.
   *
   * @throws ImageFormatException if the file is damaged
   */
  public static Map<String, String> texts(byte[] stored) throws ImageFormatException {
    byte[] file = read(stored).file;
    ByteBuffer in = ByteBuffer.wrap(file).position(Long.BYTES);
    Map<String, String> texts = new LinkedHashMap<>();
    while (in.getInt(in.position() + 4) != IEND) {
      int start = in.position();
      int length = chunkLength(in);
      int type = in.getInt(start + 4);
      if (type == TEXT || type == UNICODE_TEXT) {
        checkSum(file, start, length);
        String chunk = new String(file, start + 8, length, StandardCharsets.ISO_8859_1);
        int end = chunk.indexOf('\0');
        if (end >= 0 && type == TEXT) {
          texts.put(chunk.substring(0, end), chunk.substring(end + 1));
        } else if (end >= 0 && chunk.startsWith("\0\0\0\0", end + 1)) {
          int from = start + 8 + end + 5;
          texts.put(
              chunk.substring(0, end),
              new String(file, from, start + 8 + length - from, StandardCharsets.UTF_8));
        }
      }
      in.position(start + length + FRAME_BYTES);
    }
    return texts;
  }

  /**
   * Returns a file with an end chunk. One without it, or with a part of it, may have all pixels,
   * which decoding finds out.
   *
   * @throws ImageFormatException if the last chunk of such a file is damaged
   */
  private static byte[] ended(byte[] file) throws ImageFormatException {
    ByteBuffer in = ByteBuffer.wrap(file);
    int last = Long.BYTES;
    int at = Long.BYTES;
    boolean hasPixels = false;
    while (file.length - at >= FRAME_BYTES && in.getInt(at + 4) != IEND) {
      long next = (long) at + (in.getInt(at) & 0xffffffffL) + FRAME_BYTES;
      if (next > file.length) {
        return file;
      }
      hasPixels |= in.getInt(at + 4) == IDAT;
      last = at;
      at = (int) next;
    }
    if (!hasPixels || file.length - at >= FRAME_BYTES) {
      return file;
    }
    checkSum(file, last, in.getInt(last));
    return ByteBuffer.allocate(at + FRAME_BYTES)
        .put(file, 0, at)
        .putInt(0)
        .putInt(IEND)
        .putInt(END_SUM)
        .array();
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

  private static void requireDepth(int depth, int colorType) throws ImageFormatException {
    String depths =
        switch (colorType) {
          case 0 -> "1, 2, 4, 8 or 16";
          case PALETTE -> "1, 2, 4 or 8";
          case 2, 4, 6 -> "8 or 16";
          default -> throw malformed("PNG has the unknown color type " + colorType);
        };
    if (!List.of(depths.split(", | or ")).contains("" + depth)) {
      throw malformed(
          "PNG has %d bits per sample with color type %d, expected %s"
              .formatted(depth, colorType, depths));
    }
  }

  /** Reads the rest of the header, and returns the kind of interlacing. */
  private static int interlacing(ByteBuffer header) throws ImageFormatException {
    int compression = header.get() & 0xff;
    int filters = header.get() & 0xff;
    int interlacing = header.get() & 0xff;
    if (compression != 0 || filters != 0 || interlacing > 1) {
      throw malformed(
          "PNG has compression %d, filters %d and interlacing %d, expected 0, 0 and 0 or 1"
              .formatted(compression, filters, interlacing));
    }
    return interlacing;
  }

  private static void requirePalette(int colorType, long deflated, byte[] palette)
      throws ImageFormatException {
    if (palette.length > 0 || deflated > 0 || colorType == 0 || colorType == 4) {
      throw malformed("PNG is damaged: a palette that does not belong here");
    }
  }

  /** Returns the colors of a palette; those without a color of their own are black. */
  private static byte[] palette(byte[] file, int start, int length, int depth, int colorType)
      throws ImageFormatException {
    int colors = colorType == PALETTE ? 1 << depth : MAX_COLORS;
    if (length < 3 || length / 3 > colors) {
      throw malformed(
          "PNG has a palette of %d colors, expected 1 to %d".formatted(length / 3, colors));
    }
    return Arrays.copyOf(Arrays.copyOfRange(file, start, start + length / 3 * 3), 3 * colors);
  }

  boolean hasPalette() {
    return colorType == PALETTE;
  }

  /** Returns the number of samples of a pixel. */
  int samples() {
    return switch (colorType) {
      case 2 -> 3;
      case 4 -> 2;
      case 6 -> 4;
      default -> 1;
    };
  }

  /** Returns the number of values of a pixel after decoding. */
  int channels() {
    return (hasPalette() ? 3 : samples()) + (transparency.isPresent() ? 1 : 0);
  }

  private Pixels decode() throws ImageFormatException {
    Inflater inflater = new Inflater();
    try {
      return new PngDecoder(this, inflater).decode();
    } finally {
      inflater.end();
    }
  }
}
