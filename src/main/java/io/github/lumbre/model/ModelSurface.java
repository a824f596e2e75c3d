package io.github.lumbre.model;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import io.github.lumbre.scene.SceneBuilder;
import java.util.Objects;
import java.util.Optional;

/**
 * A part of a model as a scene has it.
 *
 * @param shape in the scene's world space
 * @param emission empty if the surface emits no light
 */
public record ModelSurface(
    ModelPart part, Shape shape, Material material, Optional<Emission> emission) {
  public ModelSurface {
    Objects.requireNonNull(part, "part");
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(emission, "emission");
  }

  /** Adds the surface to a scene: one primitive, and one emitter if it emits light. */
  public void addTo(SceneBuilder scene) {
    if (emission.isPresent()) {
      scene.add(shape, material, emission.get());
    } else {
      scene.add(shape, material);
    }
  }
}
