package io.github.lumbre.scene;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Unlit;
import java.util.Objects;
import java.util.Optional;

/**
 * A shape with its material and, if it emits light, its emission.
 *
 * @param shape in world space
 * @param emission visible to every ray that hits the shape. {@link SceneAssembly} decides whether
 *     it also lights other surfaces
 */
public record Primitive(Shape shape, Material material, Optional<Emission> emission) {
  public Primitive {
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(emission, "emission");
  }

  /** Returns whether the surface scatters light. */
  public boolean scatters() {
    return material != Unlit.INSTANCE;
  }

  /** Returns an equivalent primitive whose uniform material is evaluated once. */
  Primitive simplified() {
    return new Primitive(shape, material.simplified(), emission);
  }
}
