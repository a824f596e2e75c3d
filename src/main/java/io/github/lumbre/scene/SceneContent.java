package io.github.lumbre.scene;

import io.github.lumbre.math.Transform;

/**
 * Several surfaces and lights that a scene contains as one thing, such as a model file. Immutable.
 */
public interface SceneContent {
  /** Content at its place in world space. */
  @FunctionalInterface
  interface Placed {
    /** Adds the surfaces and lights to a scene. */
    void addTo(SceneAssembly scene);
  }

  /**
   * Returns the content at a place. Calls with several transforms share all that does not depend on
   * them, such as meshes and textures.
   *
   * @param toWorld from the scene's space, in which the content was given, to world space
   */
  Placed placed(Transform toWorld);
}
