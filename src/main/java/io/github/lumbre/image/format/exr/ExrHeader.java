package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.internal.PictureLimits;
import io.github.lumbre.image.internal.Primaries;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The header of a part of an OpenEXR file. The data window is the rectangle whose pixels are
 * stored, and the display window the one that the picture shows; either may extend beyond the
 * other.
 *
 * @param data the data window
 * @param display the display window
 * @param texts the text attributes by name
 * @param tiles the sizes of tiles; empty for scan lines
 * @param toRec709 the matrix of {@link Primaries}; empty if colors need none
 */
record ExrHeader(
    Window data,
    Window display,
    ExrCompression compression,
    List<ExrChannel> channels,
    Map<String, String> texts,
    Optional<Tiles> tiles,
    Optional<double[]> toRec709) {

  /**
   * A rectangle of pixels.
   *
   * @param left the column of the first pixel, any number
   * @param top the row of the first pixel, any number
   * @param width in pixels, 1 to {@link ImageReader#MAX_SIDE}
   * @param height in pixels, 1 to {@link ImageReader#MAX_SIDE}
   */
  record Window(int left, int top, int width, int height) {
    /**
     * @param name of the attribute, for messages
     */
    private static Window of(ByteBuffer box, String name) throws ImageFormatException {
      int width = side(box.getInt(0), box.getInt(8), name);
      int height = side(box.getInt(4), box.getInt(12), name);
      PictureLimits.checkSize(width, height);
      return new Window(box.getInt(0), box.getInt(4), width, height);
    }

    /** Returns the number of pixels from the first to the last; the largest int if it is larger. */
    private static int side(int first, int last, String name) throws ImageFormatException {
      if (last < first) {
        throw malformed("OpenEXR: the " + name + " window ends before it begins");
      }
      return (int) Math.min((long) last - first + 1, Integer.MAX_VALUE);
    }
  }

  /**
   * The sizes of tiles.
   *
   * @param levels 0 for one level, 1 for mipmaps, 2 for ripmaps
   * @param roundsUp whether the sizes of smaller levels are rounded up
   */
  record Tiles(int width, int height, int levels, boolean roundsUp) {}

  /**
   * Reads a header.
   *
   * @param isTiled whether the version field states tiles; parts of multi-part files state it
   *     themselves
   * @param isPicture whether the channels must have one picture
   */
  static ExrHeader read(ByteBuffer in, boolean isTiled, boolean isPicture)
      throws ImageFormatException {
    Map<String, Attribute> attributes = attributes(in);
    boolean hasTiles = isTiled || type(attributes).equals("tiledimage");
    return new ExrHeader(
        Window.of(attribute(attributes, "dataWindow"), "data"),
        Window.of(attribute(attributes, "displayWindow"), "display"),
        ExrCompression.of(attribute(attributes, "compression").get(0)),
        channels(attribute(attributes, "channels"), isPicture),
        texts(attributes),
        hasTiles ? Optional.of(tiles(attribute(attributes, "tiles"))) : Optional.empty(),
        Optional.ofNullable(attributes.get("chromaticities"))
            .flatMap(attribute -> Primaries.toRec709(floats(attribute.value))));
  }

  private static double[] floats(ByteBuffer value) {
    double[] floats = new double[value.remaining() / Float.BYTES];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = value.getFloat(Float.BYTES * i);
    }
    return floats;
  }

  private static List<ExrChannel> channels(ByteBuffer list, boolean isPicture)
      throws ImageFormatException {
    List<ExrChannel> channels = ExrChannel.read(list);
    return isPicture ? ExrChannel.used(channels) : channels;
  }

  private static Map<String, String> texts(Map<String, Attribute> attributes) {
    Map<String, String> texts = new TreeMap<>();
    attributes.forEach(
        (name, attribute) -> {
          if (attribute.type.equals("string")) {
            ByteBuffer bytes = attribute.value.duplicate();
            texts.put(name, StandardCharsets.UTF_8.decode(bytes).toString());
          }
        });
    return texts;
  }

  record Attribute(String type, ByteBuffer value) {}

  /** Returns a header's attributes; none if there is no further header. */
  static Map<String, Attribute> attributes(ByteBuffer in) throws ImageFormatException {
    Map<String, Attribute> attributes = new HashMap<>();
    for (String name = text(in); !name.isEmpty(); name = text(in)) {
      String type = text(in);
      int length = in.getInt();
      if (length < 0 || length > in.remaining()) {
        throw malformed("OpenEXR ends too early");
      }
      ByteBuffer value = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
      attributes.put(name, new Attribute(type, value));
      in.position(in.position() + length);
    }
    return attributes;
  }

  private static ByteBuffer attribute(Map<String, Attribute> attributes, String name)
      throws ImageFormatException {
    Attribute attribute = attributes.get(name);
    if (attribute == null) {
      throw malformed("OpenEXR has no attribute " + name);
    }
    return attribute.value;
  }

  private static String type(Map<String, Attribute> attributes) throws ImageFormatException {
    Attribute attribute = attributes.get("type");
    String type =
        attribute == null
            ? ""
            : StandardCharsets.US_ASCII.decode(attribute.value.duplicate()).toString();
    if (type.startsWith("deep")) {
      throw malformed("OpenEXR: expected flat pixels, found deep ones; save the picture flattened");
    }
    return type;
  }

  private static Tiles tiles(ByteBuffer value) throws ImageFormatException {
    int mode = value.get(8);
    Tiles tiles = new Tiles(value.getInt(0), value.getInt(4), mode & 0xf, mode >> 4 == 1);
    if (tiles.width < 1 || tiles.height < 1 || tiles.levels > 2) {
      throw malformed("OpenEXR: the description of tiles is damaged");
    }
    return tiles;
  }

  /** Returns the width of the data window. */
  int width() {
    return data.width;
  }

  /** Returns the height of the data window. */
  int height() {
    return data.height;
  }

  /** Returns the number of bytes of one pixel in all channels. */
  int bytesPerPixel() {
    return channels.stream().mapToInt(channel -> channel.type().bytes()).sum();
  }

  boolean hasAlpha() {
    return channels.stream().anyMatch(channel -> channel.use() == ExrChannel.ALPHA);
  }

  /** Returns whether red, green and blue are stored apart. */
  boolean hasColor() {
    return channels.stream().anyMatch(channel -> channel.use() == ExrChannel.RED);
  }

  int blockWidth() {
    return tiles.map(Tiles::width).orElse(width());
  }

  int blockHeight() {
    return tiles.map(Tiles::height).orElse(compression.lines());
  }

  /** Returns the number of blocks in a row of the full-size picture. */
  int blocksAcross() {
    return count(width(), blockWidth());
  }

  /** Returns the number of blocks of the full-size picture. */
  int blocks() {
    return Math.multiplyExact(blocksAcross(), count(height(), blockHeight()));
  }

  long blocksOfAllLevels() {
    if (tiles.isEmpty() || tiles.get().levels() == 0) {
      return blocks();
    }
    long across = 0;
    long down = 0;
    long mipmaps = 0;
    int last = levels(Math.max(width(), height())) - 1;
    for (int level = 0; level <= last; level++) {
      int x = count(size(width(), level), blockWidth());
      int y = count(size(height(), level), blockHeight());
      across += level < levels(width()) ? x : 0;
      down += level < levels(height()) ? y : 0;
      mipmaps += (long) x * y;
    }
    return tiles.get().levels() == 1 ? mipmaps : across * down;
  }

  private int levels(int side) {
    int floor = 31 - Integer.numberOfLeadingZeros(side);
    boolean isPower = Integer.bitCount(side) == 1;
    return floor + (tiles.orElseThrow().roundsUp() && !isPower ? 2 : 1);
  }

  private int size(int side, int level) {
    int rounding = tiles.orElseThrow().roundsUp() ? (1 << level) - 1 : 0;
    return Math.max(1, side + rounding >> level);
  }

  private static int count(int size, int blockSize) {
    return (int) (((long) size + blockSize - 1) / blockSize);
  }

  /** Returns the next text, in UTF-8, which ends with a zero byte. */
  static String text(ByteBuffer in) {
    int start = in.position();
    while (in.get() != 0) {
      // The name ends at the first zero.
    }
    byte[] name = new byte[in.position() - start - 1];
    in.get(start, name);
    return new String(name, StandardCharsets.UTF_8);
  }
}
