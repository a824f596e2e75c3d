package io.github.lumbre.base.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * An output file that appears complete or not at all. Mutable, for one thread.
 *
 * <p>{@link #open} creates and locks a hidden temporary file beside the target. A problem such as a
 * missing directory is therefore found before hours of rendering, not after. {@link #commit} forces
 * the bytes to the disk and atomically renames the temporary file to the target, replacing an
 * existing file. If the file is closed without a commit, the temporary file is deleted and the
 * target is unchanged.
 *
 * <p>The name of the temporary file depends only on the name of the target. Two runs therefore
 * cannot write the same target at the same time, and the next run reuses a file that a killed run
 * left behind.
 */
public final class OutputFile implements Closeable {
  private final Disk disk;
  private final Path target;
  private final Path destination;
  private final LockedFile temporary;
  private final MadeFolders made;
  private boolean done;

  private OutputFile(
      Disk disk, Path target, Path destination, LockedFile temporary, MadeFolders made) {
    this.disk = disk;
    this.target = target;
    this.destination = destination;
    this.temporary = temporary;
    this.made = made;
  }

  /**
   * Reserves an output file. Missing directories are made, and deleted again if nothing is written.
   * If the target is a symbolic link, the link stays and the file it leads to is replaced.
   *
   * @throws IOException with a message for the user, if the directory cannot be made or written, if
   *     the target is not a regular file or is protected, or if another run has reserved it
   */
  public static OutputFile open(Path target) throws IOException {
    MadeFolders made = MadeFolders.of(Objects.requireNonNull(target, "target"));
    try {
      return open(target, Disk.REAL, made);
    } catch (IOException e) {
      made.deleteEmpty();
      throw e;
    }
  }

  /**
   * Reserves an output file in a directory that exists, for a disk that may fail; otherwise as
   * {@link #open(Path)}. A directory that vanished during a run, as with its disk, is not made
   * anew.
   */
  public static OutputFile open(Path target, Disk disk) throws IOException {
    return open(Objects.requireNonNull(target, "target"), disk, MadeFolders.NONE);
  }

  private static OutputFile open(Path target, Disk disk, MadeFolders made) throws IOException {
    Path destination = destination(target);
    LockedFile temporary = LockedFile.open(target, hidden(destination, ".tmp"));
    return new OutputFile(disk, target, destination, temporary, made);
  }

  /**
   * Reserves a target to which several files are written in turn, until the returned object is
   * closed. It excludes other callers of this method, but not callers of {@link #open}, which finds
   * the target free between two of the files.
   *
   * @throws IOException as {@link #open(Path)}
   */
  public static Closeable reserve(Path target) throws IOException {
    MadeFolders made = MadeFolders.of(target);
    try {
      LockedFile lock = LockedFile.open(target, hidden(destination(target), ".lock"));
      return () -> {
        lock.close();
        made.deleteEmpty();
      };
    } catch (IOException e) {
      made.deleteEmpty();
      throw e;
    }
  }

  /**
   * Reserves the names of many files, each of which is opened when it is written, until the
   * returned object is closed. It holds one open file for each folder, excludes other callers of
   * this method, and finds files that are open by {@link #open(Path)}. Missing directories are made, and deleted again if nothing is written.
   *
   * @param targets at least one
   * @throws IOException as {@link #open(Path)}, for the first file that cannot be written
   */
  public static Closeable reserve(List<Path> targets) throws IOException {
    Map<Path, List<Path>> folders = new LinkedHashMap<>();
    for (Path target : targets) {
      Path folder = target.toAbsolutePath().getParent();
      folders.computeIfAbsent(folder, key -> new ArrayList<>()).add(target);
    }
    Deque<Closeable> reserved = new ArrayDeque<>();
    try {
      for (Map.Entry<Path, List<Path>> folder : folders.entrySet()) {
        MadeFolders made = MadeFolders.of(folder.getValue().get(0));
        reserved.push(made::deleteEmpty);
        for (Path target : folder.getValue()) {
          requireUnused(target);
        }
        reserved.push(NamesLock.open(folder.getKey(), folder.getValue()));
      }
    } catch (IOException e) {
      closeAll(reserved);
      throw e;
    }
    return () -> closeAll(reserved);
  }

  /** Requires that no run that writes this file alone holds it. */
  private static void requireUnused(Path target) throws IOException {
    Path temporary = hidden(destination(target), ".tmp");
    LockedFile.requireOwnFile(target, temporary);
    if (Files.exists(temporary, LinkOption.NOFOLLOW_LINKS)) {
      LockedFile.open(target, temporary).close();
    }
  }

  private static void closeAll(Deque<Closeable> reserved) throws IOException {
    while (!reserved.isEmpty()) {
      reserved.pop().close();
    }
  }

  /**
   * Deletes the temporary files and reservations of this JVM that are neither committed nor closed.
   * For a program that ends immediately, because those files cannot be used afterwards. Safe for
   * use by any thread.
   */
  public static void deleteUnfinished() {
    for (Unfinished open : ProcessEnd.open(Unfinished.class)) {
      try {
        open.delete();
      } catch (IOException e) {
        // The program is ending and cannot report this. The next run reuses hidden files.
        continue;
      }
    }
  }

  private static Path hidden(Path destination, String ending) {
    return destination.resolveSibling("." + destination.getFileName() + ending);
  }

  /** Returns the file's path as it was given. */
  public Path target() {
    return target;
  }

  /**
   * Discards everything written before and returns a channel at position 0 of the empty file. This
   * object owns the channel; callers must not close it.
   *
   * @throws IllegalStateException if the file is committed or closed
   */
  public SeekableByteChannel restart() throws IOException {
    requireOpen();
    return temporary.channel().truncate(0).position(0);
  }

  /**
   * Writes all remaining bytes of a buffer at the channel's position.
   *
   * @throws IllegalStateException if the file is committed or closed
   */
  public void write(ByteBuffer buffer) throws IOException {
    requireOpen();
    while (buffer.hasRemaining()) {
      disk.write(temporary.channel(), buffer);
    }
  }

  /** Returns the path of the hidden temporary file that {@link #open} creates beside a file. */
  public static Path temporary(Path file) {
    return hidden(file, ".tmp");
  }

  /**
   * Returns the path at which {@link #commitKeepingPrevious} keeps the previous version of a file.
   */
  public static Path previous(Path file) {
    return file.resolveSibling(file.getFileName() + ".bak");
  }

  /**
   * Commits the file as {@link #commit} does, and keeps the previous version under the name {@link
   * #previous}. At every moment, one of the two names leads to a complete file.
   */
  public void commitKeepingPrevious() throws IOException {
    requireOpen();
    disk.force(temporary.channel());
    if (Files.exists(destination)) {
      disk.move(destination, previous(destination));
    }
    appear();
  }

  /**
   * Makes the complete file appear under the target's name. When this method returns, it is on the
   * disk.
   *
   * @throws IOException if the commit fails; the target is then unchanged, and content may be
   *     written and committed again
   * @throws IllegalStateException if the file is committed or closed
   */
  public void commit() throws IOException {
    requireOpen();
    disk.force(temporary.channel());
    appear();
  }

  private void appear() throws IOException {
    // Rename while the lock is held, so that no other run starts over in our file. Release it only
    // after the directory is on the disk, because the next writer locks the file at once.
    disk.move(temporary.path(), destination);
    done = true;
    try {
      disk.forceDirectory(destination.getParent());
    } finally {
      temporary.release();
    }
  }

  /** Deletes the temporary file unless the file is committed. Further calls do nothing. */
  @Override
  public void close() throws IOException {
    if (done) {
      return;
    }
    done = true;
    temporary.close();
    made.deleteEmpty();
  }

  private void requireOpen() {
    if (done) {
      throw new IllegalStateException(target + ": already committed or closed");
    }
  }

  private static Path destination(Path target) throws IOException {
    Path absolute = target.toAbsolutePath();
    Path directory = absolute.getParent();
    if (directory == null || absolute.getFileName() == null || Files.isDirectory(target)) {
      throw new IOException(target + ": is a directory, expected a file");
    }
    if (!Files.isDirectory(directory)) {
      throw new IOException(target + ": the directory " + directory + " does not exist");
    }
    try {
      if (!Files.readAttributes(target, BasicFileAttributes.class).isRegularFile()) {
        throw new IOException(target + ": is not a regular file");
      }
      if (isProtected(target)) {
        throw new IOException(target + ": is write-protected");
      }
      return target.toRealPath();
    } catch (NoSuchFileException e) {
      return absolute;
    } catch (FileSystemException e) {
      throw new IOException(target + ": " + FileFailure.reason(e), e);
    }
  }

  /**
   * Returns whether an existing file cannot be written. A file that another program is replacing
   * may be missing for a moment, which does not count.
   */
  private static boolean isProtected(Path target) {
    return !Files.isWritable(target) && Files.exists(target) && !Files.isWritable(target);
  }

  /**
   * The folders that were made for an output file.
   *
   * @param folders the innermost first
   */
  private record MadeFolders(List<Path> folders) {
    static final MadeFolders NONE = new MadeFolders(List.of());

    /**
     * Makes the missing folders of a file.
     *
     * @throws IOException with a message for the user, if they cannot be made
     */
    static MadeFolders of(Path target) throws IOException {
      Path folder = target.toAbsolutePath().getParent();
      List<Path> missing = new ArrayList<>();
      for (Path f = folder; f != null && !Files.isDirectory(f); f = f.getParent()) {
        missing.add(f);
      }
      if (!missing.isEmpty()) {
        try {
          Files.createDirectories(folder);
        } catch (IOException e) {
          String reason = FileFailure.reason(e);
          throw new IOException(
              target + ": the directory " + folder + " cannot be created: " + reason, e);
        }
      }
      return new MadeFolders(missing);
    }

    void deleteEmpty() throws IOException {
      for (Path folder : folders) {
        try {
          Files.deleteIfExists(folder);
        } catch (DirectoryNotEmptyException e) {
          return;
        }
      }
    }
  }
}
