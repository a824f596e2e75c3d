package io.github.lumbre.parser;

import java.io.Serializable;
import java.util.Objects;

/**
 * What is wrong or doubtful in a scene, and where. Nothing in it can control a terminal.
 *
 * @param file name of the scene file
 * @param path in the file, as {@code $.objects[3].radius}, a very long one without its middle;
 *     empty if the problem is that of the whole file
 * @param message what was found and what was expected
 */
public record Problem(String file, String path, String message) implements Serializable {
  public Problem {
    Objects.requireNonNull(file, "file");
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(message, "message");
  }

  /**
   * Returns a line for people, such as {@code scene.json: $.objects[3].radius: expected a finite
   * number > 0, found -1}.
   */
  @Override
  public String toString() {
    return path.isEmpty() ? file + ": " + message : file + ": " + path + ": " + message;
  }
}
