package io.github.lumbre.scene.internal;

import io.github.lumbre.scene.Scene;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * What the parts of this program read in a {@link Scene} and other programs do not need.
 *
 * @param description what code built the scene from; empty if it was read from a file
 * @param names the names of the objects and materials of the primitives
 * @param lightGroups the light groups of the emitters and primitives
 * @param specializations those that the scene uses
 * @param dropping returns the same scene without a specialization
 */
public record SceneInside(
    Optional<SceneDescription> description,
    SurfaceNames names,
    LightGroups lightGroups,
    Set<Specialization> specializations,
    Function<Specialization, Scene> dropping) {
  /** A superclass of scenes that this class can open, and no class of another package. */
  public abstract static class Opener {
    private final Function<Scene, SceneInside> opening;

    protected Opener(Function<Scene, SceneInside> opening) {
      this.opening = opening;
    }
  }

  public static SceneInside of(Scene scene) {
    Opener opener = scene;
    return opener.opening.apply(scene);
  }

  public boolean takes(Specialization specialization) {
    return specializations.contains(specialization);
  }

  /** Returns the same scene without a specialization. Its renders are bit-identical. */
  public Scene without(Specialization specialization) {
    return dropping.apply(specialization);
  }
}
