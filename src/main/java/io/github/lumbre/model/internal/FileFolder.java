package io.github.lumbre.model.internal;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.text.PrintableText;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** Reads the files in a folder and below. Mutable; confined to one thread. */
public final class FileFolder implements ModelFolder {
  private final Path folder;
  private final long mostBytes;
  private final FileSearch search;

  /**
   * @param folder absolute and normalized
   */
  public FileFolder(Path folder) {
    this(folder, Long.MAX_VALUE);
  }

  /**
   * @param folder absolute and normalized
   * @param mostBytes of a file
   */
  public FileFolder(Path folder, long mostBytes) {
    this.folder = folder;
    this.mostBytes = mostBytes;
    search = new FileSearch(folder);
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    String problem;
    try {
      Path path = folder.resolve(name).normalize();
      if (!path.startsWith(folder) || !path.toRealPath().startsWith(folder.toRealPath())) {
        problem = "expected a file inside the model's folder, found " + PrintableText.quoted(name);
      } else if (Files.isRegularFile(path)) {
        requireSize(path, name, location);
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
    throw ModelFormatException.Kind.ASSET.at(location, problem);
  }

  private void requireSize(Path path, String name, String location)
      throws ModelFormatException, IOException {
    if (Files.size(path) > mostBytes) {
      throw ModelFormatException.Kind.TOO_LARGE.at(
          location,
          PrintableText.quoted(name) + ": expected at most " + mostBytes + " bytes, found more");
    }
  }

  @Override
  public List<String> similar(String name) {
    return search.of(name);
  }

  private static String unreadable(String name, String reason) {
    return "expected a readable file, found " + PrintableText.quoted(name) + ": " + reason;
  }
}
