package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;
import static io.github.lumbre.image.format.exr.ExrBytes.little;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.format.exr.ExrHeader.Window;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.PictureLimits;
import io.github.lumbre.image.internal.Primaries;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.zip.DataFormatException;

/**
 * Reads OpenEXR files ("OpenEXR File Layout", openexr.com): scan lines and tiles, of which the
 * full-size level is read; of several parts, the first; every {@link ExrCompression}. The channels
 * are R, G and B, or a gray one, and perhaps A, of the picture or of its only layer. Its
 * colors are converted to the primaries of BT.709 if the file states others; named layers stay as
 * they are stored. The picture has the size of the display window; pixels outside the data window are 0.
 */
public final class ExrReader {
  private static final int MAGIC = 20000630;
  private static final int VERSION = 2;
  private static final int TILES = 0x200;
  private static final int LONG_NAMES = 0x400;
  private static final int DEEP = 0x800;
  private static final int PARTS = 0x1000;

  private static final List<String> COLORS = List.of("R", "G", "B");

  /** The memory that unpacking takes, in sizes of an unpacked block. */
  private static final int BLOCK_COPIES = 4;

  private final ByteBuffer in;
  private final ExrHeader header;
  private final boolean hasParts;
  private final BitSet found = new BitSet();

  /** Receives the values of a channel in a part of a row of the display window. */
  @FunctionalInterface
  private interface Rows {
    /**
     * @param raw holds the values next; the receiver consumes them
     * @param channel index in the header's list
     * @param first index of the first pixel in the display window
     */
    void put(ByteBuffer raw, int channel, int first, int count);
  }

  private ExrReader(byte[] file, boolean isPicture) throws ImageFormatException {
    in = little(file);
    in.getInt();
    int version = in.getInt();
    if ((version & ~(LONG_NAMES | TILES | PARTS)) != VERSION) {
      throw malformed(
          "OpenEXR: expected version 2, found "
              + (version == (version & (LONG_NAMES | PARTS) | DEEP | VERSION)
                  ? "deep pixels; save the picture flattened"
                  : "version and flags 0x" + Integer.toHexString(version)));
    }
    hasParts = (version & PARTS) != 0;
    header = ExrHeader.read(in, (version & TILES) != 0, isPicture);
    while (hasParts && !ExrHeader.attributes(in).isEmpty()) {
      // The other parts are not read.
    }
    long pixels = (long) header.width() * header.height();
    if (in.remaining() < Long.BYTES * header.blocksOfAllLevels()
        || header.bytesPerPixel() * pixels > header.compression().maxInflation() * in.remaining()) {
      throw malformed("OpenEXR ends too early");
    }
  }

  public static boolean startsIn(byte[] file) {
    return file.length >= Long.BYTES && little(file).getInt() == MAGIC;
  }

  /** Reads the picture of a file that {@link #startsIn} recognizes. */
  public static LinearPicture read(byte[] file, long maxPixels) throws ImageFormatException {
    return intact(() -> new ExrReader(file, true).readPicture(maxPixels));
  }

  /** Reads all channels of a file that {@link #startsIn} recognizes. */
  public static LayeredImage readLayers(byte[] file) throws ImageFormatException {
    return intact(() -> new ExrReader(file, false).readAll());
  }

  /** Reads a file, of which any part may be damaged. */
  @FunctionalInterface
  private interface Reading<T> {
    T read() throws ImageFormatException, DataFormatException;
  }

  private static <T> T intact(Reading<T> reading) throws ImageFormatException {
    try {
      return reading.read();
    } catch (BufferUnderflowException
        | IndexOutOfBoundsException
        | IllegalArgumentException
        | ArithmeticException e) {
      throw malformed("OpenEXR is damaged or ends too early");
    } catch (DataFormatException e) {
      throw malformed("OpenEXR is damaged: a block cannot be unpacked");
    }
  }

  /**
   * Checks the memory for the picture and for a block, whose sides count as multiples of those that
   * compressions divide it into.
   *
   * @param values of each pixel
   */
  private void checkMemory(int values) throws ImageFormatException {
    long width = ExrDct.squares(Math.min(header.blockWidth(), header.width()));
    long height = ExrDct.squares(Math.min(header.blockHeight(), header.height()));
    long block = width * height * ExrDct.SIZE * header.bytesPerPixel();
    if (block > Integer.MAX_VALUE - 8) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "OpenEXR: a block has more than 2 GiB");
    }
    Window display = header.display();
    long picture = (long) Float.BYTES * values * display.width() * display.height();
    PictureLimits.checkBytes(
        display.width(), display.height(), picture + BLOCK_COPIES * block, Limits.NONE);
  }

  private LinearPicture readPicture(long maxPixels)
      throws ImageFormatException, DataFormatException {
    int width = header.display().width();
    int height = header.display().height();
    PictureLimits.checkPixels(width, height, maxPixels);
    checkMemory(header.hasAlpha() ? 4 : 3);
    float[] rgb = LinearReader.raster(width, height, 3);
    float[] alpha = header.hasAlpha() ? LinearReader.raster(width, height, 1) : new float[0];
    readBlocks(
        (raw, channel, first, count) -> {
          ExrChannel read = header.channels().get(channel);
          if (read.use() == 0) {
            return;
          }
          for (int i = first; i < first + count; i++) {
            float value = read.type().next(raw);
            if (read.use() == ExrChannel.ALPHA) {
              alpha[i] = value;
              continue;
            }
            for (int component = 0; component < 3; component++) {
              if ((read.use() >> component & 1) != 0) {
                rgb[3 * i + component] = value;
              }
            }
          }
        });
    if (header.hasColor()) {
      header.toRec709().ifPresent(matrix -> Primaries.convert(rgb, 3, matrix));
    }
    return new LinearPicture(width, height, rgb, alpha);
  }

  private LayeredImage readAll() throws ImageFormatException, DataFormatException {
    int width = header.display().width();
    int height = header.display().height();
    int pixels = Math.multiplyExact(width, height);
    List<ExrChannel> channels = header.channels();
    if ((long) channels.size() * pixels > LayeredImage.MAX_VALUES) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "OpenEXR: expected at most %d values in all channels, found %d channels of %d pixels"
              .formatted(LayeredImage.MAX_VALUES, channels.size(), pixels));
    }
    checkMemory(channels.size());
    Map<String, List<ExrChannel>> byLayer = new TreeMap<>();
    for (ExrChannel channel : channels) {
      byLayer.computeIfAbsent(channel.layer(), name -> new ArrayList<>()).add(channel);
    }
    float[][] rasters = new float[channels.size()][];
    int[] strides = new int[channels.size()];
    int[] offsets = new int[channels.size()];
    List<ImageLayer> layers = new ArrayList<>();
    for (Map.Entry<String, List<ExrChannel>> layer : byLayer.entrySet()) {
      List<ExrChannel> members = layer.getValue();
      members.sort(Comparator.comparingInt(ExrReader::rank));
      float[] raster = LinearReader.raster(width, height, members.size());
      for (ExrChannel member : members) {
        int index = channels.indexOf(member);
        rasters[index] = raster;
        strides[index] = members.size();
        offsets[index] = members.indexOf(member);
      }
      boolean isHalf = members.stream().allMatch(c -> c.type() == ExrChannel.Type.HALF);
      layers.add(
          new ImageLayer(
              layer.getKey(),
              members.stream().map(ExrChannel::component).toList(),
              isHalf ? ImageLayer.Precision.HALF : ImageLayer.Precision.FLOAT,
              width,
              height,
              raster));
    }
    readBlocks(
        (raw, channel, first, count) -> {
          ExrChannel.Type type = channels.get(channel).type();
          for (int i = first; i < first + count; i++) {
            rasters[channel][i * strides[channel] + offsets[channel]] = type.next(raw);
          }
        });
    List<ExrChannel> picture = byLayer.getOrDefault("", List.of());
    if (picture.stream().map(ExrChannel::component).limit(3).toList().equals(COLORS)) {
      float[] raster = rasters[channels.indexOf(picture.get(0))];
      header.toRec709().ifPresent(m -> Primaries.convert(raster, picture.size(), m));
    }
    return new LayeredImage(width, height, layers, header.texts());
  }

  /** Returns the place of a channel in its layer: R G B A, or by name. */
  private static int rank(ExrChannel channel) {
    int place = "RGBA".indexOf(channel.component());
    return place < 0 ? 4 : place;
  }

  private void readBlocks(Rows rows) throws ImageFormatException, DataFormatException {
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
      Interrupts.check();
      if (header.tiles().isPresent()) {
        readTile(rows);
      } else {
        readLines(rows);
      }
    }
    if (found.cardinality() != header.blocks()) {
      throw malformed("OpenEXR is damaged: blocks are missing");
    }
  }

  private void readLines(Rows rows) throws ImageFormatException, DataFormatException {
    int lines = header.blockHeight();
    int first = Objects.checkIndex(in.getInt() - header.data().top(), header.height());
    if (first % lines != 0 || found.get(first / lines)) {
      throw malformed("OpenEXR is damaged: expected one block for every " + lines + " lines");
    }
    found.set(first / lines);
    readBlock(0, first, rows);
  }

  private void readTile(Rows rows) throws ImageFormatException, DataFormatException {
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
    readBlock(column * header.blockWidth(), row * header.blockHeight(), rows);
  }

  /** Reads the data of a block whose upper left pixel is given. */
  private void readBlock(int left, int top, Rows rows)
      throws ImageFormatException, DataFormatException {
    int width = Math.min(header.blockWidth(), header.width() - left);
    int height = Math.min(header.blockHeight(), header.height() - top);
    byte[] data = new byte[Math.max(0, Math.min(in.getInt(), in.remaining()))];
    in.get(data);
    ExrBlock block = new ExrBlock(header.channels(), width, height);
    ByteBuffer raw = little(header.compression().unpacked(data, block));
    for (int y = top; y < top + height; y++) {
      for (int channel = 0; channel < header.channels().size(); channel++) {
        int bytes = header.channels().get(channel).type().bytes();
        int end = raw.position() + width * bytes;
        putShown(raw, channel, bytes, left, y, width, rows);
        raw.position(end);
      }
    }
  }

  /**
   * Passes on the pixels of a part of a row that lie in the display window.
   *
   * @param left column of the first pixel in the data window
   * @param y row in the data window
   */
  private void putShown(
      ByteBuffer raw, int channel, int bytes, int left, int y, int width, Rows rows) {
    Window data = header.data();
    Window display = header.display();
    long row = (long) y + data.top() - display.top();
    long column = (long) left + data.left() - display.left();
    long from = Math.max(0, column);
    long to = Math.min(display.width(), column + width);
    if (row < 0 || row >= display.height() || from >= to) {
      return;
    }
    raw.position(raw.position() + (int) (from - column) * bytes);
    rows.put(raw, channel, (int) (row * display.width() + from), (int) (to - from));
  }
}
