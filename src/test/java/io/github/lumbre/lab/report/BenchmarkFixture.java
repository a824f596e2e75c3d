package io.github.lumbre.lab.report;

import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.perf.Measurement;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import java.math.BigDecimal;
import java.util.List;
import java.util.OptionalInt;

/** Realistic rows, plans and results for tests. */
public final class BenchmarkFixture {
  public static final Machine MACHINE =
      new Machine(
          "Fast|er", 4, "VM 17", List.of("-Xmx1g"), 1 << 30, List.of("GC"), "Linux 6 amd64", .25);
  public static final String HASH = "0123456789abcdef".repeat(4);

  private BenchmarkFixture() {}

  static ReportRow row(int samples) {
    return new ReportRow(
        5,
        "Hearts",
        "hearts",
        new Size(8, 4),
        Mode.PATH,
        samples,
        32,
        OptionalInt.of(5),
        8,
        "i7",
        "1h",
        "");
  }

  static ReportRow rayRow(String note) {
    return new ReportRow(
        9,
        "Gray",
        "gray",
        new Size(8, 4),
        Mode.RAY,
        4,
        30,
        OptionalInt.empty(),
        8,
        "i5",
        "16s",
        note);
  }

  static BenchmarkPlan plan(String share) {
    return new BenchmarkPlan(new BigDecimal(share), 2, 1, 3);
  }

  /** Returns a result with 12.5 s, 320 samples and 1000 rays. */
  static BenchmarkResult result(ReportRow row, int samples) {
    RenderStatistics statistics = new RenderStatistics(320, 600, 400, 0, List.of(), 0, 0, 0, 0);
    RenderSettings settings = row.over(RenderSettings.DEFAULT);
    settings = settings.toBuilder().samples(samples).threads(2).build();
    Cost cost = new Cost(12.5, 25, 0);
    return new BenchmarkResult(
        row, new Measurement("hearts", "feed", settings, .25, List.of(cost), statistics, HASH));
  }
}
