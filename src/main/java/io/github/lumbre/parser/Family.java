package io.github.lumbre.parser;

import io.github.lumbre.text.PrintableText;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The types of materials, textures, shapes, lights or cameras, by their names in scene files.
 * Mutable while it is set up.
 *
 * @param <F> reader of one type
 */
final class Family<F> {
  private final String typeKey;
  private final Map<String, F> readers = new LinkedHashMap<>();
  private final Set<String> keys;

  /**
   * @param typeKey key that holds the name of the type
   * @param commonKeys keys that are valid for every type
   */
  Family(String typeKey, Set<String> commonKeys) {
    this.typeKey = typeKey;
    keys = new LinkedHashSet<>(commonKeys);
    keys.add(typeKey);
  }

  /** Adds a type and its keys; returns this family. */
  Family<F> with(String name, F reader, String... keysOfType) {
    readers.put(name, reader);
    keys.addAll(Set.of(keysOfType));
    return this;
  }

  /** Returns the keys of all types; none of them is ever reported as unknown. */
  Set<String> keys() {
    return keys;
  }

  Set<String> types() {
    return readers.keySet();
  }

  /** Returns the reader of a node's type; empty, with an error added, if the type is unknown. */
  Optional<F> choose(JsonNode node) {
    return choose(node, "");
  }

  /** Returns the same as {@link #choose(JsonNode)}, but with a default for a missing type. */
  Optional<F> choose(JsonNode node, String missing) {
    if (!node.has(typeKey)) {
      if (missing.isEmpty()) {
        node.error(typeKey, "expected one of " + names() + ", found nothing");
      }
      return Optional.ofNullable(readers.get(missing));
    }
    Optional<String> name = node.string(typeKey);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    if (!readers.containsKey(name.get())) {
      node.error(
          typeKey, "expected one of " + names() + ", found " + PrintableText.quoted(name.get()));
    }
    return Optional.ofNullable(readers.get(name.get()));
  }

  private String names() {
    return String.join(", ", readers.keySet());
  }
}
