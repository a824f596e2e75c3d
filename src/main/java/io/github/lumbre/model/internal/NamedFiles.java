package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Files that have names but are in no folder of the file system, such as those of an archive.
 *
 * @param folder of the model among the files, which ends with a slash, or is empty
 * @param source finds the files by their normalized names
 */
public record NamedFiles(String folder, Source source) implements ModelFolder {
  @FunctionalInterface
  public interface Source {
    /**
     * Returns the bytes of a file; empty if there is none of that name.
     *
     * @param path names with / between them; no name is empty, {@code .} or {@code ..}
     */
    Optional<byte[]> read(String path, String location) throws ModelFormatException, IOException;
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    String path =
        normalized(name)
            .orElseThrow(
                () -> missing(location, "a file inside the model's folder, found " + quoted(name)));
    return source
        .read(path, location)
        .orElseThrow(() -> missing(location, "a file, found none at " + quoted(name)));
  }

  /** Returns the path of a file among all files; empty if it leaves them. */
  private Optional<String> normalized(String name) {
    Deque<String> path = new ArrayDeque<>();
    if (name.isEmpty() || name.startsWith("/")) {
      return Optional.empty();
    }
    for (String part : (folder + name).split("/")) {
      if (part.equals("..")) {
        if (path.pollLast() == null) {
          return Optional.empty();
        }
      } else if (!part.isEmpty() && !part.equals(".")) {
        path.addLast(part);
      }
    }
    return path.isEmpty() ? Optional.empty() : Optional.of(String.join("/", path));
  }

  private static String quoted(String name) {
    return PrintableText.quoted(name);
  }

  private static ModelFormatException missing(String location, String expected) {
    return Kind.ASSET.at(location, "expected " + expected);
  }
}
