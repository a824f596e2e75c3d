package io.github.lumbre.lab.report;

import io.github.lumbre.base.Release;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.Table;
import io.github.lumbre.lab.perf.Measurement;
import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.SettingType;
import java.nio.charset.Charset;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;

/** Formats the report's table with this machine's times, as Markdown and as CSV. */
public final class BenchmarkTables {
  private static final String ABOUT =
      Charset.defaultCharset().newEncoder().canEncode('≈') ? "≈" : "~";

  private final Machine machine;
  private final BenchmarkPlan plan;
  private final Table<BenchmarkResult> markdown;
  private final Table<BenchmarkResult> csv;

  public BenchmarkTables(Machine machine, BenchmarkPlan plan) {
    this.machine = machine;
    this.plan = plan;
    markdown =
        Table.<BenchmarkResult>empty()
            .number("#", row(ReportRow::number))
            .text("name", row(ReportRow::name))
            .text("size", row(ReportRow::size))
            .text("samples", BenchmarkTables::samples)
            .number("threads", of(m -> m.settings().threads()))
            .number("bucket", row(ReportRow::bucket))
            .number("depth", row(row -> depth(row, "N/A")))
            .text("hardware", result -> machine.cpu())
            .text("time", of(m -> ReportTime.of(m.seconds())))
            .text("time of all samples", BenchmarkTables::allSamples)
            .text(
                "report's hardware",
                row(row -> row.reportHardware() + ", " + row.reportThreads() + " threads"))
            .text(
                "report's time",
                row(row -> row.reportTime() + (row.note().isEmpty() ? "" : " (note)")))
            .number("samples/s", of(m -> Numbers.rate(m.statistics().samples(), m.seconds())))
            .number("rays/s", of(m -> Numbers.rate(m.rays(), m.seconds())))
            .text("image", of(Measurement::image));
    csv =
        Table.<BenchmarkResult>empty()
            .number("row", row(ReportRow::number))
            .text("name", row(ReportRow::name))
            .text("scene", row(ReportRow::scene))
            .text("size", row(ReportRow::size))
            .text("mode", row(row -> SettingType.nameOf(row.mode())))
            .number("samples", BenchmarkResult::samples)
            .number("all_samples", row(ReportRow::samples))
            .number("threads", of(m -> m.settings().threads()))
            .number("bucket", row(ReportRow::bucket))
            .number("depth", row(row -> depth(row, "")))
            .number("warmup", result -> plan.warmup())
            .number("repeat", result -> plan.repeat())
            .number("load_seconds", of(m -> decimal(m.loadSeconds())))
            .number("seconds", of(m -> decimal(m.seconds())))
            .number("all_seconds", result -> decimal(result.allSeconds()))
            .text("extrapolated", BenchmarkResult::isExtrapolated)
            .text("all_time", result -> ReportTime.of(result.allSeconds()))
            .number("samples_per_second", of(m -> rate(m.statistics().samples(), m)))
            .number("rays_per_second", of(m -> rate(m.rays(), m)))
            .number("report_threads", row(ReportRow::reportThreads))
            .text("report_hardware", row(ReportRow::reportHardware))
            .text("report_time", row(ReportRow::reportTime))
            .text("image_sha256", of(Measurement::imageHash))
            .text("scene_sha256", of(Measurement::sceneHash))
            .text("version", result -> Release.number())
            .text("cpu", result -> machine.cpu())
            .number("cores", result -> machine.cores())
            .text("jvm", result -> machine.jvm())
            .text("os", result -> machine.os())
            .text("note", row(ReportRow::note));
  }

  private static Function<BenchmarkResult, Object> row(Function<ReportRow, Object> value) {
    return result -> value.apply(result.row());
  }

  private static Function<BenchmarkResult, Object> of(Function<Measurement, Object> value) {
    return result -> value.apply(result.renders());
  }

  /** Returns the caption and the header of the Markdown table. */
  public List<String> head() {
    return markdown.head(
        "Lumbre " + Release.number() + " on " + machine.line() + ".",
        plan.sentences(),
        "Rays include shadow rays. Image: the first "
            + RasterHash.SHOWN_DIGITS
            + " digits of the picture's SHA-256, identical on every machine.");
  }

  /** Returns the Markdown row of a result. */
  public String line(BenchmarkResult result) {
    return markdown.line(result);
  }

  /** Returns the lines below the table: notes on peculiarities of the report's rows. */
  public List<String> foot(List<BenchmarkResult> results) {
    List<String> notes =
        results.stream()
            .map(BenchmarkResult::row)
            .filter(row -> !row.note().isEmpty())
            .map(row -> "- Note on row " + row.number() + ": " + row.note())
            .toList();
    return notes.isEmpty() ? notes : Stream.concat(Stream.of(""), notes.stream()).toList();
  }

  /** Returns the text of the CSV file: a line of names and one for each row; empty without rows. */
  public String csv(List<BenchmarkResult> results) {
    return csv.csv(results);
  }

  private static String samples(BenchmarkResult result) {
    ReportRow row = result.row();
    String count = (result.isExtrapolated() ? result.samples() + " of " : "") + row.samples();
    return row.mode() == Mode.RAY ? count + " (ray tracing)" : count;
  }

  private static String depth(ReportRow row, String ifNone) {
    return row.depth().isPresent() ? String.valueOf(row.depth().getAsInt()) : ifNone;
  }

  private static String allSamples(BenchmarkResult result) {
    String time = ReportTime.of(result.allSeconds());
    return result.isExtrapolated() ? ABOUT + " " + time + " extrapolated" : time;
  }

  private static String decimal(double seconds) {
    return String.format(Locale.ROOT, "%.3f", seconds);
  }

  private static String rate(long count, Measurement renders) {
    double seconds = renders.seconds();
    return String.format(Locale.ROOT, "%.0f", seconds > 0 ? count / seconds : 0);
  }
}
