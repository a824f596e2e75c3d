package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.scene.SceneAssembly;

/** The surface that a material of a scene file gives a shape: one that scatters, or emits. */
@FunctionalInterface
interface Surface {
  /** The surface of shapes without a material. */
  Surface DEFAULT = of(Matte.GRAY);

  void add(Shape shape, SceneAssembly scene);

  /** Returns the surface that scatters light by a material. */
  static Surface of(Material material) {
    return (shape, scene) -> scene.add(shape, material);
  }
}
