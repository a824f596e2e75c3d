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

  private static final int MOST_FILES = 100_000;

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

  /**
   * Returns the number of bytes of all files in the folder and below, which a program may still
   * change; a number above a limit as soon as there are more, or a great number of files.
   */
  long bytes(long limit) throws IOException {
    Count count = new Count(limit);
    Files.walkFileTree(path, count);
    return count.files > MOST_FILES ? Long.MAX_VALUE : count.bytes;
  }

  @Override
  public void close() throws IOException {
    ProcessEnd.remove(this);
    if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
      Files.walkFileTree(path, new Deletion());
    }
  }

  /** Sums the sizes of files, and follows no link. */
  private static final class Count extends SimpleFileVisitor<Path> {
    private final long limit;
    private long bytes;
    private int files;

    Count(long limit) {
      this.limit = limit;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      bytes += attributes.size();
      files++;
      return bytes > limit || files > MOST_FILES
          ? FileVisitResult.TERMINATE
          : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException failure) {
      // The program has deleted it, or keeps it for itself.
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException failure) {
      return FileVisitResult.CONTINUE;
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
