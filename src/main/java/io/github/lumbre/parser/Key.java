package io.github.lumbre.parser;

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

  static Key<Double> number(String name, Range range, double missing, String meaning) {
    return of(name, new Value.Numbers(range), missing, meaning);
  }

  static Key<Integer> integer(String name, int low, int high, int missing, String meaning) {
    return of(name, new Value.Integers(low, high), missing, meaning);
  }

  static Key<Boolean> flag(String name, boolean missing, String meaning) {
    return of(name, new Value.Flags(), missing, meaning);
  }

  static Key<Rgb> color(String name, String meaning) {
    return of(name, new Value.Colors(), Rgb.WHITE, meaning);
  }

  static <T> Key<T> choice(String name, Map<String, T> choices, T missing, String meaning) {
    return of(name, new Value.Choices<>(choices), missing, meaning);
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
  static Key<Integer> id(String name, AssetTable.Type type) {
    return of(name, new Value.Ids(Optional.of(type)), AssetTable.NONE, "");
  }

  /** Returns a key whose values have a structure of their own. */
  static Key<JsonNode> other(String name, String meaning) {
    return new Key<>(name, new Value.Others(), Optional.empty(), false, meaning);
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

  /** Returns this key with a range that depends on other keys. */
  static Key<Double> within(Key<Double> key, Range range) {
    return new Key<>(key.name, new Value.Numbers(range), key.missing, false, key.meaning);
  }

  /** Returns the value in an object; the default, with an error added, if it is wrong. */
  T in(JsonNode node) {
    return in(node, missing.orElseThrow());
  }

  T in(JsonNode node, T otherwise) {
    return type.read(node, name, otherwise);
  }

  Optional<JsonNode> find(JsonNode node) {
    return node.find(name);
  }

  boolean isIn(JsonNode node) {
    return node.has(name);
  }

  /**
   * Writes a value into an object.
   *
   * @throws Unwritable if scenes may not state it
   */
  void put(JsonObject to, T value) {
    type.excess(value)
        .ifPresent(
            expected -> {
              throw new Unwritable(name + ": " + expected, "" + value);
            });
    if (!(isOmitted && missing.equals(Optional.of(value)))) {
      to.add(name, type.write(value));
    }
  }
}
