package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * A hidden lock file or temporary file beside a target file. Only one run at a time can hold it.
 * The next run reuses a file that a killed run left behind. Mutable, for one thread.
 */
final class LockedFile implements Unfinished {
  private static final int ATTEMPTS = 10;

  private final Path path;
  private final FileChannel channel;

  private LockedFile(Path path, FileChannel channel) {
    this.path = path;
    this.channel = channel;
  }

  /**
   * Creates the file, or takes an existing one that no run holds.
   *
   * @param target the target file as the user named it, for messages
   * @param path the hidden file
   * @throws IOException with a message for the user, if the directory cannot be written, or if
   *     another run holds the file
   */
  static LockedFile open(Path target, Path path) throws IOException {
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      FileChannel channel = create(target, path);
      if (!lock(channel)) {
        channel.close();
        throw new IOException(target + ": another run is writing this file");
      }
      // Start over if a run that has just ended has deleted or renamed our file.
      if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
        return ProcessEnd.add(new LockedFile(path, channel));
      }
      channel.close();
    }
    throw new IOException(target + ": other runs keep writing this file");
  }

  Path path() {
    return path;
  }

  FileChannel channel() {
    return channel;
  }

  /** Releases the file without deleting it. */
  void release() throws IOException {
    ProcessEnd.remove(this);
    channel.close();
  }

  @Override
  public void delete() throws IOException {
    Files.deleteIfExists(path);
  }

  /** Deletes the file. */
  @Override
  public void close() throws IOException {
    try (channel) {
      Files.deleteIfExists(path);
      ProcessEnd.remove(this);
    }
  }

  /**
   * Opens a hidden file, which is created if it does not exist.
   *
   * @throws IOException with a message for the user, if the directory cannot be written, or if
   *     something else has the name: a link, also a hard one, or a pipe, which may wait for ever
   */
  static FileChannel create(Path target, Path path) throws IOException {
    requireOwnFile(target, path);
    try {
      return FileChannel.open(
          path, StandardOpenOption.CREATE, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    } catch (FileSystemException e) {
      throw new IOException(
          "%s: the directory %s cannot be written: %s"
              .formatted(target, path.getParent(), reason(e, path.getParent())),
          e);
    }
  }

  /**
   * Requires that a hidden file is no pipe or device, and has no second name. Opening refuses
   * directories and symbolic links.
   */
  static void requireOwnFile(Path target, Path path) throws IOException {
    boolean isSpecial =
        Files.exists(path, LinkOption.NOFOLLOW_LINKS)
            && !Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)
            && !Files.isSymbolicLink(path)
            && !Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS);
    if (isSpecial || names(path) > 1 && Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(
          "%s: expected a file of this program at %s, found %s; remove it"
              .formatted(target, path, isSpecial ? "a pipe or device" : "a hard link"));
    }
  }

  /** Returns the number of a file's names; 1 where the file system does not tell. */
  private static int names(Path path) {
    try {
      return (Integer) Files.getAttribute(path, "unix:nlink", LinkOption.NOFOLLOW_LINKS);
    } catch (IOException | UnsupportedOperationException e) {
      return 1;
    }
  }

  private static String reason(FileSystemException e, Path directory) {
    // Linux reports so of /proc.
    boolean isMissing = e instanceof NoSuchFileException;
    return isMissing && Files.isDirectory(directory)
        ? "its file system allows no new files"
        : FileFailure.reason(e);
  }

  private static boolean lock(FileChannel channel) {
    try {
      return channel.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false;
    } catch (IOException e) {
      // Some network file systems do not support locks. The file can be written nevertheless.
      return true;
    }
  }
}
