package io.github.lumbre.scene;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import java.util.Objects;
import java.util.Optional;

/**
 * A shape with what it is made of and, if it glows, its light.
 *
 * @param emission seen by every ray that hits the shape, and the end of a path there; whether it
 *     also lights other things is the {@link SceneBuilder}'s to say
 */
public record Primitive(Shape shape, Material material, Optional<Emission> emission) {
  public Primitive {
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(emission, "emission");
  }

  /** Returns a primitive that looks the same and does no work twice. */
  Primitive simplified() {
    return new Primitive(shape, material.simplified(), emission);
  }
}
