package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.internal.AllowedFolders;
import io.github.lumbre.model.internal.FileFolder;
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

  /** The same folders, also by the names that were given, which may lead through links. */
  private final List<Path> named;

  /**
   * @param folders that exist
   * @throws IOException if one is no folder
   */
  Roots(List<Path> folders) throws IOException {
    List<Path> real = new ArrayList<>();
    List<Path> all = new ArrayList<>();
    for (Path folder : folders) {
      real.add(folder.toRealPath());
      all.add(folder.toAbsolutePath().normalize());
    }
    all.addAll(real);
    roots = List.copyOf(real);
    named = List.copyOf(all);
  }

  /**
   * Returns the real path of a file. A name that leads out of the roots by its text is refused
   * before the file system sees it: even a question could tell a client what exists elsewhere, or
   * open a connection.
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
  private Optional<Path> real(Path given) {
    Path path = given.normalize();
    if (named.stream().noneMatch(path::startsWith)) {
      return Optional.empty();
    }
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
    return new FileFolder(new AllowedFolders(model.getParent(), List.of()), most);
  }
}
