package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.RunFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PictureHint;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.DrawingJob;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.FrameWindow;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.JoinedFrames;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.internal.PictureDrawing;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * {@code lumbre render}: reads a scene, renders it and writes the picture.
 *
 * <p>The command fails before it renders if it can: it first checks the flags, then the output
 * path, then the scene, then memory.
 */
@Command(
    name = "render",
    header = "Render a scene to a picture.",
    description =
        "Flags override the scene's settings. The picture is bit-identical on every machine and"
            + " with any number of threads.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre render scene.json",
      "  lumbre render scene.json -s 16 --size 480x270 --exposure auto",
      "  lumbre render scene.json -o picture.exr --mode ray --stats",
      "  lumbre render - -o - --format jpg < scene.json > picture.jpg",
      "  lumbre render scene.json -o detail.png --crop 100,50,64,48 -s 1000",
      "  lumbre render *.glb -o pictures --format jpg",
      "  lumbre render *.glb --sheet sheet.png",
      "  lumbre render scene.json --timeout 5m",
      "  lumbre render scene.json --target-error 2%% --time 10m",
      "  lumbre render scene.json -s 4000 --checkpoint night.film"
    })
@Exits({
  ExitCode.OK, ExitCode.PARTIAL, ExitCode.WARNINGS, ExitCode.TARGET, ExitCode.SCENE, ExitCode.ASSET,
  ExitCode.LIMIT, ExitCode.LATE, ExitCode.OUTPUT, ExitCode.REJECTED, ExitCode.SAVED
})
final class RenderCommand extends Subcommand {
  private final Engine engine;

  @Mixin private final RenderOptions options = new RenderOptions();

  @Parameters(
      index = "1..*",
      paramLabel = "SCENE",
      description = "More scenes or models, rendered in turn with the same flags; -o is a folder.")
  private List<Path> others = new ArrayList<>();

  @Option(
      names = "--dry-run",
      description = "Print how much memory the render would need, and render nothing.")
  private boolean dryRun;

  /** Creates the command that renders in this process. */
  RenderCommand() {
    this(Engine.LOCAL);
  }

  RenderCommand(Engine engine) {
    this.engine = engine;
  }

  @Override
  ExitCode run() throws Exception {
    Instant start = options.budgets.start();
    Duration startup = Duration.between(start, Instant.now());
    Deadline deadline = options.run.deadline();
    List<Path> scenes = new ArrayList<>(List.of(options.scene.scene()));
    scenes.addAll(others);
    List<Path> targets = options.to.targets(scenes);
    options.validate(scenes);
    try (Interruption interruption = Interruption.listen()) {
      Invocation invocation =
          new Invocation(
              start, startup, deadline, interruption, scenes, drawn -> {}, Optional.empty());
      if (options.to.sheet().isPresent()) {
        return new RenderSheet(options, invocation, this::each).run();
      }
      if (!dryRun && (options.sequence.areGiven() || options.to.animation().isPresent())) {
        return new RenderSequence(options, engine, this::frame, invocation, targets.get(0)).run();
      }
      if (options.to.animation().isPresent()) {
        targets = List.of(JoinedFrames.picture(targets.get(0)));
      }
      try (Frames frames = new Frames(targets, interruption, deadline)) {
        return others.isEmpty()
            ? frame(invocation, frames, PictureExposure.ofEach())
            : batch(invocation, frames);
      }
    }
  }

  private ExitCode frame(Invocation invocation, Frames frames, PictureExposure exposing)
      throws Exception {
    JsonSummary report = new JsonSummary("render", options.scene.scene());
    Run border = options.run.border(invocation.interruption, Optional.of(frames));
    return border.of(report, () -> run(report, invocation, frames, exposing));
  }

  private ExitCode batch(Invocation invocation, Frames frames) throws Exception {
    ExitCode code = each(invocation, frames);
    if (!frames.haveEnded()) {
      options.run.summarize(
          frames.summary(), Duration.between(invocation.start(), Instant.now()));
    }
    return code;
  }

  /** Renders several scenes, and returns the highest of their exit codes. */
  private ExitCode each(Invocation invocation, Frames frames) throws Exception {
    RunFlags run = options.run;
    ExitCode code = ExitCode.OK;
    for (Path scene : invocation.scenes()) {
      options.scene.choose(scene);
      run.about(frames, scene);
      try {
        code = code.or(frame(invocation, frames, PictureExposure.ofEach()));
      } catch (Exception | Error e) {
        ExitCode failure = Failures.exitCode(e);
        if (!frames.areReserved() || frames.haveEnded() && failure.or(code) == failure) {
          throw e;
        }
        code = code.or(Failures.report(e, spec.commandLine(), run.errors()));
        if (frames.haveEnded()) {
          return code;
        }
        frames.fail(scene);
      }
    }
    return code;
  }

  /**
   * What the frames of the command share.
   *
   * @param startup time between the start and the first line of the command
   * @param receiver receives the pictures with their lines and labels
   * @param window the frames with which a frame is denoised; empty if it is denoised by itself
   */
  record Invocation(
      Instant start,
      Duration startup,
      Deadline deadline,
      Interruption interruption,
      List<Path> scenes,
      Consumer<DisplayLight> receiver,
      Optional<FrameWindow> window) {
    /** Returns the same for frames that are denoised with each other. */
    Invocation with(Optional<FrameWindow> frames) {
      return new Invocation(
          start, startup, deadline, interruption, scenes, receiver, frames);
    }
  }

  /** Renders one frame. */
  private ExitCode run(
      JsonSummary report, Invocation invocation, Frames frames, PictureExposure exposing)
      throws Exception {
    Optional<Denoising> denoising = options.denoising(frames.targets().get(0), engine);
    if (!frames.areReserved()) {
      options.reserve(invocation.scenes, frames);
    }
    Instant begin = frames.isSingle() ? invocation.start : Instant.now();
    Messages messages = options.run.errors();
    SceneOptions scene = options.scene;
    try (FilmKeeper keeper = options.checkpoints.newKeeper(options.checkpoint(), messages);
        RenderMonitor monitor = options.run.monitor(invocation.interruption, invocation.deadline)) {
      Optional<FrameWindow> window = invocation.window;
      Optional<SceneFile> known = window.flatMap(FrameWindow::file);
      SceneFile file;
      if (known.isPresent()) {
        file = known.get();
      } else {
        Interruption.Wait reading = monitor.reading(scene.scene());
        try (reading) {
          file = options.announced().load(options.parser(), messages);
        }
      }
      if (dryRun) {
        return isFilmless(file) ? vectorEstimate(file, report) : estimate(file, denoising, report);
      }
      boolean hasMemory = window.filter(FrameWindow::hasMemory).isPresent();
      if (!isFilmless(file) && !hasMemory) {
        MemoryCheck.require(estimate(file));
      }
      frames.requireFits(file.settings());
      // The first frame of several takes longest to read: all of them share that time.
      Instant from = frames.isFirst() && !frames.isSingle() ? Instant.now() : begin;
      if (window.isPresent()) {
        invocation.interruption.requireRender();
        if (!hasMemory) {
          window.get().require(estimate(file));
        }
        window
            .get()
            .render(
                new NextFrames(invocation, window.get().current(), file, from, monitor),
                new FrameWindow.Work(
                    scene.scene(),
                    engine,
                    denoising.orElseThrow(),
                    options.flags.samples().first(),
                    monitor,
                    messages));
      }
      Optional<RunBudget> spent = window.flatMap(FrameWindow::budget);
      RunBudget budget =
          spent.isPresent()
              ? spent.get()
              : budget(invocation, from, frames.left(), file.settings());
      RenderJob job =
          job(
              file,
              frames,
              keeper,
              monitor,
              budget,
              denoising,
              exposing,
              invocation.receiver,
              window,
              report);
      invocation.interruption.requireRender();
      ExitCode code =
          options.isDrawing()
              ? new DrawingJob(job).run()
              : job.run(options.flags.samples().first());
      if (!spec.commandLine().getParseResult().hasMatchedOption("--up")) {
        options.run.hint(() -> PictureHint.ofAxes(scene.scene(), file));
      }
      if (options.run.isJson()) {
        report.putPictures(Map.of(frames.picture().target(), file));
      }
      return code;
    }
  }

  /**
   * @param left number of frames that share the time, this one included
   */
  private RunBudget budget(
      Invocation invocation, Instant from, int left, RenderSettings settings) {
    return options.budgets.since(
        from,
        invocation.startup,
        options.budgets.share(invocation.start, from, left),
        settings,
        options.quality.targetError(),
        Budget.CONFIDENCE);
  }

  private static MemoryEstimate estimate(SceneFile file) {
    return MemoryEstimate.of(file.settings(), FilmLayers.of(file.settings(), file.scene()));
  }

  /** Reads the frames around the current one, which is read. */
  private final class NextFrames implements FrameWindow.Source {
    private final Invocation invocation;
    private final int current;
    private final SceneFile file;
    private final Instant begin;
    private final RenderMonitor monitor;

    NextFrames(
        Invocation invocation,
        int current,
        SceneFile file,
        Instant begin,
        RenderMonitor monitor) {
      this.invocation = invocation;
      this.current = current;
      this.file = file;
      this.begin = begin;
      this.monitor = monitor;
    }

    @Override
    public SceneFile read(int index) throws Exception {
      if (index == current) {
        return file;
      }
      options.scene.choose(index);
      try {
        return monitor.reading(
            options.scene.scene(),
            () -> options.announced().load(options.parser(), options.run.errors()));
      } finally {
        options.scene.choose(current);
      }
    }

    @Override
    public RunBudget budget(SceneFile frame, int left) {
      Instant from = frame == file ? begin : Instant.now();
      return RenderCommand.this.budget(invocation, from, left, frame.settings());
    }
  }

  private RenderJob job(
      SceneFile file,
      Frames frames,
      FilmKeeper keeper,
      RenderMonitor monitor,
      RunBudget budget,
      Optional<Denoising> denoising,
      PictureExposure exposing,
      Consumer<DisplayLight> receiver,
      Optional<FrameWindow> window,
      JsonSummary report)
      throws TaskException {
    Path scene = options.scene.scene();
    PictureOutput picture = frames.picture();
    keeper.begin(
        FilmHeader.identity(file.hash(), file.settings()),
        RecordedLayers.of(file.settings(), file.scene()),
        () ->
            FilmNotes.of(
                scene, file, picture.target(), options.bits(), options.scene.isLenient(), budget),
        RenderStatistics.ZERO,
        file.settings());
    file.parsed()
        .imported()
        .ifPresent(model -> keeper.identify(FilmHeader.CONVERTED_HASH, model.hash()));
    RenderJob.Options jobOptions =
        options
            .run
            .jobOptions(
                options.bits(),
                options.stored.jpegQuality(),
                options.scene.isStrict(),
                denoising,
                options.flags.layers(),
                exposing,
                receiver)
            .withDither(options.to.animation().isEmpty())
            .withWindow(window);
    Messages messages = options.run.errors();
    return new RenderJob(
        scene, file, picture, keeper, monitor, messages, report, budget, jobOptions, engine);
  }

  private ExitCode estimate(SceneFile file, Optional<Denoising> denoising, JsonSummary report)
      throws TaskException {
    MemoryEstimate estimate =
        MemoryEstimate.measured(file.settings(), FilmLayers.of(file.settings(), file.scene()));
    long denoise = denoising.isPresent() ? BuiltInDenoiser.bytes(estimate.pixels()) : 0;
    if (options.isDrawing()) {
      print(estimate, Set.of("samples", "copy"));
    } else if (!options.run.isJson()) {
      print(estimate, Set.of());
      String more = MemoryEstimate.mebibytes(denoise) + " more after the render";
      options.run.out().line("denoise  " + more);
    }
    report.put("denoise_bytes", denoise);
    if (options.sequence.areGiven() && denoising.filter(d -> d.program().isEmpty()).isPresent()) {
      boolean isClosed = options.sequence.motion().orElseThrow().turns() > 0;
      long frames = FrameWindow.bytes(estimate.pixels(), isClosed);
      report.put("window_bytes", frames);
      if (!options.run.isJson()) {
        String more = MemoryEstimate.mebibytes(frames);
        options.run.out().line("window   " + more + " more for frames that are denoised together");
      }
    }
    report.putScene(file);
    report.putEstimate(estimate);
    if (options.isDrawing()) {
      report.put("samples_per_pixel", 0);
    }
    MemoryCheck.require(estimate);
    return ExitCode.OK;
  }

  /** Prints the memory that a drawing as vectors needs; it has no film. */
  private ExitCode vectorEstimate(SceneFile file, JsonSummary report) {
    MemoryEstimate estimate = MemoryEstimate.measured(file.settings(), FilmLayers.NONE);
    print(estimate, Set.of("samples", "film", "threads", "needed", "copy"));
    report.putScene(file);
    report.put("samples_per_pixel", 0);
    report.put("pixels", estimate.pixels());
    report.put("scene_bytes", estimate.sceneBytes());
    report.put("max_heap_bytes", estimate.maxHeapBytes());
    return ExitCode.OK;
  }

  /** Prints an estimate without the lines that begin with some words. */
  private void print(MemoryEstimate estimate, Set<String> without) {
    if (!options.run.isJson()) {
      estimate.lines().stream()
          .filter(line -> !without.contains(line.substring(0, line.indexOf(' '))))
          .forEach(options.run.out()::line);
    }
  }

  /** Returns whether nothing is stored for each pixel: vectors of lines alone. */
  private boolean isFilmless(SceneFile file) throws TaskException {
    return options.to.isVector()
        && options.isDrawing()
        && !PictureDrawing.hasAreas(file.parsed());
  }
}
