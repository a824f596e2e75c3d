package io.github.lumbre.parser;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.scene.SceneBuilder;

/** What a material of a scene file makes of a shape: a surface that scatters, or one that emits. */
@FunctionalInterface
interface Surface {
  /** What shapes without a material have. */
  Surface DEFAULT = of(Matte.GREY);

  /** Adds a shape with this surface to a scene. */
  void add(Shape shape, SceneBuilder scene);

  /** Returns the surface that scatters as a material does. */
  static Surface of(Material material) {
    return (shape, scene) -> scene.add(shape, material);
  }
}
