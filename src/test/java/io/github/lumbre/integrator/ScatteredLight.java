package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Moments;
import java.util.EnumSet;

/**
 * Light at the origin of a floor, for tests of light that is sampled by way of specular surfaces:
 * scattered rays find it without that.
 */
final class ScatteredLight {
  static final int SAMPLES = 60_000;

  /** The relative standard error that is enough for the light of scattered rays. */
  private static final double ERROR = .009;

  private ScatteredLight() {}

  /** Returns what the techniques of a path tracer with default options share. */
  static LightSampling sampling(Scene scene) {
    PathOptions options = PathOptions.toDepth(5);
    return new LightSampling(
        scene,
        options,
        options.lightSampler().over(scene),
        DirectionStrategy.of(options, Guide.NONE));
  }

  static Moments samples(Scene scene, PathOptions options) {
    return samples(scene, options, new RenderContext(), lookingDownAt(0, .05), SAMPLES);
  }

  static Moments samples(
      Scene scene, PathOptions options, RenderContext context, Ray ray, int count) {
    return samples(scene, options, context, ray, count, count);
  }

  /** Returns the least number of samples, or more until their error is small; at most so many. */
  private static Moments samples(
      Scene scene, PathOptions options, RenderContext context, Ray ray, int least, int most) {
    PathTracer tracer = new PathTracer(scene, options);
    IndependentSampler sampler = new IndependentSampler(7);
    Moments moments = new Moments();
    for (int i = 0; i < least || i < most && error(moments) > ERROR; i++) {
      sampler.startSample(0, 0, i);
      context.startSample();
      moments.add(tracer.radiance(ray, sampler, context).g());
    }
    return moments;
  }

  private static double error(Moments moments) {
    return Math.sqrt(moments.variance() / moments.count()) / moments.mean();
  }

  /** The light that scattered rays find alone. */
  static Moments scattered(Scene scene, int depth) {
    PathOptions options = PathOptions.toDepth(depth).by(MisHeuristic.BSDF).withoutSpecularLinks();
    Ray ray = lookingDownAt(0, .05);
    return samples(scene, options, new RenderContext(), ray, 3 * SAMPLES, 20 * SAMPLES);
  }

  /**
   * Checks that all heuristics have the mean of scattered rays. Its standard error is below 1 %, so
   * that 4 of them show a difference of 4 %.
   */
  static void assertSameMean(Scene scene, int depth) {
    Moments expected = scattered(scene, depth);
    assertThat(error(expected)).isLessThan(.01);
    for (MisHeuristic heuristic : MisHeuristic.values()) {
      Moments found = samples(scene, PathOptions.toDepth(depth).by(heuristic));
      assertThat(found.z(expected)).as(heuristic.toString()).isBetween(-4.0, 4.0);
    }
  }

  /**
   * Checks that recorded lights add up to samples that are the same without a recorder.
   *
   * @param source a way to find light, in more than {@code least} of 1000 samples
   */
  static void assertRecordedLightsAddUp(Scene scene, Source source, int least) {
    PathRecorder recorder = new PathRecorder();
    PathTracer tracer = new PathTracer(scene, 4);
    RenderContext recorded = RenderContext.recordedBy(recorder);
    RenderContext plain = new RenderContext();
    IndependentSampler sampler = new IndependentSampler(5);
    Ray ray = lookingDownAt(0, .05);
    int sampled = 0;
    for (int i = 0; i < 1000; i++) {
      sampler.startSample(0, 0, i);
      recorded.startSample();
      Rgb found = tracer.radiance(ray, sampler, recorded);
      assertThat(found).isEqualTo(tracer.radiance(ray, sampler, plain));
      double sum = 0;
      for (PathVertex vertex : recorder.vertices()) {
        for (Contribution contribution : vertex.contributions()) {
          for (FoundLight light : contribution.lights()) {
            sum += vertex.throughput().times(light.weighted()).g();
            sampled += light.source() == source && !light.blocked() ? 1 : 0;
          }
        }
      }
      assertThat(sum).isCloseTo(found.g(), within(1e-12));
    }
    assertThat(sampled).isGreaterThan(least);
  }

  /** Checks that all light is that of the only light group, and none of it is direct. */
  static void assertIsIndirectLightOfTheGroup(Scene scene) {
    SampleLayers layers = new SampleLayers(EnumSet.of(Layer.DIRECT, Layer.LIGHTS), scene);
    RenderContext context = RenderContext.collecting(layers);
    PathTracer tracer = new PathTracer(scene, 3);
    IndependentSampler sampler = new IndependentSampler(5);
    double sum = 0;
    for (int i = 0; i < 1000; i++) {
      sampler.startSample(0, 0, i);
      context.startSample();
      layers.clear();
      Rgb found = tracer.radiance(lookingDownAt(0, .05), sampler, context);
      assertThat(layers.of(Layer.DIRECT)).containsOnly(0);
      assertThat(layers.of(Layer.LIGHTS)[1]).isCloseTo(found.g(), within(1e-12));
      sum += found.g();
    }
    assertThat(sum).isPositive();
  }
}
