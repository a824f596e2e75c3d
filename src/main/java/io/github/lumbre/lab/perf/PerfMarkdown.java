package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.Release;
import java.util.List;
import java.util.Locale;

/** Formats the measurements of scenes as a Markdown table, row by row. */
public final class PerfMarkdown {
  private final PerfMachine machine;
  private final PerfPlan plan;

  public PerfMarkdown(PerfMachine machine, PerfPlan plan) {
    this.machine = machine;
    this.plan = plan;
  }

  /** Returns the caption and the header of the table. */
  public List<String> head() {
    return List.of(
        "Lumbre " + Release.number() + " on " + machine.hardware().line() + ".",
        machine.load() < 0
            ? "Load average before: unknown."
            : String.format(Locale.ROOT, "Load average before: %.2f (0 is ideal).", machine.load()),
        plan.sentences(),
        "Rays include shadow rays. Warm-up: the time until a render reaches 95 % of the final rate;"
            + " only the first scene starts with a cold JVM.",
        "relMSE: mean over pixels and channels of ((a - b)^2 / 2) / (m^2 + 0.01) for pictures a and"
            + " b of two seeds; m: mean of all pictures.",
        "To relMSE 0.01: time extrapolated with an error proportional to 1/samples.",
        "",
        Markdown.row(
            List.of(
                "scene",
                "size",
                "samples",
                "threads",
                "time",
                "CPU time",
                "samples/s",
                "rays/s",
                "rays/CPU s",
                "B/ray",
                "warm-up",
                "relMSE",
                "relMSE x s",
                "to relMSE 0.01",
                "image")),
        "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|");
  }

  /** Returns the row of one result. */
  public String row(PerfResult result) {
    return Markdown.row(
        List.of(
            result.scene(),
            result.settings().width() + "x" + result.settings().height(),
            String.valueOf(result.settings().samples()),
            String.valueOf(result.settings().threads()),
            seconds(result.seconds()),
            seconds(result.cpuSeconds()),
            Markdown.rate(result.statistics().samples(), result.seconds()),
            Markdown.rate(result.rays(), result.seconds()),
            Markdown.rate(result.rays(), result.cpuSeconds()),
            String.format(Locale.ROOT, "%.0f", result.bytesPerRay()),
            result.warmUp().text(),
            threeDigits(result.noise().relativeMse()),
            threeDigits(result.errorSeconds()),
            threeDigits(result.secondsToTarget()) + " s",
            "`" + result.imageHash().substring(0, RasterHash.SHOWN_DIGITS) + "`"));
  }

  private static String seconds(double value) {
    return String.format(Locale.ROOT, "%.3f s", value);
  }

  private static String threeDigits(double value) {
    return String.format(Locale.ROOT, "%.3g", value);
  }
}
