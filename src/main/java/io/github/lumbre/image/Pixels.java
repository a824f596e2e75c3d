package io.github.lumbre.image;

import io.github.lumbre.image.format.png.PngWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

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
  private final int channels;

  private Pixels(int width, int height, int channels, byte[] bytes, short[] shorts) {
    this.width = width;
    this.height = height;
    this.channels = channels;
    this.bytes = bytes;
    this.shorts = shorts;
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
    return new Pixels(width, height, channels, values, NO_SHORTS);
  }

  /** Returns a picture of 16-bit values; see {@link #of(int, int, int, byte[])}. */
  public static Pixels of(int width, int height, int channels, short[] values) {
    check(width, height, channels, values.length);
    return new Pixels(width, height, channels, NO_BYTES, values);
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
    return at(x, y, offset(channel));
  }

  /**
   * Looks up the values of a row and a channel in a table; faster than one {@link #raw} each.
   *
   * @param table a number for each encoded value
   * @param row receives a number for each column
   */
  public void lookUp(int y, int channel, double[] table, double[] row) {
    int i = y * width * channels + offset(channel);
    boolean isWide = bytes.length == 0;
    for (int x = 0; x < width; x++, i += channels) {
      row[x] = table[isWide ? shorts[i] & 0xffff : bytes[i] & 0xff];
    }
  }

  /** Returns an encoded alpha from 0 to {@link #max}, which is the result without alpha. */
  public int alpha(int x, int y) {
    return hasAlpha() ? at(x, y, channels - 1) : max();
  }

  /** Returns whether the picture has alpha. */
  public boolean hasAlpha() {
    return channels % 2 == 0;
  }

  /** Returns the place in a pixel of a color channel, which is the same for all if it is gray. */
  private int offset(int channel) {
    return channels < 3 ? 0 : channel;
  }

  private int at(int x, int y, int offset) {
    int i = (y * width + x) * channels + offset;
    return bytes.length == 0 ? shorts[i] & 0xffff : bytes[i] & 0xff;
  }

  /** Returns {@link #raw} divided by {@link #max}: an encoded value in [0,1]. */
  public double value(int x, int y, int channel) {
    return (double) raw(x, y, channel) / max();
  }

  /** Returns the size and the kind of values, for people. */
  @Override
  public String toString() {
    return "Pixels: %sx%s, %s channels of %s bits"
        .formatted(width, height, channels, shorts.length == 0 ? 8 : 16);
  }
}
