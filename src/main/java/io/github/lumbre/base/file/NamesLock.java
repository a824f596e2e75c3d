package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A lock on the names of many files in one folder, by one hidden file in it: each name locks one
 * byte of that file, at a place that follows from the name. Runs that write other files of the
 * folder share the hidden file, and the last of them deletes it. Mutable, for one thread.
 */
final class NamesLock implements Unfinished {
  private static final String NAME = ".lumbre.lock";
  private static final int ATTEMPTS = 10;

  /** FNV-1a, 64 bits: Fowler, Noll and Vo. */
  private static final long HASH_OF_NOTHING = 0xcbf29ce484222325L;

  private static final long HASH_FACTOR = 0x100000001b3L;

  private final Path path;
  private final FileChannel channel;
  private final List<FileLock> locks = new ArrayList<>();

  private NamesLock(Path path, FileChannel channel) {
    this.path = path;
    this.channel = channel;
  }

  /**
   * Locks names.
   *
   * @param files the files, as the user named them, all in the folder
   * @throws IOException with a message for the user, if the folder cannot be written, or if another
   *     run has locked one of the names
   */
  static NamesLock open(Path folder, List<Path> files) throws IOException {
    Path path = folder.resolve(NAME);
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      NamesLock lock = new NamesLock(path, LockedFile.create(files.get(0), path));
      lock.lock(files);
      // Start over if a run that has just ended has deleted the file.
      if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
        return ProcessEnd.add(lock);
      }
      lock.channel.close();
    }
    throw new IOException(files.get(0) + ": other runs keep writing into this folder");
  }

  /** Locks in the order of the places, so that of two runs with the same names one gets all. */
  private void lock(List<Path> files) throws IOException {
    Map<Long, Path> places = new TreeMap<>();
    files.forEach(file -> places.put(place(file.getFileName().toString()), file));
    for (Map.Entry<Long, Path> place : places.entrySet()) {
      if (!isLocked(place.getKey(), 1)) {
        channel.close();
        throw new IOException(place.getValue() + ": another run is writing this file");
      }
    }
  }

  private boolean isLocked(long position, long size) {
    try {
      Optional<FileLock> lock = Optional.ofNullable(channel.tryLock(position, size, false));
      lock.ifPresent(locks::add);
      return lock.isPresent();
    } catch (OverlappingFileLockException e) {
      return false;
    } catch (IOException e) {
      // Some network file systems do not support locks. The files can be written nevertheless.
      return true;
    }
  }

  private static long place(String name) {
    long hash = HASH_OF_NOTHING;
    for (byte b : name.getBytes(StandardCharsets.UTF_8)) {
      hash = (hash ^ b & 0xff) * HASH_FACTOR;
    }
    return hash >>> 2;
  }

  /** Unlocks the names, and deletes the file unless another run has locked names, too. */
  @Override
  public void close() throws IOException {
    if (!ProcessEnd.remove(this)) {
      return;
    }
    try (channel) {
      for (FileLock lock : locks) {
        lock.release();
      }
      if (isLocked(0, Long.MAX_VALUE)) {
        Files.deleteIfExists(path);
      }
    }
  }
}
