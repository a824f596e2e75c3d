package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import io.github.lumbre.scene.SceneAssembly;
import java.util.List;
import java.util.Objects;

/**
 * A part of a model as a scene has it.
 *
 * @param shape in the scene's world space
 * @param emitters divide the shape if it emits light; empty otherwise
 */
public record ModelSurface(ModelPart part, Shape shape, Material material, List<Emitter> emitters) {
  /**
   * A part of a surface that emits light of similar radiance.
   *
   * @param shape in the scene's world space
   */
  public record Emitter(Shape shape, Emission emission) {
    public Emitter {
      Objects.requireNonNull(shape, "shape");
      Objects.requireNonNull(emission, "emission");
    }
  }

  public ModelSurface {
    Objects.requireNonNull(part, "part");
    Objects.requireNonNull(shape, "shape");
    Objects.requireNonNull(material, "material");
    emitters = List.copyOf(emitters);
  }

  /** Adds the surface to a scene: one primitive, or one with an emission for each emitter. */
  public void addTo(SceneAssembly scene) {
    if (emitters.isEmpty()) {
      scene.add(shape, material);
    }
    for (Emitter emitter : emitters) {
      if (part.material().flat()) {
        scene.addFlat(emitter.shape(), material, emitter.emission());
      } else {
        scene.add(emitter.shape(), material, emitter.emission());
      }
    }
  }
}
