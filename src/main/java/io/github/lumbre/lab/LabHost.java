package io.github.lumbre.lab;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;

/** The services that a measurement needs: reading scenes, and displaying renders. */
public interface LabHost {
  /**
   * Reads a scene and reports its warnings.
   *
   * @throws IOException if the file cannot be read
   * @throws java.util.concurrent.CancellationException if the program is stopped
   */
  SceneFile read(Path scene, SceneParser parser) throws SceneFormatException, IOException;

  /**
   * Requires that a render fits into memory.
   *
   * @throws TaskException that states the needed and the available memory, if it does not
   */
  void requireMemory(RenderSettings settings) throws TaskException;

  /** Returns the result of a render whose progress is displayed; the display can cancel it. */
  <T> T displayed(Displayed<T> render) throws InterruptedException;

  /** A render that reports its progress. */
  @FunctionalInterface
  interface Displayed<T> {
    T render(Progress display) throws InterruptedException;
  }
}
