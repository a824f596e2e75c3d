package io.github.lumbre.model;

import java.util.List;

/**
 * The content of a model file, in its own world space: right-handed, +Y up, in the file's units.
 * The scene graph is flattened: each part has its own transform. Immutable.
 *
 * @param parts surfaces to render, in the order of the file; parts that use one mesh share one
 *     {@link ModelGeometry} object
 * @param cameras in the order of the file; empty if the file has none
 * @param lights in the order of the file; empty if the file has none
 * @param variants names of material variants that the file offers; empty if it offers none
 * @param animations names of animations that the file offers; empty if it has none
 * @param warnings problems that do not prevent rendering, each with its place in the file; empty if
 *     there are none
 */
public record Model(
    List<ModelPart> parts,
    List<ModelCamera> cameras,
    List<ModelLight> lights,
    List<String> variants,
    List<String> animations,
    List<String> warnings) {
  public Model {
    parts = List.copyOf(parts);
    cameras = List.copyOf(cameras);
    lights = List.copyOf(lights);
    variants = List.copyOf(variants);
    animations = List.copyOf(animations);
    warnings = List.copyOf(warnings);
  }
}
