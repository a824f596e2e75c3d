package io.github.lumbre.cli.option;

import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/** The flags that do not suit drawings as vectors. Stateless. */
public final class VectorFlags {
  /** The flags of samples, light and pixels. */
  private static final Set<String> REFUSED =
      Set.of(
          "--sky", "--sun", "--sky-intensity", "--sky-rotation", "--ground", "--checkpoint",
          "--denoise", "--no-denoise", "--denoiser", "--denoise-timeout", "--oidn", "--bits",
          "--jpeg-quality", "--exposure", "--tonemap", "--layers", "--mode", "--depth", "--split",
          "--guide", "--clamp", "--samples", "--samples-from", "--samples-to", "--share",
          "--filter", "--seed", "--time", "--target-error", "--confidence", "--quality",
          "--adaptive", "--shutter", "--poses");

  private VectorFlags() {}

  /**
   * Requires that no flag of a command does not suit vectors.
   *
   * @throws ParameterException that names the first one
   */
  public static void require(CommandSpec spec) {
    for (OptionSpec given : spec.commandLine().getParseResult().matchedOptionsSet()) {
      for (String flag : given.names()) {
        if (REFUSED.contains(flag)) {
          throw new ParameterException(
              spec.commandLine(),
              flag + ": cannot be used with an .svg file, which shows lines without light");
        }
      }
    }
  }
}
