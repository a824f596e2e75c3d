package io.github.lumbre.cli.run;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassRenderer;
import io.github.lumbre.scenefile.SceneFile;
import java.nio.file.Path;

/** What renders the passes of {@code render} and {@code resume}: this process, or a cluster. */
@FunctionalInterface
public interface Engine {
  /** Renders in this process. */
  Engine LOCAL = (path, scene, local, isTimed) -> local;

  /**
   * Returns the renderer of a scene's passes.
   *
   * @param path of the scene file
   * @param local renders in this process
   * @param isTimed whether a time ends the render, so that passes should be short
   * @throws TaskException if the engine cannot render the scene
   */
  PassRenderer over(Path path, SceneFile scene, FilmRenderer local, boolean isTimed)
      throws TaskException;
}
