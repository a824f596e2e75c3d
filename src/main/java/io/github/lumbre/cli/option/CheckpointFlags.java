package io.github.lumbre.cli.option;

import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flags that say how a render is kept from being lost. */
public final class CheckpointFlags {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--checkpoint-interval",
      paramLabel = "T",
      defaultValue = "60s",
      converter = FlagConverters.OfDuration.class,
      description = "Time between two checkpoints (${DEFAULT-VALUE}).")
  private Duration interval;

  @Option(
      names = "--fallback-dir",
      paramLabel = "DIR",
      description = {
        "Where the picture and the film go if they cannot be written where they should be.",
        "Default: the directory for temporary files."
      })
  private Optional<Path> fallback;

  /** Complains about values that cannot be, before anything is read. */
  public void validate() {
    Path directory = fallback().directory();
    if (!Files.isDirectory(directory)) {
      throw new ParameterException(
          spec.commandLine(), "--fallback-dir: " + directory + " is not a directory");
    }
  }

  public Fallback fallback() {
    return fallback.map(Fallback::new).orElse(Fallback.TEMPORARY);
  }

  /**
   * Reserves a file for films.
   *
   * @throws TaskException if it cannot be written
   */
  public FilmKeeper keeper(Path path, Messages messages) throws TaskException {
    try {
      return new FilmKeeper(
          Optional.of(CheckpointFile.reserve(path)), interval, fallback(), messages);
    } catch (IOException e) {
      throw new TaskException(Kind.OUTPUT, e.getMessage(), e);
    }
  }
}
