package io.github.lumbre.cli;

import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.FlagConverters;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.cli.run.CommandLineHost;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.perf.PairedLoads;
import io.github.lumbre.lab.perf.PairedRenders;
import io.github.lumbre.lab.perf.PerfComparison;
import io.github.lumbre.lab.perf.PerfComparison.Clock;
import io.github.lumbre.lab.perf.PerfJson;
import io.github.lumbre.lab.perf.PerfMachine;
import io.github.lumbre.lab.perf.PerfMarkdown;
import io.github.lumbre.lab.perf.PerfPlan;
import io.github.lumbre.lab.perf.PerfResult;
import io.github.lumbre.lab.perf.PerfRunner;
import io.github.lumbre.lab.perf.PerfTimes;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.Specialization;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code lumbre perf}: measures what scenes take, and compares two such measurements. */
@Command(
    name = "perf",
    header = "Measure how fast scenes render, or compare two measurements.",
    description =
        "Prints a table in Markdown: rates, CPU time, memory allocated, warm-up and noise of each"
            + " scene with each number of threads. With --compare, prints how two measurements"
            + " differ instead.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre perf scenes/cornell-box.json",
      "  lumbre perf scenes/cornell-box.json scenes/torus-knot.json -s 4 --json before.json",
      "  lumbre perf scenes/cornell-box.json --adaptive --paired -s 256 --repeat 16",
      "  lumbre perf --compare before.json after.json"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "1:Under --compare, a scene is slower or a picture differs",
      "2:The command line is wrong: also a scene or measurement that does not exist",
      "3, 4, 5:A scene is invalid, a mesh or picture of it is, or something is too large",
      "6:The JSON file cannot be written",
      "7:A fault of the program",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM; what is measured by then is"
          + " written"
    })
final class PerfCommand implements Callable<Integer> {
  private static final int DEFAULT_REPETITIONS = 5;
  private static final int MAX_REPETITIONS = 1000;

  @Parameters(paramLabel = "SCENE", arity = "0..*", description = "Scenes, JSON files.")
  private List<Path> scenes = List.of();

  @Option(
      names = "--compare",
      paramLabel = "FILE",
      arity = "2",
      description = "Tell whether the second file's measurement is faster than the first's.")
  private List<Path> compared = List.of();

  @Option(
      names = "--by",
      paramLabel = "CLOCK",
      converter = FlagConverters.OfClock.class,
      defaultValue = "cpu",
      description = "Compare by cpu time or by time on the wall (${DEFAULT-VALUE}).")
  private Clock clock;

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      defaultValue = "16",
      description = "Samples per pixel (${DEFAULT-VALUE}).")
  private int samples;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = FlagConverters.OfSize.class,
      description = "Size of the frame. Default: the scene's, shrunk to 320 pixels at most.")
  private Optional<Size> size;

  @Option(
      names = "--threads",
      paramLabel = "N",
      split = ",",
      description = "Numbers of threads, such as 1,2; 0 means one per processor (1,0).")
  private List<Integer> threads = List.of(1, 0);

  @Option(
      names = "--warmup",
      paramLabel = "N",
      defaultValue = "10",
      description = "Renders of one sample per pixel before the timed ones (${DEFAULT-VALUE}).")
  private int warmup;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      description =
          "Timed renders; the median counts (5). With --paired or --loading, how many pairs (12;"
              + " 6), which are the fewest.")
  private Optional<Integer> repeat = Optional.empty();

  @Option(
      names = "--pairs",
      paramLabel = "N",
      defaultValue = "2",
      description = "Pairs of seeds that tell the noise (${DEFAULT-VALUE}).")
  private int pairs;

  @Option(
      names = "--without",
      paramLabel = "SHORTCUT",
      split = ",",
      description = {
        "Do the work that a scene does not require: ${COMPLETION-CANDIDATES}.",
        "With --paired, tells what a shortcut saves."
      })
  private Set<Specialization> without = Set.of();

  @Option(
      names = "--adaptive",
      description = "Give more of the samples to noisy pixels, as 'render --adaptive' does.")
  private boolean adaptive;

  @Option(
      names = "--split",
      paramLabel = "N",
      defaultValue = "1",
      description = "Let paths go on in so many ways, as 'render --split' does.")
  private int split;

  @Option(
      names = "--paired",
      description =
          "Instead: render each scene in turn as it is and as --without, --adaptive or --split say,"
              + " so many times as --repeat says, and print the ratios of CPU time, memory and"
              + " squared error.")
  private boolean paired;

  @Option(
      names = "--loading",
      description =
          "Instead: read each scene in turn as it is and with meshes and textures decoded that"
              + " nothing uses, so many times as --repeat says, and print time and memory that"
              + " leaving them out saves.")
  private boolean loading;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "Write every repetition, for programs and for --compare.")
  private Optional<Path> json;

  @Option(names = "--debug", description = "Show the stack trace of an error.")
  private boolean debug;

  @Mixin private OverwriteFlag overwrite;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, TaskException {
    FlagChecks checks = new FlagChecks(spec);
    checks.require(
        scenes.isEmpty() != compared.isEmpty(), "expected scenes, or --compare and two files");
    Messages out = new Messages(spec.commandLine().getOut());
    if (!compared.isEmpty()) {
      PerfComparison comparison =
          PerfComparison.of(
              PerfTimes.load(compared.get(0)), PerfTimes.load(compared.get(1)), clock);
      comparison.lines().forEach(out::line);
      return comparison.isWorse() ? ExitCodes.DIFFERENT : ExitCodes.OK;
    }
    PerfPlan plan = plan(checks);
    requireDistinctFiles(checks);
    OutputGuard guard = overwrite.guard();
    scenes.forEach(guard::readsScene);
    json.ifPresent(file -> guard.writes("--json", file, OutputContent.BENCH_JSON));
    guard.check();
    if (loading) {
      return readPairs(out);
    }
    try (TextOutput output = TextOutput.reserve(json);
        Interruption interruption = Interruption.listen()) {
      LabHost host =
          new CommandLineHost(interruption, false, new Messages(spec.commandLine().getErr()));
      boolean complete =
          interruption.beginRender()
              && (paired
                  ? runPairs(new PairedRenders(plan, host), out)
                  : run(new PerfRunner(plan, host), plan, out, output));
      return complete ? ExitCodes.OK : ExitCodes.INTERRUPTED;
    }
  }

  private PerfPlan plan(FlagChecks checks) {
    checks.requireIn("--samples", 1, RenderSettings.MAX_SAMPLES, samples);
    size.ifPresent(s -> checks.requireIn("--size", 1, RenderSettings.MAX_SIDE, s.width()));
    size.ifPresent(s -> checks.requireIn("--size", 1, RenderSettings.MAX_SIDE, s.height()));
    threads.forEach(n -> checks.requireIn("--threads", 0, RenderSettings.MAX_THREADS, n));
    checks.requireIn("--warmup", 0, MAX_REPETITIONS, warmup);
    checks.require(!loading || !paired, "--loading: expected no --paired");
    checks.require(!paired || json.isEmpty(), "--paired: expected no --json");
    checks.require(!loading || json.isEmpty(), "--loading: expected no --json");
    checks.requireIn("--repeat", fewestRepetitions(), MAX_REPETITIONS, repeat());
    checks.requireIn("--pairs", 1, MAX_REPETITIONS, pairs);
    checks.requireIn("--split", 1, RenderSettings.MAX_SPLIT, split);
    checks.require(
        !paired || adaptive || split > 1 || !without.isEmpty(),
        "--paired: expected --without, --adaptive or --split");
    int processors = Runtime.getRuntime().availableProcessors();
    List<Integer> used = threads.stream().map(n -> n == 0 ? processors : n).distinct().toList();
    return new PerfPlan(size, samples, used, warmup, repeat(), pairs, without, adaptive, split);
  }

  private int repeat() {
    return repeat.orElse(paired || loading ? fewestRepetitions() : DEFAULT_REPETITIONS);
  }

  private int fewestRepetitions() {
    if (paired) {
      return PairedRenders.FEWEST_PAIRS;
    }
    return loading ? PairedLoads.FEWEST_PAIRS : 1;
  }

  /** Results bear their scene's name, so no two may have the same. */
  private void requireDistinctFiles(FlagChecks checks) {
    Set<String> names = new HashSet<>();
    for (Path scene : scenes) {
      checks.require(Files.isRegularFile(scene), "there is no scene " + scene);
      String name = SceneFolder.name(scene);
      checks.require(names.add(name), "expected scenes of different names, found two " + name);
    }
  }

  private int readPairs(Messages out) throws SceneFormatException, TaskException {
    Messages errors = new Messages(spec.commandLine().getErr());
    PairedLoads bench = new PairedLoads(repeat(), errors::warning);
    bench.head().forEach(out::line);
    for (Path scene : scenes) {
      out.line(bench.row(scene));
    }
    return ExitCodes.OK;
  }

  /** Measures scenes in two ways and prints the ratios; returns false if that was stopped. */
  private boolean runPairs(PairedRenders bench, Messages out)
      throws SceneFormatException, TaskException {
    bench.head().forEach(out::line);
    try {
      for (Path scene : scenes) {
        Optional<String> row = bench.row(scene);
        if (row.isEmpty()) {
          return false;
        }
        out.line(row.get());
      }
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Measures and prints the scenes; returns false if that was stopped. */
  private boolean run(PerfRunner runner, PerfPlan plan, Messages out, TextOutput output)
      throws SceneFormatException, TaskException {
    PerfMachine machine = PerfMachine.here();
    PerfMarkdown table = new PerfMarkdown(machine, plan);
    List<PerfResult> results = new ArrayList<>();
    table.head().forEach(out::line);
    try {
      for (Path scene : scenes) {
        Optional<List<PerfResult>> measured = runner.run(scene);
        if (measured.isEmpty()) {
          return false;
        }
        results.addAll(measured.get());
        measured.get().forEach(result -> out.line(table.row(result)));
      }
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } finally {
      // Keep what is known already, however the others ended.
      output.write(PerfJson.text(machine, plan, results));
    }
  }
}
