package io.github.lumbre.parser;

import java.nio.file.Path;
import java.util.Objects;

/**
 * A scene that is not in a file of its own.
 *
 * @param json the scene in UTF-8; not copied
 * @param path a path in the folder where asset paths start; its name appears in messages
 */
public record SceneText(byte[] json, Path path) {
  public SceneText {
    Objects.requireNonNull(json, "json");
    Objects.requireNonNull(path, "path");
  }
}
