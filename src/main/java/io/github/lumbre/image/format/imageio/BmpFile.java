package io.github.lumbre.image.format.imageio;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EmptyAlpha;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Objects;
import javax.imageio.ImageReader;

/**
 * Checks the header of a BMP file before Java decodes the picture (Microsoft, "Bitmap Storage" and
 * BITMAPV5HEADER). The decoder receives a copy without sizes that it would allocate unchecked, and
 * without a color profile.
 */
public final class BmpFile {
  private static final int FILE_HEADER = 14;
  private static final int CORE_HEADER = 12;
  private static final int INFO_HEADER = 40;
  private static final int V4_HEADER = 108;
  private static final int V5_HEADER = 124;
  private static final int FILE_SIZE_AT = 2;
  private static final int RESERVED_AT = 6;
  private static final int DATA_AT = 10;
  private static final int DATA_SIZE_AT = 34;
  private static final int COLOR_SPACE_AT = 70;
  private static final int PROFILE_AT = 126;
  private static final int PROFILE_SIZE_AT = 130;
  private static final int SRGB = 0x73524742;
  private static final int EMBEDDED = 0x4d424544;
  private static final int RLE8 = 1;
  private static final int RLE4 = 2;
  private static final int BIT_FIELDS = 3;

  /** Pixels that a byte of packed data can skip: 255 columns and rows by four bytes. */
  private static final long MAX_SKIPPED = 255 * 255 / 4 + 1;

  /** Memory of decoding: 4 bytes for the decoded picture and for its values, and 4 for buffers. */
  private static final int BYTES_PER_PIXEL = 12;

  private BmpFile() {}

  public static boolean startsIn(byte[] file) {
    return file.length >= FILE_HEADER
        && file[0] == 'B'
        && file[1] == 'M'
        && buffer(file).getInt(RESERVED_AT) == 0;
  }

  private static ByteBuffer buffer(byte[] file) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Returns the ICC profile of a file that {@link #startsIn} recognizes; empty if there is none.
   *
   * @throws IndexOutOfBoundsException if the file is truncated
   */
  public static byte[] profile(byte[] file) {
    ByteBuffer in = buffer(file);
    if (in.getInt(FILE_HEADER) < V5_HEADER || in.getInt(COLOR_SPACE_AT) != EMBEDDED) {
      return new byte[0];
    }
    int size = in.getInt(PROFILE_SIZE_AT);
    int from = Objects.checkFromIndexSize(FILE_HEADER + in.getInt(PROFILE_AT), size, file.length);
    return Arrays.copyOfRange(file, from, from + size);
  }

  /**
   * Reads the header of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if it is truncated or not of a supported kind, exceeds the limits,
   *     or the picture is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    ByteBuffer in = buffer(file.clone());
    int size = file.length < FILE_HEADER + CORE_HEADER ? 0 : in.getInt(FILE_HEADER);
    boolean isCore = size == CORE_HEADER;
    if (!isCore && size < INFO_HEADER || size > file.length - FILE_HEADER) {
      throw malformed("BMP has a header of " + size + " bytes, expected 12 or at least 40");
    }
    int width = isCore ? in.getShort(18) & 0xffff : in.getInt(18);
    int height = isCore ? in.getShort(20) & 0xffff : Math.abs(in.getInt(22));
    PictureLimits.checkSize(width, height);
    int bits = in.getShort(isCore ? 24 : 28);
    int compression = isCore ? 0 : in.getInt(30);
    if (compression < 0 || compression > BIT_FIELDS) {
      throw malformed(
          "BMP has the compression " + compression + ", expected 0 to 3; save it as a PNG");
    }
    long data = (long) file.length - Integer.toUnsignedLong(in.getInt(DATA_AT));
    boolean isPacked = compression == RLE8 || compression == RLE4;
    long rows = (31L + (long) width * bits) / 32 * 4 * height;
    if (isPacked ? (long) width * height > MAX_SKIPPED * data : rows > data) {
      throw malformed("BMP data are too short for " + width + "x" + height + " pixels");
    }
    in.putInt(FILE_SIZE_AT, file.length);
    if (!isCore) {
      in.putInt(DATA_SIZE_AT, 0);
    }
    if (size >= V4_HEADER) {
      in.putInt(COLOR_SPACE_AT, SRGB);
    }
    return new EncodedPicture(
        width,
        height,
        BYTES_PER_PIXEL,
        () -> JdkDecoder.decode("BMP", in.array(), BmpFile::pixels));
  }

  /** Returns the pixels; an alpha of 0 everywhere is none. */
  private static Pixels pixels(ImageReader reader) throws IOException {
    return EmptyAlpha.dropped(RasterPixels.of(reader.read(0)));
  }
}
