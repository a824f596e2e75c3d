package io.github.lumbre.lab;

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
}
