package io.github.lumbre.scenefile.internal;

import java.util.Objects;

/**
 * The place of an object or asset in a scene file. Its texts contain no control characters.
 *
 * @param path JSON path, such as {@code $.objects[3].children[0]}; a path of more than 200
 *     characters is shortened in the middle
 * @param name the name in the file, shortened to 60 characters; empty if there is none
 */
public record Origin(String path, String name) {
  /** The origin of an item that the file does not contain, such as a default material. */
  public static final Origin NONE = new Origin("", "");

  public Origin {
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(name, "name");
  }

  /** Returns the path, followed by the quoted name if there is one. */
  @Override
  public String toString() {
    return name.isEmpty() ? path : path + " \"" + name + '"';
  }
}
