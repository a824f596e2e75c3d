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
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flags that protect a render against loss. */
@Command(optionListHeading = Headings.CHECKPOINTS)
public final class CheckpointFlags {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--checkpoint-interval",
      paramLabel = "DURATION",
      defaultValue = "60s",
      description = "Time between two saves of the checkpoint file (${DEFAULT-VALUE}).")
  private Duration interval;

  @Option(
      names = "--fallback-dir",
      paramLabel = "DIR",
      description = {
        "Write the picture and the checkpoint file here if their own folder cannot be written.",
        "Default: the directory for temporary files."
      })
  private Optional<Path> fallback;

  /**
   * Checks the values before anything is read. Without the flag, the directory for temporary files
   * must exist only when it is needed.
   */
  public void validate() {
    if (fallback.isPresent() && !Files.isDirectory(fallback.get())) {
      throw new ParameterException(
          spec.commandLine(), "--fallback-dir: " + fallback.get() + " is not a directory");
    }
  }

  public Fallback fallback() {
    return fallback.map(Fallback::new).orElse(Fallback.TEMPORARY);
  }

  /**
   * Reserves a checkpoint file.
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
