package io.github.lumbre.integrator;

import static io.github.lumbre.integrator.TestScenes.lookingDownAt;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Ray;
import io.github.lumbre.sampling.IndependentSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Moments;

/**
 * Light at the origin of a floor, for tests of light that is sampled by way of specular surfaces:
 * scattered rays find it without that.
 */
final class ScatteredLight {
  static final int SAMPLES = 60_000;

  private ScatteredLight() {}

  static Moments samples(Scene scene, PathOptions options) {
    return samples(scene, options, new RenderContext(), lookingDownAt(0, .05), SAMPLES);
  }

  static Moments samples(
      Scene scene, PathOptions options, RenderContext context, Ray ray, int count) {
    PathTracer tracer = new PathTracer(scene, options);
    IndependentSampler sampler = new IndependentSampler(7);
    Moments moments = new Moments();
    for (int i = 0; i < count; i++) {
      sampler.startSample(0, 0, i);
      context.startSample();
      moments.add(tracer.radiance(ray, sampler, context).g());
    }
    return moments;
  }

  /** The light that scattered rays find alone. */
  static Moments scattered(Scene scene, int depth) {
    PathOptions options =
        PathOptions.toDepth(depth).by(MisHeuristic.BSDF).withoutSpecularLinks();
    return samples(scene, options, new RenderContext(), lookingDownAt(0, .05), 20 * SAMPLES);
  }

  /**
   * Checks that all heuristics have the mean of scattered rays. Its standard error is below 1 %, so
   * that 4 of them show a difference of 4 %.
   */
  static void assertSameMean(Scene scene, int depth) {
    Moments expected = scattered(scene, depth);
    assertThat(Math.sqrt(expected.variance() / expected.count()) / expected.mean())
        .isLessThan(.01);
    for (MisHeuristic heuristic : MisHeuristic.values()) {
      Moments found = samples(scene, PathOptions.toDepth(depth).by(heuristic));
      assertThat(found.z(expected)).as(heuristic.toString()).isBetween(-4.0, 4.0);
    }
  }
}
