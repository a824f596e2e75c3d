package io.github.lumbre.cli.output;

import io.github.lumbre.base.file.FileFailure;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The directory for files that cannot be written to their own folder.
 *
 * @param directory a directory, which must exist only when it is needed
 */
public record Fallback(Path directory) {
  /** Java's directory for temporary files. */
  public static final Fallback TEMPORARY =
      new Fallback(Path.of(System.getProperty("java.io.tmpdir")));

  /**
   * Creates an empty file whose name ends with the name of the file that could not be written.
   *
   * @throws IOException with the reason, without the name of the directory
   */
  public Path newFile(Path wanted) throws IOException {
    try {
      return Files.createTempFile(directory, "lumbre-", "-" + wanted.getFileName());
    } catch (IOException e) {
      String reason =
          Files.isDirectory(directory)
              ? FileFailure.reason(e)
              : "no such directory; choose another one with --fallback-dir";
      throw new IOException(reason, e);
    }
  }

  /** Deletes a file made by {@link #newFile} that is still empty; failures to do so are ignored. */
  public static void deleteIfEmpty(Path file) {
    try {
      if (Files.exists(file) && Files.size(file) == 0) {
        Files.delete(file);
      }
    } catch (IOException e) {
      // The file is empty and a message has already named it.
      return;
    }
  }
}
