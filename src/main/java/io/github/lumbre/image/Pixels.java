package io.github.lumbre.image;

import io.github.lumbre.image.png.PngTransparency;
import io.github.lumbre.image.png.PngWriter;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentSampleModel;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * A decoded picture file: the encoded channel values as the file has them, 8 or 16 bits each, row 0
 * at the top. Whether they are sRGB or data is not known here.
 *
 * <p>Immutable and safe for use by any thread, as long as nobody changes the arrays from which it
 * was created. It takes at most 4 bytes per pixel with 8 bits per channel, and at most 8 with 16
 * bits.
 */
public final class Pixels {
  private static final byte[] NO_BYTES = {};
  private static final short[] NO_SHORTS = {};

  private final int width;
  private final int height;
  private final byte[] bytes;
  private final short[] shorts;
  private final int pixelStride;
  private final int rowStride;
  private final int red;
  private final int green;
  private final int blue;

  /** Offset of alpha in a pixel; -1 without alpha. */
  private final int alpha;

  /**
   * The samples of the color that is transparent: one of gray, or three; empty if there is none.
   */
  private final int[] key;

  private Pixels(
      int width, int height, byte[] bytes, short[] shorts, int pixelStride, int[] bandOffsets) {
    this(width, height, bytes, shorts, pixelStride, bandOffsets, new int[0]);
  }

  private Pixels(
      int width,
      int height,
      byte[] bytes,
      short[] shorts,
      int pixelStride,
      int[] bandOffsets,
      int[] key) {
    this.key = key;
    this.width = width;
    this.height = height;
    this.bytes = bytes;
    this.shorts = shorts;
    this.pixelStride = pixelStride;
    this.rowStride = pixelStride * width;
    boolean grey = bandOffsets.length < 3;
    red = bandOffsets[0];
    green = bandOffsets[grey ? 0 : 1];
    blue = bandOffsets[grey ? 0 : 2];
    alpha = bandOffsets.length % 2 == 0 ? bandOffsets[bandOffsets.length - 1] : -1;
  }

  /**
   * Returns a picture of 8-bit values. The array is shared with the caller.
   *
   * @param channels 1 for gray, 2 for gray and alpha, 3 for red, green and blue, or 4 with alpha
   * @param values row by row from the top, channel after channel in each texel
   * @throws IllegalArgumentException if the sizes do not fit together
   */
  public static Pixels of(int width, int height, int channels, byte[] values) {
    check(width, height, channels, values.length);
    return new Pixels(width, height, values, NO_SHORTS, channels, natural(channels));
  }

  /** Returns a picture of 16-bit values; see {@link #of(int, int, int, byte[])}. */
  public static Pixels of(int width, int height, int channels, short[] values) {
    check(width, height, channels, values.length);
    return new Pixels(width, height, NO_BYTES, values, channels, natural(channels));
  }

  /**
   * Returns the values of a decoded picture, without copying them if possible.
   *
   * @param transparency of colors of a picture without alpha
   */
  static Pixels of(BufferedImage picture, PngTransparency transparency) {
    Raster raster = picture.getRaster();
    if (picture.getColorModel() instanceof IndexColorModel palette) {
      return looked(raster, palette, transparency);
    }
    ComponentSampleModel model = (ComponentSampleModel) raster.getSampleModel();
    boolean wide = raster.getDataBuffer() instanceof DataBufferUShort;
    Pixels pixels =
        new Pixels(
            raster.getWidth(),
            raster.getHeight(),
            wide ? NO_BYTES : ((DataBufferByte) raster.getDataBuffer()).getData(),
            wide ? ((DataBufferUShort) raster.getDataBuffer()).getData() : NO_SHORTS,
            model.getPixelStride(),
            model.getBandOffsets(),
            transparency.key());
    if (model.getScanlineStride() != pixels.rowStride) {
      throw new IllegalArgumentException("picture: expected rows without gaps");
    }
    return pixels;
  }

  private static Pixels looked(
      Raster raster, IndexColorModel palette, PngTransparency transparency) {
    int width = raster.getWidth();
    int channels = transparency.isPresent() ? 4 : 3;
    byte[] rgb = new byte[channels * width * raster.getHeight()];
    int[] row = new int[width];
    int i = 0;
    for (int y = 0; y < raster.getHeight(); y++) {
      raster.getSamples(0, y, width, 1, 0, row);
      for (int index : row) {
        Objects.checkIndex(index, palette.getMapSize());
        rgb[i++] = (byte) palette.getRed(index);
        rgb[i++] = (byte) palette.getGreen(index);
        rgb[i++] = (byte) palette.getBlue(index);
        if (channels == 4) {
          rgb[i++] = (byte) transparency.alpha(index);
        }
      }
    }
    return of(width, raster.getHeight(), channels, rgb);
  }

  /** Returns the bytes of a PNG file with the same values: RGB, and alpha if there is any. */
  public byte[] toPng() {
    try {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      PngWriter.write(this, out);
      return out.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void check(int width, int height, int channels, int values) {
    if (width < 1 || height < 1 || channels < 1 || channels > 4) {
      throw new IllegalArgumentException(
          "pixels: expected at least 1x1 and 1 to 4 channels, found %dx%d and %d"
              .formatted(width, height, channels));
    }
    if (values != (long) width * height * channels) {
      throw new IllegalArgumentException(
          "values: expected %dx%dx%d values, found %d".formatted(width, height, channels, values));
    }
  }

  private static int[] natural(int channels) {
    return IntStream.range(0, channels).toArray();
  }

  /** Returns the number of columns. */
  public int width() {
    return width;
  }

  /** Returns the number of rows. */
  public int height() {
    return height;
  }

  /** Returns the largest encoded value: 255 or 65535. */
  public int max() {
    return bytes.length == 0 ? 0xffff : 0xff;
  }

  /**
   * Returns an encoded value from 0 to {@link #max}.
   *
   * @param x the column, counted from the left
   * @param y the row, counted from the top
   * @param channel 0 red, 1 green, 2 blue; in a gray picture all are the same
   */
  public int raw(int x, int y, int channel) {
    return at(x, y, channel == 0 ? red : channel == 1 ? green : blue);
  }

  /**
   * Looks up the values of a row and a channel in a table; faster than one {@link #raw} each.
   *
   * @param table a number for each encoded value
   * @param row receives a number for each column
   */
  public void lookUp(int y, int channel, double[] table, double[] row) {
    int i = y * rowStride + (channel == 0 ? red : channel == 1 ? green : blue);
    boolean isWide = bytes.length == 0;
    for (int x = 0; x < width; x++, i += pixelStride) {
      row[x] = table[isWide ? shorts[i] & 0xffff : bytes[i] & 0xff];
    }
  }

  /** Returns an encoded alpha from 0 to {@link #max}, which is the result without alpha. */
  public int alpha(int x, int y) {
    return alpha >= 0 ? at(x, y, alpha) : isKey(x, y) ? 0 : max();
  }

  private boolean isKey(int x, int y) {
    for (int i = 0; i < key.length; i++) {
      if (raw(x, y, i) != key[i]) {
        return false;
      }
    }
    return key.length > 0;
  }

  /** Returns whether the picture has alpha. */
  public boolean hasAlpha() {
    return alpha >= 0 || key.length > 0;
  }

  private int at(int x, int y, int offset) {
    int i = y * rowStride + x * pixelStride + offset;
    return bytes.length == 0 ? shorts[i] & 0xffff : bytes[i] & 0xff;
  }

  /** Returns {@link #raw} divided by {@link #max}: an encoded value in [0,1]. */
  public double value(int x, int y, int channel) {
    return (double) raw(x, y, channel) / max();
  }
}
