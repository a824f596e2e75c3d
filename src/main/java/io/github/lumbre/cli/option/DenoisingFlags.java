package io.github.lumbre.cli.option;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.run.Denoising;
import java.util.Optional;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The flags that set whether a picture is denoised, and by what. */
@Command(optionListHeading = Headings.PICTURE)
public final class DenoisingFlags {
  @ArgGroup private Choice choice = new Choice();

  /** Whether to denoise; at most one of the two flags. */
  static final class Choice {
    @Option(
        names = "--denoise",
        description =
            "Denoise the picture: the default of 'render' and 'views' for a PNG or JPEG of a"
                + " model.")
    private boolean wanted;

    @Option(names = "--no-denoise", description = "Leave the noise in the picture.")
    private boolean unwanted;
  }

  @Mixin private final DenoiserFlags denoiser = new DenoiserFlags();

  /** Returns whether {@code --denoise} is given. */
  public boolean areOn() {
    return choice.wanted;
  }

  /**
   * Returns the denoiser; empty if the picture keeps its noise.
   *
   * @param isDefault whether the picture is denoised if no flag says otherwise
   * @throws TaskException if the denoiser's program is not found
   */
  public Optional<Denoising> denoising(boolean isDefault) throws TaskException {
    return choice.wanted || isDefault && !choice.unwanted
        ? Optional.of(denoiser.denoising(0))
        : Optional.empty();
  }
}
