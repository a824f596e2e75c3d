package io.github.lumbre.image.exr;

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
 * @param use the components that the channel provides: a sum of {@link #RED}, {@link #GREEN},
 *     {@link #BLUE} and {@link #ALPHA}; 0 if it is skipped
 */
record ExrChannel(String name, Type type, int use) {
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
      list.getInt();
      if (type < 0 || type >= Type.values().length) {
        throw malformed("OpenEXR: expected channels of uint, half or float, found type " + type);
      }
      if (list.getInt() != 1 || list.getInt() != 1) {
        throw malformed("OpenEXR: expected channels without subsampling");
      }
      if (!names.add(name) || channels.size() == MAX_CHANNELS) {
        throw malformed("OpenEXR: expected different channels, at most " + MAX_CHANNELS);
      }
      channels.add(new ExrChannel(name, Type.values()[type], 0));
    }
    return channels;
  }

  /** Returns channels with their uses in the only picture that they have. */
  static List<ExrChannel> used(List<ExrChannel> channels) throws ImageFormatException {
    Set<String> names = new TreeSet<>();
    channels.forEach(channel -> names.add(channel.name));
    String layer = layer(names);
    return channels.stream().map(channel -> channel.usedIn(layer, names)).toList();
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
      String prefix = name.substring(0, name.lastIndexOf('.') + 1);
      if (hasColor(prefix, names)) {
        layers.add(prefix);
      }
    }
    if (layers.size() > 1) {
      throw malformed("OpenEXR: expected one layer of colors, found " + layers.size());
    }
    if (layers.isEmpty()) {
      throw malformed("OpenEXR: expected the channels R, G and B, or Y");
    }
    return layers.iterator().next();
  }

  private static boolean hasColor(String layer, Set<String> names) {
    return hasRgb(layer, names) || names.contains(layer + "Y") && !names.contains(layer + "RY");
  }

  private static boolean hasRgb(String layer, Set<String> names) {
    return names.containsAll(Set.of(layer + "R", layer + "G", layer + "B"));
  }

  private ExrChannel usedIn(String layer, Set<String> names) {
    boolean hasRgb = hasRgb(layer, names);
    int newUse = 0;
    if (name.startsWith(layer)) {
      newUse =
          switch (name.substring(layer.length())) {
            case "R" -> hasRgb ? RED : 0;
            case "G" -> hasRgb ? GREEN : 0;
            case "B" -> hasRgb ? BLUE : 0;
            case "A" -> ALPHA;
            case "Y" -> hasRgb ? 0 : COLOR;
            default -> 0;
          };
    }
    return new ExrChannel(name, type, newUse);
  }
}
