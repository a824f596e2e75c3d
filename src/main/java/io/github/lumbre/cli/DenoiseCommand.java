package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.DenoiserFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.FilmExposure;
import io.github.lumbre.cli.run.FilmInput;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.LayerInput;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre denoise}: removes noise from a rendered picture. */
@Command(
    name = "denoise",
    header = "Remove noise from an OpenEXR or checkpoint file.",
    description =
        "The layers of 'lumbre render --denoise' or '--layers denoise' help the denoiser, and so do"
            + " the layers albedo and normal of other programs. The result is an estimate: error"
            + " bounds of the render do not hold for it.",
    footer = {
      "",
      "Examples:",
      "  lumbre denoise night.film -o night.denoised.png",
      "  lumbre denoise picture.exr -o clean.exr --oidn folder/bin"
    })
@Exits({
  ExitCode.OK, ExitCode.ABSENT, ExitCode.FILM, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.OUTPUT,
  ExitCode.DENOISER
})
final class DenoiseCommand extends Subcommand {
  @Parameters(paramLabel = "FILE", description = "OpenEXR file (.exr) or checkpoint file.")
  private Path file;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      required = true,
      description =
          "Picture to write: PNG or JPEG for the screen, OpenEXR or PFM for linear light, by its"
              + " ending.")
  private Path output;

  @Mixin private final DenoiserFlags denoiser = new DenoiserFlags();

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 means one for each processor (${DEFAULT-VALUE}).")
  private int threads;

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  /** A picture to denoise, and how to write it. */
  private record Input(NoisyPicture noisy, ImageWriter.Options options) {}

  @Override
  ExitCode run() throws TaskException, InterruptedException {
    checks().requirePicture(output);
    require(threads >= 0, "--threads: expected at least 0, found " + threads);
    Denoising denoising = denoiser.denoising(threads);
    overwrite.guard().readsFilm(file).writes("-o", output, OutputContent.PICTURE).check();
    Messages errors = errors();
    Input input = read(errors);
    denoising.advise(input.noisy, file.toString(), errors);
    if (input.noisy.replaced() != 0) {
      errors.line(
          "warning: %s: NaN or infinite pixels: %d; they got the light of their neighbors"
              .formatted(file, input.noisy.replaced()));
    }
    try (PictureOutput picture = PictureOutput.reserve(output)) {
      Denoised denoised = denoising.denoise(input.noisy);
      picture.write(denoised.image(), Denoising.noting(denoised, input.options));
      errors.line(output + ": " + Denoising.line(denoised));
    }
    return ExitCode.OK;
  }

  private Input read(Messages errors) throws TaskException {
    if (LayerInput.isFilm(file)) {
      FilmFile film = FilmInput.read(file, errors);
      FilmNotes notes = new FilmNotes(file, film.header());
      Exposure exposure =
          ImageFormat.of(output).filter(ImageFormat::isForScreen).isPresent()
              ? FilmExposure.of(notes.exposure(), file, film, errors)
              : notes.exposure();
      return new Input(
          NoisyPicture.of(film.film()),
          new ImageWriter.Options(
              exposure,
              notes.toneCurve(),
              notes.bits(),
              90,
              notes.metadata(),
              film.header().background(),
              Optional.of(film.header().window().dither())));
    }
    LayeredImage image = LayerInput.read(file, errors);
    try {
      return new Input(
          NoisyPicture.of(image),
          new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, 90, Map.of()));
    } catch (IllegalArgumentException e) {
      throw ExitCode.ASSET.failure(file + ": " + e.getMessage(), e);
    }
  }
}
