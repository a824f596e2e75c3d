package io.github.lumbre.cli.option;

import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that set how a picture is denoised and stored. */
@Command(optionListHeading = Headings.PICTURE)
public final class PictureFlags extends Flags {
  @Option(
      names = "--bits",
      paramLabel = "8|16",
      description = "Bits per channel of a PNG (8; of a film: as rendered).")
  private Optional<Integer> bits;

  @Option(
      names = "--jpeg-quality",
      paramLabel = "N",
      defaultValue = "90",
      description = "Quality of a JPEG, 1 to 100 (${DEFAULT-VALUE}).")
  private int jpegQuality;

  @Mixin private final DenoisingFlags denoising = new DenoisingFlags();

  /**
   * Checks the ranges of the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is out of range
   */
  public void validate() {
    bits.ifPresent(n -> require(n == 8 || n == 16, "--bits: expected 8 or 16, found " + n));
    checks().requireIn("--jpeg-quality", 1, 100, jpegQuality);
  }

  /** Returns the number of bits per channel of a PNG; empty if it is not given. */
  public Optional<Integer> bits() {
    return bits;
  }

  /** Returns the quality of a JPEG, 1 to 100. */
  public int jpegQuality() {
    return jpegQuality;
  }

  /** Returns the flags that set whether the picture is denoised. */
  public DenoisingFlags denoising() {
    return denoising;
  }
}
