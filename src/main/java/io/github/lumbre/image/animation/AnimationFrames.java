package io.github.lumbre.image.animation;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.png.PngFile;
import io.github.lumbre.image.internal.EncodedPicture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The frames of an animation: PNG files of one size. Each is read when it is needed, and only one
 * is in memory at a time. Immutable.
 *
 * @param files the frames in order, at least one
 * @param rate of all frames
 * @param width in pixels
 * @param height in pixels
 */
public record AnimationFrames(List<Path> files, FrameRate rate, int width, int height) {
  /** Creates the frames; {@link #open} reads their size. */
  public AnimationFrames {
    files = List.copyOf(files);
  }

  /**
   * Returns frames whose size is the size of the first one.
   *
   * @throws ImageFormatException if the first file is no PNG file
   * @throws IOException if the first file cannot be read
   */
  public static AnimationFrames open(List<Path> files, FrameRate rate) throws IOException {
    if (files.isEmpty()) {
      throw new IllegalArgumentException("files: expected at least one frame");
    }
    EncodedPicture first = header(files.get(0), Files.readAllBytes(files.get(0)));
    return new AnimationFrames(files, rate, first.width(), first.height());
  }

  /** Returns the number of frames. */
  public int count() {
    return files.size();
  }

  /**
   * Returns whether the first frame has alpha.
   *
   * @throws IOException as {@link #bytes}
   */
  public boolean haveAlpha() throws IOException {
    return ImageReader.decode(bytes(0)).hasAlpha();
  }

  /**
   * Returns the bytes of a frame, a PNG file whose checksums are right.
   *
   * @param frame counted from 0
   * @throws ImageFormatException if the file is no PNG file, is damaged or has another size
   * @throws IOException if the file cannot be read
   */
  public byte[] bytes(int frame) throws IOException {
    Path file = files.get(frame);
    byte[] bytes = Files.readAllBytes(file);
    EncodedPicture header = header(file, bytes);
    if (header.width() != width || header.height() != height) {
      throw malformed(
          "%s: has %dx%d pixels, expected %dx%d, as %s has"
              .formatted(file, header.width(), header.height(), width, height, files.get(0)));
    }
    return bytes;
  }

  /**
   * Returns the pixels of a frame, row by row: 8 bits each of alpha, red, green and blue, from the
   * highest bits to the lowest. Alpha is straight, and 255 without any.
   *
   * @throws IOException as {@link #bytes}
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
   *     interrupt status stays set
   */
  public int[] argb(int frame) throws IOException {
    Pixels pixels = ImageReader.decode(bytes(frame));
    int[] argb = new int[width * height];
    int max = pixels.max();
    for (int i = 0; i < argb.length; i++) {
      int x = i % width;
      int y = i / width;
      int value = toByte(pixels.alpha(x, y), max);
      for (int channel = 0; channel < 3; channel++) {
        value = value << Byte.SIZE | toByte(pixels.raw(x, y, channel), max);
      }
      argb[i] = value;
    }
    return argb;
  }

  private static int toByte(int value, int max) {
    return max == 0xff ? value : (value * 0xff + max / 2) / max;
  }

  private static EncodedPicture header(Path file, byte[] bytes) throws ImageFormatException {
    if (!PngFile.startsIn(bytes)) {
      throw malformed(file + ": expected a PNG picture");
    }
    try {
      return PngFile.open(bytes);
    } catch (ImageFormatException e) {
      throw new ImageFormatException(e.kind(), file + ": " + e.getMessage(), e);
    }
  }
}
