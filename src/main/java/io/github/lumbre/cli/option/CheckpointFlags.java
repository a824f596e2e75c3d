package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The flags that protect a render against loss. */
@Command(optionListHeading = Headings.CHECKPOINTS)
public final class CheckpointFlags extends Flags {
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
    fallback.ifPresent(
        folder ->
            require(
                Files.isDirectory(folder), "--fallback-dir: " + folder + " is not a directory"));
  }

  public Fallback fallback() {
    return fallback.map(Fallback::new).orElse(Fallback.TEMPORARY);
  }

  /**
   * Reserves the checkpoint file of a new render; without a path, none.
   *
   * @throws TaskException if it exists already, or cannot be written
   */
  public FilmKeeper newKeeper(Optional<Path> path, Messages messages) throws TaskException {
    if (path.isEmpty()) {
      return FilmKeeper.none(messages);
    }
    for (Path existing : List.of(path.get(), OutputFile.previous(path.get()))) {
      if (Files.exists(existing)) {
        throw ExitCode.OUTPUT.failure(
            existing + ": already exists; 'lumbre resume " + path.get() + "' continues it");
      }
    }
    return keeper(path.get(), messages);
  }

  /**
   * Reserves a checkpoint file.
   *
   * @throws TaskException if it cannot be written
   */
  public FilmKeeper keeper(Path path, Messages messages) throws TaskException {
    CheckpointFile file = Failures.written(() -> CheckpointFile.reserve(path));
    return new FilmKeeper(Optional.of(file), interval, fallback(), messages);
  }
}
