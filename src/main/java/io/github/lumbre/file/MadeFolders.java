package io.github.lumbre.file;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The folders that were made for an output file.
 *
 * @param folders the innermost first
 */
record MadeFolders(List<Path> folders) {
  static final MadeFolders NONE = new MadeFolders(List.of());

  /**
   * Makes the missing folders of a file.
   *
   * @throws IOException with a message for the user, if they cannot be made
   */
  static MadeFolders of(Path target) throws IOException {
    Path folder = target.toAbsolutePath().getParent();
    List<Path> missing = new ArrayList<>();
    for (Path f = folder; f != null && !Files.isDirectory(f); f = f.getParent()) {
      missing.add(f);
    }
    if (!missing.isEmpty()) {
      try {
        Files.createDirectories(folder);
      } catch (IOException e) {
        String reason = FileFailure.reason(e);
        throw new IOException(
            target + ": the directory " + folder + " cannot be created: " + reason, e);
      }
    }
    return new MadeFolders(missing);
  }

  void deleteEmpty() throws IOException {
    for (Path folder : folders) {
      try {
        Files.deleteIfExists(folder);
      } catch (DirectoryNotEmptyException e) {
        return;
      }
    }
  }
}
