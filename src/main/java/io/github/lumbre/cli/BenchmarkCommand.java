package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.report.BenchmarkPlan;
import io.github.lumbre.lab.report.BenchmarkResult;
import io.github.lumbre.lab.report.BenchmarkRunner;
import io.github.lumbre.lab.report.BenchmarkTables;
import io.github.lumbre.lab.report.ReportRow;
import io.github.lumbre.lab.report.ReportTable;
import io.github.lumbre.lab.report.TableHashes;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/**
 * {@code lumbre benchmark}: renders the scenes of the 2016 report's table and prints both sets of
 * times.
 */
@Command(
    name = "benchmark",
    header = "Render the scenes of the 2016 report and print their times.",
    description =
        "Print the table in Markdown, each row as soon as it is rendered. A row's size, mode,"
            + " samples, bucket and depth override its scene's.",
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre benchmark",
      "  lumbre benchmark --rows 1,5,14 --scale 0.001 --repeat 3",
      "  lumbre benchmark --full --csv table.csv",
      "  lumbre benchmark --check"
    })
@Exits(
    value = {
      ExitCode.OK, ExitCode.DIFFERENT, ExitCode.ABSENT, ExitCode.SCENE, ExitCode.ASSET,
      ExitCode.LIMIT, ExitCode.OUTPUT, ExitCode.SAVED
    },
    different = "under --check, a picture's hash differs from the stored one or is not stored")
final class BenchmarkCommand extends Subcommand {
  private static final int MAX_REPETITIONS = 1000;

  @Option(
      names = "--rows",
      paramLabel = "N",
      split = ",",
      description = "Render these rows of the table, such as 1,5,14 (all).")
  private List<Integer> rows = List.of();

  @ArgGroup private Amount amount = new Amount();

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Number of threads; 0: one per processor (${DEFAULT-VALUE}).")
  private int threads;

  @Option(
      names = "--warmup",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Render each row N times with 1 sample per pixel before the timed renders"
              + " (${DEFAULT-VALUE}).")
  private int warmup;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      defaultValue = "1",
      description = "Render each row N times and report the median time (${DEFAULT-VALUE}).")
  private int repeat;

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Also write the table as comma-separated values.")
  private Optional<Path> csv;

  @Option(
      names = "--scenes",
      paramLabel = "DIR",
      description = {
        "Folder of the scenes, " + ReportTable.FILE + " and " + TableHashes.FILE + ".",
        "Default: scenes, beside the launcher."
      })
  private Optional<Path> scenes;

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @ArgGroup private Hashes hashes = new Hashes();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  /** The share of the samples to render; at most one of the two flags. */
  static final class Amount {
    @Option(
        names = "--scale",
        paramLabel = "SHARE",
        description = "Render this share of each row's samples, rounded up (0.01).")
    private BigDecimal scale = new BigDecimal("0.01");

    @Option(names = "--full", description = "Render all samples; this takes days.")
    private boolean full;
  }

  /** The use of the pictures' hashes; at most one of the two flags. */
  static final class Hashes {
    @Option(
        names = "--check",
        description = "Compare the pictures' hashes with those in the folder of scenes.")
    private boolean check;

    @Option(names = "--store", description = "Store the pictures' hashes in the folder of scenes.")
    private boolean store;
  }

  @Override
  ExitCode run() throws SceneFormatException, TaskException, IOException {
    return new Table().run();
  }

  /** Returns the path of a file beside the launcher; without one, in the working directory. */
  private static Path beside(String name) {
    return Path.of(System.getProperty("lumbre.home", "")).resolve(name);
  }

  /** What needs the classes of the lab. */
  private final class Table {
    ExitCode run() throws SceneFormatException, TaskException, IOException {
      BenchmarkPlan plan = plan();
      kernel.validate();
      SceneFolder folder = new SceneFolder(scenes.orElseGet(() -> beside("scenes")));
      List<ReportRow> selected = selected(folder);
      checkOutputs(folder, selected);
      TableHashes stored = TableHashes.load(folder.directory());
      Messages out = out();
      List<BenchmarkResult> results = new ArrayList<>();
      try (Interruption interruption = Interruption.listen()) {
        boolean hasDisplay = Boolean.getBoolean("lumbre.tty");
        BenchmarkRunner runner =
            new BenchmarkRunner(
                folder,
                plan,
                kernel.over(new SceneParser()),
                new CommandLineHost(interruption, hasDisplay, errors()));
        boolean complete = interruption.beginRender() && run(selected, runner, results, out);
        ExitCode verdict = settle(stored, results);
        return complete ? verdict : ExitCode.INTERRUPTED;
      }
    }

    private void checkOutputs(SceneFolder folder, List<ReportRow> selected) throws TaskException {
      OutputGuard guard =
          overwrite.guard().reads(folder.directory().resolve(ReportTable.FILE), "the table");
      for (ReportRow row : selected) {
        guard.readsScene(folder.file(row.scene()));
      }
      Path stored = folder.directory().resolve(TableHashes.FILE);
      if (hashes.store) {
        guard.writes("--scenes", stored, OutputContent.HASHES);
      } else {
        guard.reads(stored, "the file of hashes");
      }
      csv.ifPresent(file -> guard.writes("--csv", file, OutputContent.BENCHMARK_CSV));
      guard.check();
    }

    private BenchmarkPlan plan() {
      BigDecimal share = amount.full ? BigDecimal.ONE : amount.scale;
      require(
          share.signum() > 0 && share.compareTo(BigDecimal.ONE) <= 0,
          "--scale: expected more than 0 and at most 1, found " + share);
      requireIn("--threads", 0, RenderSettings.MAX_THREADS, threads);
      requireIn("--warmup", 0, MAX_REPETITIONS, warmup);
      requireIn("--repeat", 1, MAX_REPETITIONS, repeat);
      int used = threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
      return new BenchmarkPlan(share, used, warmup, repeat);
    }

    private List<ReportRow> selected(SceneFolder folder) throws TaskException {
      List<ReportRow> table = ReportTable.load(folder.directory());
      List<ReportRow> selected;
      try {
        selected = ReportTable.select(table, rows);
      } catch (IllegalArgumentException e) {
        throw new ParameterException(spec.commandLine(), "--rows: " + e.getMessage(), e);
      }
      for (ReportRow row : selected) {
        Path file = folder.file(row.scene());
        require(
            Files.isRegularFile(file), "row " + row.number() + ": scene does not exist: " + file);
      }
      return selected;
    }

    /** Renders and prints the rows. Returns whether all are complete; false if stopped. */
    private boolean run(
        List<ReportRow> selected,
        BenchmarkRunner runner,
        List<BenchmarkResult> results,
        Messages out)
        throws SceneFormatException, TaskException, IOException {
      BenchmarkTables tables = new BenchmarkTables(Machine.here(), runner.plan());
      try (TextOutput output = TextOutput.reserve(csv)) {
        tables.head().forEach(out::line);
        try {
          for (ReportRow row : selected) {
            BenchmarkResult result = runner.run(row);
            out.line(tables.line(result));
            results.add(result);
          }
        } finally {
          // Keep the finished rows even if a later one fails.
          tables.foot(results).forEach(out::line);
          output.write(tables.csv(results));
        }
        return true;
      } catch (InterruptedException e) {
        return false;
      }
    }

    /** Compares or stores the hashes, as the flags demand, and returns the exit code. */
    private ExitCode settle(TableHashes stored, List<BenchmarkResult> results)
        throws TaskException {
      if (hashes.store && !results.isEmpty()) {
        results.forEach(stored::put);
        stored.save();
      }
      if (!hashes.check) {
        return ExitCode.OK;
      }
      List<String> complaints =
          results.stream().map(stored::complaint).flatMap(Optional::stream).toList();
      complaints.forEach(errors()::line);
      return complaints.isEmpty() ? ExitCode.OK : ExitCode.DIFFERENT;
    }
  }
}
