package io.github.lumbre.parser;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The types that a kind of thing comes in, by the names that scene files use: materials, textures,
 * shapes, lights or cameras. Mutable while it is set up.
 *
 * @param <F> what reads a thing of one type
 */
final class Family<F> {
  private final String typeKey;
  private final Map<String, F> readers = new LinkedHashMap<>();
  private final Set<String> keys;

  /**
   * @param typeKey under which things name their type
   * @param commonKeys that all of them have
   */
  Family(String typeKey, Set<String> commonKeys) {
    this.typeKey = typeKey;
    keys = new LinkedHashSet<>(commonKeys);
    keys.add(typeKey);
  }

  /** Adds a type and the keys that it knows. */
  Family<F> with(String name, F reader, String... keysOfType) {
    readers.put(name, reader);
    keys.addAll(Set.of(keysOfType));
    return this;
  }

  /** Returns every key that some type knows; none of them is ever reported as unknown. */
  Set<String> keys() {
    return keys;
  }

  /** Returns the names of the types. */
  Set<String> types() {
    return readers.keySet();
  }

  /** Returns what reads a thing of this type; if there is no such type, adds an error. */
  Optional<F> choose(JsonNode node) {
    return choose(node, "");
  }

  /** Does as {@link #choose(JsonNode)}, but a missing type means the given one. */
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
      node.error(typeKey, "expected one of " + names() + ", found " + Problems.quoted(name.get()));
    }
    return Optional.ofNullable(readers.get(name.get()));
  }

  private String names() {
    return String.join(", ", readers.keySet());
  }
}
