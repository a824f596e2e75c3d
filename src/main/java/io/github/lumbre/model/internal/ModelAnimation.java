package io.github.lumbre.model.internal;

import java.util.Objects;
import java.util.OptionalDouble;

/**
 * An animation that a model offers.
 *
 * @param name its name; its index if it has none
 * @param seconds time of its last key, at least 0; empty if the file does not state it
 */
public record ModelAnimation(String name, OptionalDouble seconds) {
  public ModelAnimation {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(seconds, "seconds");
  }
}
