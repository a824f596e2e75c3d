package io.github.lumbre.cli;

import java.nio.file.Path;

/** Where the program lives, with its scenes and pictures beside it. */
final class Home {
  private Home() {}

  /**
   * Returns the path of a file beside the launcher; without a launcher, of one in the working
   * directory.
   */
  static Path resolve(String name) {
    return Path.of(System.getProperty("lumbre.home", "")).resolve(name);
  }
}
