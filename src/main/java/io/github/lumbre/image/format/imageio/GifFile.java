package io.github.lumbre.image.format.imageio;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * The place of the first picture of a GIF file, whose other pictures are ignored (CompuServe,
 * "Graphics Interchange Format, version 89a").
 *
 * @param start position of the picture in the file
 * @param left column of the picture's left edge on the screen
 * @param top row of the picture's upper edge on the screen
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param screenWidth in pixels; at least up to the picture's right edge
 * @param screenHeight in pixels; at least down to the picture's lower edge
 */
public record GifFile(
    int start, int left, int top, int width, int height, int screenWidth, int screenHeight) {
  private static final int HEADER = 13;
  private static final int DESCRIPTOR = 10;
  private static final int IMAGE = 0x2c;
  private static final int EXTENSION = 0x21;

  /** More pixels than a byte of data can stand for: codes of 12 bits for at most 4096 pixels. */
  private static final long MAX_PIXELS_PER_BYTE = 4096 * 8 / 12 + 1;

  /** Memory of decoding: an index, four values of the picture and four of the screen. */
  private static final int BYTES_PER_PIXEL = 9;

  public static boolean startsIn(byte[] file) {
    return file.length >= HEADER
        && file[0] == 'G'
        && file[1] == 'I'
        && file[2] == 'F'
        && file[3] == '8';
  }

  /**
   * Reads the header of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if it is truncated, has no picture, exceeds the limits, or the
   *     picture is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    GifFile gif = read(file);
    PictureLimits.checkSize(gif.screenWidth, gif.screenHeight);
    PictureLimits.checkSize(gif.width, gif.height);
    if ((long) gif.width * gif.height > MAX_PIXELS_PER_BYTE * file.length) {
      throw malformed("GIF data are too short for " + gif.width + "x" + gif.height + " pixels");
    }
    return new EncodedPicture(
        gif.screenWidth,
        gif.screenHeight,
        BYTES_PER_PIXEL,
        () ->
            JdkDecoder.decode(
                "GIF", file, reader -> gif.onScreen(RasterPixels.of(reader.read(0)))));
  }

  /**
   * Returns whether a file that {@link #startsIn} recognizes has a second picture.
   *
   * @throws ImageFormatException if the file is damaged or truncated before it
   */
  public static boolean hasMorePictures(byte[] file) throws ImageFormatException {
    int start = read(file).start;
    // After the colors and the size of codes, the blocks of the picture; then extensions.
    int at = afterBlocks(file, start + DESCRIPTOR + colorBytes(file[start + 9]) + 1);
    while (at + 1 < file.length && file[at] == EXTENSION) {
      at = afterBlocks(file, at + 2);
    }
    return at < file.length && file[at] == IMAGE;
  }

  private static int colorBytes(int flags) {
    return (flags & 0x80) == 0 ? 0 : 3 << (flags & 7) + 1;
  }

  private static GifFile read(byte[] file) throws ImageFormatException {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    int at = HEADER + colorBytes(file[10]);
    while (at + DESCRIPTOR <= file.length) {
      if (file[at] == IMAGE) {
        int left = in.getShort(at + 1) & 0xffff;
        int top = in.getShort(at + 3) & 0xffff;
        int width = in.getShort(at + 5) & 0xffff;
        int height = in.getShort(at + 7) & 0xffff;
        return new GifFile(
            at,
            left,
            top,
            width,
            height,
            Math.max(in.getShort(6) & 0xffff, left + width),
            Math.max(in.getShort(8) & 0xffff, top + height));
      }
      if (file[at] != EXTENSION) {
        throw malformed("GIF is damaged: expected a picture at byte " + at);
      }
      at = afterBlocks(file, at + 2);
    }
    throw malformed("GIF is truncated");
  }

  /** Returns the position after a sequence of blocks, which ends with an empty one. */
  private static int afterBlocks(byte[] file, int from) {
    int at = from;
    while (at < file.length && file[at] != 0) {
      at += 1 + (file[at] & 0xff);
    }
    return at + 1;
  }

  /** Returns the picture on a transparent screen. */
  private Pixels onScreen(Pixels picture) {
    if (width == screenWidth && height == screenHeight) {
      return picture;
    }
    byte[] values = new byte[Math.multiplyExact(4, screenWidth * screenHeight)];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int to = 4 * ((top + y) * screenWidth + left + x);
        for (int channel = 0; channel < 3; channel++) {
          values[to + channel] = (byte) picture.raw(x, y, channel);
        }
        values[to + 3] = (byte) picture.alpha(x, y);
      }
    }
    return Pixels.of(screenWidth, screenHeight, 4, values);
  }
}
