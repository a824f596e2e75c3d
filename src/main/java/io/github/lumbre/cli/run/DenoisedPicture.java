package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.denoise.NoisyPicture;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.TaskException;
import java.nio.file.Path;
import java.util.Optional;

/** The denoised picture beside a noisy one: its file is reserved before anything is rendered. */
public final class DenoisedPicture implements AutoCloseable {
  /** No denoised picture. */
  public static final DenoisedPicture NONE =
      new DenoisedPicture(Optional.empty(), Optional.empty());

  private final Optional<Denoising> denoising;
  private final Optional<PictureOutput> output;

  private DenoisedPicture(Optional<Denoising> denoising, Optional<PictureOutput> output) {
    this.denoising = denoising;
    this.output = output;
  }

  /**
   * Reserves the file.
   *
   * @param denoising the denoiser; if empty, nothing is reserved
   * @param noisy path of the noisy picture
   * @throws TaskException if the file cannot be written
   */
  public static DenoisedPicture reserve(
      Optional<Denoising> denoising, Path noisy, Fallback fallback) throws TaskException {
    return new DenoisedPicture(
        denoising,
        denoising.isPresent()
            ? Optional.of(PictureOutput.reserve(Denoising.beside(noisy), fallback))
            : Optional.empty());
  }

  /** Returns whether there is a denoiser. */
  public boolean isWanted() {
    return denoising.isPresent();
  }

  /**
   * Denoises and writes the picture; there must be a denoiser. See {@link Denoising#write}.
   *
   * @param kept where the noisy picture is
   * @throws TaskException if the denoiser fails or the picture cannot be written
   */
  public void write(
      NoisyPicture noisy,
      ImageWriter.Options options,
      String kept,
      Messages messages,
      JsonSummary report)
      throws TaskException {
    Denoising denoiser = denoising.orElseThrow();
    denoiser.advise(noisy, kept, messages);
    denoiser.write(noisy, output.orElseThrow(), options, kept, messages, report);
  }

  /** Releases the reserved file if nothing was written. */
  @Override
  public void close() {
    output.ifPresent(PictureOutput::close);
  }
}
