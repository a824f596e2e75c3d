package io.github.lumbre.scenefile;

import java.io.Serializable;
import java.util.Objects;

/**
 * An error or warning in a scene file. Its texts contain no control characters.
 *
 * @param file name of the scene file
 * @param path JSON path, such as {@code $.objects[3].radius}, a place in a model, or the argument
 *     {@code sky} or {@code size} of a picture of a model; a path of more than 200 characters is
 *     shortened in the middle; empty if the problem concerns the whole file
 * @param message what was found and what was expected
 */
public record Problem(String file, String path, String message) implements Serializable {
  public Problem {
    Objects.requireNonNull(file, "file");
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(message, "message");
    // The root of the JSON is the file.
    path = path.equals("$") ? "" : path;
  }

  /**
   * Returns one readable line, such as {@code scene.json: $.objects[3].radius: expected a finite
   * number > 0, found -1}.
   */
  @Override
  public String toString() {
    return path.isEmpty() ? file + ": " + message : file + ": " + path + ": " + message;
  }
}
