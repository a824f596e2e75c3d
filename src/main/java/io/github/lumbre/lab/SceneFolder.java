package io.github.lumbre.lab;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.io.IOException;
import java.nio.file.Path;

/** A folder of scene files. */
public record SceneFolder(Path directory) {
  private static final String ENDING = ".json";

  /** Returns the name of a scene file without its extension. */
  public static String name(Path file) {
    String name = String.valueOf(file.getFileName());
    return name.endsWith(ENDING) ? name.substring(0, name.length() - ENDING.length()) : name;
  }

  /** Returns the file of the scene with this name. */
  public Path file(String name) {
    return directory.resolve(name + ENDING);
  }

  /**
   * Reads a scene from any folder.
   *
   * @throws TaskException if the file cannot be read
   */
  public static SceneFile load(Path path, SceneParser parser)
      throws SceneFormatException, TaskException {
    try {
      return parser.parse(path);
    } catch (IOException e) {
      throw Kind.SCENE.failure(path + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }
}
