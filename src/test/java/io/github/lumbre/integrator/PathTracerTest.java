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
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Scattering;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests single paths against exact values: sums, lengths, probabilities and counts of rays. */
class PathTracerTest {
  private static final Ray INSIDE = new Ray(new Vec3(.1, .2, -.3), new Vec3(.6, .64, .48));
  private static final Rgb ALBEDO = new Rgb(.2, .4, .8);
  private static final int SAMPLES = 100;
  private static final int NEVER = 1000;

  private final PathRecorder recorder = new PathRecorder();
  private final RenderContext recorded = RenderContext.recordedBy(recorder);
  private final RenderContext plain = new RenderContext();
  private final SobolSampler sampler = new SobolSampler(3);

  /** Returns a closed sphere with an ambient irradiance of π. */
  private static Scene furnace(Rgb albedo) {
    return empty()
        .add(sphere(0, 0, 0, 1), new Matte(Texture.constant(albedo)))
        .addAmbient(Rgb.gray(Math.PI))
        .build();
  }

  private Rgb radiance(Integrator integrator, Ray ray, int sample, RenderContext context) {
    sampler.startSample(2, 1, sample);
    return integrator.radiance(ray, sampler, context);
  }

  private static Offset<Double> rounding() {
    return within(1e-12);
  }

  private static void assertClose(Rgb found, Rgb expected) {
    assertThat(found.r()).isCloseTo(expected.r(), within(1e-9 * (1 + expected.r())));
    assertThat(found.g()).isCloseTo(expected.g(), within(1e-9 * (1 + expected.g())));
    assertThat(found.b()).isCloseTo(expected.b(), within(1e-9 * (1 + expected.b())));
  }

  /** a + a² + … + aⁿ in each channel, without roulette in each sample. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 8})
  void furnaceIsAGeometricSeries(int split) {
    for (int depth = 0; depth < 12; depth++) {
      PathOptions options = PathOptions.toDepth(depth).rouletteFrom(NEVER).splitInto(split);
      PathTracer tracer = new PathTracer(furnace(ALBEDO), options);
      Rgb expected = Rgb.BLACK;
      Rgb power = Rgb.WHITE;
      for (int bounce = 0; bounce < depth; bounce++) {
        power = power.times(ALBEDO);
        expected = expected.plus(power);
      }
      for (int sample = 0; sample < 5; sample++) {
        assertClose(radiance(tracer, INSIDE, sample, plain), expected);
      }
    }
  }

  /** A closed path of n vertices needs n + 1 rays, and a shadow ray from each vertex. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 5})
  void raysAreThoseOfTheVertices(int split) {
    Scene scene = empty().add(sphere(0, 0, 0, 1), matte(1)).add(point(Vec3.ZERO, 1)).build();
    for (int depth = 0; depth < 7; depth++) {
      PathOptions options = PathOptions.toDepth(depth).splitInto(split);
      RenderContext context = new RenderContext();
      assertThat(context.hitSomething()).isFalse();
      radiance(new PathTracer(scene, options), INSIDE, 0, context);
      assertThat(context.hitSomething()).isTrue();
      assertThat(context.rays()).isEqualTo(1 + depth * split);
      assertThat(context.shadowRays()).isEqualTo(depth == 0 ? 0 : 1 + (depth - 1) * split);
      radiance(new PathTracer(scene, options), INSIDE, 0, recorded);
      long ends = recorder.vertices().stream().filter(v -> v.end() == End.DEPTH).count();
      assertThat(ends).isEqualTo(depth == 0 ? 1 : split);
      PathVertex last = recorder.vertices().get(recorder.vertices().size() - 1);
      assertThat(last.hit().orElseThrow().bsdf()).isEmpty();
      assertThat(last.scattered()).isEmpty();
    }
  }

  /**
   * From the first vertex of roulette on, a path survives with twice the largest component of its
   * throughput, relative to that behind the first vertex.
   */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 3})
  void rouletteEndsPathsByTheirThroughput(int first) {
    PathOptions options = PathOptions.toDepth(50).rouletteFrom(first);
    PathTracer tracer = new PathTracer(furnace(ALBEDO), options);
    double expectedEnds = 0;
    double ends = 0;
    double variance = 0;
    double behindFirst = 0;
    for (int sample = 0; sample < 20 * SAMPLES; sample++) {
      sampler.startSample(sample, 7, 0);
      tracer.radiance(INSIDE, sampler, recorded);
      List<PathVertex> vertices = recorder.vertices();
      for (int depth = 0; depth < vertices.size(); depth++) {
        PathVertex vertex = vertices.get(depth);
        if (vertex.scattered().isEmpty()) {
          continue;
        }
        Scattering scattering = vertex.scattered().get(0);
        Rgb carried = vertex.throughput().times(scattering.weight());
        if (depth == 0) {
          behindFirst = carried.max();
        }
        double survival = depth < first ? 1 : Math.min(1, 2 * carried.max() / behindFirst);
        assertThat(scattering.survival()).isCloseTo(survival, rounding());
        assertThat(scattering.survives()).isEqualTo(vertex.end() != End.ROULETTE);
        assertThat(vertex.end() == End.ROULETTE).isEqualTo(depth == vertices.size() - 1);
        if (scattering.survives()) {
          assertClose(vertices.get(depth + 1).throughput(), carried.times(1 / survival));
        }
        expectedEnds += 1 - survival;
        ends += scattering.survives() ? 0 : 1;
        variance += survival * (1 - survival);
      }
    }
    assertThat(ends).isCloseTo(expectedEnds, within(5 * Math.sqrt(variance)));
    assertThat(ends).isPositive();
  }

  /** A white surface keeps the whole throughput, so roulette never ends a path. */
  @Test
  void rouletteSparesPathsOfFullThroughput() {
    PathTracer tracer = new PathTracer(furnace(Rgb.WHITE), PathOptions.toDepth(40).rouletteFrom(0));
    for (int sample = 0; sample < 20; sample++) {
      assertClose(radiance(tracer, INSIDE, sample, plain), Rgb.gray(40));
    }
  }

  /** The floor's radiance is E a / π, with E = I cos θ / d² in each channel. */
  @Test
  void pointLightsAFloorByTheInverseSquare() {
    Rgb intensity = new Rgb(3, 5, 7);
    Vec3 lamp = new Vec3(1, 2, -2);
    Scene scene =
        empty()
            .add(floor(), new Matte(Texture.constant(ALBEDO)))
            .add(new PointLight(lamp, intensity, Falloff.INVERSE_SQUARE))
            .build();
    Rgb expected = ALBEDO.times(intensity).times(2 / 3.0 / 9 / Math.PI);
    for (MisHeuristic heuristic : MisHeuristic.values()) {
      PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).by(heuristic));
      assertClose(radiance(tracer, lookingDownAt(0), 0, plain), expected);
      assertClose(radiance(tracer, lookingDownAt(0), 0, recorded), expected);
      FoundLight light = recorder.vertices().get(0).contributions().get(0).lights().get(0);
      assertThat(light.lightPdf()).isEqualTo(1);
      assertThat(light.misWeight()).isEqualTo(1);
      assertThat(light.blocked()).isFalse();
      assertThat(light.emitter()).isZero();
    }
  }

  @Test
  void blockedLightAddsNothingAndIsRecordedAsBlocked() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(sphere(0, 1, 0, .3), matte(.5))
            .add(point(new Vec3(0, 2, 0), 1))
            .build();
    PathTracer tracer = new PathTracer(scene, 1);
    assertThat(radiance(tracer, lookingDownAt(0), 0, recorded)).isEqualTo(Rgb.BLACK);
    assertThat(recorder.vertices().get(0).contributions().get(0).lights())
        .singleElement()
        .matches(FoundLight::blocked);
    assertThat(radiance(tracer, lookingDownAt(3), 0, recorded).r()).isPositive();
    assertThat(recorder.vertices().get(0).contributions().get(0).lights())
        .singleElement()
        .matches(light -> !light.blocked());
  }

  /** Light from below a floor is neither traced nor blocked, but it is recorded. */
  @Test
  void lightFromBehindNeedsNoShadowRay() {
    Scene scene = empty().add(floor(), matte(.5)).add(point(new Vec3(0, -2, 0), 1)).build();
    PathTracer tracer = new PathTracer(scene, 1);
    for (RenderContext context : List.of(plain, recorded)) {
      assertThat(radiance(tracer, lookingDownAt(0), 0, context)).isEqualTo(Rgb.BLACK);
      assertThat(context.shadowRays()).isZero();
    }
    FoundLight light = recorder.vertices().get(0).contributions().get(0).lights().get(0);
    assertThat(light.f()).isEqualTo(Rgb.BLACK);
    assertThat(light.blocked()).isFalse();
  }

  /** A sample of one of two lights counts for both: its light is divided by its probability. */
  @ParameterizedTest
  @EnumSource(LightSamplerKind.class)
  void selectedLightsAreDividedByTheirProbability(LightSamplerKind kind) {
    PointLight one = point(new Vec3(0, 1, 0), 1);
    PointLight other = point(new Vec3(2, 2, 0), 5);
    Scene scene = empty().add(floor(), matte(.5)).add(one).add(other).build();
    double[] alone = new double[2];
    for (int i = 0; i < 2; i++) {
      Scene single = empty().add(floor(), matte(.5)).add(i == 0 ? one : other).build();
      alone[i] = radiance(new PathTracer(single, 1), lookingDownAt(0), 0, plain).r();
    }
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).by(kind));
    double[] probability = new double[2];
    int[] count = new int[2];
    for (int sample = 0; sample < SAMPLES; sample++) {
      double radiance = radiance(tracer, lookingDownAt(0), sample, recorded).r();
      FoundLight light = recorder.vertices().get(0).contributions().get(0).lights().get(0);
      probability[light.emitter()] = light.lightPdf();
      count[light.emitter()]++;
      assertThat(radiance * light.lightPdf()).isCloseTo(alone[light.emitter()], rounding());
    }
    assertThat(probability[0] + probability[1]).isCloseTo(1, rounding());
    assertThat((double) count[0] / SAMPLES).isCloseTo(probability[0], within(.03));
    if (kind == LightSamplerKind.UNIFORM) {
      assertThat(probability[0]).isEqualTo(.5);
    }
  }

  /** Cosine-distributed rays into a uniform environment find the same light in each sample. */
  @Test
  void uniformEnvironmentsLightAFloorByItsAlbedo() {
    Scene scene =
        empty()
            .add(floor(), new Matte(Texture.constant(ALBEDO)))
            .add(EnvironmentLight.uniform(new Rgb(1, 2, 3)))
            .add(EnvironmentLight.uniform(new Rgb(.5, .25, 4)))
            .build();
    Rgb both = new Rgb(1.5, 2.25, 7);
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).by(MisHeuristic.BSDF));
    for (int sample = 0; sample < 20; sample++) {
      assertClose(radiance(tracer, lookingDownAt(0), sample, recorded), ALBEDO.times(both));
      PathVertex end = recorder.vertices().get(1);
      assertThat(end.end()).isEqualTo(End.ESCAPED);
      assertThat(end.hit()).isEmpty();
      assertThat(end.contributions().get(0).lights())
          .extracting(FoundLight::emitter)
          .containsExactly(0, 1);
    }
    Ray up = new Ray(Vec3.Y, Vec3.Y);
    recorded.startSample();
    assertClose(radiance(new PathTracer(scene, 0), up, 0, recorded), both);
    assertThat(recorded.hitSomething()).isFalse();
  }

  /**
   * Both techniques have the same densities: what one sample of a light says of a direction is what
   * a ray says that finds it, with weights that add up to 1.
   */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void lightsFoundByRaysAreWeightedAgainstLightSampling(MisHeuristic heuristic) {
    double radiance = 2;
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .addAreaLight(ceilingLamp(3, 3, 1), glow(radiance))
            .add(EnvironmentLight.uniform(Rgb.gray(.1)))
            .build();
    PathTracer tracer =
        new PathTracer(scene, PathOptions.toDepth(1).by(heuristic).by(LightSamplerKind.UNIFORM));
    boolean samples = heuristic != MisHeuristic.BSDF;
    int found = 0;
    for (int sample = 0; sample < SAMPLES; sample++) {
      radiance(tracer, lookingDownAt(.2), sample, recorded);
      List<PathVertex> vertices = recorder.vertices();
      PathVertex end = vertices.get(1);
      if (end.end() != End.EMITTER) {
        continue;
      }
      found++;
      FoundLight light = end.contributions().get(0).lights().get(0);
      assertThat(end.hit().orElseThrow().position().y()).isCloseTo(1, rounding());
      assertThat(light.radiance()).isEqualTo(Rgb.gray(radiance));
      double cosine = end.ray().direction().y();
      assertThat(light.bsdfPdf()).isCloseTo(cosine / Math.PI, rounding());
      assertThat(light.misWeight())
          .isCloseTo(
              samples ? heuristic.bsdfWeight(light.bsdfPdf(), light.lightPdf()) : 1, rounding());
      if (samples) {
        // The light is selected half of the time and then sampled by area or by solid angle.
        assertThat(light.lightPdf()).isPositive();
        vertices.get(0).contributions().stream()
            .flatMap(c -> c.lights().stream())
            .filter(other -> other.emitter() == light.emitter())
            .forEach(
                other -> assertThat(other.lightPdf()).isCloseTo(light.lightPdf(), within(1e-9)));
      }
      assertThat(light.lightPdf() > 0).isEqualTo(samples);
    }
    assertThat(found).isBetween(SAMPLES / 2, SAMPLES);
  }

  /** Escaped rays are weighted against sampling the environment, but camera rays are not. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void environmentsFoundByRaysAreWeightedAgainstLightSampling(MisHeuristic heuristic) {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(EnvironmentLight.uniform(Rgb.gray(2)))
            .add(EnvironmentLight.uniform(new Rgb(1, 2, 3)))
            .build();
    PathOptions options = PathOptions.toDepth(1).by(heuristic).by(LightSamplerKind.UNIFORM);
    PathTracer tracer = new PathTracer(scene, options);
    for (int sample = 0; sample < SAMPLES; sample++) {
      radiance(tracer, lookingDownAt(.2), sample, recorded);
      PathVertex end = recorder.vertices().get(1);
      for (FoundLight light : end.contributions().get(0).lights()) {
        boolean samples = heuristic != MisHeuristic.BSDF;
        // Half of the light samples are of each environment, uniform over the sphere.
        double lightPdf = samples ? .5 / (4 * Math.PI) : 0;
        assertThat(light.lightPdf()).isCloseTo(lightPdf, rounding());
        assertThat(light.misWeight())
            .isCloseTo(samples ? heuristic.bsdfWeight(light.bsdfPdf(), lightPdf) : 1, rounding());
      }
    }
    radiance(tracer, new Ray(Vec3.Y, Vec3.Y), 0, recorded);
    for (FoundLight light : recorder.vertices().get(0).contributions().get(0).lights()) {
      assertThat(light.lightPdf()).isZero();
      assertThat(light.misWeight()).isEqualTo(1);
      assertThat(light.bsdfPdf()).isInfinite();
    }
  }

  /**
   * Balls are sampled uniformly in a cone, so all branches that hit one straight from the split
   * vertex have the same density of light sampling there.
   */
  @Test
  void branchesAreWeightedAgainstLightSamplingAtTheSplitVertex() {
    Scene scene =
        empty()
            .add(floor(), matte(.9))
            .add(sphere(2, 1, 2, .9), matte(.9))
            .addAreaLight(sphere(-.5, 1, 0, .7), glow(1))
            .addAreaLight(sphere(1.5, 1, -.5, .7), glow(2))
            .build();
    int branches = 0;
    for (LightSamplerKind kind : LightSamplerKind.values()) {
      PathOptions options = PathOptions.toDepth(5).splitInto(6).by(kind);
      PathTracer tracer = new PathTracer(scene, options);
      for (int sample = 0; sample < SAMPLES; sample++) {
        radiance(tracer, lookingDownAt(.2), sample, recorded);
        double[] densities = {Double.NaN, Double.NaN};
        int previous = -1;
        for (PathVertex vertex : recorder.vertices().subList(1, recorder.vertices().size())) {
          boolean isFirst = vertex.branch() != previous;
          previous = vertex.branch();
          if (isFirst && vertex.end() == End.EMITTER) {
            FoundLight light = vertex.contributions().get(0).lights().get(0);
            double known = densities[light.emitter()];
            if (!Double.isNaN(known)) {
              branches++;
              assertThat(light.lightPdf()).isCloseTo(known, within(1e-9 * known));
            }
            densities[light.emitter()] = light.lightPdf();
          }
        }
      }
    }
    assertThat(branches).isGreaterThan(SAMPLES);
  }

  /** Returns a material whose normals are tilted by 45°. */
  private static Material tilted() {
    Texture<Rgb> normals =
        Texture.constant(new Rgb(.5 + Math.sqrt(.125), .5, .5 + Math.sqrt(.125)));
    return new NormalMapped(matte(.2), new NormalMap(normals, 1));
  }

  /**
   * A path ends where its direction is below the surface, or by roulette. The light that was
   * sampled there is recorded also if it was blocked.
   */
  @ParameterizedTest
  @ValueSource(ints = {0, 5})
  void lightsOfLastVerticesAreRecorded(int firstRoulette) {
    Scene scene =
        empty()
            .add(floor(), tilted())
            .add(sphere(0, 1, 0, .2), matte(.2))
            .add(point(new Vec3(0, 2, 0), 1))
            .build();
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(5).rouletteFrom(firstRoulette));
    Set<End> ends = EnumSet.noneOf(End.class);
    for (int sample = 0; sample < SAMPLES; sample++) {
      RenderContext context = RenderContext.recordedBy(recorder);
      radiance(tracer, lookingDownAt(0), sample, context);
      List<PathVertex> vertices = recorder.vertices();
      assertThat(context.rays()).isEqualTo(vertices.size());
      PathVertex last = vertices.get(vertices.size() - 1);
      ends.add(last.end());
      for (PathVertex vertex : vertices) {
        assertThat(vertex.end() == End.CONTINUES).isEqualTo(vertex != last);
        assertThat(vertex.contributions()).hasSize(vertex.end() == End.ESCAPED ? 0 : 1);
      }
      if (last.end() == End.ABSORBED) {
        assertThat(last.scattered()).isEmpty();
      }
    }
    assertThat(ends).contains(firstRoulette == 0 ? End.ROULETTE : End.ESCAPED, End.ABSORBED);
  }

  /** No random number is used for two purposes, and each has its own place within a vertex. */
  @ParameterizedTest
  @ValueSource(ints = {1, 3})
  void numbersAreUsedOnce(int split) {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), matte(.9))
            .add(sphere(.3, .3, 0, .2), glass(1.5))
            .add(point(new Vec3(.5, 0, 0), 1))
            .addAreaLight(sphere(-.3, 0, .3, .1), glow(1))
            .build();
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(8).splitInto(split));
    boolean choosesLobes = false;
    for (int sample = 0; sample < SAMPLES; sample++) {
      UsedNumbers numbers = new UsedNumbers(sampler);
      numbers.startSample(0, 0, sample);
      tracer.radiance(INSIDE, numbers, recorded);
      numbers.assertUsedAsAgreed();
      boolean meetsGlass =
          recorder.vertices().stream()
              .anyMatch(v -> v.hit().isPresent() && v.hit().get().primitive() == 1);
      boolean scattersThere =
          recorder.vertices().stream()
              .anyMatch(v -> !v.scattered().isEmpty() && v.hit().get().primitive() == 1);
      assertThat(numbers.uses(Sampler.LOBE)).isEqualTo(meetsGlass && scattersThere);
      choosesLobes |= scattersThere;
      assertThat(numbers.uses(Sampler.DIRECTION)).isTrue();
      assertThat(numbers.uses(Sampler.LIGHT_CHOICE)).isTrue();
      assertThat(numbers.uses(Sampler.LIGHT_POINT)).isTrue();
    }
    assertThat(choosesLobes).isTrue();
  }

  /** A number equal to the probability of survival ends a path: numbers are below 1. */
  @Test
  void pathsSurviveOnNumbersBelowTheProbability() {
    PathTracer tracer =
        new PathTracer(furnace(Rgb.gray(.5)), PathOptions.toDepth(9).rouletteFrom(0));
    for (double u : new double[] {0, Math.nextDown(.5), .5, .75}) {
      Sampler constant =
          new Sampler() {
            @Override
            public void startSample(int x, int y, int sample) {}

            @Override
            public void startPart(int part, int parts) {}

            @Override
            public double get1d(int dimension) {
              return u;
            }

            @Override
            public Point2 get2d(int dimension) {
              return new Point2(.3, .6);
            }
          };
      tracer.radiance(INSIDE, constant, recorded);
      assertThat(recorder.vertices()).hasSize(u < .5 ? 10 : 3);
    }
  }

  /** No light sampling finds what a mirror shows, so it keeps its full radiance. */
  @ParameterizedTest
  @ValueSource(ints = {1, 4})
  void mirrorsShowLightsWithTheirFullRadiance(int split) {
    Rgb radiance = new Rgb(2, 3, 5);
    Scene scene =
        empty()
            .add(floor(), new Mirror(Texture.constant(ALBEDO)))
            .addAreaLight(
                new Rectangle(at(1.2, 4, .8).times(turned(180, 0, 0)), .6, .6, false),
                new Emission(Texture.constant(radiance), false))
            .build();
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).splitInto(split));
    assertThat(radiance(new PathTracer(scene, 0), lookingDownAt(0), 0, plain).isBlack()).isTrue();
    assertClose(radiance(tracer, lookingDownAt(0), 0, recorded), ALBEDO.times(radiance));
    assertThat(recorded.shadowRays()).isZero();
    assertThat(recorded.rays()).isEqualTo(2);
    List<PathVertex> vertices = recorder.vertices();
    assertThat(vertices).extracting(PathVertex::end).containsExactly(End.CONTINUES, End.EMITTER);
    assertThat(vertices.get(1).hit().orElseThrow().primitive()).isEqualTo(1);
    assertThat(vertices.get(1).hit().orElseThrow().bsdf()).isEmpty();
  }

  /** Lights that the camera sees have their own radiance, on their front side only. */
  @Test
  void visibleLightsHaveTheirRadiance() {
    Rgb radiance = new Rgb(2, 3, 5);
    Scene scene =
        empty()
            .addAreaLight(ceilingLamp(1, 1, 1), new Emission(Texture.constant(radiance), false))
            .build();
    PathTracer tracer = new PathTracer(scene, 0);
    assertThat(radiance(tracer, new Ray(Vec3.ZERO, Vec3.Y), 0, plain)).isEqualTo(radiance);
    Ray fromBehind = new Ray(new Vec3(0, 2, 0), Vec3.Y.negated());
    assertThat(radiance(tracer, fromBehind, 0, plain)).isEqualTo(Rgb.BLACK);
  }

  /** Rays from cameras are traced as any others. */
  @Test
  void cameraRaysAreRays() {
    Scene scene =
        empty()
            .add(sphere(0, 0, 3, 1), matte(.7))
            .add(sphere(.3, .2, 1.5, .3), glass(1.5))
            .add(point(new Vec3(-1, 2, 1), 3))
            .add(EnvironmentLight.uniform(Rgb.gray(.1)))
            .build();
    PathTracer path = new PathTracer(scene, 5);
    RayTracer ray = new RayTracer(scene, 3, 5);
    CameraRay aimed = new CameraRay();
    double light = 0;
    for (int sample = 0; sample < SAMPLES; sample++) {
      sampler.startSample(0, 0, sample);
      assertThat(scene.camera().aim(.4 + .002 * sample, .1 + .008 * sample, sampler, aimed))
          .isTrue();
      for (Integrator integrator : List.of(path, ray)) {
        Rgb expected = integrator.radiance(aimed.toRay(), sampler, plain);
        assertThat(integrator.radiance(aimed, sampler, plain)).isEqualTo(expected);
        light += expected.r();
      }
    }
    assertThat(light).isPositive();
  }

  /** Branches start at the split vertex and differ from each other; each is numbered. */
  @Test
  void branchesAreDifferentPathsFromOneVertex() {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), matte(.9))
            .add(sphere(.3, .3, 0, .2), glass(1.5))
            .addAreaLight(sphere(-.3, 0, .3, .1), glow(1))
            .build();
    int split = 4;
    PathTracer tracer =
        new PathTracer(scene, PathOptions.toDepth(6).splitInto(split).rouletteFrom(NEVER));
    for (int sample = 0; sample < SAMPLES; sample++) {
      radiance(tracer, INSIDE, sample, recorded);
      List<PathVertex> vertices = recorder.vertices();
      List<PathVertex> splits = vertices.stream().filter(v -> v.end() == End.SPLIT).toList();
      if (splits.isEmpty()) {
        continue;
      }
      PathVertex at = splits.get(0);
      assertThat(splits).hasSize(1);
      assertThat(vertices.subList(0, vertices.indexOf(at) + 1)).allMatch(v -> v.branch() == 0);
      List<Vec3> directions = new ArrayList<>();
      for (Scattering scattering : at.scattered()) {
        assertThat(directions).doesNotContain(scattering.wi());
        directions.add(scattering.wi());
      }
      assertThat(at.scattered()).hasSize(split);
      Vec3 origin = at.hit().orElseThrow().position();
      for (int branch = 0; branch < split; branch++) {
        int number = branch;
        PathVertex first =
            vertices.subList(vertices.indexOf(at) + 1, vertices.size()).stream()
                .filter(v -> v.branch() == number)
                .findFirst()
                .orElseThrow();
        assertThat(first.ray().direction()).isEqualTo(directions.get(branch));
        assertThat(first.ray().origin().minus(origin).length()).isLessThan(1e-12);
        assertThat(first.throughput().r() * split)
            .isCloseTo(at.throughput().r() * at.scattered().get(branch).weight().r(), rounding());
      }
    }
  }
}
