package io.github.lumbre.model;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.limit.Limits;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads the files in a folder and below. Mutable; confined to one thread. */
final class FileFolder implements ModelFolder {
  private final Path folder;
  private final FileSearch search;
  private final long maxBytes;
  private long bytes;

  /**
   * @param folder absolute and normalized
   * @param maxBytes the largest sum of the sizes of all files that are read
   */
  FileFolder(Path folder, long maxBytes) {
    this.folder = folder;
    search = new FileSearch(folder);
    this.maxBytes = maxBytes;
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    String problem;
    try {
      Path path = folder.resolve(name).normalize();
      if (!path.startsWith(folder) || !path.toRealPath().startsWith(folder.toRealPath())) {
        problem = "expected a file inside the model's folder, found " + PrintableText.quoted(name);
      } else if (Files.isRegularFile(path)) {
        requireBytes(Files.size(path), location);
        return Files.readAllBytes(path);
      } else {
        String found = Files.isDirectory(path) ? "a folder" : "no regular file";
        problem = "expected a file, found " + found + " at " + PrintableText.quoted(name);
      }
    } catch (ClosedByInterruptException e) {
      throw e;
    } catch (NoSuchFileException e) {
      problem = "expected a file, found none at " + PrintableText.quoted(name);
    } catch (InvalidPathException e) {
      problem = unreadable(name, FileFailure.reason(e));
    } catch (IOException e) {
      problem = unreadable(name, FileFailure.reason(e));
    }
    throw new ModelFormatException(ModelFormatException.Kind.ASSET, location, problem);
  }

  @Override
  public List<String> similar(String name) {
    return search.of(name);
  }

  private void requireBytes(long more, String location) throws ModelFormatException {
    Optional<String> excess = Limits.excess("more bytes of files", maxBytes, bytes + more);
    if (excess.isPresent()) {
      throw new ModelFormatException(ModelFormatException.Kind.TOO_LARGE, location, excess.get());
    }
    bytes += more;
  }

  private static String unreadable(String name, String reason) {
    return "expected a readable file, found " + PrintableText.quoted(name) + ": " + reason;
  }
}
