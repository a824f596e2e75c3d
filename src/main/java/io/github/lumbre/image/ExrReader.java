package io.github.lumbre.image;

import static io.github.lumbre.image.ImageFormatException.malformed;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.BitSet;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.zip.DataFormatException;

/**
 * Reads OpenEXR files ("OpenEXR File Layout", openexr.com): scan lines and tiles, of which the
 * full-size level is read; of several parts, the first; no compression, RLE, ZIPS, ZIP or PIZ. The
 * channels are R, G and B, or the gray Y, and perhaps A, of the picture or of its only layer.
 * Colors are divided by alpha, since an {@link Image} keeps the two apart.
 */
final class ExrReader {
  private static final int MAGIC = 20000630;
  private static final int VERSION = 2;
  private static final int TILES = 0x200;
  private static final int LONG_NAMES = 0x400;
  private static final int PARTS = 0x1000;

  /**
   * The largest number of bytes that one byte of deflated data can inflate to (zlib technical
   * notes).
   */
  private static final long MAX_INFLATION = 1032;

  private final ByteBuffer in;
  private final ExrHeader header;
  private final boolean hasParts;
  private final float[] rgb;
  private final float[] alpha;
  private final BitSet found = new BitSet();

  private ExrReader(byte[] file) throws ImageFormatException {
    in = little(file);
    in.getInt();
    int version = in.getInt();
    if ((version & ~(LONG_NAMES | TILES | PARTS)) != VERSION) {
      throw malformed("OpenEXR: expected version 2 without deep data");
    }
    hasParts = (version & PARTS) != 0;
    header = ExrHeader.read(in, (version & TILES) != 0);
    while (hasParts && !ExrHeader.attributes(in).isEmpty()) {
      // The other parts are not read.
    }
    long pixels = (long) header.width() * header.height();
    if (in.remaining() < Long.BYTES * header.blocksOfAllLevels()
        || header.bytesPerPixel() * pixels > MAX_INFLATION * in.remaining()) {
      throw malformed("OpenEXR ends too early");
    }
    checkBlockSize();
    rgb = LinearReader.raster(header.width(), header.height(), 3);
    alpha =
        header.hasAlpha() ? LinearReader.raster(header.width(), header.height(), 1) : new float[0];
  }

  static boolean startsIn(byte[] file) {
    return file.length >= Long.BYTES && little(file).getInt() == MAGIC;
  }

  /** Reads a file that {@link #startsIn} recognizes. */
  static Image read(byte[] file) throws ImageFormatException {
    try {
      return new ExrReader(file).readPixels();
    } catch (BufferUnderflowException
        | IndexOutOfBoundsException
        | IllegalArgumentException
        | ArithmeticException e) {
      throw malformed("OpenEXR is damaged or ends too early");
    } catch (DataFormatException e) {
      throw malformed("OpenEXR is damaged: a block cannot be unpacked");
    }
  }

  private void checkBlockSize() throws ImageFormatException {
    long width = Math.min(header.blockWidth(), header.width());
    long height = Math.min(header.blockHeight(), header.height());
    if (width * height * header.bytesPerPixel() > Integer.MAX_VALUE - 8) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "OpenEXR: a block has more than 2 GiB");
    }
  }

  private Image readPixels() throws ImageFormatException, DataFormatException {
    // In files of one part, blocks follow each other and name their places. Offsets are needed only
    // if blocks of other parts may lie between them.
    int table = in.position();
    long blocks = header.blocksOfAllLevels();
    in.position(table + (int) (Long.BYTES * blocks));
    for (int i = 0; i < blocks; i++) {
      if (hasParts) {
        in.position(Math.toIntExact(in.getLong(table + Long.BYTES * i)));
        if (in.getInt() != 0) {
          throw malformed("OpenEXR is damaged: a block is not of the first part");
        }
      }
      if (Thread.currentThread().isInterrupted()) {
        throw new CancellationException("decoding was interrupted");
      }
      if (header.tiles().isPresent()) {
        readTile();
      } else {
        readLines();
      }
    }
    if (found.cardinality() != header.blocks()) {
      throw malformed("OpenEXR is damaged: blocks are missing");
    }
    divide();
    return new Image(header.width(), header.height(), rgb, alpha);
  }

  private void readLines() throws ImageFormatException, DataFormatException {
    int lines = header.blockHeight();
    int first = Objects.checkIndex(in.getInt() - header.top(), header.height());
    if (first % lines != 0 || found.get(first / lines)) {
      throw malformed("OpenEXR is damaged: expected one block for every " + lines + " lines");
    }
    found.set(first / lines);
    readBlock(0, first);
  }

  private void readTile() throws ImageFormatException, DataFormatException {
    int column = in.getInt();
    int row = in.getInt();
    int levelX = in.getInt();
    int levelY = in.getInt();
    if (levelX != 0 || levelY != 0) {
      int size = in.getInt();
      in.position(Math.addExact(in.position(), Math.max(0, size)));
      return;
    }
    int across = header.blocksAcross();
    Objects.checkIndex(column, across);
    Objects.checkIndex(row, header.blocks() / across);
    if (found.get(row * across + column)) {
      throw malformed("OpenEXR is damaged: a tile occurs twice");
    }
    found.set(row * across + column);
    readBlock(column * header.blockWidth(), row * header.blockHeight());
  }

  /** Reads the data of a block whose upper left pixel is given. */
  private void readBlock(int left, int top) throws ImageFormatException, DataFormatException {
    int width = Math.min(header.blockWidth(), header.width() - left);
    int height = Math.min(header.blockHeight(), header.height() - top);
    byte[] data = new byte[Math.max(0, Math.min(in.getInt(), in.remaining()))];
    in.get(data);
    ByteBuffer raw = little(header.compression().unpacked(data, header, width, height));
    for (int y = top; y < top + height; y++) {
      for (ExrChannel channel : header.channels()) {
        put(raw, channel, y * header.width() + left, width);
      }
    }
  }

  private void put(ByteBuffer raw, ExrChannel channel, int first, int count) {
    if (channel.use() == 0) {
      raw.position(raw.position() + count * channel.type().bytes());
      return;
    }
    for (int i = first; i < first + count; i++) {
      float value = channel.type().next(raw);
      if (channel.use() == ExrChannel.ALPHA) {
        alpha[i] = value;
        continue;
      }
      for (int component = 0; component < 3; component++) {
        if ((channel.use() >> component & 1) != 0) {
          rgb[3 * i + component] = value;
        }
      }
    }
  }

  private void divide() throws ImageFormatException {
    for (int i = 0; i < 3 * alpha.length; i++) {
      float opacity = alpha[i / 3];
      if (!(opacity >= 0 && opacity <= 1)) {
        throw malformed("OpenEXR: expected alpha of 0 to 1, found " + opacity);
      }
      rgb[i] = opacity > 0 ? rgb[i] / opacity : 0;
    }
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
