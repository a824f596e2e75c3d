package io.github.lumbre.image.format.imageio;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Checks the first directory of a TIFF file before Java decodes the picture (TIFF revision 6.0,
 * 1992). The decoder receives a copy with one directory, which has only the fields that are checked
 * here: no profiles, no further directories and no sizes beyond the file.
 */
public final class TiffFile {
  private static final int VERSION = 42;
  private static final int BIG_VERSION = 43;
  private static final int ENTRY = 12;
  private static final int SHORT = 3;
  private static final int LONG = 4;

  private static final int WIDTH = 256;
  private static final int HEIGHT = 257;
  private static final int BITS = 258;
  private static final int COMPRESSION = 259;
  private static final int COLORS = 262;
  private static final int STRIP_OFFSETS = 273;
  private static final int CHANNELS = 277;
  private static final int STRIP_BYTES = 279;
  private static final int PREDICTOR = 317;
  private static final int TILE_WIDTH = 322;
  private static final int TILE_HEIGHT = 323;
  private static final int TILE_OFFSETS = 324;
  private static final int TILE_BYTES = 325;
  private static final int EXTRA_CHANNELS = 338;
  private static final int SAMPLE_FORMAT = 339;
  private static final int PROFILE = 34675;

  /**
   * The fields that the decoder receives. Besides those above: bit order, rows per strip, planes,
   * options of fax codes and palette.
   */
  private static final Set<Integer> FIELDS =
      Set.of(
          WIDTH,
          HEIGHT,
          BITS,
          COMPRESSION,
          COLORS,
          266,
          STRIP_OFFSETS,
          CHANNELS,
          278,
          STRIP_BYTES,
          284,
          292,
          293,
          PREDICTOR,
          320,
          TILE_WIDTH,
          TILE_HEIGHT,
          TILE_OFFSETS,
          TILE_BYTES,
          EXTRA_CHANNELS,
          SAMPLE_FORMAT);

  private static final int UNCOMPRESSED = 1;
  private static final int LAST_FAX = 4;

  /** No compression, three fax codes, LZW, Deflate (two numbers), PackBits. */
  private static final Set<Long> COMPRESSIONS = Set.of(1L, 2L, 3L, 4L, 5L, 8L, 32946L, 32773L);

  private static final int RGB = 2;
  private static final int PALETTE = 3;

  /**
   * The decoded picture, its values, and a strip of the whole picture before and after unpacking.
   */
  private static final int COPIES = 4;

  /** Kinds of the channel besides the colors; if the kind is missing, the channel is alpha. */
  private static final int UNSPECIFIED = 0;

  private static final int ALPHA = 2;

  /** Tiles may be this large in smaller pictures. */
  private static final int COMMON_TILE = 512;

  /** More bytes than one byte can stand for: in LZW, 4096 in codes of 12 bits. */
  private static final long MAX_EXPANSION = 4096 * 8 / 12 + 1;

  private final ByteBuffer file;
  private final Map<Integer, long[]> fields = new HashMap<>();

  private TiffFile(byte[] file) {
    this.file = ByteBuffer.wrap(file.clone()).order(order(file));
  }

  private static ByteOrder order(byte[] file) {
    return file[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
  }

  public static boolean startsIn(byte[] file) {
    if (file.length < Long.BYTES || file[0] != file[1] || file[0] != 'I' && file[0] != 'M') {
      return false;
    }
    int version = ByteBuffer.wrap(file).order(order(file)).getShort(2);
    return version == VERSION || version == BIG_VERSION;
  }

  /**
   * Reads the header of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if it is truncated or not of a supported kind, exceeds the limits,
   *     or the picture is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    try {
      return new TiffFile(file).open();
    } catch (IndexOutOfBoundsException e) {
      throw malformed("TIFF is truncated");
    }
  }

  /**
   * Returns the ICC profile of a file that {@link #startsIn} recognizes; empty if there is none.
   *
   * @throws IndexOutOfBoundsException if the file is truncated
   */
  public static byte[] profile(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file).order(order(file));
    int start = in.getInt(4);
    int count = in.getShort(start) & 0xffff;
    for (int at = start + Short.BYTES; at < start + Short.BYTES + ENTRY * count; at += ENTRY) {
      if ((in.getShort(at) & 0xffff) == PROFILE) {
        int size = in.getInt(at + 4);
        int from = Objects.checkFromIndexSize(in.getInt(at + 8), size, file.length);
        return Arrays.copyOfRange(file, from, from + size);
      }
    }
    return new byte[0];
  }

  /**
   * Returns whether a file that {@link #startsIn} recognizes has a second directory.
   *
   * @throws IndexOutOfBoundsException if the file is truncated
   */
  public static boolean hasMorePictures(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file).order(order(file));
    int start = in.getInt(4);
    return in.getInt(start + Short.BYTES + ENTRY * (in.getShort(start) & 0xffff)) != 0;
  }

  private EncodedPicture open() throws ImageFormatException {
    if (file.getShort(2) == BIG_VERSION) {
      throw malformed("TIFF is a BigTIFF file, expected one of at most 4 GB; save it as a PNG");
    }
    readDirectory(file.getInt(4));
    int width = (int) one(WIDTH, 0);
    int height = (int) one(HEIGHT, 0);
    PictureLimits.checkSize(width, height);
    int channels = channels();
    int bits = bits();
    checkBlocks(width, height, (long) width * height * channels * bits / 8);
    int bytes = Math.max(4, channels * ((bits + 7) / 8));
    return new EncodedPicture(width, height, COPIES * bytes, this::decode);
  }

  private Pixels decode() throws ImageFormatException {
    return JdkDecoder.decode(
        "TIFF",
        file.array(),
        reader -> {
          BufferedImage picture = reader.read(0);
          picture.coerceData(false);
          return one(EXTRA_CHANNELS, ALPHA) == UNSPECIFIED
              ? RasterPixels.withoutAlpha(picture)
              : RasterPixels.of(picture);
        });
  }

  /** Reads the known fields of a directory, and removes the other ones from it. */
  private void readDirectory(int start) throws ImageFormatException {
    int count = file.getShort(start) & 0xffff;
    int to = start + Short.BYTES;
    for (int i = 0; i < count; i++) {
      int at = start + Short.BYTES + ENTRY * i;
      int tag = file.getShort(at) & 0xffff;
      if (FIELDS.contains(tag) && fields.putIfAbsent(tag, values(at)) == null) {
        file.put(to, file.array(), at, ENTRY);
        to += ENTRY;
      }
    }
    file.putShort(start, (short) ((to - start) / ENTRY));
    file.putInt(to, 0);
  }

  private long[] values(int entry) throws ImageFormatException {
    int type = file.getShort(entry + 2);
    int tag = file.getShort(entry) & 0xffff;
    long count = Integer.toUnsignedLong(file.getInt(entry + 4));
    if (type != SHORT && type != LONG || count == 0) {
      throw malformed("TIFF is damaged: field " + tag + " has no whole numbers");
    }
    int size = type == SHORT ? Short.BYTES : Integer.BYTES;
    int at = count * size <= Integer.BYTES ? entry + 8 : file.getInt(entry + 8);
    if (at < 0 || count * size > file.limit() - at) {
      throw malformed("TIFF is truncated: field " + tag + " ends beyond the file");
    }
    long[] values = new long[(int) count];
    for (int i = 0; i < values.length; i++) {
      values[i] =
          type == SHORT
              ? file.getShort(at + size * i) & 0xffff
              : Integer.toUnsignedLong(file.getInt(at + size * i));
    }
    return values;
  }

  private long one(int tag, long missing) {
    return fields.containsKey(tag) ? fields.get(tag)[0] : missing;
  }

  /** Returns the number of channels, which may have one besides the colors. */
  private int channels() throws ImageFormatException {
    long colors = one(COLORS, -1);
    long channels = one(CHANNELS, 1);
    long least = colors == RGB ? 3 : 1;
    if (colors < 0 || colors > PALETTE) {
      String found =
          switch ((int) colors) {
            case 5 -> "CMYK colors";
            case 6 -> "YCbCr colors";
            case 8 -> "Lab colors";
            default -> "colors of the kind " + colors;
          };
      throw unsupported(found, "gray, RGB or a palette");
    }
    if (channels < least || channels > (colors == PALETTE ? 1 : least + 1)) {
      throw unsupported(channels + " channels", "gray, RGB or a palette, and alpha");
    }
    return (int) channels;
  }

  private int bits() throws ImageFormatException {
    long bits = one(BITS, 1);
    for (long other : fields.getOrDefault(BITS, new long[0])) {
      if (other != bits || bits > 16 || Long.bitCount(bits) != 1) {
        throw unsupported(other + " bits per channel", "1, 2, 4, 8 or 16");
      }
    }
    if (one(SAMPLE_FORMAT, 1) != 1) {
      throw unsupported("signed or floating-point numbers", "whole numbers from 0 up");
    }
    if (one(PREDICTOR, 1) != 1 && bits != 8) {
      throw unsupported("a predictor for " + bits + " bits per channel", "one for 8 bits");
    }
    return (int) bits;
  }

  private static ImageFormatException unsupported(String found, String expected) {
    return malformed("TIFF has " + found + ", expected " + expected + "; save it as a PNG");
  }

  /** Checks that the strips or tiles are in the file, and large enough for the picture. */
  private void checkBlocks(int width, int height, long pictureBytes) throws ImageFormatException {
    boolean isTiled = fields.containsKey(TILE_WIDTH);
    long tileWidth = one(TILE_WIDTH, 1);
    long tileHeight = one(TILE_HEIGHT, 1);
    if (tileWidth < 1
        || tileWidth > Math.max(COMMON_TILE, width + 15)
        || tileHeight < 1
        || tileHeight > Math.max(COMMON_TILE, height + 15)) {
      throw malformed("TIFF has tiles of " + tileWidth + "x" + tileHeight + " pixels");
    }
    long[] offsets = fields.getOrDefault(isTiled ? TILE_OFFSETS : STRIP_OFFSETS, new long[0]);
    long[] counts = fields.getOrDefault(isTiled ? TILE_BYTES : STRIP_BYTES, new long[0]);
    if (offsets.length == 0 || offsets.length != counts.length) {
      throw malformed(
          "TIFF has " + offsets.length + " offsets and " + counts.length + " sizes of its data");
    }
    long sum = 0;
    for (int i = 0; i < offsets.length; i++) {
      sum += counts[i];
      if (offsets[i] + counts[i] > file.limit() || sum > file.limit()) {
        throw malformed("TIFF is truncated: its data end beyond the file");
      }
    }
    long compression = one(COMPRESSION, UNCOMPRESSED);
    if (!COMPRESSIONS.contains(compression)) {
      throw unsupported(
          compression == 7 ? "JPEG compression" : "the compression " + compression,
          "none, LZW, Deflate, PackBits or fax");
    }
    boolean isFax = compression > UNCOMPRESSED && compression <= LAST_FAX;
    long most = compression == UNCOMPRESSED ? sum : MAX_EXPANSION * sum;
    if (!isFax && pictureBytes > most) {
      throw malformed("TIFF data are too short for " + width + "x" + height + " pixels");
    }
  }
}
