package io.github.lumbre.cli;

import io.github.lumbre.scene.RenderSettings.Mode;
import java.nio.charset.Charset;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The report's table with this machine's times, in Markdown, in parts as they become known. */
final class BenchmarkMarkdown {
  /** How much of a fingerprint is shown: enough to tell any two pictures apart. */
  static final int HASH_DIGITS = 16;

  private static final String ABOUT =
      Charset.defaultCharset().newEncoder().canEncode('≈') ? "≈" : "~";

  private final Hardware hardware;
  private final BenchmarkPlan plan;

  BenchmarkMarkdown(Hardware hardware, BenchmarkPlan plan) {
    this.hardware = hardware;
    this.plan = plan;
  }

  /** Returns caption and head of the table. */
  List<String> head() {
    return List.of(
        "Lumbre " + Version.number() + " on " + hardware.line() + ".",
        plan.sentences(),
        "Rays include shadow rays. Image: the first "
            + HASH_DIGITS
            + " digits of the picture's"
            + " SHA-256, which is the same on every machine.",
        "",
        cells(
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

  /** Returns the line of one row. */
  String row(BenchmarkResult result) {
    ReportRow row = result.row();
    return cells(
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
            Summary.rate(result.statistics().samples(), result.seconds()),
            Summary.rate(result.rays(), result.seconds()),
            "`" + result.imageHash().substring(0, HASH_DIGITS) + "`"));
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

  /** Returns what follows the table: what is odd about its rows in the report. */
  List<String> foot(List<BenchmarkResult> results) {
    List<String> notes =
        results.stream()
            .map(BenchmarkResult::row)
            .filter(row -> !row.note().isEmpty())
            .map(row -> "- Note on row " + row.number() + ": " + row.note())
            .toList();
    return notes.isEmpty() ? notes : Stream.concat(Stream.of(""), notes.stream()).toList();
  }

  /** Returns a line of a Markdown table. */
  static String cells(List<String> values) {
    return values.stream()
        .map(value -> value.replace("|", "\\|"))
        .collect(Collectors.joining(" | ", "| ", " |"));
  }
}
