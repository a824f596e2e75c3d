package io.github.lumbre.model.format.obj;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.format.MtlMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The statements of one material of a library, by keys in lower case. Mutable. */
final class MtlMaterial {
  private final String name;
  private final String location;
  private final Map<String, Rgb> colors = new HashMap<>();
  private final Map<String, Double> numbers = new HashMap<>();
  private final Map<String, MtlMap> maps = new HashMap<>();

  MtlMaterial(String name, String location) {
    this.name = name;
    this.location = location;
  }

  String name() {
    return name;
  }

  String location() {
    return location;
  }

  void put(String key, Rgb color) {
    colors.put(key, color);
  }

  void put(String key, double number) {
    numbers.put(key, number);
  }

  void put(String key, MtlMap map) {
    maps.put(key, map);
  }

  Optional<Rgb> color(String key) {
    return Optional.ofNullable(colors.get(key));
  }

  Optional<Double> number(String key) {
    return Optional.ofNullable(numbers.get(key));
  }

  /** Returns the texture of the first of some keys that has one. */
  Optional<MtlMap> map(String... keys) {
    for (String key : keys) {
      if (maps.containsKey(key)) {
        return Optional.of(maps.get(key));
      }
    }
    return Optional.empty();
  }

  /** Returns whether there is a number or texture of a key. */
  boolean has(String key) {
    return numbers.containsKey(key) || maps.containsKey("map_" + key);
  }
}
