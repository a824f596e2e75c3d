package io.github.lumbre.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * What an {@link OutputFile} does to the disk, a step a method: so that each of them can be made to
 * fail.
 */
public interface Disk {
  /** The disk itself. */
  Disk REAL = new Disk() {};

  /** Writes bytes of a buffer at a channel's position: at least one, if there are any. */
  default void write(FileChannel channel, ByteBuffer buffer) throws IOException {
    channel.write(buffer);
  }

  /** Returns when all that was written to a channel is on the disk. */
  default void force(FileChannel channel) throws IOException {
    channel.force(true);
  }

  /** Gives a file another name, in one step where that is possible; replaces what has that name. */
  default void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Forces the names of a directory to the disk, on systems that support it. */
  default void forceDirectory(Path directory) {
    try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
      channel.force(true);
    } catch (IOException e) {
      // Windows cannot open directories; there the file system keeps names by itself.
      return;
    }
  }
}
