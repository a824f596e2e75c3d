package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.SettingType;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A key of scene files: the only declaration of its name, type, range, default and meaning. The
 * readers, the writer and the schema use it. Immutable.
 *
 * @param missing the default; empty if it depends on other keys
 * @param isOmitted whether the default is not written
 * @param meaning for editors; empty if the name says it
 */
record Key<T>(
    String name, Value<T> type, Optional<T> missing, boolean isOmitted, String meaning) {
  static <T> Key<T> of(String name, Value<T> type, T missing, String meaning) {
    return new Key<>(name, type, Optional.of(missing), false, meaning);
  }

  /** Returns a key without a default. */
  static <T> Key<T> of(String name, Value<T> type, String meaning) {
    return new Key<>(name, type, Optional.empty(), false, meaning);
  }

  static Key<Double> number(String name, Range range, double missing, String meaning) {
    return of(name, Value.number(range), missing, meaning);
  }

  static Key<Integer> integer(String name, int low, int high, int missing, String meaning) {
    return of(name, Value.integer(low, high), missing, meaning);
  }

  static Key<Boolean> flag(String name, boolean missing, String meaning) {
    return of(name, Value.FLAG, missing, meaning);
  }

  static Key<Rgb> color(String name, String meaning) {
    return of(name, Value.COLOR, Rgb.WHITE, meaning);
  }

  static <T> Key<T> choice(String name, Map<String, T> choices, T missing, String meaning) {
    return of(name, Value.choice(choices), missing, meaning);
  }

  /** Returns a key whose values are the names of enum constants. */
  static <E extends Enum<E>> Key<E> choice(String name, E missing, String meaning) {
    Map<String, E> choices = new LinkedHashMap<>();
    for (E each : missing.getDeclaringClass().getEnumConstants()) {
      choices.put(SettingType.nameOf(each), each);
    }
    return choice(name, choices, missing, meaning);
  }

  /** Returns a key that names an asset by its id. */
  static Key<Integer> id(String name) {
    return of(name, Value.ID, AssetTable.NONE, "");
  }

  /** Returns the names of keys. */
  static Set<String> names(Collection<Key<?>> keys) {
    return keys.stream().map(Key::name).collect(Collectors.toCollection(LinkedHashSet::new));
  }

  Key<T> withoutDefault() {
    return new Key<>(name, type, Optional.empty(), isOmitted, meaning);
  }

  Key<T> omitted() {
    return new Key<>(name, type, missing, true, meaning);
  }

  /** Returns the value in an object; the default, with an error added, if it is wrong. */
  T in(JsonNode node) {
    return in(node, missing.orElseThrow());
  }

  T in(JsonNode node, T otherwise) {
    return type.reader().read(node, name, otherwise);
  }

  Optional<JsonNode> find(JsonNode node) {
    return node.find(name);
  }

  boolean isIn(JsonNode node) {
    return node.has(name);
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
    if (isOmitted && missing.equals(Optional.of(value))) {
      return;
    }
    try {
      to.add(name, type.writer().apply(value));
    } catch (Unwritable e) {
      throw e.at(name);
    }
  }
}
