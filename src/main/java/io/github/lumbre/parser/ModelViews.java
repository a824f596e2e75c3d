package io.github.lumbre.parser;

import io.github.lumbre.scene.Scene;
import java.util.List;

/**
 * A model seen from several directions.
 *
 * @param first the scene file of the first view, with the settings of all
 * @param scenes one for each view, in order; they share everything but the camera
 */
public record ModelViews(SceneFile first, List<Scene> scenes) {
  public ModelViews {
    scenes = List.copyOf(scenes);
  }
}
