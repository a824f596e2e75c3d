package io.github.lumbre.lab;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.Progress;
import java.nio.file.Path;

/** What a measurement needs of the program that runs it: scenes, and a display of its renders. */
public interface LabHost {
  /**
   * Reads a scene and reports its warnings.
   *
   * @throws TaskException if the file cannot be read, or if the program ends meanwhile
   */
  SceneFile read(Path scene, SceneParser parser) throws SceneFormatException, TaskException;

  /** Opens the display of one render, which can cancel the render as well. */
  Display display();

  /** Reports something that the user should know, in one line. */
  void warn(String line);

  /** The display of one render. */
  interface Display extends Progress, AutoCloseable {
    @Override
    void close();
  }
}
