package io.github.lumbre.cli.option;

import io.github.lumbre.scene.RenderSettings;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The flag that sets the samples of each pixel. */
@Command(optionListHeading = Headings.SAMPLES)
public final class SamplesFlag extends Flags {
  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description =
          "Samples per pixel (scene or 100; of a model that is denoised: 8, of 'views' 2).")
  private Optional<Integer> samples;

  /** Requires the value to be in its range. */
  public void validate() {
    samples.ifPresent(n -> checks().requireIn("--samples", 1, RenderSettings.MAX_SAMPLES, n));
  }

  boolean isGiven() {
    return samples.isPresent();
  }

  /** Sets the samples, if they are given. */
  public void override(RenderSettings.Builder builder) {
    samples.ifPresent(builder::samples);
  }
}
