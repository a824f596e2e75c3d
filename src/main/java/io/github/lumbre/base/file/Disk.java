package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * The disk operations of an {@link OutputFile}, one per method, so that tests can make each of them
 * fail.
 */
public interface Disk {
  Disk REAL = new Disk() {};

  /** Writes bytes of a buffer at a channel's position: at least one if the buffer is not empty. */
  default void write(FileChannel channel, ByteBuffer buffer) throws IOException {
    channel.write(buffer);
  }

  /** Forces all data written to a channel to the disk before it returns. */
  default void force(FileChannel channel) throws IOException {
    channel.force(true);
  }

  /** Renames a file, atomically if possible, and replaces any file with the new name. */
  default void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Forces the entries of a directory to the disk, on systems that support it. */
  default void forceDirectory(Path directory) {
    try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
      channel.force(true);
    } catch (IOException e) {
      // Windows cannot open directories. There the file system itself keeps their entries safe.
      return;
    }
  }
}
