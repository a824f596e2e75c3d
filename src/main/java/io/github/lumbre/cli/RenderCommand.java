package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.cli.FlagConverters.ProgressStyle;
import io.github.lumbre.image.ImageFormat;
import io.github.lumbre.image.OutputFile;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * {@code lumbre render}: reads a scene, renders it and writes the picture.
 *
 * <p>What can be known to fail is tried first: flags, then the place of the picture, then the
 * scene, then memory.
 */
@Command(
    name = "render",
    header = "Render a scene to a picture.",
    description =
        "A flag wins over the scene. The picture is the same, bit for bit, on every machine and"
            + " with any number of threads.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre render scene.json",
      "  lumbre render scene.json -s 16 --size 480x270 --exposure auto",
      "  lumbre render scene.json -o picture.exr --mode ray --stats",
      "  lumbre render scene.json -o detail.png --crop 100,50,64,48 -s 1000",
      "  lumbre render scene.json --timeout 5m",
      "  lumbre render scene.json --target-error 2%% --time 10m",
      "  lumbre render scene.json -s 4000 --checkpoint night.film"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done, or stopped by --timeout with a partial picture",
      "1:There are warnings, and --strict makes them errors; or --target-error is not reached",
      "2:The command line is wrong",
      "3:The scene is missing, unreadable or invalid",
      "4:A mesh or picture of the scene cannot be decoded",
      "5:Something is larger than a limit or than memory",
      "6:The picture or the film cannot be written",
      "7:A fault of the program, or under --strict a sample that is not a number",
      "130, 143:Stopped by SIGINT (Ctrl-C), SIGTERM; a render begun saves what it has"
    })
final class RenderCommand implements Callable<Integer> {
  @Mixin private SceneOptions options;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      description = {
        "The picture: .png for the screen, .exr or .pfm for linear light.",
        "Default: the scene's name with .png, in the working directory."
      })
  private Optional<Path> output;

  @Mixin private RenderFlags flags;

  @Mixin private BudgetFlags budgets;

  @Mixin private KernelFlag kernel;

  @Option(
      names = "--bits",
      paramLabel = "8|16",
      defaultValue = "8",
      description = "Bits per channel of a PNG (${DEFAULT-VALUE}).")
  private int bits;

  @Option(
      names = "--timeout",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      description = {
        "Stop after such a time, reading the scene included: 90s, 5m, 2h.",
        "The picture is what was rendered until then, marked as partial."
      })
  private Optional<Duration> timeout;

  @Option(
      names = "--dry-run",
      description = "Tell what the render would take of memory, and render nothing.")
  private boolean dryRun;

  @Option(
      names = "--progress",
      paramLabel = "STYLE",
      converter = FlagConverters.OfProgressStyle.class,
      description = {
        "How to tell the progress on standard error: bar, none, or json, which is an object on a",
        "line of its own every second. Default: bar on a terminal, else none."
      })
  private Optional<ProgressStyle> progress;

  @Option(
      names = "--json",
      description = "Print a summary as a JSON object, on one line of standard output.")
  private boolean json;

  @Option(
      names = "--checkpoint",
      paramLabel = "FILM",
      description = {
        "Keep the samples in this file: 'lumbre resume' goes on from it, 'lumbre merge' joins",
        "several, 'lumbre develop' makes other pictures of it. It must not exist yet."
      })
  private Optional<Path> checkpoint;

  @Mixin private CheckpointFlags checkpoints;

  @Option(names = "--quiet", description = "No progress bar, no summary.")
  private boolean quiet;

  @Option(names = "--stats", description = "Tell rays, rates, threads and memory at the end.")
  private boolean stats;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, CommandException {
    JsonSummary report = new JsonSummary("render", options.scene());
    return json ? report.around(() -> run(report), out()) : run(report);
  }

  private Messages out() {
    return new Messages(spec.commandLine().getOut());
  }

  private int run(JsonSummary report) throws SceneFormatException, CommandException {
    flags.validate();
    budgets.validate();
    checkpoints.validate();
    kernel.apply();
    require(
        !budgets.isAdaptive() || checkpoint.isEmpty() && !flags.hasSampleRange(),
        "--adaptive: not with --checkpoint, --samples-from or --samples-to, since a film does not"
            + " tell which samples were to come next");
    require(
        !flags.isClamping() || checkpoint.isEmpty(),
        "--clamp: not with --checkpoint, since a film does not tell what its samples lost");
    require(bits == 8 || bits == 16, "--bits: expected 8 or 16, found " + bits);
    Deadline deadline = Deadline.after(timeout);
    Instant start = BudgetFlags.start();
    Duration startup = Duration.between(start, Instant.now());
    Path target = target();
    Messages messages = new Messages(spec.commandLine().getErr());
    try (PictureOutput picture = PictureOutput.reserve(target, checkpoints.fallback());
        FilmKeeper keeper = keeper(target, messages);
        Interruption interruption = Interruption.listen(picture::close, keeper::close)) {
      SceneFile file =
          options.load(
              flags.over(
                  options.parser(), budgets.areGiven(), budgets.isAdaptive(), budgets.depth()),
              messages);
      if (dryRun) {
        return estimate(file, report);
      }
      MemoryEstimate.require(file.settings());
      RenderMonitor monitor = new RenderMonitor(interruption, this::display, deadline, messages);
      RunBudget budget = budgets.since(start, startup, file.settings());
      return interruption.beginRender()
          ? ended(
              job(file, picture, keeper, monitor, budget, report).run(flags.firstSample()), report)
          : ExitCodes.INTERRUPTED;
    }
  }

  private FilmKeeper keeper(Path target, Messages messages) throws CommandException {
    if (checkpoint.isEmpty()) {
      return FilmKeeper.none(messages);
    }
    Path path = checkpoint.get();
    require(
        !PictureOutput.isSame(path, target) && !PictureOutput.isSame(path, options.scene()),
        "--checkpoint: " + path + " is the scene or the picture");
    for (Path existing : List.of(path, OutputFile.previous(path))) {
      if (Files.exists(existing)) {
        throw new CommandException(
            ExitCodes.OUTPUT,
            existing + ": exists already; 'lumbre resume " + path + "' goes on with it");
      }
    }
    return checkpoints.keeper(path, messages);
  }

  private RenderJob job(
      SceneFile file,
      PictureOutput picture,
      FilmKeeper keeper,
      RenderMonitor monitor,
      RunBudget budget,
      JsonSummary report) {
    Path scene = options.scene();
    keeper.begin(
        FilmHeader.identity(file.hash(), file.settings()),
        FilmNotes.of(scene, file, picture.target(), bits, options.isLenient()),
        file.settings());
    RenderJob.How how = new RenderJob.How(bits, quiet, stats, options.isStrict());
    Messages messages = new Messages(spec.commandLine().getErr());
    return new RenderJob(scene, file, picture, keeper, monitor, messages, report, budget, how);
  }

  private int estimate(SceneFile file, JsonSummary report) throws CommandException {
    MemoryEstimate estimate = MemoryEstimate.measured(file.settings());
    if (!json) {
      estimate.print(out());
    }
    report.putScene(file);
    report.putEstimate(estimate);
    estimate.require();
    return ended(ExitCodes.OK, report);
  }

  private int ended(int exitCode, JsonSummary report) {
    report.put("exit_code", exitCode);
    if (json) {
      report.print(out());
    }
    return exitCode;
  }

  private ProgressDisplay display(long totalSamples) {
    ProgressStyle style =
        progress.orElse(
            !quiet && Boolean.getBoolean("lumbre.tty") ? ProgressStyle.BAR : ProgressStyle.NONE);
    return switch (style) {
      case BAR -> ProgressDisplay.bar(totalSamples);
      case JSON -> new JsonProgress(totalSamples, new Messages(spec.commandLine().getErr()));
      case NONE -> ProgressDisplay.NONE;
    };
  }

  private Path target() {
    Path scene = options.scene();
    Path target = output.orElseGet(() -> PictureOutput.defaultFor(scene));
    require(
        ImageFormat.of(target).isPresent(),
        target + ": expected a name that ends in one of " + ImageFormat.endings());
    require(
        !PictureOutput.isSame(scene, target),
        target + ": is the scene itself, which is never overwritten");
    return target;
  }

  private void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }
}
