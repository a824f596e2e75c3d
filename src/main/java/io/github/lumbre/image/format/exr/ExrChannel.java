package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * A channel of an OpenEXR file.
 *
 * @param isLinear whether equal steps of values look equal, so that lossy compressions keep them
 * @param use the components that the channel provides: a sum of {@link #RED}, {@link #GREEN},
 *     {@link #BLUE} and {@link #ALPHA}; 0 if it is skipped
 */
record ExrChannel(String name, Type type, boolean isLinear, int use) {
  static final int RED = 1;
  static final int GREEN = 2;
  static final int BLUE = 4;
  static final int ALPHA = 8;
  private static final int COLOR = RED | GREEN | BLUE;
  private static final int MAX_CHANNELS = 1024;

  /** The bits of the floats 65504 and 2^-14. */
  private static final int LARGEST_HALF = 0x477fe000;

  private static final int SMALLEST_NORMAL_HALF = 0x38800000;

  /** The number types, in the order of their codes. */
  enum Type {
    UINT,
    HALF,
    FLOAT;

    int bytes() {
      return this == HALF ? 2 : 4;
    }

    /** Returns the next number of a buffer. */
    float next(ByteBuffer in) {
      return switch (this) {
        case UINT -> in.getInt() & 0xffffffffL;
        case HALF -> ofHalf(in.getShort());
        case FLOAT -> in.getFloat();
      };
    }
  }

  /** Returns the value of a half: 1 sign bit, 5 exponent bits, 10 mantissa bits (IEEE 754). */
  static float ofHalf(short half) {
    int exponent = half >> 10 & 0x1f;
    int mantissa = half & 0x3ff;
    int sign = half & 0x8000;
    if (exponent == 0) {
      float magnitude = mantissa * 0x1p-24f;
      return sign == 0 ? magnitude : -magnitude;
    }
    int wide = exponent == 0x1f ? 0xff : exponent + 127 - 15;
    return Float.intBitsToFloat(sign << 16 | wide << 23 | mantissa << 13);
  }

  /** Returns the channels of a list attribute, without their uses. */
  static List<ExrChannel> read(ByteBuffer list) throws ImageFormatException {
    List<ExrChannel> channels = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (String name = ExrHeader.text(list); !name.isEmpty(); name = ExrHeader.text(list)) {
      int type = list.getInt();
      boolean isLinear = list.getInt() << Byte.SIZE * 3 != 0;
      if (type < 0 || type >= Type.values().length) {
        throw malformed("OpenEXR: expected channels of uint, half or float, found type " + type);
      }
      int stepX = list.getInt();
      int stepY = list.getInt();
      if (stepX != 1 || stepY != 1) {
        throw malformed(
            "OpenEXR: expected channels without subsampling, found "
                + "one that has a value for every %d columns and %d lines; save the picture as RGB"
                    .formatted(stepX, stepY));
      }
      if (!names.add(name) || channels.size() == MAX_CHANNELS) {
        throw malformed("OpenEXR: expected different channels, at most " + MAX_CHANNELS);
      }
      channels.add(new ExrChannel(name, Type.values()[type], isLinear, 0));
    }
    return channels;
  }

  /**
   * Returns channels with their uses in the only picture that they have: a gray one if there is one
   * channel besides alpha, whatever its name.
   */
  static List<ExrChannel> used(List<ExrChannel> channels) throws ImageFormatException {
    Set<String> names = new TreeSet<>();
    channels.forEach(channel -> names.add(channel.name));
    List<ExrChannel> others = channels.stream().filter(c -> !c.component().equals("A")).toList();
    if (others.size() <= 1 && !channels.isEmpty()) {
      ExrChannel gray = others.isEmpty() ? channels.get(0) : others.get(0);
      return channels.stream().map(c -> c.usedIn(prefix(gray.name), gray.name)).toList();
    }
    String layer = layer(names);
    String gray = hasRgb(layer, names) ? "" : layer + "Y";
    return channels.stream().map(channel -> channel.usedIn(layer, gray)).toList();
  }

  /** Returns the name of the channel's layer; empty if it has none. */
  String layer() {
    return name.substring(0, Math.max(0, name.lastIndexOf('.')));
  }

  /** Returns the name without the name of the layer. */
  String component() {
    return name.substring(name.lastIndexOf('.') + 1);
  }

  /**
   * Returns the half nearest to a number, even on ties; finite for all finite numbers.
   *
   * @param value not NaN
   */
  static short toHalf(float value) {
    int bits = Float.floatToRawIntBits(value);
    int sign = bits >>> 16 & 0x8000;
    int magnitude = bits & 0x7fffffff;
    if (magnitude >= LARGEST_HALF) {
      return (short) (sign | 0x7bff);
    }
    if (magnitude < SMALLEST_NORMAL_HALF) {
      return (short) (sign | (int) Math.rint(Float.intBitsToFloat(magnitude) * 0x1p24));
    }
    // Rounds to 10 bits of mantissa; a carry increases the exponent, as it should.
    int rounded = magnitude + 0xfff + (magnitude >>> 13 & 1);
    return (short) (sign | rounded - (127 - 15 << 23) >>> 13);
  }

  /** Returns the prefix of the color channels: empty, or the only layer's name and a dot. */
  private static String layer(Set<String> names) throws ImageFormatException {
    if (hasColor("", names)) {
      return "";
    }
    Set<String> layers = new TreeSet<>();
    for (String name : names) {
      if (hasColor(prefix(name), names)) {
        layers.add(prefix(name));
      }
    }
    if (layers.size() > 1) {
      throw malformed("OpenEXR: expected one layer of colors, found " + layers.size());
    }
    if (layers.isEmpty()) {
      boolean hasChroma = names.containsAll(Set.of("Y", "RY", "BY"));
      throw malformed(
          "OpenEXR: expected the channels R, G and B, or one gray channel, found "
              + (hasChroma ? "luminance and chroma (Y, RY, BY)" : names.size() + " channels")
              + "; save the picture as RGB");
    }
    return layers.iterator().next();
  }

  private static String prefix(String name) {
    return name.substring(0, name.lastIndexOf('.') + 1);
  }

  private static boolean hasColor(String layer, Set<String> names) {
    return hasRgb(layer, names) || names.contains(layer + "Y") && !names.contains(layer + "RY");
  }

  private static boolean hasRgb(String layer, Set<String> names) {
    return names.containsAll(Set.of(layer + "R", layer + "G", layer + "B"));
  }

  /**
   * @param layer the prefix of the channels of the picture
   * @param gray the name of its gray channel; empty if it has R, G and B
   */
  private ExrChannel usedIn(String layer, String gray) {
    boolean hasRgb = gray.isEmpty();
    int newUse = name.equals(gray) ? COLOR : 0;
    if (newUse == 0 && name.startsWith(layer)) {
      newUse =
          switch (name.substring(layer.length())) {
            case "R" -> hasRgb ? RED : 0;
            case "G" -> hasRgb ? GREEN : 0;
            case "B" -> hasRgb ? BLUE : 0;
            case "A" -> ALPHA;
            default -> 0;
          };
    }
    return new ExrChannel(name, type, isLinear, newUse);
  }
}
