package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * A kind of scene object, such as a sphere: the only declaration of its name, its keys, and how it
 * is read and written. Mutable while it is set up.
 *
 * @param <F> how it is read
 * @param <O> the class of what is written; {@link Void} if its family has another writer
 */
final class Kind<F, O> {
  /** Writes a part of an object. */
  interface Part<O> {
    void write(O object, JsonObject to, TextureWriter textures);
  }

  private final String name;
  private final Class<O> type;
  private final F reader;
  private final List<Key<?>> keys = new ArrayList<>();
  private final List<Part<O>> parts = new ArrayList<>();
  private Optional<Key<Boolean>> condition = Optional.empty();

  Kind(String name, Class<O> type, F reader) {
    this.name = name;
    this.type = type;
    this.reader = reader;
  }

  String name() {
    return name;
  }

  Class<O> type() {
    return type;
  }

  F reader() {
    return reader;
  }

  List<Key<?>> keys() {
    return keys;
  }

  /** Returns the flag that distinguishes this kind from another one of the same name. */
  Optional<Key<Boolean>> condition() {
    return condition;
  }

  /** Adds keys that are written elsewhere. */
  Kind<F, O> with(Key<?>... read) {
    List.of(read).forEach(key -> keys.addAll(key.all()));
    return this;
  }

  <T> Kind<F, O> with(Key<T> key, Function<O, T> getter) {
    return with(key).writing((object, to, textures) -> key.put(to, getter.apply(object)));
  }

  <T> Kind<F, O> with(Key<T> key, BiFunction<O, TextureWriter, T> getter) {
    return with(key).writing((object, to, textures) -> key.put(to, getter.apply(object, textures)));
  }

  Kind<F, O> color(Key<Rgb> key, Function<O, Texture<Rgb>> getter) {
    return with(key)
        .writing((object, to, textures) -> textures.color(to, key, getter.apply(object)));
  }

  Kind<F, O> number(Key<Double> key, Function<O, ScalarTexture> getter) {
    return with(key)
        .writing((object, to, textures) -> textures.number(to, key, getter.apply(object)));
  }

  /** Adds a flag that is true in this kind, and false or missing in another one of its name. */
  Kind<F, O> when(Key<Boolean> flag) {
    condition = Optional.of(flag);
    return with(flag, object -> true);
  }

  /** Adds the place of an object. */
  Kind<F, O> placed(Function<O, Transform> getter) {
    return writing((object, to, textures) -> LocalTransform.place(to, getter.apply(object)));
  }

  Kind<F, O> writing(Part<O> part) {
    parts.add(part);
    return this;
  }

  void write(Object object, JsonObject to, TextureWriter textures) {
    parts.forEach(part -> part.write(type.cast(object), to, textures));
  }
}
