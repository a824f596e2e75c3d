package io.github.lumbre.cli;

import com.sun.management.OperatingSystemMXBean;
import io.github.lumbre.cli.FlagConverters.Size;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.measure.ExactRow;
import io.github.lumbre.measure.TradePage;
import io.github.lumbre.measure.TradeResult;
import io.github.lumbre.measure.TradeSetting;
import io.github.lumbre.measure.TradeStudy;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code lumbre trade}: measures what each setting costs and how wrong it is, for one scene. */
@Command(
    name = "trade",
    header = "Measure what settings cost and how wrong they are, for one scene.",
    description =
        "Renders a reference of its own, then each depth and mode with several seeds at 1, 4, 16,"
            + " ... samples, and writes a page that shows error against time; beside it, the same"
            + " name with .csv and .json.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    footer = {"", "Example:", "  lumbre trade scene.json --quick -o trade.html"},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "1:There are warnings under --strict; or threads or buckets have changed a picture",
      "2:The command line is wrong",
      "3:The scene is missing, unreadable or invalid",
      "4:A mesh or picture of the scene cannot be decoded",
      "5:Something is larger than a limit or than memory",
      "6:The page cannot be written",
      "7:A fault of the program",
      "130, 143:Stopped by SIGINT (Ctrl-C), SIGTERM"
    })
final class TradeCommand implements Callable<Integer> {
  private static final int[] DEPTHS = {1, 2, 3, 5, 8, 16};

  /** Roulette ends paths long before. */
  private static final int DEEP = 1000;

  /** The most samples per pixel of a setting, and how many times as many the reference has. */
  private static final int LARGEST = 1 << 20;

  private static final int REFERENCE_FACTOR = 64;
  private static final int PAGE_SIDE = 160;
  private static final int QUICK_SIDE = 96;
  private static final double PILOT_SECONDS = .3;
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  @Mixin private SceneOptions options;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT.html",
      description =
          "The page. Default: the scene's name with -trade.html, in the working directory.")
  private Optional<Path> output = Optional.empty();

  @Option(names = "--quick", description = "About a minute: small pictures, 4 seeds.")
  private boolean quick;

  @Option(
      names = "--time",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      description = "About how long to take (5m; with --quick 1m).")
  private Optional<Duration> time = Optional.empty();

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description = "Instead of a time: the most samples per pixel of a setting (a power of four).")
  private Optional<Integer> samples = Optional.empty();

  @Option(
      names = "--row",
      description = "Print a row of the table in docs/trade.md instead of the page's name.")
  private boolean row;

  @Option(
      names = "--seeds",
      paramLabel = "N",
      description = "Renders of each setting, at least 3 (16; with --quick 4).")
  private Optional<Integer> seeds = Optional.empty();

  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = FlagConverters.OfSize.class,
      description = "Size in pixels (the scene's, shrunk to a side of 160; with --quick 96).")
  private Optional<Size> size = Optional.empty();

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Threads; 0 means one per processor (0).")
  private int threads;

  @Mixin private KernelFlag kernel;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, CommandException {
    kernel.apply();
    require(seeds.orElse(4) >= 3 && seeds.orElse(4) <= 1000, "--seeds: expected 3 to 1000");
    require(threads >= 0 && threads <= RenderSettings.MAX_THREADS, "--threads: expected 0 to 1024");
    int most = samples.orElse(1);
    require(
        most >= 1 && most <= LARGEST && 1 << 2 * log4(most) == most,
        "--samples: expected a power of four up to " + LARGEST + ", found " + most);
    Path page = output.orElseGet(() -> Path.of(baseName(options.scene()) + "-trade.html"));
    require(page.toString().endsWith(".html"), "-o: expected a name that ends in .html");
    Messages messages = new Messages(spec.commandLine().getErr());
    try (TextOutput html = TextOutput.reserve(Optional.of(page));
        TextOutput csv = TextOutput.reserve(Optional.of(beside(page, ".csv")));
        TextOutput json = TextOutput.reserve(Optional.of(beside(page, ".json")))) {
      SceneFile path = options.load(options.parser().inMode(Mode.PATH), messages);
      SceneFile ray = options.load(options.parser().inMode(Mode.RAY), new Messages(quiet()));
      List<TradeSetting> settings = settings(path, ray);
      TradeSetting deep = settings.get(0);
      TradeStudy.Plan plan = plan(path, deep.settings(), settings.size());
      long start = System.nanoTime();
      TradeResult result =
          new TradeStudy(deep, settings, plan, TradeCommand::cpuSeconds, messages::line).run();
      double seconds = (System.nanoTime() - start) * 1e-9;
      Map<String, String> facts = facts(path, deep.settings(), plan, seconds);
      html.write(html(path, facts, result));
      csv.write(TradeTables.csv(result));
      json.write(TradeTables.json(facts, result));
      new Messages(spec.commandLine().getOut())
          .line(row ? TradeTables.markdown(facts.get("scene"), result) : page.toString());
      boolean same = result.exact().stream().allMatch(ExactRow::isSamePicture);
      return same ? ExitCodes.OK : ExitCodes.DIFFERENT;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCodes.INTERRUPTED;
    }
  }

  private static PrintWriter quiet() {
    return new PrintWriter(Writer.nullWriter());
  }

  private void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  private static String baseName(Path scene) {
    String picture = PictureOutput.defaultFor(scene).toString();
    return picture.substring(0, picture.lastIndexOf('.'));
  }

  private static Path beside(Path page, String ending) {
    String name = page.toString();
    return Path.of(name.substring(0, name.length() - ".html".length()) + ending);
  }

  private static int log4(int value) {
    return (Integer.SIZE - 1 - Integer.numberOfLeadingZeros(Math.max(1, value))) / 2;
  }

  private static double cpuSeconds() {
    return PROCESS.getProcessCpuTime() * 1e-9;
  }

  /** Returns what is measured, the truth first. */
  private List<TradeSetting> settings(SceneFile path, SceneFile ray) {
    List<TradeSetting> settings = new ArrayList<>();
    RenderSettings base = framed(path.settings());
    settings.add(
        new TradeSetting(
            "depth",
            String.valueOf(DEEP),
            true,
            path.scene(),
            base.toBuilder().maxTraceDepth(DEEP).build()));
    for (int depth : DEPTHS) {
      RenderSettings shallow = base.toBuilder().maxTraceDepth(depth).build();
      settings.add(new TradeSetting("depth", String.valueOf(depth), false, path.scene(), shallow));
    }
    settings.add(new TradeSetting("mode", "ray", false, ray.scene(), framed(ray.settings())));
    return settings;
  }

  private RenderSettings framed(RenderSettings settings) {
    RenderSettings own = settings.toBuilder().threads(threads).build();
    return size.map(s -> own.toBuilder().size(s.width(), s.height()).build())
        .orElseGet(() -> SampleBudget.shrunk(own, quick ? QUICK_SIDE : PAGE_SIDE));
  }

  /** Returns as much work as fits into the time, by a short pilot. */
  private TradeStudy.Plan plan(SceneFile file, RenderSettings settings, int count)
      throws InterruptedException {
    int each = seeds.orElse(quick ? 4 : 16);
    if (samples.isPresent()) {
      return plan(each, samples.get());
    }
    OptionalDouble rate = SampleBudget.rate(file, PILOT_SECONDS, Progress.NONE);
    double wanted = time.orElse(Duration.ofMinutes(quick ? 1 : 5)).toMillis() * 1e-3;
    double affordable = rate.orElse(1) * wanted / ((double) settings.width() * settings.height());
    TradeStudy.Plan plan = plan(each, 4);
    for (int most = 16; most <= LARGEST; most *= 4) {
      TradeStudy.Plan larger = plan(each, most);
      if (larger.samples(count) > affordable) {
        break;
      }
      plan = larger;
    }
    return plan;
  }

  private static TradeStudy.Plan plan(int seeds, int most) {
    List<Integer> ladder = new ArrayList<>();
    for (int samples = 1; samples <= most; samples *= 4) {
      ladder.add(samples);
    }
    return new TradeStudy.Plan(ladder, seeds, REFERENCE_FACTOR * most);
  }

  private Map<String, String> facts(
      SceneFile file, RenderSettings settings, TradeStudy.Plan plan, double seconds) {
    Hardware hardware = Hardware.here();
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("scene", Messages.printable(String.valueOf(options.scene().getFileName())));
    facts.put("scene hash", file.hash());
    facts.put("size", settings.width() + "x" + settings.height());
    facts.put("seeds", plan.seeds() + " for each setting, numbered from 1");
    facts.put("machine", hardware.line());
    facts.put("threads", threads == 0 ? "one per processor" : String.valueOf(threads));
    facts.put("load", BenchMachine.here().load() + " before the report");
    facts.put("version", Version.number());
    facts.put("took", Math.round(seconds) + " s");
    return facts;
  }

  private static String html(SceneFile file, Map<String, String> facts, TradeResult result)
      throws CommandException {
    ImageWriter.Options visible =
        new ImageWriter.Options(
            file.settings().exposure(), file.settings().toneCurve(), 8, Map.of());
    try {
      return TradePage.of("Speed for accuracy: " + facts.get("scene"), facts, result, visible);
    } catch (IOException e) {
      throw new CommandException(ExitCodes.OUTPUT, e.getMessage(), e);
    }
  }
}
