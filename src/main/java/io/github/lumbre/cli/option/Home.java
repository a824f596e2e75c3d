package io.github.lumbre.cli.option;

import java.nio.file.Path;

/** The program's folder, which also holds its scenes and pictures. */
public final class Home {
  private Home() {}

  /**
   * Returns the path of a file beside the launcher, or in the working directory if there is no
   * launcher.
   */
  public static Path resolve(String name) {
    return Path.of(System.getProperty("lumbre.home", "")).resolve(name);
  }
}
