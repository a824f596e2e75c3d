package io.github.lumbre.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Where files go that cannot be written where they should be.
 *
 * @param directory which exists
 */
record Fallback(Path directory) {
  /** Java's directory for temporary files. */
  static final Fallback TEMPORARY = new Fallback(Path.of(System.getProperty("java.io.tmpdir")));

  /** Makes an empty file whose name ends in that of a file which could not be written. */
  Path newFile(Path wanted) throws IOException {
    return Files.createTempFile(directory, "lumbre-", "-" + wanted.getFileName());
  }
}
