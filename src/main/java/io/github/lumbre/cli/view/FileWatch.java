package io.github.lumbre.cli.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.List;
import java.util.TreeSet;

/**
 * Notices that files have changed, by their sizes and times. A change counts once the files have
 * stayed the same for one more look, so that a file which is being written is not read too early.
 * Mutable; for one thread.
 */
final class FileWatch {
  private List<Path> files = List.of();
  private List<String> known = List.of();
  private List<String> last = List.of();

  /** Watches these files, as they are now. */
  void watch(Collection<Path> newFiles) {
    files = List.copyOf(new TreeSet<>(newFiles));
    known = states();
    last = known;
  }

  /** Looks at the files. Returns whether they have changed since they were last reported. */
  boolean hasChanged() {
    List<String> now = states();
    boolean isStable = now.equals(last);
    last = now;
    if (!isStable || now.equals(known)) {
      return false;
    }
    known = now;
    return true;
  }

  private List<String> states() {
    return files.stream().map(FileWatch::state).toList();
  }

  private static String state(Path file) {
    try {
      BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
      return now.size() + " " + now.lastModifiedTime().toMillis() + " " + now.fileKey();
    } catch (IOException e) {
      return "none";
    }
  }
}
