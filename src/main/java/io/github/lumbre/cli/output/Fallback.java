package io.github.lumbre.cli.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Where files go that cannot be written where they should be.
 *
 * @param directory which exists
 */
public record Fallback(Path directory) {
  /** Java's directory for temporary files. */
  public static final Fallback TEMPORARY =
      new Fallback(Path.of(System.getProperty("java.io.tmpdir")));

  /** Makes an empty file whose name ends in that of a file which could not be written. */
  public Path newFile(Path wanted) throws IOException {
    return Files.createTempFile(directory, "lumbre-", "-" + wanted.getFileName());
  }

  /** Deletes a file made by {@link #newFile} that is still empty; failures to do so are ignored. */
  public static void deleteIfEmpty(Path file) {
    try {
      if (Files.exists(file) && Files.size(file) == 0) {
        Files.delete(file);
      }
    } catch (IOException e) {
      // The file is named in a message already, and nothing is lost with it.
      return;
    }
  }
}
