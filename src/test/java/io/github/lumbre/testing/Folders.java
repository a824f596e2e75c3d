package io.github.lumbre.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** What is in folders, sorted. */
public final class Folders {
  private Folders() {}

  /** Returns all files and folders of a folder. */
  public static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  /** Returns the files of a folder whose names end so. */
  public static List<Path> files(Path folder, String ending) throws IOException {
    return files(folder).stream().filter(file -> file.toString().endsWith(ending)).toList();
  }

  /** Returns the names of all files and folders of a folder. */
  public static List<String> names(Path folder) throws IOException {
    return files(folder).stream().map(file -> file.getFileName().toString()).toList();
  }

  /** Returns the files of a folder and of all folders in it whose names end so. */
  public static List<Path> below(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> Files.isRegularFile(file) && file.toString().endsWith(ending))
          .sorted()
          .toList();
    }
  }

  /** Returns the example scenes. */
  public static List<Path> scenes() throws IOException {
    return files(Path.of("scenes"), ".json");
  }
}
