package io.github.lumbre.model.internal;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads the files in some folders and below. Mutable; confined to one thread. */
public final class FileFolder implements ModelFolder {
  /** The largest number of bytes of a file: those of an array. */
  static final long MAX_BYTES = Integer.MAX_VALUE - 8L;

  private final AllowedFolders folders;
  private final long mostBytes;

  public FileFolder(AllowedFolders folders) {
    this(folders, MAX_BYTES);
  }

  /**
   * @param mostBytes of a file; an array has at most 2^31 - 9
   */
  public FileFolder(AllowedFolders folders, long mostBytes) {
    this.folders = folders;
    this.mostBytes = Math.min(mostBytes, MAX_BYTES);
  }

  @Override
  public byte[] read(String name, String location) throws ModelFormatException, IOException {
    String problem;
    try {
      Optional<Path> path = folders.find(name);
      if (path.isEmpty()) {
        problem = folders.refusal(name);
      } else if (Files.isRegularFile(path.get())) {
        requireSize(path.get(), name, location);
        return Files.readAllBytes(path.get());
      } else {
        String found = Files.isDirectory(path.get()) ? "a folder" : "no regular file";
        problem = "expected a file, found " + found + " at " + PrintableText.quoted(name);
      }
    } catch (ClosedByInterruptException e) {
      throw Interrupts.cancelled(e);
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
    return folders.similar(name);
  }

  private static String unreadable(String name, String reason) {
    return "expected a readable file, found " + PrintableText.quoted(name) + ": " + reason;
  }
}
