package io.github.lumbre.image.format.gif;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.animation.AnimationFrames;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Writes animated GIF files (CompuServe, "Graphics Interchange Format, version 89a") that are
 * played for ever (Netscape's application extension). All frames have the same palette; a first
 * pass over the frames chooses it. Each frame after the first holds only the rectangle that
 * changes, or, if there are transparent pixels, the rectangle that is not transparent.
 */
public final class GifWriter {
  private static final int NO_DISPOSAL = 1;
  private static final int RESTORE_BACKGROUND = 2;

  private final AnimationFrames frames;
  private final GifPalette palette;
  private final int width;
  private final OutputStream out;

  private GifWriter(AnimationFrames frames, GifPalette palette, OutputStream out) {
    this.frames = frames;
    this.palette = palette;
    this.width = frames.width();
    this.out = out;
  }

  /**
   * Writes an animation.
   *
   * @param frames at most 50 per second, since viewers show shorter frames for 1/10 s
   * @throws IOException if a frame cannot be read or the stream not be written
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
   *     interrupt status stays set
   */
  public static void write(AnimationFrames frames, OutputStream out) throws IOException {
    ColorHistogram histogram = new ColorHistogram();
    for (int frame = 0; frame < frames.count(); frame++) {
      histogram.add(frames.argb(frame));
    }
    new GifWriter(frames, GifPalette.of(histogram), out).write();
  }

  private void write() throws IOException {
    writeHeader();
    // What is on the screen before a frame: nothing at first, and in a transparent animation.
    int[] shown = new int[width * frames.height()];
    Arrays.fill(shown, palette.transparent());
    for (int frame = 0; frame < frames.count(); frame++) {
      int[] indices = indices(frames.argb(frame));
      Box box = Box.ofChange(shown, indices, width);
      writeFrame(indices, box, frames.rate().hundredths(frame));
      if (!palette.isTransparent()) {
        shown = indices;
      }
    }
    out.write(';');
  }

  private int[] indices(int[] argb) {
    for (int i = 0; i < argb.length; i++) {
      if (i % width == 0) {
        Interrupts.check();
      }
      argb[i] = palette.index(argb[i], i % width, i / width);
    }
    return argb;
  }

  private void writeHeader() throws IOException {
    out.write("GIF89a".getBytes(StandardCharsets.US_ASCII));
    writeShort(width);
    writeShort(frames.height());
    // A global palette of unsorted colors, 8 bits each.
    out.write(0xf0 | palette.bits() - 1);
    // The index of the background, and an unknown aspect ratio of pixels.
    out.write(new byte[2]);
    out.write(palette.bytes());
    out.write(new byte[] {'!', (byte) 0xff, 11});
    out.write("NETSCAPE2.0".getBytes(StandardCharsets.US_ASCII));
    // A block of three bytes: the number of repetitions follows; 0 means without end.
    out.write(new byte[] {3, 1, 0, 0, 0});
  }

  private void writeFrame(int[] indices, Box box, int hundredths) throws IOException {
    boolean isTransparent = palette.isTransparent();
    out.write(new byte[] {'!', (byte) 0xf9, 4});
    int disposal = isTransparent ? RESTORE_BACKGROUND : NO_DISPOSAL;
    out.write(disposal << 2 | (isTransparent ? 1 : 0));
    writeShort(hundredths);
    out.write(isTransparent ? palette.transparent() : 0);
    out.write(0);
    out.write(',');
    writeShort(box.left);
    writeShort(box.top);
    writeShort(box.width);
    writeShort(box.height);
    // No palette of its own, and no interlacing.
    out.write(0);
    GifCodes codes = new GifCodes(Math.max(2, palette.bits()), out);
    for (int y = box.top; y < box.top + box.height; y++) {
      Interrupts.check();
      for (int x = box.left; x < box.left + box.width; x++) {
        codes.write(indices[y * width + x]);
      }
    }
    codes.end();
  }

  private void writeShort(int value) throws IOException {
    out.write(value);
    out.write(value >> Byte.SIZE);
  }

  /** A rectangle of pixels, at least one. */
  private record Box(int left, int top, int width, int height) {
    /** Returns the smallest rectangle that holds all pixels in which two pictures differ. */
    static Box ofChange(int[] before, int[] after, int width) {
      int left = width;
      int right = 0;
      int top = before.length;
      int bottom = 0;
      for (int i = 0; i < before.length; i++) {
        if (before[i] != after[i]) {
          left = Math.min(left, i % width);
          right = Math.max(right, i % width);
          top = Math.min(top, i / width);
          bottom = i / width;
        }
      }
      return left > right
          ? new Box(0, 0, 1, 1)
          : new Box(left, top, right - left + 1, bottom - top + 1);
    }
  }
}
