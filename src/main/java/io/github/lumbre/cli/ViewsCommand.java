package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.option.DenoisingFlags;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.LaterStep;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.DenoisedPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ContactSheet;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.internal.PictureDrawing;
import io.github.lumbre.stage.internal.ViewNumbers;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre views}: renders a model from all standard views. */
@Command(
    name = "views",
    modelTransformer = SettingFlags.Adder.class,
    header = "Render a model from all sides, and a contact sheet.",
    description =
        "Writes front.png, back.png, left.png, right.png, top.png, bottom.png, iso.png and"
            + " views.png into a folder. Each picture has the bits of 'lumbre render MODEL --view"
            + " NAME' with the same flags and samples.",
    footer = {"", "Example:", "  lumbre views part.stl --up z --ground -o part-views"})
@Exits({
  ExitCode.OK, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.OUTPUT, ExitCode.SAVED
})
final class ViewsCommand extends Subcommand {
  private static final String SHEET = "views.png";
  private static final int SHEET_COLUMNS = 4;

  /** The gaps of the contact sheet are narrower than a picture by this factor. */
  private static final int GAPS_PER_WIDTH = 64;

  @Parameters(paramLabel = "MODEL", description = "Model: " + ModelFormat.TITLES + ".")
  private Path model;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "DIR",
      required = true,
      description = "Folder of the pictures; it is created if it does not exist.")
  private Path folder;

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description = "Samples per pixel (2; with --no-denoise 100).")
  private Optional<Integer> samples;

  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description = "Size of each picture in pixels, or its longer side (1024x768).")
  private Optional<FrameSize> size;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Number of threads; 0: one per processor (0).")
  private Optional<Integer> threads;

  @Option(
      names = "--json",
      description = "Print the model's parts and what each view shows as one line of JSON.")
  private boolean json;

  @Mixin private final ModelFlags flags = new ModelFlags();

  @Mixin private final DenoisingFlags stored = new DenoisingFlags();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  private Optional<Denoising> denoising = Optional.empty();

  @Override
  ExitCode run() throws Exception {
    Stage stage = checkedStage();
    OutputGuard guard = guard();
    JsonSummary report = new JsonSummary("views", model);
    try (Interruption interruption = Interruption.listen()) {
      return new Run(interruption, json ? Optional.of(out()) : Optional.empty(), Optional.empty())
          .of(report, () -> run(stage, guard, report, interruption));
    }
  }

  private ExitCode run(
      Stage stage, OutputGuard guard, JsonSummary report, Interruption interruption)
      throws Exception {
    guard.check();
    denoising = stored.denoising(true);
    Messages messages = errors();
    try (RenderMonitor monitor = new RenderMonitor(interruption, Boolean.getBoolean("lumbre.tty"));
        Frames frames = new Frames(targets(), interruption, Deadline.after(Optional.empty()))) {
      StagedModel staged;
      Interruption.Wait reading = monitor.reading(model);
      try (reading) {
        staged = read(stage);
      }
      SceneFile first = staged.scene();
      List<Scene> views = staged.seenFrom(List.copyOf(View.standard().values()));
      guard.checkAssets(model, first.assetPaths(first.text().orElseThrow().path()));
      messages.warnings(first.warnings());
      RenderSettings settings = first.settings();
      MemoryCheck.require(settings, FilmLayers.of(settings, first.scene()));
      frames.reserve(Fallback.TEMPORARY);
      long start = System.nanoTime();
      render(first, views, frames, interruption, monitor, messages);
      if (json) {
        describe(first, views, report);
      }
      messages.line(summary(settings, (System.nanoTime() - start) * 1e-9));
      return ExitCode.OK;
    }
  }

  private String summary(RenderSettings settings, double seconds) {
    return String.format(
        Locale.ROOT,
        "%s: %d views and a contact sheet, %s; %dx%d pixels, %s per pixel%s, %.2f s",
        folder,
        View.standard().size(),
        SHEET,
        settings.width(),
        settings.height(),
        Numbers.count(settings.samples(), "sample"),
        denoising.isPresent() ? ", denoised" : "",
        seconds);
  }

  private Stage checkedStage() {
    require(ModelReader.isModel(model), model + ": expected a model file: " + Models.NAMES);
    for (String flag : List.of("--view", "--camera")) {
      require(
          !spec.commandLine().getParseResult().hasMatchedOption(flag),
          flag + ": cannot be used; 'lumbre views' renders all standard views");
    }
    samples.ifPresent(n -> requireIn("--samples", 1, RenderSettings.MAX_SAMPLES, n));
    threads.ifPresent(n -> requireIn("--threads", 0, RenderSettings.MAX_THREADS, n));
    size.ifPresent(checks()::requireSize);
    return flags.stage();
  }

  private OutputGuard guard() {
    OutputGuard guard = overwrite.guard().reads(model, "the model");
    targets().forEach(target -> guard.writes("-o", target, OutputContent.PICTURE));
    return guard;
  }

  /** Returns the paths of the views in their order, and of the contact sheet. */
  private List<Path> targets() {
    List<Path> targets = new ArrayList<>();
    View.standard().keySet().forEach(name -> targets.add(folder.resolve(name + ".png")));
    targets.add(folder.resolve(SHEET));
    return targets;
  }

  private StagedModel read(Stage stage) throws SceneFormatException, IOException {
    SceneParser parser = new SceneParser().overriding(this::overridden);
    View first = View.standard().values().iterator().next();
    return StagedModel.read(model, stage.seenFrom(first), parser);
  }

  private RenderSettings overridden(RenderSettings settings) {
    RenderSettings.Builder builder =
        size.map(s -> s.over(settings)).orElse(settings).toBuilder();
    if (denoising.isPresent()) {
      builder.samples(Denoising.VIEW_SAMPLES).set(Setting.LAYERS, Layer.FOR_DENOISING);
    }
    samples.ifPresent(builder::samples);
    threads.ifPresent(builder::threads);
    return builder.build();
  }

  /**
   * Renders all views and the contact sheet.
   *
   * @throws TaskException if a picture cannot be written, or a signal ends the command
   */
  private void render(
      SceneFile file,
      List<Scene> views,
      Frames frames,
      Interruption interruption,
      RenderMonitor monitor,
      Messages messages)
      throws Exception {
    RenderSettings settings = file.settings();
    ImageWriter.Options options = settings.development();
    ParsedScene first = file.parsed();
    List<String> notes = new ArrayList<>();
    PictureDrawing drawing =
        monitor
            .unlessStopped(() -> PictureDrawing.of(first, notes::add))
            .orElseThrow(CancellationException::new);
    List<DisplayLight> pictures = new ArrayList<>();
    Iterator<String> names = View.standard().keySet().iterator();
    for (Scene view : views) {
      Optional<String> name = Optional.of(names.next());
      new Run(interruption, Optional.empty(), Optional.of(frames)).of(
          new JsonSummary("views", model),
          () -> {
            interruption.requireRender();
            Film film = rendered(settings, view, monitor);
            DenoisedPicture denoised = denoised(film, frames, monitor, messages);
            Image clean = denoised.image(film.develop());
            DisplayLight drawn =
                monitor
                    .finishing(
                        "drawing lines and labels",
                        () -> drawing.onDisplay(view, name, clean, options))
                    .orElseThrow(CancellationException::new);
            notes.forEach(note -> messages.line(name.get() + ": " + note));
            notes.clear();
            pictures.add(drawn);
            frames.picture().write(drawn.image(), options(denoised, drawn, film));
            denoised.requireDone();
            return ExitCode.OK;
          });
    }
    int gap = Math.max(1, settings.width() / GAPS_PER_WIDTH);
    List<DisplayLight> whole = pictures.stream().map(DisplayLight::withBackground).toList();
    List<Image> images = whole.stream().map(DisplayLight::image).toList();
    Image sheet = ContactSheet.of(images, SHEET_COLUMNS, gap);
    frames.picture().write(sheet, whole.get(0).options());
  }

  /** Adds the parts of the model, and what each view shows. */
  private void describe(SceneFile file, List<Scene> views, JsonSummary report) {
    ParsedScene first = file.parsed();
    ModelContents contents = first.model().orElseThrow();
    PartTable parts = contents.parts(first.scene());
    report.putScene(first);
    report.putContents(first.contents());
    report.putModel(contents, parts);
    for (int i = 0; i < views.size(); i++) {
      ViewNumbers numbers = ViewNumbers.of(views.get(i), first.settings(), parts);
      report.putView("file", targets().get(i), first.settings(), numbers, parts);
    }
  }

  private static Film rendered(RenderSettings settings, Scene view, RenderMonitor monitor)
      throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, view);
    Film film = renderer.newFilm();
    monitor.started(settings.window().pixels() * settings.samples());
    if (!new PassLoop(renderer, film).run(monitor).complete()) {
      throw new CancellationException("stopped");
    }
    return film;
  }

  private DenoisedPicture denoised(
      Film film, Frames frames, RenderMonitor monitor, Messages messages) {
    if (denoising.isEmpty()) {
      return DenoisedPicture.NOISY;
    }
    Denoising used = denoising.get().withThreads(threads.orElse(0));
    DenoisedPicture denoised =
        DenoisedPicture.of(film, used, frames.picture().target(), true, messages, monitor);
    if (denoised.isMissing() && denoised.failure().isEmpty()) {
      throw new CancellationException("stopped");
    }
    return denoised;
  }

  /** Returns how to write a picture, which is partial if its denoiser has failed. */
  private static ImageWriter.Options options(
      DenoisedPicture denoised, DisplayLight drawn, Film film) {
    if (!denoised.isMissing()) {
      return denoised.noting(drawn.options());
    }
    String samples = Numbers.count(film.mostSamples(), "sample") + " per pixel";
    String lack = LaterStep.text(samples, Set.of(LaterStep.DENOISING));
    return drawn.options().withMetadata(Map.of(PictureMetadata.PARTIAL, lack));
  }
}
