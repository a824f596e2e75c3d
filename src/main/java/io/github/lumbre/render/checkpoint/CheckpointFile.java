package io.github.lumbre.render.checkpoint;

import io.github.lumbre.base.file.Disk;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.file.OutputFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * The checkpoint file to which a running render saves its film. Each save replaces the previous
 * one, which is kept beside it with the suffix {@code .bak}. At every moment, one of the two files
 * is complete. The file is reserved from the start, so that two renders cannot save to the same
 * file. Mutable, for one thread at a time.
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
   * Reserves a checkpoint file.
   *
   * @throws IOException with a message for the user, if the file cannot be written or another
   *     render has reserved it
   */
  public static CheckpointFile reserve(Path path) throws IOException {
    return reserve(path, Disk.REAL);
  }

  static CheckpointFile reserve(Path path, Disk disk) throws IOException {
    return new CheckpointFile(Objects.requireNonNull(path, "path"), disk);
  }

  /** Returns where the file is. */
  public Path path() {
    return path;
  }

  /**
   * Saves a film. When this method returns, the film is on the disk.
   *
   * @throws IOException if the film cannot be saved; the previous save still exists, in the file or
   *     in the {@code .bak} file
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

  /** Releases the reservation. Saved films stay. */
  @Override
  public void close() throws IOException {
    try (reservation) {
      output.close();
    }
  }

  /**
   * A film that was read from a checkpoint file.
   *
   * @param file the film with its header
   * @param from the file from which the film was read: the requested file, or its {@code .bak} file
   * @param problem why the requested file was not used; empty if it was used
   */
  public record Loaded(FilmFile file, Path from, Optional<String> problem) {}

  /**
   * Reads a film from a checkpoint file, or from its {@code .bak} file if the first is missing or
   * damaged.
   *
   * @throws IOException with the problem of the first file, if neither can be read
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
      throw new FilmFormatException(
          problem + "; " + previous + " cannot be used either: " + reason(e));
    }
  }

  private static String reason(IOException e) {
    return e instanceof FilmFormatException ? e.getMessage() : FileFailure.reason(e);
  }
}
