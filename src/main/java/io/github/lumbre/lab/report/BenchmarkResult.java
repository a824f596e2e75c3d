package io.github.lumbre.lab.report;

import io.github.lumbre.lab.perf.Measurement;

/** The measurement of a table row on this machine. */
public record BenchmarkResult(ReportRow row, Measurement renders) {
  /** Returns the rendered samples per pixel. */
  int samples() {
    return renders.settings().samples();
  }

  /** Returns whether fewer samples than the report's were rendered. */
  boolean isExtrapolated() {
    return samples() != row.samples();
  }

  /** Returns the time of all of the report's samples, extrapolated if fewer were rendered. */
  double allSeconds() {
    return row.extrapolated(renders.seconds(), samples());
  }
}
