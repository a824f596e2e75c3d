package io.github.lumbre.image.format.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Decodes the image data of a PNG file (PNG specification, third edition). For one thread. */
final class PngDecoder {
  /** Interlaced passes: first column, first row, and the steps between columns and rows. */
  private static final int[][] PASSES = {
    {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
  };

  private static final int[][] ONE_PASS = {{0, 0, 1, 1}};
  private static final int WIDE = 16;

  private final PngFile png;
  private final int depth;
  private final int samples;
  private final int channels;
  private final int[] key;
  private final byte[] bytes;
  private final short[] shorts;
  private final PngData data;

  PngDecoder(PngFile png, Inflater inflater) {
    this.png = png;
    depth = png.depth();
    samples = png.samples();
    key = png.transparency().key();
    channels = png.channels();
    int values = Math.multiplyExact(channels, Math.multiplyExact(png.width(), png.height()));
    bytes = new byte[depth == WIDE ? 0 : values];
    shorts = new short[depth == WIDE ? values : 0];
    data = new PngData(png.file(), inflater);
  }

  Pixels decode() throws ImageFormatException {
    for (int[] pass : png.isInterlaced() ? PASSES : ONE_PASS) {
      int columns = (png.width() - pass[0] + pass[2] - 1) / pass[2];
      int rows = (png.height() - pass[1] + pass[3] - 1) / pass[3];
      if (columns > 0 && rows > 0) {
        decode(pass, columns, rows);
      }
    }
    data.end();
    return depth == WIDE
        ? Pixels.of(png.width(), png.height(), channels, shorts)
        : Pixels.of(png.width(), png.height(), channels, bytes);
  }

  private void decode(int[] pass, int columns, int rows) throws ImageFormatException {
    int bits = depth * samples;
    int length = (int) (((long) columns * bits + 7) / 8);
    int distance = Math.max(1, bits / 8);
    byte[] row = new byte[distance + length];
    byte[] above = new byte[distance + length];
    boolean isStored = depth == 8 && pass[2] == 1 && channels == samples;
    for (int i = 0; i < rows; i++) {
      Interrupts.check();
      data.read(row, distance - 1, length + 1);
      int filter = row[distance - 1] & 0xff;
      row[distance - 1] = 0;
      PngFilter.undo(filter, row, above, distance);
      int to = channels * (png.width() * (pass[1] + i * pass[3]) + pass[0]);
      if (isStored && !png.hasPalette()) {
        System.arraycopy(row, distance, bytes, to, length);
      } else {
        for (int x = 0; x < columns; x++, to += channels * pass[2]) {
          store(row, distance, x, to);
        }
      }
      byte[] next = above;
      above = row;
      row = next;
    }
  }

  private void store(byte[] row, int start, int x, int to) {
    if (png.hasPalette()) {
      int index = sample(row, start, x);
      for (int c = 0; c < 3; c++) {
        bytes[to + c] = png.palette()[3 * index + c];
      }
      if (channels == 4) {
        bytes[to + 3] = (byte) png.transparency().alpha(index);
      }
      return;
    }
    boolean isKey = key.length > 0;
    for (int c = 0; c < samples; c++) {
      int sample = sample(row, start, samples * x + c);
      isKey &= key.length > 0 && sample == key[c];
      put(to + c, depth < 8 ? sample * 255 / ((1 << depth) - 1) : sample);
    }
    if (channels > samples) {
      put(to + samples, isKey ? 0 : 0xffff);
    }
  }

  private void put(int to, int value) {
    if (depth == WIDE) {
      shorts[to] = (short) value;
    } else {
      bytes[to] = (byte) value;
    }
  }

  private int sample(byte[] row, int start, int i) {
    if (depth == WIDE) {
      return (row[start + 2 * i] & 0xff) << 8 | row[start + 2 * i + 1] & 0xff;
    }
    int bit = i * depth;
    return row[start + (bit >> 3)] >> 8 - depth - (bit & 7) & (1 << depth) - 1;
  }

  /** Inflates the image data of a PNG file whose chunks were checked. Mutable. */
  private static final class PngData {
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
}
