package io.github.lumbre.cli;

import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that say how the work is divided, which changes no bit of the picture. */
final class WorkFlags {
  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Threads; 0 means one per processor. Changes no bit of the picture.")
  private Optional<Integer> threads;

  @Option(
      names = "--bucket",
      paramLabel = "N",
      description = "Side of the squares that threads render (32). Changes no bit of the picture.")
  private Optional<Integer> bucket;

  /**
   * Complains about values out of range before anything is read.
   *
   * @param command that has these flags
   * @throws ParameterException naming the flag
   */
  void validate(CommandSpec command) {
    FlagChecks checks = new FlagChecks(command);
    threads.ifPresent(n -> checks.requireIn("--threads", 0, RenderSettings.MAX_THREADS, n));
    bucket.ifPresent(n -> checks.requireIn("--bucket", 1, Integer.MAX_VALUE, n));
  }

  /** Lets the flags win over other settings. */
  void override(RenderSettings.Builder builder) {
    threads.ifPresent(builder::threads);
    bucket.ifPresent(builder::bucketSize);
  }
}
