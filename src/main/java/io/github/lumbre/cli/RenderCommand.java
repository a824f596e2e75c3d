package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.checkpoint.RecordedLayers;
import io.github.lumbre.cli.option.BudgetFlags;
import io.github.lumbre.cli.option.CheckpointFlags;
import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.PictureFlags;
import io.github.lumbre.cli.option.QualityFlags;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.RunFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.option.TargetFlags;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.StandardOutput;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.denoise.BuiltInDenoiser;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.lab.MemoryCheck;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.parser.internal.ParsedScene;
import io.github.lumbre.parser.internal.PartTable;
import io.github.lumbre.parser.internal.ViewNumbers;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.stopping.Budget;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

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
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
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
      "  lumbre render scene.json --timeout 5m",
      "  lumbre render scene.json --target-error 2%% --time 10m",
      "  lumbre render scene.json -s 4000 --checkpoint night.film"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done, or stopped by --timeout with a partial picture",
      "1:There are warnings under --strict, or --target-error is not reached",
      "2:The command line is invalid",
      "3:The scene is missing, unreadable or invalid",
      "4:A mesh or image of the scene cannot be decoded",
      "5:A limit or the memory is exceeded, or --timeout ended before a picture was begun",
      "6:The picture or the checkpoint file cannot be written",
      "7:Internal error, or rejected samples under --strict",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM; a started render is saved"
    })
final class RenderCommand implements Callable<Integer> {
  private final Engine engine;

  @Mixin private final SceneOptions options = new SceneOptions();

  @Parameters(
      index = "1..*",
      paramLabel = "SCENE",
      description = "More scenes or models, rendered in turn with the same flags; -o is a folder.")
  private List<Path> others = new ArrayList<>();

  @Mixin private final TargetFlags to = new TargetFlags();

  @Mixin private final RenderFlags flags = new RenderFlags();

  @Mixin private final BudgetFlags budgets = new BudgetFlags();

  @Mixin private final QualityFlags quality = new QualityFlags();

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @Mixin private final PictureFlags stored = new PictureFlags();

  @Mixin private final RunFlags run = new RunFlags();

  @Option(
      names = "--dry-run",
      description = "Print how much memory the render would need, and render nothing.")
  private boolean dryRun;

  @Option(
      names = "--checkpoint",
      paramLabel = "FILM",
      description =
          "Save the samples to this new checkpoint file, for 'lumbre resume', 'lumbre merge' and"
              + " 'lumbre develop'.")
  private Optional<Path> checkpoint;

  @Mixin private final CheckpointFlags checkpoints = new CheckpointFlags();

  @Option(
      names = "--turntable",
      paramLabel = "N",
      description =
          "Write N pictures of a model from around it, numbered from 000: OUT with -000 before its"
              + " ending.")
  private Optional<Integer> turntable;

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Spec private CommandSpec spec;

  /** Creates the command that renders in this process. */
  RenderCommand() {
    this(Engine.LOCAL);
  }

  RenderCommand(Engine engine) {
    this.engine = engine;
  }

  @Override
  public Integer call() throws SceneFormatException, TaskException {
    Instant start = budgets.start();
    Duration startup = Duration.between(start, Instant.now());
    Deadline deadline = run.deadline();
    List<Path> scenes = new ArrayList<>(List.of(options.scene()));
    scenes.addAll(others);
    List<Path> targets = targets(scenes);
    int code = ExitCodes.OK;
    try (Interruption interruption = Interruption.listen();
        Frames frames = new Frames(targets, interruption, deadline)) {
      Course course = new Course(start, startup, deadline, interruption, scenes, frames);
      if (!others.isEmpty()) {
        return batch(course);
      }
      int count = dryRun ? 1 : targets.size();
      for (int i = 0; i < count && code <= ExitCodes.WARNINGS; i++) {
        if (turntable.isPresent()) {
          options.turn(360. * i / turntable.get());
        }
        code = Math.max(code, frame(course));
      }
    }
    return code;
  }

  private int frame(Course course) throws SceneFormatException, TaskException {
    JsonSummary report = new JsonSummary("render", options.scene());
    return run.summarized(report, () -> course.frames.render(report, () -> run(report, course)));
  }

  /** Renders several scenes, and returns the highest of their exit codes. */
  private int batch(Course course) throws SceneFormatException, TaskException {
    Frames frames = course.frames;
    int code = ExitCodes.OK;
    for (Path scene : course.scenes) {
      options.choose(scene);
      run.about(frames, scene);
      try {
        code = Math.max(code, frame(course));
      } catch (SceneFormatException | TaskException | RuntimeException | Error e) {
        if (!frames.areReserved() || frames.haveEnded() && code <= Failures.exitCode(e)) {
          throw e;
        }
        code = Math.max(code, Failures.report(e, spec.commandLine(), run.errors()));
        if (frames.haveEnded()) {
          return code;
        }
        frames.fail(scene);
      }
    }
    run.summarize(frames.summary(), Duration.between(course.start, Instant.now()));
    return code;
  }

  /**
   * What the frames of the command share.
   *
   * @param startup time between the start and the first line of the command
   */
  private record Course(
      Instant start,
      Duration startup,
      Deadline deadline,
      Interruption interruption,
      List<Path> scenes,
      Frames frames) {}

  /** Returns the paths of all pictures. */
  private List<Path> targets(List<Path> scenes) throws TaskException {
    List<Path> targets = to.targets(scenes);
    if (turntable.isEmpty()) {
      return targets;
    }
    int count = turntable.get();
    new FlagChecks(spec).requireIn("--turntable", 1, 10_000, count);
    require(
        options.isModel() && checkpoint.isEmpty() && !to.isStandardOutput(),
        "--turntable: requires a model file, and cannot be combined with --checkpoint or -o -");
    return Frames.numbered(targets.get(0), count);
  }

  /** Renders one frame. */
  private int run(JsonSummary report, Course course) throws SceneFormatException, TaskException {
    Frames frames = course.frames;
    if (!frames.areReserved()) {
      validate();
      requireStreams();
    }
    Optional<Denoising> denoising = denoising(frames.targets().get(0));
    boolean isUsual = denoising.isPresent() && options.isModel() && !quality.isAdaptive();
    flags.recordForDenoising(
        denoising.isPresent(),
        isUsual ? OptionalInt.of(Denoising.MODEL_SAMPLES) : OptionalInt.empty());
    if (!frames.areReserved()) {
      reserve(course.scenes, frames);
    }
    Instant begin = frames.isSingle() ? course.start : Instant.now();
    Messages messages = run.errors();
    try (FilmKeeper keeper = checkpoints.newKeeper(checkpoint, messages);
        RenderMonitor monitor = run.monitor(course.interruption, course.deadline)) {
      SceneFile file = monitor.reading(options.scene(), () -> options.load(parser(), messages));
      if (dryRun) {
        return estimate(file, denoising, report);
      }
      MemoryCheck.require(file.settings(), FilmLayers.of(file.settings(), file.scene()));
      frames.picture().requireFits(file.settings());
      // The first frame of several takes longest to read: all of them share that time.
      Instant from = frames.isFirst() && !frames.isSingle() ? Instant.now() : begin;
      RunBudget budget =
          budgets.since(
              from,
              course.startup,
              budgets.share(course.start, from, frames.left()),
              file.settings(),
              quality.targetError(),
              Budget.CONFIDENCE);
      RenderJob job = job(file, frames, keeper, monitor, budget, denoising, report);
      course.interruption.requireRender();
      int code = job.run(flags.samples().first());
      if (run.isJson()) {
        report(file, frames.picture().target(), report);
      }
      return code;
    }
  }

  /** Adds what the picture of a model shows. */
  private static void report(SceneFile file, Path picture, JsonSummary report) {
    ParsedScene parsed = ParsedScene.of(file);
    if (parsed.model().isPresent()) {
      PartTable parts = parsed.model().get().parts(parsed.scene());
      report.putContents(parsed.contents());
      report.putModel(parsed.model().get(), parts);
      ViewNumbers numbers = ViewNumbers.of(parsed.scene(), parsed.settings(), parts);
      report.putView("file", picture, parsed.settings(), numbers, parts);
    }
  }

  /** Checks all flags before anything is read. */
  private void validate() {
    flags.validate();
    budgets.validate();
    checkpoints.validate();
    kernel.validate();
    require(
        !quality.isAdaptive() || checkpoint.isEmpty() && !flags.samples().haveRange(),
        "--adaptive: cannot be combined with --checkpoint, --samples-from or --samples-to, because"
            + " a checkpoint file does not record which samples come next");
    require(
        !flags.samples().haveShare() || checkpoint.isPresent(),
        "--share: requires --checkpoint, whose files 'lumbre merge' joins");
    require(
        !flags.samples().haveShare() || !budgets.areGiven() && quality.targetError().isEmpty(),
        "--share: cannot be combined with --time, --target-error or --quality, because the shares"
            + " would end at different samples");
    require(
        !flags.isClamping() || checkpoint.isEmpty(),
        "--clamp: cannot be combined with --checkpoint, because a checkpoint file does not record"
            + " the clamped energy");
    require(
        checkpoint.isEmpty() || !spec.commandLine().getParseResult().hasMatchedOption("--labels"),
        "--labels: cannot be combined with --checkpoint, because a checkpoint file does not record"
            + " the labels");
    stored.validate();
  }

  /** Checks and reserves the files of all pictures. */
  private void reserve(List<Path> scenes, Frames frames) throws TaskException {
    Path target = frames.targets().get(0);
    require(
        flags.layers().isEmpty()
            || checkpoint.isPresent()
            || format(target).equals(Optional.of(ImageFormat.EXR)),
        "--layers: expected an .exr picture (-o) or --checkpoint, which hold layers, found "
            + target);
    checkOutputs(scenes, frames.targets());
    if (to.isStandardOutput()) {
      frames.reserve(PictureOutput.toStandardOutput(to.format(), checkpoints.fallback()));
    } else {
      frames.reserve(checkpoints.fallback());
    }
  }

  /**
   * Returns the denoiser of the scene's picture; empty if the picture keeps its noise. With a
   * checkpoint file it has the noise of the picture that {@code resume} writes.
   *
   * @throws TaskException if the denoiser's program is not found
   */
  private Optional<Denoising> denoising(Path target) throws TaskException {
    return stored
        .denoising()
        .denoising(
            options.isModel()
                && format(target).filter(ImageFormat::isForScreen).isPresent()
                && !flags.isRayMode()
                && checkpoint.isEmpty()
                && engine == Engine.LOCAL);
  }

  private SceneParser parser() {
    boolean isOpen = budgets.areGiven() || quality.targetError().isPresent();
    SceneParser parser = kernel.over(options.parser(), budgets.time());
    return flags.over(parser, isOpen, quality.isAdaptive(), quality.depth());
  }

  private RenderJob job(
      SceneFile file,
      Frames frames,
      FilmKeeper keeper,
      RenderMonitor monitor,
      RunBudget budget,
      Optional<Denoising> denoising,
      JsonSummary report) {
    Path scene = options.scene();
    PictureOutput picture = frames.picture();
    keeper.begin(
        FilmHeader.identity(file.hash(), file.settings()),
        RecordedLayers.of(file.settings(), file.scene()),
        FilmNotes.of(scene, file, picture.target(), bits(), options.isLenient(), budget),
        RenderStatistics.ZERO,
        file.settings());
    RenderJob.How how =
        run.how(bits(), stored.jpegQuality(), options.isStrict(), denoising, flags.layers());
    return new RenderJob(
        scene, file, picture, keeper, monitor, run.errors(), report, budget, how, engine);
  }

  private int bits() {
    return stored.bits().orElse(ImageWriter.Options.DEFAULT.pngBits());
  }

  private int estimate(SceneFile file, Optional<Denoising> denoising, JsonSummary report)
      throws TaskException {
    MemoryEstimate estimate =
        MemoryEstimate.measured(file.settings(), FilmLayers.of(file.settings(), file.scene()));
    long denoise = denoising.isPresent() ? BuiltInDenoiser.bytes(estimate.pixels()) : 0;
    if (!run.isJson()) {
      estimate.lines().forEach(run.out()::line);
      run.out().line("denoise  " + MemoryEstimate.mebibytes(denoise) + " more after the render");
    }
    report.put("denoise_bytes", denoise);
    report.putScene(file);
    report.putEstimate(estimate);
    MemoryCheck.require(estimate);
    return ExitCodes.OK;
  }

  private Optional<ImageFormat> format(Path target) {
    return to.isStandardOutput() ? Optional.of(to.format()) : ImageFormat.of(target);
  }

  /** Rejects flags that cannot be combined with standard input or output. */
  private void requireStreams() {
    require(
        checkpoint.isEmpty() || !options.isStandardInput() && !to.isStandardOutput(),
        "--checkpoint: expected files for the scene and the picture, found -; 'lumbre resume' needs"
            + " both files");
    require(!to.isStandardOutput() || !run.isJson(), "-o -: cannot be combined with --json");
    require(
        !to.isStandardOutput() || !StandardOutput.isTerminal(),
        "-o -: standard output is a terminal; expected a file or a pipe");
  }

  private void checkOutputs(List<Path> scenes, List<Path> targets) throws TaskException {
    OutputGuard guard = overwrite.guard();
    if (scenes.size() > 1) {
      options.guardAll(scenes, guard);
    } else {
      options.guardedBy(guard);
    }
    if (!to.isStandardOutput()) {
      targets.forEach(target -> guard.writes("-o", target, OutputContent.PICTURE));
    }
    // An existing checkpoint file is rejected later, with the advice to resume it.
    checkpoint.ifPresent(film -> guard.updatesFilm("--checkpoint", film));
    guard.check();
  }

  private void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }
}
