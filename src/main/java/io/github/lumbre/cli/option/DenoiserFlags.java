package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.render.denoise.DenoiseException;
import io.github.lumbre.render.denoise.OpenImageDenoise;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The flags that choose a denoiser. */
@Command(optionListHeading = Headings.PICTURE)
public final class DenoiserFlags {
  enum Engine {
    BUILTIN,
    OIDN
  }

  @Option(
      names = "--denoiser",
      paramLabel = "NAME",
      description =
          "Denoiser: builtin, with the same bits on every machine, or oidn (builtin, or oidn with"
              + " --oidn).")
  private Optional<Engine> engine;

  @Option(
      names = "--oidn",
      paramLabel = "PATH",
      description =
          "The program oidnDenoise of Open Image Denoise, or its folder (LUMBRE_OIDN, or sought on"
              + " the PATH).")
  private Optional<Path> oidn;

  @Option(
      names = "--denoise-timeout",
      paramLabel = "DURATION",
      description = "Time after which oidnDenoise is ended: 90s, 5m, 2h (10m).")
  private Optional<Duration> limit;

  /**
   * Returns the chosen denoiser.
   *
   * @param threads number of threads; 0 means one for each processor
   * @throws TaskException if the program is not found
   */
  public Denoising denoising(int threads) throws TaskException {
    if (engine.orElse(oidn.isPresent() ? Engine.OIDN : Engine.BUILTIN) == Engine.BUILTIN) {
      return new Denoising(Optional.empty(), threads);
    }
    try {
      OpenImageDenoise program = OpenImageDenoise.find(oidn, System.getenv()).withThreads(threads);
      return new Denoising(Optional.of(limit.map(program::within).orElse(program)), threads);
    } catch (DenoiseException e) {
      throw ExitCode.USAGE.failure(e.getMessage() + " or with --oidn", e);
    }
  }
}
