package io.github.lumbre.checkpoint;

import io.github.lumbre.file.Disk;
import io.github.lumbre.file.FileFailure;
import io.github.lumbre.file.OutputFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * Where a running render keeps its film: each save replaces the one before, which stays beside it
 * with the ending {@code .bak}. Whenever the program ends, one of the two is complete. Reserved
 * from the start, so that two renders cannot keep their films in one file. Mutable, for one thread
 * at a time.
 */
public final class CheckpointFile implements Closeable {
  private final Disk disk;
  private final Path path;
  private final Closeable reservation;
  private OutputFile output;
  private boolean isOpen = true;

  private CheckpointFile(Path path, Disk disk) throws IOException {
    this.path = path;
    this.disk = disk;
    reservation = OutputFile.reserve(path);
    try {
      output = OutputFile.open(path, disk);
    } catch (IOException e) {
      reservation.close();
      throw e;
    }
  }

  /**
   * Reserves a file.
   *
   * @throws IOException with a message for the user, if it cannot be written or another render has
   *     reserved it
   */
  public static CheckpointFile reserve(Path path) throws IOException {
    return reserve(path, Disk.REAL);
  }

  static CheckpointFile reserve(Path path, Disk disk) throws IOException {
    return new CheckpointFile(Objects.requireNonNull(path, "path"), disk);
  }

  public Path path() {
    return path;
  }

  /**
   * Saves a film: when this returns, it is on the disk.
   *
   * @throws IOException if that fails; what was saved before is still there, under its name or that
   *     of the previous one
   */
  public void save(FilmFile film) throws IOException {
    if (!isOpen) {
      output = OutputFile.open(path, disk);
      isOpen = true;
    }
    film.write(output);
    output.commitKeepingPrevious();
    isOpen = false;
    output = OutputFile.open(path, disk);
    isOpen = true;
  }

  /** Gives the file free; what was saved stays. */
  @Override
  public void close() throws IOException {
    try (reservation) {
      output.close();
    }
  }

  /**
   * A film that was read.
   *
   * @param from the file it was read from: the requested one, or the previous one
   * @param problem why the requested file was not used; empty if it was
   */
  public record Loaded(FilmFile file, Path from, Optional<String> problem) {}

  /**
   * Reads a film, or if that cannot be, the one saved before it.
   *
   * @throws IOException what was wrong with the first, if the second cannot be read either
   */
  public static Loaded load(Path path) throws IOException {
    Path previous = OutputFile.previous(path);
    try {
      return new Loaded(FilmFile.read(path), path, Optional.empty());
    } catch (FilmFormatException | NoSuchFileException e) {
      if (!Files.exists(previous)) {
        throw e;
      }
      String problem = e instanceof FilmFormatException ? e.getMessage() : "does not exist";
      return new Loaded(previous(previous, path, problem), previous, Optional.of(problem));
    }
  }

  private static FilmFile previous(Path previous, Path path, String problem) throws IOException {
    try {
      return FilmFile.read(previous);
    } catch (IOException e) {
      throw new FilmFormatException(problem + "; nor can " + previous + " be used: " + reason(e));
    }
  }

  private static String reason(IOException e) {
    return e instanceof FilmFormatException ? e.getMessage() : FileFailure.reason(e);
  }
}
