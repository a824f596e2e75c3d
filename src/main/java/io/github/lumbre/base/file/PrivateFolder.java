package io.github.lumbre.base.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A new folder for what an installed program reads and writes, which only this user can enter. Its
 * name cannot be guessed, so that nobody can put links there. {@link #close} deletes it with all
 * that it contains. Immutable.
 *
 * @param path absolute path of the folder
 */
public record PrivateFolder(Path path) implements Closeable {
  private static final String PREFIX = ".lumbre-";

  /** The folders of this JVM that are not closed. */
  private static final Set<PrivateFolder> OPEN = ConcurrentHashMap.newKeySet();

  /** Creates a folder beside a file. */
  public static PrivateFolder beside(Path file) throws IOException {
    return opened(Files.createTempDirectory(file.toAbsolutePath().getParent(), PREFIX));
  }

  /** Creates a folder in Java's directory for temporary files. */
  public static PrivateFolder temporary() throws IOException {
    return opened(Files.createTempDirectory(PREFIX).toAbsolutePath());
  }

  private static PrivateFolder opened(Path path) {
    PrivateFolder folder = new PrivateFolder(path);
    OPEN.add(folder);
    return folder;
  }

  /**
   * Returns the size of a file that a program left in a folder.
   *
   * @throws IOException with a message for the user, if it is missing, or no file but a link or a
   *     pipe
   */
  public static long size(Path file) throws IOException {
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(
          Files.exists(file, LinkOption.NOFOLLOW_LINKS)
              ? "a link or another special file instead of a file"
              : "no file");
    }
    return Files.size(file);
  }

  /** Deletes all folders that are not closed, as far as possible. */
  static void deleteAll() {
    for (PrivateFolder folder : OPEN) {
      try {
        folder.close();
      } catch (IOException e) {
        // The program is ending and cannot report this.
        continue;
      }
    }
  }

  @Override
  public void close() throws IOException {
    OPEN.remove(this);
    if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
      Files.walkFileTree(path, new Deletion());
    }
  }

  /** Deletes files, links and folders, and follows no link. */
  private static final class Deletion extends SimpleFileVisitor<Path> {
    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
        throws IOException {
      Files.deleteIfExists(file);
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException failure)
        throws IOException {
      Files.deleteIfExists(folder);
      return FileVisitResult.CONTINUE;
    }
  }
}
