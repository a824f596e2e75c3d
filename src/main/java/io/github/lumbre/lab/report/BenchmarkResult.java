package io.github.lumbre.lab.report;

import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.render.RenderStatistics;

/**
 * The measurement of a table row on this machine.
 *
 * @param samples rendered samples per pixel
 * @param threads number of threads
 * @param loadSeconds loading time of the scene
 * @param seconds median time of a render
 * @param statistics statistics of one render
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
  /** Returns whether fewer samples than the report's were rendered. */
  boolean isExtrapolated() {
    return samples != row.samples();
  }

  /** Returns the time of all of the report's samples, extrapolated if fewer were rendered. */
  double allSeconds() {
    return row.extrapolated(seconds, samples);
  }

  /** Returns the number of rays traced, including shadow rays. */
  long rays() {
    return statistics.rays() + statistics.shadowRays();
  }
}
