package io.github.lumbre.junit;

import java.nio.file.Path;

/**
 * What the system properties say.
 *
 * @param folder of the golden pictures
 * @param report folder for the pictures of failures
 * @param stores whether pictures are stored instead of compared
 */
record GoldenSettings(Path folder, Path report, boolean stores) {
  private static final String MODE = "lumbre.golden";

  /**
   * Returns the settings of this process.
   *
   * @throws IllegalArgumentException if {@code lumbre.golden} has another value than compare or
   *     store
   */
  static GoldenSettings ofSystem() {
    String mode = System.getProperty(MODE, "compare");
    if (!mode.equals("compare") && !mode.equals("store")) {
      throw new IllegalArgumentException(
          "-D" + MODE + ": expected compare or store, found " + mode);
    }
    return new GoldenSettings(
        Path.of(System.getProperty(MODE + ".folder", "src/test/golden")),
        Path.of(System.getProperty(MODE + ".report", "target/golden")),
        mode.equals("store"));
  }
}
