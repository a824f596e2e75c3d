package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The result of denoising a film's picture. If the denoiser fails, the picture keeps its noise.
 *
 * @param denoised the denoised picture; empty if the picture keeps its noise
 * @param failure the denoiser's failure
 * @param isWanted whether the picture shall be denoised
 */
public record DenoisedPicture(
    Optional<Denoised> denoised, Optional<TaskException> failure, boolean isWanted) {
  /** A picture that shall keep its noise. */
  public static final DenoisedPicture NOISY =
      new DenoisedPicture(Optional.empty(), Optional.empty(), false);

  /** A picture that keeps its noise because its render was stopped. */
  private static final DenoisedPicture STOPPED =
      new DenoisedPicture(Optional.empty(), Optional.empty(), true);

  /**
   * Denoises the picture of a film.
   *
   * @param target where the picture is written
   * @throws InterruptedException if the thread is interrupted
   */
  private static DenoisedPicture of(Film film, Denoising denoising, Path target, Messages messages)
      throws InterruptedException {
    String name = target.equals(PictureOutput.STANDARD) ? "standard output" : target.toString();
    try {
      NoisyPicture noisy = NoisyPicture.of(film);
      denoising.advise(noisy, name, messages);
      return new DenoisedPicture(Optional.of(denoising.denoise(noisy)), Optional.empty(), true);
    } catch (TaskException e) {
      return failed(e.code(), e.getMessage(), name, e);
    } catch (OutOfMemoryError e) {
      String advice = MemoryCheck.advice(Runtime.getRuntime().maxMemory() * 3 / 2);
      return failed(ExitCode.LIMIT, "not enough memory to denoise; " + advice, name, e);
    }
  }

  /**
   * Denoises the picture of a film, unless the render was stopped before the film had all its
   * samples, or denoising is stopped.
   *
   * @param target where the picture is written
   * @param isSampled whether the film has all its samples
   */
  public static DenoisedPicture of(
      Film film,
      Denoising denoising,
      Path target,
      boolean isSampled,
      Messages messages,
      RenderMonitor monitor) {
    Optional<DenoisedPicture> done =
        isSampled
            ? monitor.finishing("denoising", () -> of(film, denoising, target, messages))
            : Optional.empty();
    if (done.isEmpty()) {
      messages.line("not denoised, because the render was stopped");
    }
    return done.orElse(STOPPED);
  }

  private static DenoisedPicture failed(
      ExitCode code, String reason, String name, Throwable cause) {
    String text = reason + "; the noisy picture is " + name;
    return new DenoisedPicture(
        Optional.empty(), Optional.of(new TaskException(code, text, cause)), true);
  }

  /** Returns whether the picture keeps its noise, although it shall be denoised. */
  public boolean isMissing() {
    return isWanted && denoised.isEmpty();
  }

  /** Returns the picture to write, given the noisy one. */
  public Image image(Image noisy) {
    return denoised.map(Denoised::image).orElse(noisy);
  }

  /** Returns how to write the picture: the metadata of the denoiser are added. */
  public ImageWriter.Options noting(ImageWriter.Options options) {
    return denoised.map(picture -> Denoising.noting(picture, options)).orElse(options);
  }

  /** Reports by what the picture was denoised, and its errors before and after. */
  public void tell(Messages messages, JsonSummary report) {
    denoised.ifPresent(
        picture -> {
          messages.line(Denoising.line(picture));
          report.put("denoised", Denoising.values(picture));
        });
  }

  /**
   * Requires that the denoiser has not failed.
   *
   * @throws TaskException that states the failure and where the noisy picture is
   */
  public void requireDone() throws TaskException {
    if (failure.isPresent()) {
      throw failure.get();
    }
  }
}
