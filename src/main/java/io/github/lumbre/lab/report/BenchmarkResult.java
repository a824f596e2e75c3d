package io.github.lumbre.lab.report;

import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.render.RenderStatistics;

/**
 * What a row of the table took here.
 *
 * @param samples per pixel that were rendered
 * @param threads that rendered them
 * @param loadSeconds that reading the scene took
 * @param seconds that one render took, the median of all
 * @param statistics of one render
 * @param sceneHash SHA-256 of the scene and of every file it refers to
 * @param imageHash see {@link RasterHash}
 */
public record BenchmarkResult(
    ReportRow row,
    int samples,
    int threads,
    double loadSeconds,
    double seconds,
    RenderStatistics statistics,
    String sceneHash,
    String imageHash) {
  /** Tells whether these were fewer samples than the report's. */
  boolean isExtrapolated() {
    return samples != row.samples();
  }

  /** Returns the time of all samples, extrapolated unless all were rendered. */
  double allSeconds() {
    return row.extrapolated(seconds, samples);
  }

  /** Returns how many rays were followed, shadow rays included. */
  long rays() {
    return statistics.rays() + statistics.shadowRays();
  }
}
