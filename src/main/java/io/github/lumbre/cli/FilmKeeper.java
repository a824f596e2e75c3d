package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.checkpoint.Checkpoints;
import io.github.lumbre.checkpoint.FilmFile;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.Progress;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;

/**
 * Keeps the film of a running render in a file, if there is one; if it cannot be written, in
 * another directory. Mutable, for the thread that renders.
 */
final class FilmKeeper implements AutoCloseable {
  private final Optional<CheckpointFile> file;
  private final Fallback fallback;
  private final Messages messages;
  private final Optional<Checkpoints> checkpoints;
  private Map<String, String> identity = Map.of();
  private Map<String, String> notes = Map.of();
  private Optional<Path> instead = Optional.empty();
  private Optional<String> failure = Optional.empty();

  /**
   * @param interval between two checkpoints
   * @param messages hears of failures
   */
  FilmKeeper(
      Optional<CheckpointFile> file, Duration interval, Fallback fallback, Messages messages) {
    this.file = file;
    this.fallback = fallback;
    this.messages = messages;
    checkpoints = file.map(f -> new Checkpoints(interval, this::save));
  }

  /** Returns one that keeps nothing. */
  static FilmKeeper none(Messages messages) {
    return new FilmKeeper(Optional.empty(), Duration.ZERO, Fallback.TEMPORARY, messages);
  }

  /** Says what films are of, before the first is saved. */
  void label(Map<String, String> newIdentity, Map<String, String> newNotes) {
    identity = newIdentity;
    notes = newNotes;
  }

  /** Returns a listener that pauses a pass whenever the film is to be saved. */
  Progress pausing(Progress progress) {
    return checkpoints.map(c -> c.pausing(progress)).orElse(progress);
  }

  /** Saves a film if it is time to. */
  void saveIfDue(Film film) {
    checkpoints.ifPresent(c -> c.saveIfDue(film));
  }

  /** Saves a film now. A failure is told once, and remembered until a later attempt succeeds. */
  void save(Film film) {
    if (file.isEmpty() || film.totalSamples() == 0) {
      return;
    }
    CheckpointFile wanted = file.get();
    FilmFile content = FilmFile.of(identity, film, notes);
    try {
      wanted.save(content);
      failure = Optional.empty();
    } catch (IOException e) {
      String what = wanted.path() + ": cannot be written: " + e.getMessage();
      Optional<String> found = Optional.of(what + "; " + rescue(content, wanted.path()));
      if (!found.equals(failure)) {
        messages.line("warning: " + found.get());
      }
      failure = found;
    }
  }

  private String rescue(FilmFile content, Path wanted) {
    try {
      Path other = instead.isPresent() ? instead.get() : fallback.newFile(wanted);
      instead = Optional.of(other);
      try (CheckpointFile rescued = CheckpointFile.reserve(other)) {
        rescued.save(content);
      }
      return "the film is saved as " + other + " instead";
    } catch (IOException e) {
      return "nor could " + fallback.directory() + ": " + e.getMessage();
    }
  }

  /** Returns what went wrong with the last film, if anything did. */
  Optional<String> failure() {
    return failure;
  }

  /** Gives the file free. */
  @Override
  public void close() {
    if (file.isPresent()) {
      try {
        file.get().close();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
