package io.github.lumbre.image.png;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.CRC32;

/**
 * Collects the chunks of a PNG file for the decoder. Consecutive image data chunks are merged into
 * one, because the JDK's decoder takes about 8 µs per chunk of any size: a minute for 90 MB of
 * empty chunks. Mutable.
 */
final class PngContent {
  /** The bytes before a chunk's data: its length and type. */
  private static final int HEAD_BYTES = 8;

  private final byte[] file;
  private final ByteBuffer out;
  private int run = -1;

  /**
   * @param file the bytes of the PNG file
   */
  PngContent(byte[] file) {
    this.file = file;
    out = ByteBuffer.allocate(file.length).put(file, 0, Long.BYTES);
  }

  /**
   * Adds a chunk.
   *
   * @param type chunk type
   * @param start position of the chunk in the file
   * @param length number of bytes of its data
   */
  void add(int type, int start, int length) {
    if (type != PngFile.IDAT) {
      endRun();
      out.put(file, start, length + PngFile.FRAME_BYTES);
      return;
    }
    if (run < 0) {
      run = out.position();
      out.putInt(0).putInt(type);
    }
    out.put(file, start + HEAD_BYTES, length);
  }

  private void endRun() {
    if (run >= 0) {
      out.putInt(run, out.position() - run - HEAD_BYTES);
      CRC32 crc = new CRC32();
      crc.update(out.array(), run + Integer.BYTES, out.position() - run - Integer.BYTES);
      out.putInt((int) crc.getValue());
      run = -1;
    }
  }

  /** Returns the signature and all chunks added. The last chunk added must not be image data. */
  byte[] bytes() {
    return Arrays.copyOf(out.array(), out.position());
  }
}
