package io.github.lumbre.cli.mcp;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.text.PrintableText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The folders that calls may read files from, links followed. Immutable. */
final class Roots {
  private final List<Path> roots;

  /**
   * @param folders that exist
   * @throws IOException if one is no folder
   */
  Roots(List<Path> folders) throws IOException {
    List<Path> real = new ArrayList<>();
    for (Path folder : folders) {
      real.add(folder.toRealPath());
    }
    roots = List.copyOf(real);
  }

  /**
   * Returns the real path of a file.
   *
   * @param name an absolute path, or one below a root
   * @throws ToolException if it is no file in a root
   */
  Path file(String name) throws ToolException {
    try {
      for (Path root : roots) {
        Optional<Path> real = real(root.resolve(name));
        if (real.isPresent()) {
          return real.get();
        }
      }
    } catch (InvalidPathException e) {
      throw new ToolException(PrintableText.quoted(name) + ": " + FileFailure.reason(e), e);
    }
    throw new ToolException(
        PrintableText.quoted(name)
            + ": expected a file in "
            + (roots.isEmpty()
                ? "a folder that 'lumbre mcp --root DIR' names, and none is named"
                : String.join(", ", roots.stream().map(Path::toString).toList())));
  }

  /** Returns the real path of a file in a root; empty for all others, whether they exist or not. */
  private Optional<Path> real(Path path) {
    try {
      Path real = path.toRealPath();
      return roots.stream().anyMatch(real::startsWith) && Files.isRegularFile(real)
          ? Optional.of(real)
          : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Returns the bytes of a file, or one more than the limit, which readers refuse. */
  static byte[] content(Path file, Limits limits) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return limits.bytesOf(in);
    }
  }

  /**
   * Returns access to the files in the folder of a model and below.
   *
   * @param most bytes of a file
   */
  static ModelFolder folderOf(Path model, long most) {
    Path folder = model.getParent();
    ModelFolder files = ModelFolder.of(folder);
    ModelFolder bounded =
        (name, location) -> {
          if (size(folder, name) > most) {
            throw ModelFormatException.Kind.TOO_LARGE.at(
                location,
                PrintableText.quoted(name) + ": expected at most " + most + " bytes, found more");
          }
          return files.read(name, location);
        };
    return bounded.searchedBy(files::similar);
  }

  /** Returns the bytes of a file; 0 if it cannot be read, which the reader reports. */
  private static long size(Path folder, String name) {
    try {
      return Files.size(folder.resolve(name));
    } catch (IOException | InvalidPathException e) {
      return 0;
    }
  }
}
