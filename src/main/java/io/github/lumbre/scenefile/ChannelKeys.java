package io.github.lumbre.scenefile;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.internal.Range;
import java.util.List;

/**
 * The keys of a channel of materials: a constant, and a texture that varies it over the surface.
 * Immutable.
 *
 * @param name stem of the keys
 * @param low lower limit of a number times its texture
 * @param high upper limit
 */
record ChannelKeys<T>(
    String name,
    Key<T> constant,
    Key<Integer> texture,
    Key<Point2> offset,
    Key<Point2> scale,
    double low,
    double high) {
  private static <T> ChannelKeys<T> of(String name, Key<T> constant, double low, double high) {
    return new ChannelKeys<>(
        name,
        constant,
        Key.id(name + "TextureId"),
        Key.of(name + "Offset", Value.POINT, new Point2(0, 0), ""),
        Key.of(name + "Scale", Value.POINT, new Point2(1, 1), ""),
        low,
        high);
  }

  static ChannelKeys<Rgb> color(String name, String meaning) {
    return color(name, Rgb.WHITE, meaning);
  }

  static ChannelKeys<Rgb> color(String name, Rgb missing, String meaning) {
    return of(name, Key.of(name, Value.COLOR, missing, meaning), 0, 1);
  }

  /** Returns the channel of a number. */
  static ChannelKeys<Double> number(Key<Double> constant, double low, double high) {
    return of(constant.name(), constant, low, high);
  }

  /** Returns the channel of a normal map, whose constant is its strength. */
  static ChannelKeys<Double> normals(String name, String meaning) {
    return of(name, Key.number(name + "Strength", Range.ANY, 1, meaning), 0, 1);
  }

  List<Key<?>> keys() {
    return List.of(constant, texture, offset, scale);
  }

  boolean isIn(JsonNode material) {
    return constant.isIn(material) || texture.isIn(material);
  }
}
