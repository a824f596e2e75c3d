package io.github.lumbre.lab;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.Progress;
import java.nio.file.Path;

/** The services that a measurement needs: reading scenes, and displaying renders. */
public interface LabHost {
  /**
   * Reads a scene and reports its warnings.
   *
   * @throws TaskException if the file cannot be read, or if the program is stopped
   */
  SceneFile read(Path scene, SceneParser parser) throws SceneFormatException, TaskException;

  /** Opens the display of one render; it can also cancel the render. */
  Display display();

  /** The display of one render. */
  interface Display extends Progress, AutoCloseable {
    @Override
    void close();
  }
}
