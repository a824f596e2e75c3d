package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;

/**
 * A new folder for what an installed program reads and writes, which only this user can enter. Its
 * name cannot be guessed, so that nobody can put links there. {@link #close} deletes it with all
 * that it contains. Immutable.
 *
 * @param path absolute path of the folder
 */
public record PrivateFolder(Path path) implements Unfinished {
  private static final String PREFIX = ".lumbre-";

  /** Creates a folder beside a file. */
  public static PrivateFolder beside(Path file) throws IOException {
    return opened(Files.createTempDirectory(file.toAbsolutePath().getParent(), PREFIX));
  }

  /** Creates a folder in Java's directory for temporary files. */
  public static PrivateFolder temporary() throws IOException {
    return opened(Files.createTempDirectory(PREFIX).toAbsolutePath());
  }

  private static PrivateFolder opened(Path path) {
    return ProcessEnd.add(new PrivateFolder(path));
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

  @Override
  public void close() throws IOException {
    ProcessEnd.remove(this);
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
