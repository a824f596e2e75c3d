package io.github.lumbre.image.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Inflates the image data of a PNG file whose chunks were checked. Mutable. */
final class PngData {
  private final ByteBuffer file;
  private final Inflater inflater;
  private int at = Long.BYTES;

  PngData(byte[] file, Inflater inflater) {
    this.file = ByteBuffer.wrap(file);
    this.inflater = inflater;
  }

  /** Reads as many bytes as are asked for. */
  void read(byte[] target, int from, int length) throws ImageFormatException {
    int left = length;
    while (left > 0) {
      int count = inflate(target, from + length - left, left);
      if (count == 0 && !next()) {
        throw malformed("PNG ends too early");
      }
      left -= count;
    }
  }

  /** Checks the sum of all bytes if the data end here. */
  void end() throws ImageFormatException {
    byte[] rest = new byte[1];
    while (inflate(rest, 0, 1) == 0 && next()) {
      // The sum may be in a further chunk.
    }
  }

  private int inflate(byte[] target, int from, int length) throws ImageFormatException {
    try {
      return inflater.inflate(target, from, length);
    } catch (DataFormatException e) {
      String reason = e.getMessage() == null ? "" : ": " + e.getMessage();
      throw malformed("PNG is damaged" + reason);
    }
  }

  /** Passes the next chunk of image data to the inflater, and returns whether there is one. */
  private boolean next() {
    boolean needsMore = inflater.needsInput() && !inflater.finished();
    while (needsMore && file.getInt(at + 4) != PngFile.IEND) {
      int start = at + 8;
      int length = file.getInt(at);
      at += length + PngFile.FRAME_BYTES;
      if (file.getInt(start - 4) == PngFile.IDAT && length > 0) {
        inflater.setInput(file.array(), start, length);
        return true;
      }
    }
    return false;
  }
}
