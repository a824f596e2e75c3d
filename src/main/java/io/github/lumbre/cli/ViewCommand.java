package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.option.BudgetFlags;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.QualityFlags;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.FilmExposure;
import io.github.lumbre.cli.run.FilmInput;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.LayerInput;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.view.RenderLine;
import io.github.lumbre.cli.view.SceneSource;
import io.github.lumbre.cli.view.SystemBrowser;
import io.github.lumbre.cli.view.View;
import io.github.lumbre.cli.view.ViewLimits;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** {@code lumbre view}: shows a render as it converges, or a picture, in the browser. */
@Command(
    name = "view",
    header = "Watch a render in the browser; turn the camera, explain pixels.",
    description =
        "Open a page, served on this machine only, that shows a scene or model as it is rendered, a"
            + " checkpoint file or a picture (OpenEXR, PNG, JPEG, HDR, PFM). The page renders anew"
            + " when the scene file is saved. Ctrl-C ends it.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre view scene.json",
      "  lumbre view helmet.glb --size 800x600 --samples 1000",
      "  lumbre view picture.exr --compare reference.exr",
      "  lumbre view scene.json --no-open --port 8080"
    })
@Exits({
  ExitCode.SCENE, ExitCode.FILM, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.PORT, ExitCode.INTERRUPTED
})
final class ViewCommand extends Subcommand {
  private static final Set<String> PICTURES =
      Set.of("exr", "png", "jpg", "jpeg", "hdr", "pic", "pfm");

  /** Enough of a picture file to recognize its format. */
  private static final int MAGIC_BYTES = 64;

  @Mixin private final SceneOptions options = new SceneOptions();

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "0",
      description = "Port of the page on 127.0.0.1 (0: any that is free).")
  private int port;

  @Option(names = "--no-open", description = "Print the address, and open no browser.")
  private boolean noOpen;

  @Option(
      names = "--compare",
      paramLabel = "PICTURE",
      description = "Picture to show side by side or as a difference.")
  private Optional<Path> compare;

  @Mixin private final RenderFlags flags = new RenderFlags();

  @Mixin private final BudgetFlags budgets = new BudgetFlags();

  @Mixin private final QualityFlags quality = new QualityFlags();

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @Override
  ExitCode run()
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    flags.validate();
    budgets.validate();
    kernel.validate();
    requireIn("--port", 0, 65535, port);
    require(
        !flags.samples().haveRange(),
        "view: cannot be combined with --samples-from, --samples-to or --share");
    require(!options.isStandardInput(), "view: expected a file, found standard input");
    Messages errors = errors();
    Optional<View.Picture> other =
        compare.isPresent() ? Optional.of(picture(compare.get(), errors)) : Optional.empty();
    String otherName = compare.map(path -> String.valueOf(path.getFileName())).orElse("");
    View.Options how = new View.Options(options.scene(), port, other, otherName);
    try (Interruption interruption = Interruption.listen();
        RenderMonitor monitor = new RenderMonitor(interruption, false);
        View view = view(how, errors)) {
      view.open(new ViewLimits(targetError(), budgets.confidence(), budgets.time()));
      announce(view);
      view.run(monitor::isCancelled);
      return ExitCode.INTERRUPTED;
    }
  }

  private OptionalDouble targetError() {
    return budgets.targetError().isPresent() ? budgets.targetError() : quality.targetError();
  }

  private SceneParser parser() {
    boolean isOpen = budgets.time().isPresent() || targetError().isPresent();
    SceneParser parser = kernel.over(options.parser(), budgets.time());
    return flags.over(parser, isOpen, quality.isAdaptive(), quality.depth());
  }

  private void announce(View view) {
    Messages out = out();
    boolean isOpen = !noOpen && SystemBrowser.open(view.address());
    out.line((isOpen ? "view: opened " : "view: open ") + view.address());
  }

  private View view(View.Options how, Messages errors) throws TaskException {
    Path path = options.scene();
    if (LayerInput.isFilm(path)) {
      FilmFile film = FilmInput.read(path, errors);
      FilmNotes notes = new FilmNotes(path, film.header());
      boolean isAutomatic = notes.exposure().stops().isEmpty();
      Exposure automatic =
          isAutomatic ? FilmExposure.of(Exposure.AUTO, path, film, errors) : Exposure.AUTO;
      return View.of(developed(film), notes.exposure(), automatic, notes.toneCurve(), how);
    }
    if (isPicture(path)) {
      return View.of(picture(path, errors), Exposure.NONE, Exposure.AUTO, ToneCurve.SRGB, how);
    }
    return View.of(source(errors), how);
  }

  private static boolean isPicture(Path path) {
    String name = String.valueOf(path.getFileName()).toLowerCase(Locale.ROOT);
    return PICTURES.contains(name.substring(name.lastIndexOf('.') + 1));
  }

  private static View.Picture developed(FilmFile film) {
    FilmPicture picture = FilmPicture.of(film.film(), film.header().layers());
    return new View.Picture(
        picture.image(),
        picture.layers(),
        picture.metadata(),
        false,
        film.header().background());
  }

  private static View.Picture picture(Path path, Messages errors) throws TaskException {
    if (LayerInput.isFilm(path)) {
      return developed(FilmInput.read(path, errors)).asLight();
    }
    if (!Files.exists(path)) {
      throw ExitCode.SCENE.failure(path + ": does not exist");
    }
    try {
      boolean isExr = String.valueOf(path.getFileName()).toLowerCase(Locale.ROOT).endsWith(".exr");
      Optional<LayeredImage> exr = isExr ? Optional.of(LayeredImage.read(path)) : Optional.empty();
      List<ImageLayer> layers =
          exr.map(LayeredImage::layers).orElse(List.of()).stream()
              .filter(layer -> !layer.name().isEmpty())
              .toList();
      Map<String, String> texts = exr.map(LayeredImage::texts).orElse(Map.of());
      return new View.Picture(LinearReader.read(path), layers, texts, !isLinear(path));
    } catch (ImageFormatException e) {
      throw LayerInput.failure(path, e);
    } catch (IOException e) {
      throw ExitCode.SCENE.failure(path + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }

  private static boolean isLinear(Path path) throws IOException {
    try (InputStream in = Files.newInputStream(path)) {
      return ImageFormat.startsLinear(in.readNBytes(MAGIC_BYTES));
    }
  }

  /** Returns the command line that renders the scene. */
  private RenderLine line() {
    CommandSpec render = new CommandLine(new RenderCommand()).getCommandSpec();
    List<String> args = spec.commandLine().getParseResult().originalArgs();
    return RenderLine.of(options.scene(), args, spec, render);
  }

  private SceneSource source(Messages errors) {
    Optional<RenderLine> line = Optional.of(line());
    return new SceneSource() {
      private volatile Optional<SceneFile> last = Optional.empty();

      @Override
      public SceneFile read(Set<Layer> layers)
          throws SceneFormatException, TaskException, IOException {
        SceneFile file = options.load(parser(), errors);
        last = Optional.of(file);
        RenderSettings settings = file.settings();
        Set<Layer> all = EnumSet.noneOf(Layer.class);
        all.addAll(settings.layers());
        all.addAll(layers);
        if (options.isModel() && settings.mode() == Mode.PATH) {
          all.addAll(Layer.FOR_DENOISING);
        }
        SceneFile recorded =
            file.with(
                settings.toBuilder()
                    .set(Setting.LAYERS, Layer.setOf(all.toArray(Layer[]::new)))
                    .build());
        MemoryCheck.require(recorded.settings(), FilmLayers.of(recorded.settings(), file.scene()));
        return recorded;
      }

      @Override
      public byte[] text() throws IOException {
        Optional<SceneText> around = last.flatMap(SceneFile::text);
        return around.isPresent() ? around.get().json() : Files.readAllBytes(options.scene());
      }

      @Override
      public Optional<RenderLine> command() {
        return line;
      }

      @Override
      public Set<Path> files() {
        return options.files(last);
      }
    };
  }
}
