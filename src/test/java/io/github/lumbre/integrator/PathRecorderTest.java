package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glass;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** A recorded path explains its sample completely and equals the path of a normal render. */
class PathRecorderTest {
  private static final int SAMPLES = 200;

  /** Lights of every kind, two environment lights, glass, and ambient light. */
  private static Scene scene() {
    return empty()
        .add(floor(), matte(.7))
        .add(new Box(at(2, 1, 0), 1, 2, 3), matte(.8))
        .add(sphere(.3, 1, -1, .4), glass(1.5))
        .addAreaLight(ceilingLamp(2, 2, 4), glow(1))
        .add(point(new Vec3(-1, 2, 1), 3))
        .add(EnvironmentLight.uniform(new Rgb(.1, .2, .3)))
        .add(EnvironmentLight.uniform(new Rgb(.7, .05, .01)))
        .addAmbient(Rgb.gray(.3))
        .build();
  }

  static Stream<Arguments> options() {
    return Stream.of(MisHeuristic.values())
        .flatMap(
            strategy ->
                Stream.of(1, 3)
                    .flatMap(
                        split ->
                            Stream.of(0, 3)
                                .map(
                                    roulette ->
                                        Arguments.of(
                                            PathOptions.toDepth(8)
                                                .by(strategy)
                                                .splitInto(split)
                                                .rouletteFrom(roulette)))));
  }

  @ParameterizedTest
  @MethodSource("options")
  void contributionsAddUpToTheSampleBitForBit(PathOptions options) {
    assertExplained(new PathTracer(scene(), options));
  }

  @Test
  void contributionsOfRayTracingAddUpBitForBit() {
    assertExplained(new RayTracer(scene(), 3, 6));
  }

  private static void assertExplained(Integrator integrator) {
    PathRecorder recorder = new PathRecorder();
    RenderContext recorded = RenderContext.recordedBy(recorder);
    RenderContext plain = new RenderContext();
    SobolSampler sampler = new SobolSampler(5);
    double light = 0;
    for (int sample = 0; sample < SAMPLES; sample++) {
      Ray ray = lookingDownAt(.01 * sample - .7, 6);
      sampler.startSample(0, 0, sample);
      Rgb expected = integrator.radiance(ray, sampler, plain);
      sampler.startSample(0, 0, sample);
      assertThat(integrator.radiance(ray, sampler, recorded)).isEqualTo(expected);
      assertThat(sum(recorder.vertices())).isEqualTo(expected);
      recorder.vertices().forEach(PathRecorderTest::assertContributionsAreWeightedLight);
      light += expected.max();
    }
    assertThat(light).isPositive();
    assertThat(recorded.rays()).isEqualTo(plain.rays());
    assertThat(recorded.shadowRays()).isEqualTo(plain.shadowRays());
  }

  private static Rgb sum(List<PathVertex> vertices) {
    Rgb sum = Rgb.BLACK;
    for (PathVertex vertex : vertices) {
      for (Contribution contribution : vertex.contributions()) {
        sum = sum.plus(contribution.amount());
      }
    }
    return sum;
  }

  private static void assertContributionsAreWeightedLight(PathVertex vertex) {
    for (Contribution contribution : vertex.contributions()) {
      Rgb light = Rgb.BLACK;
      for (FoundLight found : contribution.lights()) {
        light = light.plus(found.weighted());
      }
      Rgb expected = vertex.throughput().times(light);
      Rgb amount = contribution.amount();
      assertThat(amount.r()).isCloseTo(expected.r(), within(expected));
      assertThat(amount.g()).isCloseTo(expected.g(), within(expected));
      assertThat(amount.b()).isCloseTo(expected.b(), within(expected));
    }
  }

  private static Offset<Double> within(Rgb scale) {
    return Offset.offset(1e-12 * (1 + scale.max()));
  }

  /** The densities of light sampling and BSDF sampling explain each weight. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void recordedWeightsAreThoseOfTheHeuristic(MisHeuristic strategy) {
    PathTracer tracer = new PathTracer(scene(), PathOptions.toDepth(8).by(strategy));
    PathRecorder recorder = new PathRecorder();
    RenderContext context = RenderContext.recordedBy(recorder);
    SobolSampler sampler = new SobolSampler(6);
    int weighted = 0;
    for (int sample = 0; sample < SAMPLES; sample++) {
      sampler.startSample(0, 0, sample);
      tracer.radiance(lookingDownAt(.01 * sample - .7, 6), sampler, context);
      for (FoundLight light : found(recorder.vertices())) {
        boolean both = light.lightPdf() > 0 && Double.isFinite(light.bsdfPdf());
        if (light.source() != Source.LIGHT && light.source() != Source.AMBIENT && both) {
          weighted++;
          assertThat(light.misWeight())
              .isEqualTo(strategy.bsdfWeight(light.bsdfPdf(), light.lightPdf()));
        }
      }
    }
    assertThat(weighted).isPositive();
  }

  private static List<FoundLight> found(List<PathVertex> vertices) {
    return vertices.stream()
        .flatMap(vertex -> vertex.contributions().stream())
        .flatMap(contribution -> contribution.lights().stream())
        .toList();
  }

  @Test
  void branchesOfASplitPathAreNumbered() {
    PathTracer tracer = new PathTracer(scene(), PathOptions.toDepth(4).splitInto(3));
    PathRecorder recorder = new PathRecorder();
    SobolSampler sampler = new SobolSampler(1);
    sampler.startSample(0, 0, 0);
    tracer.radiance(lookingDownAt(-.5), sampler, RenderContext.recordedBy(recorder));
    List<PathVertex> vertices = recorder.vertices();
    assertThat(vertices.get(0).end()).isEqualTo(End.SPLIT);
    assertThat(vertices.get(0).scattered()).hasSize(3);
    int previous = 0;
    for (PathVertex vertex : vertices.subList(1, vertices.size())) {
      assertThat(vertex.branch()).isBetween(previous, previous + 1);
      if (vertex.branch() != previous || vertex == vertices.get(1)) {
        assertThat(vertex.ray().direction())
            .isEqualTo(vertices.get(0).scattered().get(vertex.branch()).wi());
      }
      previous = vertex.branch();
    }
    assertThat(previous).isEqualTo(2);
  }
}
