package io.github.lumbre.lab.report;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.Release;
import io.github.lumbre.lab.perf.Hardware;
import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.nio.charset.Charset;
import java.util.List;
import java.util.stream.Stream;

/** Formats the report's table with this machine's times in Markdown, row by row. */
public final class BenchmarkMarkdown {
  private static final String ABOUT =
      Charset.defaultCharset().newEncoder().canEncode('≈') ? "≈" : "~";

  private final Hardware hardware;
  private final BenchmarkPlan plan;

  public BenchmarkMarkdown(Hardware hardware, BenchmarkPlan plan) {
    this.hardware = hardware;
    this.plan = plan;
  }

  /** Returns the caption and the header of the table. */
  List<String> head() {
    return List.of(
        "Lumbre " + Release.number() + " on " + hardware.line() + ".",
        plan.sentences(),
        "Rays include shadow rays. Image: the first "
            + RasterHash.SHOWN_DIGITS
            + " digits of the picture's SHA-256, identical on every machine.",
        "",
        Markdown.row(
            List.of(
                "#",
                "name",
                "size",
                "samples",
                "threads",
                "bucket",
                "depth",
                "hardware",
                "time",
                "time of all samples",
                "report's hardware",
                "report's time",
                "samples/s",
                "rays/s",
                "image")),
        "|--:|---|---|---|--:|--:|--:|---|---|---|---|---|--:|--:|---|");
  }

  /** Returns the table row of a result. */
  String row(BenchmarkResult result) {
    ReportRow row = result.row();
    return Markdown.row(
        List.of(
            String.valueOf(row.number()),
            row.name(),
            row.size(),
            samples(result),
            String.valueOf(result.threads()),
            String.valueOf(row.bucket()),
            row.depth().isPresent() ? String.valueOf(row.depth().getAsInt()) : "N/A",
            hardware.cpu(),
            ReportTime.of(result.seconds()),
            allSamples(result),
            row.reportHardware() + ", " + row.reportThreads() + " threads",
            row.reportTime() + (row.note().isEmpty() ? "" : " (note)"),
            Markdown.rate(result.statistics().samples(), result.seconds()),
            Markdown.rate(result.rays(), result.seconds()),
            "`" + result.imageHash().substring(0, RasterHash.SHOWN_DIGITS) + "`"));
  }

  private static String samples(BenchmarkResult result) {
    ReportRow row = result.row();
    String count =
        result.isExtrapolated()
            ? result.samples() + " of " + row.samples()
            : String.valueOf(row.samples());
    return row.mode() == Mode.RAY ? count + " (ray tracing)" : count;
  }

  private static String allSamples(BenchmarkResult result) {
    String time = ReportTime.of(result.allSeconds());
    return result.isExtrapolated() ? ABOUT + " " + time + " extrapolated" : time;
  }

  /** Returns the lines below the table: notes on peculiarities of the report's rows. */
  List<String> foot(List<BenchmarkResult> results) {
    List<String> notes =
        results.stream()
            .map(BenchmarkResult::row)
            .filter(row -> !row.note().isEmpty())
            .map(row -> "- Note on row " + row.number() + ": " + row.note())
            .toList();
    return notes.isEmpty() ? notes : Stream.concat(Stream.of(""), notes.stream()).toList();
  }
}
