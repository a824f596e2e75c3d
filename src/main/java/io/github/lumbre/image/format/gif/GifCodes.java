package io.github.lumbre.image.format.gif;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;

/**
 * Compresses the pixels of a GIF picture (GIF specification, version 89a, appendix F: LZW with
 * codes of 3 to 12 bits, in blocks of up to 255 bytes). A full table of codes is cleared. Mutable.
 */
final class GifCodes {
  private static final int MAX_CODES = 4096;
  private static final int MAX_BITS = 12;
  private static final int MAX_BLOCK = 255;

  private final OutputStream out;
  private final int clear;
  private final int codeBits;

  /** The code of each string: by the code of all but its last pixel, and that pixel; or 0. */
  private final short[] codes = new short[MAX_CODES << Byte.SIZE];

  private int next;
  private int bits;

  /** The code of the pixels that are not written yet; -1 if there are none. */
  private int prefix = -1;

  private final byte[] block = new byte[MAX_BLOCK];
  private int blockLength;
  private int buffer;
  private int buffered;

  /**
   * @param pixelBits the bits of a pixel, 2 to 8
   */
  GifCodes(int pixelBits, OutputStream out) throws IOException {
    this.out = out;
    clear = 1 << pixelBits;
    codeBits = pixelBits + 1;
    out.write(pixelBits);
    bits = codeBits;
    clear();
  }

  private void clear() throws IOException {
    put(clear);
    Arrays.fill(codes, (short) 0);
    bits = codeBits;
    // The code after the clear code ends the picture.
    next = clear + 2;
  }

  /** Writes a pixel. */
  void write(int pixel) throws IOException {
    if (prefix < 0) {
      prefix = pixel;
      return;
    }
    int string = prefix << Byte.SIZE | pixel;
    if (codes[string] > 0) {
      prefix = codes[string];
      return;
    }
    put(prefix);
    if (next < MAX_CODES) {
      codes[string] = (short) next;
      grow();
    } else {
      clear();
    }
    prefix = pixel;
  }

  /** Writes what is left, and ends the picture. */
  void end() throws IOException {
    put(prefix);
    // The reader's table grows once more.
    grow();
    put(clear + 1);
    while (buffered > 0) {
      putByte();
    }
    writeBlock();
    out.write(0);
  }

  /** Counts a new code. The reader learns it one code later, so its width is then the new one. */
  private void grow() {
    if (next == 1 << bits && bits < MAX_BITS) {
      bits++;
    }
    next++;
  }

  private void put(int code) throws IOException {
    buffer |= code << buffered;
    buffered += bits;
    while (buffered >= Byte.SIZE) {
      putByte();
    }
  }

  private void putByte() throws IOException {
    block[blockLength++] = (byte) buffer;
    buffer >>>= Byte.SIZE;
    buffered -= Byte.SIZE;
    if (blockLength == MAX_BLOCK) {
      writeBlock();
    }
  }

  private void writeBlock() throws IOException {
    if (blockLength > 0) {
      out.write(blockLength);
      out.write(block, 0, blockLength);
      blockLength = 0;
    }
  }
}
