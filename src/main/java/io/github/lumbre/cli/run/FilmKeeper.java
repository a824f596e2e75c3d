package io.github.lumbre.cli.run;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.checkpoint.internal.Checkpoints;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Saves the film of a running render to an optional checkpoint file, or to a fallback directory if
 * that file cannot be written. Mutable, for the rendering thread; another thread saves the films.
 */
public final class FilmKeeper implements PassListener, AutoCloseable {
  private final Optional<CheckpointFile> file;
  private final Fallback fallback;
  private final Messages messages;
  private final Duration interval;
  private Optional<Checkpoints> checkpoints = Optional.empty();
  private Map<String, String> identity = Map.of();
  private Map<String, String> notes = Map.of();
  private RecordedLayers layers = RecordedLayers.NONE;
  private RenderStatistics faults = RenderStatistics.ZERO;
  private RenderStatistics statistics = RenderStatistics.ZERO;
  private Optional<Path> instead = Optional.empty();
  private Optional<String> failure = Optional.empty();

  /**
   * @param interval time between two saves
   * @param messages printer of failures
   */
  public FilmKeeper(
      Optional<CheckpointFile> file, Duration interval, Fallback fallback, Messages messages) {
    this.file = file;
    this.fallback = fallback;
    this.messages = messages;
    this.interval = interval;
  }

  /** Returns a keeper that saves nothing. */
  public static FilmKeeper none(Messages messages) {
    return new FilmKeeper(Optional.empty(), Duration.ZERO, Fallback.TEMPORARY, messages);
  }

  /**
   * Starts the first interval. Rendering waits for saves only if a second film does not fit into
   * memory.
   *
   * @param newIdentity scene and settings of the film
   * @param newLayers what the film records besides the picture
   * @param newNotes returns the notes; they hold hashes of all files, so that it is called only if
   *     films are saved
   * @param existing faults of the film's existing samples
   */
  public void begin(
      Map<String, String> newIdentity,
      RecordedLayers newLayers,
      Supplier<Map<String, String>> newNotes,
      RenderStatistics existing,
      RenderSettings settings) {
    faults = existing;
    statistics = existing;
    identity = newIdentity;
    notes = file.isPresent() ? newNotes.get() : Map.of();
    layers = newLayers;
    checkpoints =
        file.map(
            f ->
                new Checkpoints(
                    interval, MemoryEstimate.leavesRoomForCopy(settings, newLayers.ofFilm())));
  }

  /** Adds an entry to the identity of the films that are saved from now on. */
  public void identify(String name, String value) {
    Map<String, String> more = new LinkedHashMap<>(identity);
    more.put(name, value);
    identity = more;
  }

  @Override
  public boolean isDue() {
    return checkpoints.map(Checkpoints::isDue).orElse(false);
  }

  @Override
  public void passed(Film film, PassResult soFar) {
    RenderStatistics all = faults.plus(soFar.statistics());
    statistics = all;
    checkpoints.ifPresent(c -> c.saveIfDue(film, content -> save(content, all)));
  }

  /** Saves the film at the end of the render. */
  public void saveLast(Film film) {
    checkpoints.ifPresent(c -> c.saveLast(film, content -> save(content, statistics)));
  }

  /** Returns the file that holds the film; empty if it is not saved, or saved elsewhere. */
  public Optional<Path> saved() {
    return file.filter(f -> failure.isEmpty() && instead.isEmpty()).map(CheckpointFile::path);
  }

  /**
   * Saves a film that has samples. A failure is reported once and kept until a later save succeeds.
   */
  private void save(Film film, RenderStatistics itsStatistics) {
    if (film.totalSamples() == 0) {
      return;
    }
    CheckpointFile wanted = file.orElseThrow();
    FilmFile content = FilmFile.of(identity, film, layers, notes, itsStatistics);
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
      rescue(content, other, instead.isEmpty());
      instead = Optional.of(other);
      return "the checkpoint is saved as " + other + " instead";
    } catch (IOException e) {
      return "nor could it be saved in " + fallback.directory() + ": " + e.getMessage();
    }
  }

  /** Saves a film to a file; a new file is kept only if the save succeeds. */
  private static void rescue(FilmFile content, Path other, boolean isNew) throws IOException {
    try (CheckpointFile rescued = CheckpointFile.reserve(other)) {
      rescued.save(content);
    } finally {
      if (isNew) {
        Fallback.deleteIfEmpty(other);
        Fallback.deleteIfEmpty(OutputFile.previous(other));
      }
    }
  }

  /** Returns the failure of the last save, if it failed; call after {@link #saveLast}. */
  public Optional<String> failure() {
    return failure;
  }

  /** Releases the file. */
  @Override
  public void close() {
    Failures.close(file);
  }
}
