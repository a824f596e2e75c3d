package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.perf.PairedRenders;
import io.github.lumbre.lab.perf.PerfPlan;
import io.github.lumbre.lab.perf.PerfResult;
import io.github.lumbre.lab.perf.PerfRunner;
import io.github.lumbre.lab.perf.PerfTables;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scene.internal.Specialization;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre perf}: measures rendering speed. */
@Command(
    name = "perf",
    header = "Measure how fast scenes render.",
    description =
        "Print a table in Markdown: throughput, CPU time, allocated memory, warm-up and noise of"
            + " each scene with each number of threads.",
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre perf scenes/cornell-box.json",
      "  lumbre perf scenes/cornell-box.json scenes/torus-knot.json -s 4 --json speed.json",
      "  lumbre perf scenes/cornell-box.json --adaptive --paired -s 256 --repeat 16"
    })
@Exits({
  ExitCode.OK, ExitCode.ABSENT, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.OUTPUT,
  ExitCode.SAVED
})
final class PerfCommand extends Subcommand {
  private static final int DEFAULT_REPETITIONS = 5;
  private static final int MAX_REPETITIONS = 1000;

  @Parameters(paramLabel = "SCENE", arity = "1..*", description = "JSON scene files.")
  private List<Path> scenes = List.of();

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      defaultValue = "16",
      description = "Samples per pixel (${DEFAULT-VALUE}).")
  private int samples;

  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description =
          "Frame size in pixels, or its longer side (the scene's, scaled down to a side of 320).")
  private Optional<FrameSize> size;

  @Option(
      names = "--threads",
      paramLabel = "N",
      split = ",",
      description = "Numbers of threads, such as 1,2; 0: one per processor (1,0).")
  private List<Integer> threads = List.of(1, 0);

  @Option(
      names = "--warmup",
      paramLabel = "N",
      defaultValue = "10",
      description =
          "Render N times with 1 sample per pixel before the timed renders (${DEFAULT-VALUE}).")
  private int warmup;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      description =
          "Render N times and report the median (5). With --paired, at least 12 pairs (12).")
  private Optional<Integer> repeat = Optional.empty();

  @Option(
      names = "--pairs",
      paramLabel = "N",
      defaultValue = "2",
      description = "Pairs of seeds that the noise is measured from (${DEFAULT-VALUE}).")
  private int pairs;

  @Option(
      names = "--without",
      paramLabel = "NAME",
      split = ",",
      description = {
        "Switch specializations off: ${COMPLETION-CANDIDATES}.",
        "With --paired, print what they save."
      })
  private Set<Specialization> without = Set.of();

  @Option(
      names = "--adaptive",
      description = "Give noisy pixels more samples, as 'render --adaptive' does.")
  private boolean adaptive;

  @Option(
      names = "--split",
      paramLabel = "N",
      defaultValue = "1",
      description = "Split each path into N branches, as 'render --split' does (${DEFAULT-VALUE}).")
  private int split;

  @Option(
      names = "--paired",
      description =
          "Render each scene alternately without and with --without, --adaptive or --split, and"
              + " print the ratios of CPU time, memory and squared error.")
  private boolean paired;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "Write every repetition as JSON, for scripts.")
  private Optional<Path> json;

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run()
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    return new Measurements().run();
  }

  private int repeat() {
    return repeat.orElse(paired ? fewestRepetitions() : DEFAULT_REPETITIONS);
  }

  private int fewestRepetitions() {
    return paired ? PairedRenders.FEWEST_PAIRS : 1;
  }

  /** Requires distinct scene names, because results are identified by them. */
  private void requireDistinctFiles() {
    Set<String> names = new HashSet<>();
    for (Path scene : scenes) {
      require(Files.isRegularFile(scene), "scene does not exist: " + scene);
      String name = SceneFolder.name(scene);
      require(names.add(name), "expected scenes with different names, found two named " + name);
    }
  }

  /** What needs the classes of the lab. */
  private final class Measurements {
    ExitCode run()
        throws SceneFormatException, TaskException, IOException, InterruptedException {
      Messages out = out();
      PerfPlan plan = plan();
      requireDistinctFiles();
      OutputGuard guard = overwrite.guard();
      scenes.forEach(guard::readsScene);
      json.ifPresent(file -> guard.writes("--json", file, OutputContent.BENCH_JSON));
      guard.check();
      try (TextOutput output = TextOutput.reserve(json);
          Interruption interruption = Interruption.listen()) {
        LabHost host = new CommandLineHost(interruption, false, errors());
        if (!interruption.beginRender()) {
          return ExitCode.INTERRUPTED;
        }
        if (paired) {
          runPairs(new PairedRenders(plan, host), out);
        } else {
          run(new PerfRunner(plan, host), out, output);
        }
        return ExitCode.OK;
      }
    }

    private PerfPlan plan() {
      requireIn("--samples", 1, RenderSettings.MAX_SAMPLES, samples);
      size.ifPresent(checks()::requireSize);
      threads.forEach(n -> requireIn("--threads", 0, RenderSettings.MAX_THREADS, n));
      requireIn("--warmup", 0, MAX_REPETITIONS, warmup);
      require(!paired || json.isEmpty(), "--paired: cannot be combined with --json");
      requireIn("--repeat", fewestRepetitions(), MAX_REPETITIONS, repeat());
      requireIn("--pairs", 1, MAX_REPETITIONS, pairs);
      requireIn("--split", 1, RenderSettings.MAX_SPLIT, split);
      require(
          !paired || adaptive || split > 1 || !without.isEmpty(),
          "--paired: requires --without, --adaptive or --split");
      int processors = Runtime.getRuntime().availableProcessors();
      List<Integer> used = threads.stream().map(n -> n == 0 ? processors : n).distinct().toList();
      return new PerfPlan(size, samples, used, warmup, repeat(), pairs, without, adaptive, split);
    }

    /** Measures scenes with two settings and prints the ratios. */
    private void runPairs(PairedRenders bench, Messages out)
        throws SceneFormatException, TaskException, IOException, InterruptedException {
      bench.head().forEach(out::line);
      for (Path scene : scenes) {
        out.line(bench.line(scene));
      }
    }

    /** Measures the scenes and prints the results. */
    private void run(PerfRunner runner, Messages out, TextOutput output)
        throws SceneFormatException, TaskException, IOException, InterruptedException {
      PerfTables tables = new PerfTables(Machine.here(), runner.plan());
      List<PerfResult> results = new ArrayList<>();
      tables.head().forEach(out::line);
      try {
        for (Path scene : scenes) {
          List<PerfResult> measured = runner.run(scene);
          results.addAll(measured);
          measured.forEach(result -> out.line(tables.line(result)));
        }
      } finally {
        // Keep the finished measurements even if a later one fails.
        output.write(tables.json(results));
      }
    }
  }
}
