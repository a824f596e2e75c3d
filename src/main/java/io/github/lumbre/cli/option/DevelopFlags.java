package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.FilmReport;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.DenoisedPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.FilmExposure;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmMismatchException;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.Setting.Group;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The flags that set how a film becomes a picture. */
public final class DevelopFlags extends Flags {
  @Mixin private final SettingFlags settings = new SettingFlags("as rendered", Group.OUTPUT);

  @Mixin private final PictureFlags stored = new PictureFlags();

  @Option(names = "--quiet", description = "Print no summary.")
  private boolean quiet;

  public interface Source {
    FilmFile film() throws TaskException, FilmMismatchException;
  }

  /** Checks the ranges of the values before anything is read. */
  public void validate() {
    stored.validate();
  }

  /**
   * Develops a film and writes the picture. The picture's file is reserved before the film is read.
   * A signal while the picture is denoised leaves it noisy and partial.
   *
   * @param name of the film, for messages
   */
  public void develop(Path name, Source source, Path output)
      throws TaskException, FilmMismatchException {
    Optional<Denoising> denoising = stored.denoising().denoising(false);
    try (PictureOutput picture = PictureOutput.reserve(output)) {
      requireLayers(picture);
      FilmFile film = source.film();
      Messages messages = new Messages(spec.commandLine().getErr());
      ImageWriter.Options options = options(name, film, picture, messages);
      DenoisedPicture denoised = DenoisedPicture.NOISY;
      try (Interruption interruption = Interruption.listen();
          RenderMonitor monitor =
              new RenderMonitor(interruption, Boolean.getBoolean("lumbre.tty"))) {
        interruption.requireRender();
        if (denoising.isPresent()) {
          denoised =
              DenoisedPicture.of(film.film(), denoising.get(), output, true, messages, monitor);
        }
        write(name, film, denoised, picture, options);
      }
      report(film, output);
      denoised.tell(summary(messages), new JsonSummary("develop", name));
      denoised.requireDone();
    }
  }

  /** Prints which samples a film has that was written, and warnings. */
  public void report(FilmFile film, Path written) {
    Messages messages = new Messages(spec.commandLine().getErr());
    new FilmReport(film).print(written, summary(messages), messages);
  }

  private Messages summary(Messages messages) {
    return quiet ? Messages.NONE : messages;
  }

  /** Rejects {@code --denoise} if the output is not a picture. */
  public void requireNoDenoising(Path output) {
    require(
        !stored.denoising().areOn(),
        "--denoise: expected a picture (-o), found the checkpoint " + output);
  }

  private void requireLayers(PictureOutput picture) {
    require(
        !settings.isGiven(Setting.LAYERS) || picture.hasLayers(),
        "--layers: expected an .exr picture, found " + picture.target() + ", which has no layers");
  }

  /** Returns the layers to develop: those given, or all. */
  private Set<Layer> layers(Path name, FilmFile film) throws TaskException {
    Set<Layer> recorded = film.header().layers().kinds();
    Set<Layer> wanted = settings.valueOr(Setting.LAYERS, recorded);
    for (Layer layer : wanted) {
      if (!recorded.contains(layer)) {
        throw ExitCode.SCENE.failure(
            "%s: has no layer %s, only %s; render it with --layers %s"
                .formatted(name, layer, recorded, layer));
      }
    }
    return wanted;
  }

  private ImageWriter.Options options(
      Path name, FilmFile film, PictureOutput picture, Messages messages) throws TaskException {
    FilmNotes notes = new FilmNotes(name, film.header());
    if (notes.hasLines()) {
      messages.line(
          name + ": its picture has lines, which a film does not hold; 'lumbre resume' draws them");
    }
    Exposure wanted = settings.valueOr(Setting.EXPOSURE, notes.exposure());
    Exposure stops = picture.isForScreen() ? FilmExposure.of(wanted, name, film, messages) : wanted;
    ToneCurve curve = settings.valueOr(Setting.TONE_MAP, notes.toneCurve());
    int depth = stored.bits().isPresent() ? stored.bits().get() : notes.bits();
    return new ImageWriter.Options(
        stops,
        curve,
        depth,
        stored.jpegQuality(),
        notes.metadata(),
        film.header().background(),
        Optional.of(film.header().window().dither()));
  }

  private void write(
      Path name,
      FilmFile film,
      DenoisedPicture denoised,
      PictureOutput picture,
      ImageWriter.Options options)
      throws TaskException {
    Map<String, String> metadata = new LinkedHashMap<>(options.metadata());
    new FilmNotes(name, film.header())
        .lack(film.film(), denoised.isMissing())
        .ifPresent(lack -> metadata.put(PictureMetadata.PARTIAL, lack));
    Set<Layer> layers = picture.hasLayers() ? layers(name, film) : Set.of();
    FilmPicture developed = FilmPicture.of(film.film(), film.header().layers(), layers);
    metadata.putAll(developed.metadata());
    picture.write(
        denoised.image(developed.image()),
        developed.layers(),
        denoised.noting(options.withMetadata(metadata)));
  }
}
