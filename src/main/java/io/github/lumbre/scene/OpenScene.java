package io.github.lumbre.scene;

import io.github.lumbre.scene.internal.SceneInside;

/** Shows a {@link Scene} to this program, with types that the exported class lacks. */
abstract class OpenScene extends SceneInside.Opener {
  OpenScene() {
    super(Scene::inside);
  }
}
