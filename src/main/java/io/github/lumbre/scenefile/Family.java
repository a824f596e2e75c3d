package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.base.text.PrintableText;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * The kinds of materials, textures, shapes, lights or cameras. Mutable while it is set up.
 *
 * @param <F> how one kind is read
 */
final class Family<F> {
  private final Key<String> typeKey;
  private final String thing;
  private final List<Kind<F, ?>> kinds = new ArrayList<>();
  private final Map<String, Supplier<Unwritable>> refusals = new TreeMap<>();
  private final List<Key<?>> common;

  /**
   * @param typeKey key that holds the name of the kind
   * @param missing the kind that is read without it; empty if it is required
   * @param thing what the family is called, with its article
   * @param common keys that are valid for every kind
   */
  Family(String typeKey, Optional<String> missing, String thing, List<Key<?>> common) {
    this.typeKey = new Key<>(typeKey, Value.TEXT, missing, false, "", Optional.empty());
    this.thing = thing;
    this.common = common;
  }

  /** Adds a kind and returns it; its keys come next. */
  <O> Kind<F, O> kind(String name, Class<O> type, F reader) {
    Kind<F, O> kind = new Kind<>(name, type, reader);
    kinds.add(kind);
    return kind;
  }

  /** Declares that the format lacks a class, by its simple name. */
  void refuse(String type, String expected, String found) {
    refusals.put(type, () -> new Unwritable(expected, found));
  }

  Key<String> typeKey() {
    return typeKey;
  }

  List<Kind<F, ?>> kinds() {
    return kinds;
  }

  List<Key<?>> common() {
    return common;
  }

  Set<String> refused() {
    return refusals.keySet();
  }

  /** Returns the keys of all kinds; none of them is ever reported as unknown. */
  Set<String> keys() {
    Set<String> keys = Key.names(common);
    keys.add(typeKey.name());
    kinds.forEach(kind -> keys.addAll(Key.names(kind.keys())));
    return keys;
  }

  /** Returns the names of the kinds. */
  Set<String> names() {
    return kinds.stream().map(Kind::name).collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /** Returns the reader of a node's kind; empty, with an error added, if the kind is unknown. */
  Optional<F> choose(JsonNode node) {
    String key = typeKey.name();
    Optional<String> name = node.has(key) ? typeKey.stated(node) : typeKey.defaultValue();
    if (name.isEmpty()) {
      if (!node.has(key)) {
        node.error(key, expected() + "nothing");
      }
      return Optional.empty();
    }
    Optional<Kind<F, ?>> found =
        kinds.stream()
            .filter(kind -> kind.name().equals(name.get()))
            .filter(kind -> kind.condition().stream().allMatch(flag -> flag.in(node)))
            .findFirst();
    if (found.isEmpty()) {
      node.error(key, expected() + PrintableText.quoted(name.get()));
    }
    return found.map(Kind::reader);
  }

  private String expected() {
    return "expected one of " + String.join(", ", names()) + ", found ";
  }

  /**
   * Writes an object as the kind of its class.
   *
   * @return the kind
   * @throws Unwritable if there is none
   */
  Kind<F, ?> write(Object object, JsonObject to, TextureWriter textures) {
    Kind<F, ?> kind =
        kinds.stream()
            .filter(each -> each.type().isInstance(object))
            .findFirst()
            .orElseThrow(() -> refusal(object));
    write(kind, object, to, textures);
    return kind;
  }

  private Unwritable refusal(Object object) {
    String type = object.getClass().getSimpleName();
    return refusals.containsKey(type)
        ? refusals.get(type).get()
        : new Unwritable(thing + " of the format", Unwritable.name(object));
  }

  /** Writes an object as a kind. */
  void write(Kind<?, ?> kind, Object object, JsonObject to, TextureWriter textures) {
    to.addProperty(typeKey.name(), kind.name());
    kind.write(object, to, textures);
  }
}
