package io.github.lumbre.cli.option;

import java.nio.file.Path;

/** Where the program lives, with its scenes and pictures beside it. */
public final class Home {
  private Home() {}

  /**
   * Returns the path of a file beside the launcher; without a launcher, of one in the working
   * directory.
   */
  public static Path resolve(String name) {
    return Path.of(System.getProperty("lumbre.home", "")).resolve(name);
  }
}
