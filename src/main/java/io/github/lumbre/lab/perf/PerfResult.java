package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.PictureNoise;

/**
 * The measurement of a scene with one number of threads.
 *
 * @param warmUp times of the first renders
 * @param noise noise of the picture, the same for any number of threads
 */
public record PerfResult(Measurement renders, WarmUp warmUp, PictureNoise noise) {
  /** The relative mean squared error that times are extrapolated to. */
  static final double TARGET = .01;

  /** Returns relative mean squared error × seconds; lower is better. */
  double errorSeconds() {
    return noise.relativeMse() * renders.seconds();
  }

  /** Returns the seconds to {@link #TARGET}, assuming an error proportional to 1/samples. */
  double secondsToTarget() {
    return errorSeconds() / TARGET;
  }
}
