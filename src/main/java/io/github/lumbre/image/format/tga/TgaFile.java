package io.github.lumbre.image.format.tga;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EmptyAlpha;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Decodes TGA files (Truevision TGA File Format Specification, version 2.0): with a palette, of
 * colors or of gray, packed or not, with any corner as the first pixel. An alpha
 * of 0 everywhere is none. Mutable; one for each file.
 */
public final class TgaFile {
  private static final byte[] FOOTER = "TRUEVISION-XFILE.\0".getBytes(StandardCharsets.US_ASCII);
  private static final int RUN = 0x80;
  private static final int MAX_RUN = 128;

  private final byte[] file;
  private final TgaHeader header;
  private final int channels;
  private final byte[] values;

  /** Position of the next pixel, or of the next packet's first byte. */
  private int at;

  /** Pixels left in the current packet. */
  private int left;

  private boolean isRun;

  private TgaFile(byte[] file, TgaHeader header) {
    this.file = file;
    this.header = header;
    channels = header.channels();
    values = new byte[Math.multiplyExact(channels, header.width() * header.height())];
    at = header.data();
  }

  /**
   * Returns whether a file is a TGA file. The format has no signature: the file has either the
   * footer of version 2, or a header whose fields suit each other.
   */
  public static boolean isIn(byte[] file) {
    return file.length >= TgaHeader.BYTES && (TgaHeader.of(file).isSupported() || hasFooter(file));
  }

  private static boolean hasFooter(byte[] file) {
    int start = file.length - FOOTER.length;
    return start >= 0 && Arrays.equals(file, start, file.length, FOOTER, 0, FOOTER.length);
  }

  /**
   * Reads the header of a file that {@link #isIn} recognizes.
   *
   * @throws ImageFormatException if the picture is not of a supported kind, exceeds the limits or
   *     is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    TgaHeader header = TgaHeader.of(file);
    if (!header.isSupported()) {
      String found =
          "TGA has the image type %d, %d bits per pixel, %d colors of %d bits and the descriptor %d"
              .formatted(
                  header.type(),
                  header.depth(),
                  header.colors(),
                  header.colorDepth(),
                  header.descriptor());
      throw malformed(
          found + "; expected the type 1, 2, 3, 9, 10 or 11 with 8 to 32 bits, not interleaved");
    }
    PictureLimits.checkSize(header.width(), header.height());
    long pixels = (long) header.width() * header.height();
    long present = Math.max(0, file.length - header.data());
    // A packet of one pixel stands for at most 128.
    long most =
        header.isPacked()
            ? present / (1 + header.pixelBytes()) * MAX_RUN
            : present / header.pixelBytes();
    if (pixels > most) {
      throw malformed(
          "TGA data are too short for " + header.width() + "x" + header.height() + " pixels");
    }
    return new EncodedPicture(
        header.width(),
        header.height(),
        2 * header.channels(),
        () -> new TgaFile(file, header).decode());
  }

  private Pixels decode() throws ImageFormatException {
    int width = header.width();
    int height = header.height();
    for (int row = 0; row < height; row++) {
      Interrupts.check();
      int y = header.isTopDown() ? row : height - 1 - row;
      for (int column = 0; column < width; column++) {
        int x = header.isRightToLeft() ? width - 1 - column : column;
        put(next(), (y * width + x) * channels);
      }
    }
    return EmptyAlpha.dropped(Pixels.of(width, height, channels, values));
  }

  /** Returns the position of the next pixel's bytes. */
  private int next() throws ImageFormatException {
    boolean isPacked = header.isPacked();
    if (isPacked && left == 0) {
      int packet = file[require(at, 1)] & 0xff;
      at++;
      isRun = packet >= RUN;
      left = 1 + packet % RUN;
    }
    int pixel = require(at, header.pixelBytes());
    left--;
    at += isPacked && isRun && left > 0 ? 0 : header.pixelBytes();
    return pixel;
  }

  private int require(int position, int count) throws ImageFormatException {
    if (position > file.length - count) {
      throw malformed("TGA is truncated");
    }
    return position;
  }

  private void put(int pixel, int to) throws ImageFormatException {
    int from = header.isMapped() ? color(pixel) : pixel;
    switch (header.valueDepth()) {
      case 8 -> values[to] = file[from];
      case 15 -> putPacked(from, to);
      case 16 -> {
        if (channels < 3) {
          System.arraycopy(file, from, values, to, channels);
        } else {
          putPacked(from, to);
        }
      }
      default -> {
        values[to] = file[from + 2];
        values[to + 1] = file[from + 1];
        values[to + 2] = file[from];
        if (channels == 4) {
          values[to + 3] = file[from + 3];
        }
      }
    }
  }

  /** Returns the position of a color of the palette. */
  private int color(int pixel) throws ImageFormatException {
    int index = header.pixelBytes() == 1 ? file[pixel] & 0xff : word(pixel);
    int color = index - header.first();
    if (color < 0 || color >= header.colors()) {
      throw malformed(
          "TGA has the color %d, expected %d to %d"
              .formatted(index, header.first(), header.first() + header.colors() - 1));
    }
    return header.palette() + color * header.colorBytes();
  }

  /** Writes a color of 5 bits per channel, and one of alpha. */
  private void putPacked(int from, int to) {
    int word = word(from);
    for (int channel = 0; channel < 3; channel++) {
      values[to + channel] = (byte) Math.round((word >> 10 - 5 * channel & 31) * 255f / 31);
    }
    if (channels == 4) {
      values[to + 3] = (byte) (word >> 15 == 0 ? 0 : 255);
    }
  }

  private int word(int position) {
    return file[position] & 0xff | (file[position + 1] & 0xff) << 8;
  }
}
