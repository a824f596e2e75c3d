package io.github.lumbre.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The folder of a process in which targets leave what is to be read. */
final class TargetFiles {
  private static final Path FOLDER = folder();

  private TargetFiles() {}

  private static Path folder() {
    try {
      return Files.createTempDirectory("lumbre-fuzz-");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Path file(String name) {
    return FOLDER.resolve(name);
  }

  static void write(String name, byte[] content) {
    try {
      Files.write(file(name), content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
