package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.option.DenoisingFlags;
import io.github.lumbre.cli.option.FrameFlags;
import io.github.lumbre.cli.option.ImportFlag;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.RunFlags;
import io.github.lumbre.cli.option.SamplesFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.option.VectorFlags;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.DrawingJob;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.image.Dither;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ContactSheet;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.Setting.Group;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.internal.ModelSequence;
import io.github.lumbre.stage.internal.ModelSource;
import io.github.lumbre.stage.internal.PictureDrawing;
import io.github.lumbre.stage.internal.StagedSheet;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
      description = {
        "Folder of the pictures; it is created if it does not exist. Or a name that ends in .svg:"
            + " one sheet of lines as vectors, in third-angle projection."
      })
  private Path folder;

  @Mixin private final SamplesFlag samples = new SamplesFlag();

  @Mixin private final FrameFlags frame = new FrameFlags();

  @Mixin private final SettingFlags work = new SettingFlags("", Group.EXECUTION);

  @Mixin private final RunFlags run = new RunFlags();

  @Mixin
  private final ModelFlags flags =
      new ModelFlags()
          .without(
              "'lumbre views' renders all standard views",
              Stage.VIEW,
              Stage.CAMERA,
              Stage.EYE,
              Stage.TARGET);

  @Mixin private final ImportFlag imports = new ImportFlag();

  @Mixin private final DenoisingFlags stored = new DenoisingFlags();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  private Optional<Denoising> denoising = Optional.empty();
  private final List<SceneFile> files = new ArrayList<>();
  private final List<DisplayLight> pictures = new ArrayList<>();

  @Override
  ExitCode run() throws Exception {
    Stage stage = checkedStage();
    Deadline deadline = run.deadline();
    JsonSummary report = new JsonSummary("views", model);
    try (Interruption interruption = Interruption.listen();
        Frames frames = new Frames(targets(), interruption, deadline)) {
      return run.border(interruption, Optional.empty())
          .of(report, () -> run(stage, report, frames, interruption, deadline));
    }
  }

  private Stage checkedStage() throws TaskException {
    require(
        imports.converts(model) || ModelReader.isModel(model),
        model + ": expected a model file: " + Models.NAMES + imports.advice(model));
    imports.validate();
    if (isVector()) {
      VectorFlags.require(spec);
      flags.drawLines();
    }
    samples.validate();
    work.validate(spec);
    frame.validate();
    return isVector() ? VectorViews.inCells(flags.stage()) : flags.stage();
  }

  /** Returns whether the views are drawn on one sheet of vectors. */
  private boolean isVector() {
    return ImageFormat.of(folder).filter(ImageFormat::isVector).isPresent();
  }

  /** Returns the paths of the views in their order, and of the contact sheet. */
  private List<Path> targets() {
    if (isVector()) {
      return List.of(folder);
    }
    List<Path> targets = new ArrayList<>();
    View.standard().keySet().forEach(name -> targets.add(folder.resolve(name + ".png")));
    targets.add(folder.resolve(SHEET));
    return targets;
  }

  private ExitCode run(
      Stage stage, JsonSummary report, Frames frames, Interruption interruption, Deadline deadline)
      throws Exception {
    OutputGuard guard = overwrite.guard().reads(model, "the model");
    targets().forEach(target -> guard.writes("-o", target, OutputContent.PICTURE));
    guard.check();
    boolean isDrawing = StagedSheet.of(stage).isAlone();
    denoising = isDrawing ? Optional.empty() : stored.denoising(true);
    try (RenderMonitor monitor = run.monitor(interruption, deadline)) {
      monitor.reading(model, () -> read(stage));
    }
    SceneFile first = files.get(0);
    guard.checkAssets(model, first.assetPaths(first.text().orElseThrow().path()));
    errors().warnings(first.warnings());
    if (!isDrawing) {
      MemoryCheck.require(first.settings(), FilmLayers.of(first.settings(), first.scene()));
    }
    frames.reserve(Fallback.TEMPORARY);
    long start = System.nanoTime();
    ExitCode code =
        isVector()
            ? draw(frames, interruption, deadline)
            : frames.each(index -> render(index, frames, interruption, deadline));
    if (run.isJson()) {
      describe(report);
    }
    run.summarize(
        summary(first.settings(), isDrawing), Duration.ofNanos(System.nanoTime() - start));
    return code;
  }

  private List<SceneFile> read(Stage stage) throws Exception {
    SceneParser parser = frame.over(new SceneParser()).overriding(this::overridden);
    ModelSource source =
        imports.converts(model) ? imports.source(parser, model) : ModelSource.of(parser, model);
    ModelSequence views = ModelSequence.of(source, stage, ModelSequence.Motion.ofViews(isVector()));
    for (int i = 0; i < views.count(); i++) {
      files.add(views.frame(i));
    }
    return files;
  }

  private RenderSettings overridden(RenderSettings settings) {
    RenderSettings.Builder builder = settings.toBuilder();
    frame.override(builder, settings);
    if (denoising.isPresent()) {
      builder.samples(Denoising.VIEW_SAMPLES).set(Setting.LAYERS, Layer.FOR_DENOISING);
    }
    samples.override(builder);
    work.override(builder);
    return builder.build();
  }

  /** Renders a view, or joins all views to the contact sheet after the last one. */
  private ExitCode render(int index, Frames frames, Interruption interruption, Deadline deadline)
      throws Exception {
    run.about(frames);
    JsonSummary report = new JsonSummary("views", model);
    return new Run(interruption, Optional.empty(), Optional.of(frames))
        .failing(
            report,
            () -> {
              if (index == files.size()) {
                writeSheet(frames);
                return ExitCode.OK;
              }
              interruption.requireRender();
              try (FilmKeeper keeper = FilmKeeper.none(run.errors());
                  RenderMonitor monitor = run.monitor(interruption, deadline)) {
                RenderJob job = job(files.get(index), frames, keeper, monitor, report);
                return PictureDrawing.isAlone(files.get(index).parsed())
                    ? new DrawingJob(job).run()
                    : job.run(0);
              }
            });
  }

  private RenderJob job(
      SceneFile file, Frames frames, FilmKeeper keeper, RenderMonitor monitor, JsonSummary report) {
    Budget budget = Budget.ofSamples(file.settings().samples());
    return new RenderJob(
        model,
        file,
        frames.picture(),
        keeper,
        monitor,
        run.errors(),
        report,
        new RunBudget(budget, Deadline.after(Optional.empty())),
        run.jobOptions(
            ImageWriter.Options.DEFAULT.pngBits(),
            ImageWriter.Options.DEFAULT_JPEG_QUALITY,
            false,
            denoising,
            Set.of(),
            PictureExposure.ofEach(),
            pictures::add),
        Engine.LOCAL);
  }

  /** Draws all views on one sheet of vectors. */
  private ExitCode draw(Frames frames, Interruption interruption, Deadline deadline)
      throws Exception {
    List<VectorPicture> views = new ArrayList<>();
    List<String> names = List.copyOf(View.standard().keySet());
    try (RenderMonitor monitor = run.monitor(interruption, deadline)) {
      for (int i = 0; i < files.size(); i++) {
        String about = folder + ", " + names.get(i) + ": ";
        views.add(
            DrawingJob.vectors(
                files.get(i).parsed(), monitor, note -> run.errors().note(about + note)));
      }
    }
    frames.picture().write(VectorViews.sheet(names, views));
    return ExitCode.OK;
  }

  private void writeSheet(Frames frames) throws Exception {
    List<DisplayLight> whole = pictures.stream().map(DisplayLight::withBackground).toList();
    List<Image> images = whole.stream().map(DisplayLight::image).toList();
    int gap = Math.max(1, images.get(0).width() / GAPS_PER_WIDTH);
    Image sheet = ContactSheet.of(images, SHEET_COLUMNS, gap);
    ImageWriter.Options options = whole.get(0).options();
    frames.picture().write(sheet, options.withDither(Optional.of(Dither.FULL_FRAME)));
  }

  /** Adds the parts of the model, and what each view shows. */
  private void describe(JsonSummary report) {
    report.putScene(files.get(0));
    Map<Path, SceneFile> seen = new LinkedHashMap<>();
    List<String> names = List.copyOf(View.standard().keySet());
    files.forEach(
        file -> {
          String name = names.get(seen.size());
          seen.put(isVector() ? Path.of(name) : targets().get(seen.size()), file);
        });
    report.putPictures(seen);
  }

  private String summary(RenderSettings settings, boolean isDrawing) {
    if (isDrawing) {
      return "%s: %d views%s, lines; %dx%d pixels each"
          .formatted(
              folder,
              files.size(),
              isVector() ? " on one sheet" : " and a contact sheet, " + SHEET,
              settings.width(),
              settings.height());
    }
    return "%s: %d views and a contact sheet, %s; %dx%d pixels, %s per pixel%s"
        .formatted(
            folder,
            files.size(),
            SHEET,
            settings.width(),
            settings.height(),
            Numbers.count(settings.samples(), "sample"),
            denoising.isPresent() ? ", denoised" : "");
  }
}
