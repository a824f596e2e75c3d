package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.lab.trade.ExactRow;
import io.github.lumbre.lab.trade.Knob;
import io.github.lumbre.lab.trade.TradeBudget;
import io.github.lumbre.lab.trade.TradeResult;
import io.github.lumbre.lab.trade.TradeTables;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code lumbre trade}: measures the time and error of each setting, for one scene. */
@Command(
    name = "trade",
    modelTransformer = SettingFlags.Adder.class,
    header = "Measure the time and error of render settings, for one scene.",
    description =
        "Render a reference, then vary one setting at a time (see --knobs) with several seeds and"
            + " increasing samples. Write a page of error against time, and the same data as .csv"
            + " and .json.",
    sortOptions = false,
    footer = {"", "Example:", "  lumbre trade scene.json --quick -o trade.html"})
@Exits(
    value = {
      ExitCode.OK, ExitCode.WARNINGS, ExitCode.DIFFERENT, ExitCode.SCENE, ExitCode.ASSET,
      ExitCode.LIMIT, ExitCode.OUTPUT, ExitCode.INTERRUPTED
    },
    different = "threads or buckets changed a picture")
final class TradeCommand extends Subcommand {
  @Mixin private final SceneOptions options = new SceneOptions();

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT.html",
      description =
          "Page to write. Default: the scene's name with -trade.html, in the working directory.")
  private Optional<Path> output = Optional.empty();

  @Option(
      names = "--quick",
      description = "Use small pictures and few seeds; takes about one minute.")
  private boolean quick;

  @Option(
      names = "--time",
      paramLabel = "DURATION",
      description = "Approximate time for the study (5m; with --quick 1m).")
  private Optional<Duration> time = Optional.empty();

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description = "Largest number of samples per pixel of a setting, instead of --time.")
  private Optional<Integer> samples = Optional.empty();

  @Option(
      names = "--reference",
      paramLabel = "N",
      description = "Samples per pixel of the reference (64 times the largest of a setting).")
  private Optional<Integer> reference = Optional.empty();

  @Option(
      names = "--knobs",
      paramLabel = "NAMES",
      description =
          "Settings to vary, separated by commas: sampler, lights, strategy, roulette, split,"
              + " depth, mode, filter, clamp, adaptive, denoise (all).")
  private Optional<String> knobs = Optional.empty();

  @Option(
      names = "--seeds",
      paramLabel = "N",
      description = "Renders of each setting, at least 3 (at least 3, as time allows).")
  private Optional<Integer> seeds = Optional.empty();

  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description =
          "Frame size in pixels, or its longer side (the scene's, scaled down to a side of 160;"
              + " with --quick 96).")
  private Optional<FrameSize> size = Optional.empty();

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Number of threads; 0: one per processor (0).")
  private int threads;

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run()
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    kernel.validate();
    checkFlags();
    Path page = output.orElseGet(() -> Path.of(baseName(options.scene()) + "-trade.html"));
    require(page.toString().endsWith(".html"), "-o: expected a name that ends in .html");
    options
        .guardedBy(overwrite.guard())
        .writes("-o", page, OutputContent.TRADE_PAGE)
        .writes("-o", beside(page, ".csv"), OutputContent.TRADE_CSV)
        .writes("-o", beside(page, ".json"), OutputContent.TRADE_JSON)
        .check();
    Messages messages = errors();
    try (TextOutput html = TextOutput.reserve(Optional.of(page));
        TextOutput csv = TextOutput.reserve(Optional.of(beside(page, ".csv")));
        TextOutput json = TextOutput.reserve(Optional.of(beside(page, ".json")))) {
      double wanted = time.orElse(Duration.ofMinutes(quick ? 1 : 5)).toMillis() * 1e-3;
      TradeBudget budget = new TradeBudget(wanted, samples, reference, seeds, size, quick);
      TradeRun run = new TradeRun(options, kernel, budget, threads, messages);
      TradeResult result = run.run(new Study().knobs());
      run.tellCommand(commandLine());
      html.write(run.page());
      csv.write(TradeTables.csv(result));
      json.write(TradeTables.json(run.facts(), result));
      out().line(page.toString());
      boolean same = result.exact().stream().allMatch(ExactRow::isSamePicture);
      return same ? ExitCode.OK : ExitCode.DIFFERENT;
    }
  }

  private void checkFlags() {
    seeds.ifPresent(n -> requireIn("--seeds", 3, 1000, n));
    size.ifPresent(checks()::requireSize);
    requireIn("--threads", 0, RenderSettings.MAX_THREADS, threads);
    samples.ifPresent(n -> requireIn("--samples", 1, TradeBudget.LARGEST, n));
    reference.ifPresent(n -> requireIn("--reference", 2, RenderSettings.MAX_SAMPLES, n));
  }

  /** What needs the classes of the lab. */
  private final class Study {
    private Set<Knob> knobs() {
      Map<String, Knob> known = new LinkedHashMap<>();
      EnumSet.allOf(Knob.class).forEach(knob -> known.put(SettingType.nameOf(knob), knob));
      if (knobs.isEmpty()) {
        return Set.copyOf(known.values());
      }
      List<String> wanted = List.of(knobs.get().split(",", -1));
      for (String name : wanted) {
        require(
            known.containsKey(name),
            "--knobs: expected some of " + String.join(",", known.keySet()) + ", found " + name);
      }
      return wanted.stream().map(known::get).collect(Collectors.toSet());
    }
  }

  /** Returns the command line that repeats this run, quoted for a shell. */
  private String commandLine() {
    return spec.commandLine().getParseResult().originalArgs().stream()
        .map(TradeCommand::quoted)
        .collect(Collectors.joining(" ", "lumbre ", ""));
  }

  /** Returns an argument, in quotes if a shell requires them. */
  private static String quoted(String argument) {
    String printable = Messages.printable(argument);
    return printable.matches("[\\w%+,./:=@-]+") ? printable : "'" + printable + "'";
  }

  private static String baseName(Path scene) {
    String picture = PictureOutput.defaultFor(scene, ImageFormat.PNG).toString();
    return picture.substring(0, picture.lastIndexOf('.'));
  }

  private static Path beside(Path page, String ending) {
    String name = page.toString();
    return Path.of(name.substring(0, name.length() - ".html".length()) + ending);
  }
}
