package io.github.lumbre.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;

/**
 * A file that appears complete or not at all; mutable, for one thread.
 *
 * <p>{@link #open} reserves the place early, so that a missing directory is known before hours of
 * work and not after: it creates and locks a hidden temporary file beside the target. {@link
 * #commit} forces its bytes to the disk and gives it the target's name in one step, replacing what
 * was there. Closed without commit, the temporary file is deleted and the target is as it was.
 *
 * <p>The temporary file's name is a function of the target's, so that two runs cannot write the
 * same target at once, and what a killed run left behind is used up by the next.
 */
public final class OutputFile implements Closeable {
  private final Disk disk;
  private final Path target;
  private final Path destination;
  private final LockedFile temporary;
  private boolean done;

  private OutputFile(Disk disk, Path target, Path destination, LockedFile temporary) {
    this.disk = disk;
    this.target = target;
    this.destination = destination;
    this.temporary = temporary;
  }

  /**
   * Reserves a place for a file. A target that is a symbolic link stays one; the file it leads to
   * is replaced.
   *
   * @throws IOException with a message for the user, if the directory is missing or cannot be
   *     written, if the target is not a regular file or is protected, or if another run has
   *     reserved it
   */
  public static OutputFile open(Path target) throws IOException {
    return open(target, Disk.REAL);
  }

  /** Reserves a place for a file, to be written by a disk; see {@link #open(Path)}. */
  public static OutputFile open(Path target, Disk disk) throws IOException {
    Path destination = destination(Objects.requireNonNull(target, "target"));
    LockedFile temporary = LockedFile.open(target, hidden(destination, ".tmp"));
    return new OutputFile(disk, target, destination, temporary);
  }

  /**
   * Reserves a place for files that are written one after the other, until what is returned is
   * closed: between two of them {@link #open} finds it free. Keeps out those who reserve it like
   * this as well, not those who only open it.
   *
   * @throws IOException as {@link #open(Path)}
   */
  public static Closeable reserve(Path target) throws IOException {
    return LockedFile.open(target, hidden(destination(target), ".lock"));
  }

  /**
   * Deletes the temporary files and reservations of this virtual machine that are neither committed
   * nor closed. For a program that ends at once; those files cannot be used afterwards. Safe for
   * use by any thread.
   */
  public static void deleteUnfinished() {
    LockedFile.deleteAll();
  }

  private static Path hidden(Path destination, String ending) {
    return destination.resolveSibling("." + destination.getFileName() + ending);
  }

  /** Returns the file's path as it was given. */
  public Path target() {
    return target;
  }

  /**
   * Returns a channel to write the file's content through, at position 0 of an empty file: what was
   * written before is discarded. The file owns the channel; it is not to be closed.
   *
   * @throws IllegalStateException if the file is committed or closed
   */
  public SeekableByteChannel restart() throws IOException {
    requireOpen();
    return temporary.channel().truncate(0).position(0);
  }

  /**
   * Writes all that is left in a buffer at the channel's position.
   *
   * @throws IllegalStateException if the file is committed or closed
   */
  public void write(ByteBuffer buffer) throws IOException {
    requireOpen();
    while (buffer.hasRemaining()) {
      disk.write(temporary.channel(), buffer);
    }
  }

  /** Returns the hidden file beside a file that {@link #open} creates while it is reserved. */
  public static Path temporary(Path file) {
    return hidden(file, ".tmp");
  }

  /** Returns where a file's predecessor is kept by {@link #commitKeepingPrevious}. */
  public static Path previous(Path file) {
    return file.resolveSibling(file.getFileName() + ".bak");
  }

  /**
   * Does what {@link #commit} does, and keeps what was there under a name of its own: at every
   * moment, one of the two names leads to a complete file.
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
   * Makes the file appear under its name, complete and on the disk, when this returns.
   *
   * @throws IOException if that fails; the target is then as it was, and content may be written and
   *     committed again
   * @throws IllegalStateException if the file is committed or closed
   */
  public void commit() throws IOException {
    requireOpen();
    disk.force(temporary.channel());
    appear();
  }

  private void appear() throws IOException {
    // Rename while the lock is still held, so that no other run starts over in our file. Hold it
    // while
    // the disk takes its time, too: whoever writes the next version locks that at once.
    disk.move(temporary.path(), destination);
    done = true;
    try {
      disk.forceDirectory(destination.getParent());
    } finally {
      temporary.release();
    }
  }

  /** Deletes the temporary file, unless the file is committed. Does nothing the second time. */
  @Override
  public void close() throws IOException {
    if (done) {
      return;
    }
    done = true;
    temporary.close();
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
        throw new IOException(target + ": is protected against writing");
      }
      return target.toRealPath();
    } catch (NoSuchFileException e) {
      return absolute;
    } catch (FileSystemException e) {
      throw new IOException(target + ": " + LockedFile.reason(e), e);
    }
  }

  /** A file that another program replaces may be gone for a moment, which is no protection. */
  private static boolean isProtected(Path target) {
    return !Files.isWritable(target) && Files.exists(target) && !Files.isWritable(target);
  }
}
