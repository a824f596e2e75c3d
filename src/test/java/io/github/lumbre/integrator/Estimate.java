package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.testing.Statistics;
import java.util.Arrays;

/**
 * The mean radiance along one ray, from independent replicates. Samples of one pixel are stratified
 * and therefore not independent; pixels are independent, and each is one replicate.
 *
 * @param mean of the red component
 * @param error standard error of the mean
 */
record Estimate(double mean, double error) {
  /** The two-sided critical value at 1e-6, as for all statistical tests. */
  static final double CRITICAL = Statistics.CRITICAL_Z;

  static final int REPLICATES = 256;

  static Estimate of(Integrator integrator, Ray ray, int samplesEach) {
    return of(integrator, ray, samplesEach, 0);
  }

  static Estimate of(Integrator integrator, Ray ray, int samplesEach, long seed) {
    Sampler sampler = new SobolSampler(seed);
    RenderContext scratch = new RenderContext();
    double[] values = new double[REPLICATES];
    for (int replicate = 0; replicate < REPLICATES; replicate++) {
      for (int sample = 0; sample < samplesEach; sample++) {
        sampler.startSample(replicate, 7, sample);
        Rgb radiance = integrator.radiance(ray, sampler, scratch);
        if (!(radiance.r() >= 0) || !radiance.isFinite()) {
          throw new AssertionError(
              "replicate " + replicate + ", sample " + sample + ": " + radiance);
        }
        values[replicate] += radiance.r() / samplesEach;
      }
    }
    double mean = Arrays.stream(values).average().orElseThrow();
    double squares = Arrays.stream(values).map(value -> (value - mean) * (value - mean)).sum();
    return new Estimate(mean, Math.sqrt(squares / REPLICATES / (REPLICATES - 1)));
  }

  /**
   * Returns the distance to a reference in standard errors. A relative distance of 1e-11 counts as
   * 0, because rounding and extremely rare events explain it.
   */
  double z(double reference) {
    double distance = Math.abs(mean - reference);
    return distance <= 1e-11 * Math.abs(reference) ? 0 : Statistics.deviation(distance / error);
  }

  /** Returns the distance to another, independent estimate in standard errors. */
  double z(Estimate other) {
    double distance = Math.abs(mean - other.mean);
    return distance <= 1e-12 * Math.abs(mean)
        ? 0
        : Statistics.deviation(distance / Math.hypot(error, other.error));
  }
}
