package io.github.lumbre.image.format.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.animation.AnimationFrames;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Map;

/**
 * Writes animated PNG files (PNG specification, third edition, sections 4.9 and 11.3.6) that are
 * played for ever. The compressed pixels of the frames are copied, so nothing is lost; the first
 * frame is what viewers without animation show.
 */
public final class ApngWriter {
  private static final int GAMA = 0x67414d41;
  private static final int SRGB = 0x73524742;
  private static final int CONTROL_BYTES = 26;

  /** The position of the color type. */
  private static final int COLOR_TYPE = 25;

  /** The position after the header. */
  private static final int HEADER_END = 33;

  private final AnimationFrames frames;
  private final OutputStream out;
  private int sequence;

  private ApngWriter(AnimationFrames frames, OutputStream out) {
    this.frames = frames;
    this.out = out;
  }

  /**
   * Writes an animation.
   *
   * @param frames whose bits per channel and channels are the same, without a palette
   * @param texts metadata by keyword
   * @throws IOException if a frame cannot be read or differs in kind from the first one, or the
   *     stream cannot be written
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted; the
   *     interrupt status stays set
   */
  public static void write(AnimationFrames frames, Map<String, String> texts, OutputStream out)
      throws IOException {
    new ApngWriter(frames, out).write(texts);
  }

  private void write(Map<String, String> texts) throws IOException {
    byte[] first = frames.bytes(0);
    if (first[COLOR_TYPE] == PngFile.PALETTE) {
      throw malformed(frames.files().get(0) + ": expected colors without a palette");
    }
    writeStart(first, texts);
    writeFrame(first, 0);
    for (int frame = 1; frame < frames.count(); frame++) {
      Interrupts.check();
      byte[] bytes = frames.bytes(frame);
      if (!Arrays.equals(bytes, 0, HEADER_END, first, 0, HEADER_END)) {
        throw malformed(
            "%s: expected the bits and channels of %s"
                .formatted(frames.files().get(frame), frames.files().get(0)));
      }
      writeFrame(bytes, frame);
    }
    PngWriter.writeChunk("IEND", new byte[0], 0, out);
  }

  /** Writes what comes before the first frame, with the color space of that frame. */
  private void writeStart(byte[] first, Map<String, String> texts) throws IOException {
    out.write(first, 0, HEADER_END);
    // Without end: 0 repetitions.
    byte[] control = ByteBuffer.allocate(8).putInt(frames.count()).putInt(0).array();
    PngWriter.writeChunk("acTL", control, control.length, out);
    for (int at = HEADER_END; type(first, at) != PngFile.IEND; at = next(first, at)) {
      int type = type(first, at);
      if (type == SRGB || type == GAMA) {
        out.write(first, at, next(first, at) - at);
      }
    }
    for (Map.Entry<String, String> text : texts.entrySet()) {
      PngWriter.writeText(text.getKey(), text.getValue(), out);
    }
  }

  private void writeFrame(byte[] file, int frame) throws IOException {
    ByteBuffer control = ByteBuffer.allocate(CONTROL_BYTES);
    control.putInt(sequence++).putInt(frames.width()).putInt(frames.height());
    // At the upper left corner.
    control.putInt(0).putInt(0);
    control.putShort((short) frames.rate().seconds()).putShort((short) frames.rate().frames());
    // The frame is left as it is, and the next one replaces all of it.
    control.put((byte) 0).put((byte) 0);
    PngWriter.writeChunk("fcTL", control.array(), CONTROL_BYTES, out);
    for (int at = HEADER_END; type(file, at) != PngFile.IEND; at = next(file, at)) {
      if (type(file, at) == PngFile.IDAT && frame == 0) {
        out.write(file, at, next(file, at) - at);
      } else if (type(file, at) == PngFile.IDAT) {
        int length = next(file, at) - at - PngFile.FRAME_BYTES;
        byte[] data =
            ByteBuffer.allocate(Integer.BYTES + length)
                .putInt(sequence++)
                .put(file, at + 8, length)
                .array();
        PngWriter.writeChunk("fdAT", data, data.length, out);
      }
    }
  }

  private static int type(byte[] file, int at) {
    return ByteBuffer.wrap(file).getInt(at + 4);
  }

  /** Returns the position of the next chunk. All chunks were checked before. */
  private static int next(byte[] file, int at) {
    return at + PngFile.FRAME_BYTES + ByteBuffer.wrap(file).getInt(at);
  }
}
