package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.lab.report.BenchmarkFixture;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Realistic measurements for tests. */
final class PerfFixture {
  static final PerfPlan PLAN =
      new PerfPlan(Optional.empty(), 4, List.of(1, 2), 2, 3, 2, Set.of(), false, 1);

  static final PerfTables TABLES = new PerfTables(BenchmarkFixture.MACHINE, PLAN);

  private PerfFixture() {}

  /**
   * Returns a result with 320 samples, 1000 rays and the given times; CPU times are twice as long.
   */
  static PerfResult result(String scene, String imageHash, double... seconds) {
    Measurement renders =
        new Measurement(
            scene,
            "feed",
            new RenderSettings.Builder().size(8, 4).samples(10).threads(2).build(),
            .25,
            Arrays.stream(seconds).mapToObj(s -> new Cost(s, 2 * s, 64_000)).toList(),
            new RenderStatistics(320, 600, 400, 0, List.of(), 0, 0, 0, 0),
            imageHash);
    return new PerfResult(
        renders, new WarmUp(List.of(2.0, 1.0), List.of(1.0)), new PictureNoise(List.of(.03, .05)));
  }
}
