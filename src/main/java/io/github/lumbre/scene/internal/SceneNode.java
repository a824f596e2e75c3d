package io.github.lumbre.scene.internal;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Transform;
import io.github.lumbre.scene.SceneContent;
import java.util.List;
import java.util.Optional;

/** A part of the {@linkplain SceneDescription description} of a scene that code built. */
public sealed interface SceneNode {
  /**
   * Parts that move together.
   *
   * @param name of the group, unique among the groups of a scene
   * @param transform from the group's space to its parent's space
   */
  record Group(String name, Transform transform, List<SceneNode> children) implements SceneNode {
    public Group {
      children = List.copyOf(children);
    }
  }

  /**
   * A shape with its material.
   *
   * @param name of the object, which is made unique in the scene; empty if it has none
   * @param lightGroup of its emission; empty for none
   * @param shape in the group's space
   * @param isDeclared whether an emission is sampled as a light in both modes
   */
  record Surface(
      String name,
      String lightGroup,
      Shape shape,
      Material material,
      Optional<Emission> emission,
      boolean isDeclared)
      implements SceneNode {}

  /**
   * A light without a surface.
   *
   * @param light in the group's space
   */
  record Lamp(String lightGroup, Light light) implements SceneNode {}

  /** Ambient irradiance. */
  record Ambient(Rgb irradiance) implements SceneNode {}

  /** A uniform environment light, of path mode alone. */
  record Background(String lightGroup, Rgb radiance) implements SceneNode {}

  /**
   * A model, for example.
   *
   * @param transform from the content's space to the group's
   */
  record Part(String name, String lightGroup, Transform transform, SceneContent content)
      implements SceneNode {}
}
