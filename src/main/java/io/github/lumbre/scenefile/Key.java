package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.SettingType;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * A key of scene files: the only declaration of its name, type, range, default and meaning. The
 * readers, the writer and the schema use it. Immutable.
 *
 * @param defaultValue empty if it depends on other keys
 * @param isOmitted whether the default is not written
 * @param meaning for editors; empty if the name says it
 * @param variation how a texture varies the value over a surface; empty if none can
 */
record Key<T>(
    String name,
    Value<T> type,
    Optional<T> defaultValue,
    boolean isOmitted,
    String meaning,
    Optional<Variation> variation) {
  /**
   * A texture that varies a value.
   *
   * @param stem of its keys
   * @param low lower limit of a number times its texture
   * @param high upper limit
   */
  record Variation(String stem, double low, double high) {}

  static <T> Key<T> of(String name, Value<T> type, T defaultValue, String meaning) {
    return new Key<>(name, type, Optional.of(defaultValue), false, meaning, Optional.empty());
  }

  /** Returns a key without a default. */
  static <T> Key<T> of(String name, Value<T> type, String meaning) {
    return new Key<>(name, type, Optional.empty(), false, meaning, Optional.empty());
  }

  static Key<Double> number(String name, Range range, double defaultValue, String meaning) {
    return of(name, Value.number(range), defaultValue, meaning);
  }

  static Key<Integer> integer(
      String name, int low, int high, int defaultValue, String meaning) {
    return of(name, Value.integer(low, high), defaultValue, meaning);
  }

  static Key<Boolean> flag(String name, boolean defaultValue, String meaning) {
    return of(name, Value.FLAG, defaultValue, meaning);
  }

  static Key<Rgb> color(String name, String meaning) {
    return of(name, Value.COLOR, Rgb.WHITE, meaning);
  }

  static Key<Vec3> vector(String name, Vec3 defaultValue, String meaning) {
    return of(name, Value.vector(defaultValue), defaultValue, meaning);
  }

  private static Key<Point2> point(String name, Point2 defaultValue) {
    return of(name, Value.point(defaultValue), defaultValue, "");
  }

  /** Returns a key whose values are the names of enum constants. */
  static <E extends Enum<E>> Key<E> choice(String name, E defaultValue, String meaning) {
    return choice(name, SettingType::nameOf, defaultValue, meaning);
  }

  /** Returns a key whose values are enum constants under other names. */
  static <E extends Enum<E>> Key<E> choice(
      String name, Function<E, String> naming, E defaultValue, String meaning) {
    E[] values = defaultValue.getDeclaringClass().getEnumConstants();
    return of(name, Value.choice(Value.named(naming, List.of(values))), defaultValue, meaning);
  }

  /** Returns a key that names an asset by its id. */
  static Key<Integer> id(String name) {
    return of(name, Value.ID, AssetTable.NONE, "");
  }

  /** Returns the strength of a normal map. */
  static Key<Double> normals(String stem, String meaning) {
    return number(stem + "Strength", Range.ANY, 1, meaning).varied(stem, 0, 1);
  }

  /** Returns the names of keys. */
  @SafeVarargs
  static Set<String> names(Collection<Key<?>>... keys) {
    Set<String> names = new LinkedHashSet<>();
    for (Collection<Key<?>> each : keys) {
      each.forEach(key -> names.add(key.name()));
    }
    return names;
  }

  Key<T> withoutDefault() {
    return new Key<>(name, type, Optional.empty(), isOmitted, meaning, variation);
  }

  /** Returns a key of the same name for numbers in another range. */
  Key<Double> within(Range range) {
    return number(name, range, (Double) defaultValue.orElseThrow(), meaning);
  }

  Key<T> omitted() {
    return new Key<>(name, type, defaultValue, true, meaning, variation);
  }

  /** Returns the same key for a value that a texture may vary, within limits. */
  Key<T> varied(double low, double high) {
    return varied(name, low, high);
  }

  private Key<T> varied(String stem, double low, double high) {
    return new Key<>(
        name, type, defaultValue, isOmitted, meaning, Optional.of(new Variation(stem, low, high)));
  }

  /** Returns the name of the value and its texture together. */
  String stem() {
    return variation.map(Variation::stem).orElse(name);
  }

  Key<Integer> texture() {
    return id(stem() + "TextureId");
  }

  Key<Point2> offset() {
    return point(stem() + "Offset", new Point2(0, 0));
  }

  Key<Point2> scale() {
    return point(stem() + "Scale", new Point2(1, 1));
  }

  /** Returns this key and those of its texture. */
  List<Key<?>> all() {
    return variation.isPresent() ? List.of(this, texture(), offset(), scale()) : List.of(this);
  }

  /** Returns the value in an object; the default, with an error added, if it is wrong. */
  T in(JsonNode node) {
    return in(node, defaultValue.orElseThrow());
  }

  T in(JsonNode node, T otherwise) {
    return stated(node).orElse(otherwise);
  }

  /** Returns the value in an object; empty if it is missing, or wrong, with an error added. */
  Optional<T> stated(JsonNode node) {
    return node.find(name).flatMap(type.reader());
  }

  Optional<JsonNode> find(JsonNode node) {
    return node.find(name);
  }

  /** Returns whether an object states the value or its texture. */
  boolean isIn(JsonNode node) {
    return node.has(name) || variation.isPresent() && texture().isIn(node);
  }

  /** Adds an error at the value in an object, or where it is missing. */
  void error(JsonNode node, String message) {
    node.error(name, message);
  }

  /** Adds a warning at the value in an object. */
  void warn(JsonNode node, String message) {
    node.warn(name, message);
  }

  /**
   * Writes a value into an object.
   *
   * @throws Unwritable if scenes may not state it
   */
  void put(JsonObject to, T value) {
    if (isOmitted && defaultValue.equals(Optional.of(value))) {
      return;
    }
    try {
      to.add(name, type.writer().apply(value));
    } catch (Unwritable e) {
      throw e.at(name);
    }
  }
}
