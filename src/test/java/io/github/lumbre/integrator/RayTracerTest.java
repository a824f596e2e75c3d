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

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.TestScenes;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests Whitted's ray tracing against exact values. */
class RayTracerTest {
  private static final Rgb ALBEDO = new Rgb(.2, .4, .8);
  private static final Ray AT_A_BALL =
      new Ray(new Vec3(0, 0, -3), new Vec3(.12, .16, 1).normalized());

  private final PathRecorder recorder = new PathRecorder();
  private final RenderContext recorded = RenderContext.recordedBy(recorder);
  private final RenderContext plain = new RenderContext();
  private final SobolSampler sampler = new SobolSampler(3);

  private Rgb radiance(Integrator integrator, Ray ray, int sample, RenderContext context) {
    sampler.startSample(2, 1, sample);
    return integrator.radiance(ray, sampler, context);
  }

  private static void assertClose(Rgb found, Rgb expected) {
    assertThat(found.r()).isCloseTo(expected.r(), within(1e-12 * (1 + expected.r())));
    assertThat(found.g()).isCloseTo(expected.g(), within(1e-12 * (1 + expected.g())));
    assertThat(found.b()).isCloseTo(expected.b(), within(1e-12 * (1 + expected.b())));
  }

  /** All lights are added at each vertex; E = I cos θ / d² for points, and ambient irradiance. */
  @Test
  void allLightsAreAdded() {
    Rgb one = new Rgb(3, 5, 7);
    Rgb other = new Rgb(1, .5, 2);
    Rgb ambient = new Rgb(.1, .2, .3);
    Scene scene =
        empty()
            .add(floor(), new Matte(Texture.constant(ALBEDO)))
            .add(new PointLight(new Vec3(1, 2, -2), one, Falloff.INVERSE_SQUARE))
            .add(new PointLight(new Vec3(0, 2, 0), other, Falloff.INVERSE_SQUARE))
            .add(new PointLight(new Vec3(0, -2, 0), one, Falloff.INVERSE_SQUARE))
            .addAmbient(ambient)
            .build();
    Rgb irradiance = one.times(2 / 3.0 / 9).plus(other.times(.25)).plus(ambient);
    Rgb expected = ALBEDO.times(irradiance).times(1 / Math.PI);
    RayTracer tracer = new RayTracer(scene, 0, 0);
    assertClose(radiance(tracer, lookingDownAt(0), 0, plain), expected);
    assertThat(plain.rays()).isEqualTo(1);
    assertThat(plain.shadowRays()).isEqualTo(2);
    assertThat(plain.hitSomething()).isTrue();
    assertClose(radiance(tracer, lookingDownAt(0), 0, recorded), expected);
    PathVertex vertex = recorder.vertices().get(0);
    assertThat(vertex.end()).isEqualTo(End.ABSORBED);
    List<FoundLight> lights = vertex.contributions().get(0).lights();
    assertThat(lights)
        .extracting(FoundLight::source)
        .containsExactly(Source.AMBIENT, Source.LIGHT, Source.LIGHT, Source.LIGHT);
    assertThat(lights).extracting(FoundLight::emitter).containsExactly(-1, 0, 1, 2);
    assertThat(lights).allMatch(light -> light.misWeight() == 1 && !light.blocked());
    assertThat(lights.get(0).bsdfPdf()).isZero();
    assertThat(lights.get(0).wi()).isEqualTo(Vec3.ZERO);
    assertThat(lights.get(2).wi().minus(Vec3.Y).length()).isLessThan(1e-12);
    assertThat(lights.get(1).lightPdf()).isEqualTo(1);
    Ray sky = new Ray(Vec3.Y, Vec3.Y);
    plain.startSample();
    assertThat(radiance(tracer, sky, 0, plain)).isEqualTo(Rgb.BLACK);
    assertThat(plain.hitSomething()).isFalse();
  }

  /** Without ambient light, none is recorded. */
  @Test
  void lightsBehindThingsAreBlocked() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(sphere(0, 1, 0, .3), matte(.5))
            .add(point(new Vec3(0, 2, 0), 1))
            .build();
    RayTracer tracer = new RayTracer(scene, 0, 0);
    assertThat(radiance(tracer, lookingDownAt(0), 0, recorded)).isEqualTo(Rgb.BLACK);
    assertThat(recorder.vertices().get(0).contributions().get(0).lights())
        .singleElement()
        .matches(FoundLight::blocked);
    assertThat(radiance(tracer, lookingDownAt(3), 0, recorded).g()).isPositive();
    assertThat(recorder.vertices().get(0).contributions().get(0).lights())
        .singleElement()
        .matches(light -> !light.blocked());
  }

  /** One sample of an area light is its light divided by the density of the point. */
  @Test
  void areaLightsAreDividedByTheDensityOfTheirSamples() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .addAreaLight(ceilingLamp(1, 1, 2), glow(3))
            .addAreaLight(at(3), glow(1))
            .build();
    RayTracer tracer = new RayTracer(scene, 0, 0);
    double before = -1;
    for (int sample = 0; sample < 10; sample++) {
      double found = radiance(tracer, lookingDownAt(0), sample, recorded).r();
      List<FoundLight> lights = recorder.vertices().get(0).contributions().get(0).lights();
      assertThat(lights).hasSize(2);
      double sum = 0;
      for (FoundLight light : lights) {
        assertThat(light.f().r()).isCloseTo(.5 / Math.PI * light.wi().y(), within(1e-12));
        double arriving = light.blocked() ? 0 : light.radiance().r();
        sum += light.f().r() * arriving / light.lightPdf();
      }
      assertThat(found).isCloseTo(sum, within(1e-12)).isNotEqualTo(before);
      // Each light has numbers of its own: the two samples are not at the same place.
      Vec3 here = Vec3.ZERO.plus(2 / lights.get(0).wi().y(), lights.get(0).wi());
      Vec3 there = Vec3.ZERO.plus(3 / lights.get(1).wi().y(), lights.get(1).wi());
      assertThat(here.x() - there.x()).isNotCloseTo(0, within(1e-6));
      before = found;
    }
  }

  private static Rectangle at(double height) {
    return ceilingLamp(1, 1, height);
  }

  @Test
  void visibleLightsHaveTheirRadiance() {
    Scene scene =
        empty()
            .addAreaLight(ceilingLamp(1, 1, 1), glow(3))
            .add(EnvironmentLight.uniform(new Rgb(1, 2, 3)))
            .add(EnvironmentLight.uniform(new Rgb(.5, .25, 4)))
            .build();
    RayTracer tracer = new RayTracer(scene, 0, 0);
    Rgb seen = radiance(tracer, new Ray(Vec3.ZERO, Vec3.Y), 0, recorded);
    assertThat(seen).isEqualTo(Rgb.gray(3));
    PathVertex lamp = recorder.vertices().get(0);
    assertThat(lamp.end()).isEqualTo(End.EMITTER);
    assertThat(lamp.contributions().get(0).amount()).isEqualTo(Rgb.gray(3));
    assertThat(lamp.hit().orElseThrow().position()).isEqualTo(Vec3.Y);
    assertThat(lamp.hit().orElseThrow().bsdf()).isEmpty();
    assertThat(lamp.contributions().get(0).lights().get(0).emitter()).isZero();
    assertThat(lamp.contributions().get(0).lights().get(0).bsdfPdf()).isInfinite();
    assertThat(lamp.contributions().get(0).lights().get(0).wi()).isEqualTo(Vec3.Y);
    Ray sky = new Ray(Vec3.ZERO, Vec3.X);
    assertThat(radiance(tracer, sky, 0, recorded)).isEqualTo(new Rgb(1.5, 2.25, 7));
    PathVertex escaped = recorder.vertices().get(0);
    assertThat(escaped.end()).isEqualTo(End.ESCAPED);
    assertThat(escaped.contributions().get(0).amount()).isEqualTo(new Rgb(1.5, 2.25, 7));
    assertThat(escaped.contributions().get(0).lights())
        .extracting(FoundLight::emitter)
        .containsExactly(1, 2);
  }

  /** In a closed mirror, a path ends after exactly the given number of reflections. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 5})
  void mirrorsAreFollowedToTheirLimit(int limit) {
    Scene closed =
        empty().add(sphere(0, 0, 0, 1), new Mirror(Texture.constant(Rgb.gray(.5)))).build();
    Ray inside = new Ray(new Vec3(.1, .2, -.3), new Vec3(.6, .64, .48));
    RenderContext context = new RenderContext();
    assertThat(radiance(new RayTracer(closed, limit, 0), inside, 0, context)).isEqualTo(Rgb.BLACK);
    assertThat(context.rays()).isEqualTo(1 + limit);
    radiance(new RayTracer(closed, limit, 0), inside, 0, recorded);
    List<PathVertex> vertices = recorder.vertices();
    assertThat(vertices).hasSize(1 + limit);
    for (int i = 0; i <= limit; i++) {
      assertThat(vertices.get(i).end()).isEqualTo(i == limit ? End.DEPTH : End.CONTINUES);
      assertThat(vertices.get(i).throughput().r()).isCloseTo(Math.scalb(1, -i), within(1e-12));
    }
  }

  @Test
  void mirrorsShowLightsTimesTheirReflectance() {
    Scene scene =
        empty()
            .add(floor(), new Mirror(Texture.constant(ALBEDO)))
            .addAreaLight(
                new Rectangle(TestScenes.at(1.2, 4, .8).times(turned(180, 0, 0)), .6, .6, false),
                glow(2))
            .build();
    assertClose(radiance(new RayTracer(scene, 1, 0), lookingDownAt(0), 0, plain), ALBEDO.times(2));
    assertThat(radiance(new RayTracer(scene, 0, 9), lookingDownAt(0), 0, plain).isBlack()).isTrue();
    assertThat(plain.shadowRays()).isZero();
  }

  private static double carriedToTheEnds(List<PathVertex> vertices) {
    return vertices.stream()
        .filter(vertex -> vertex.end() != End.CONTINUES)
        .mapToDouble(vertex -> vertex.throughput().r())
        .sum();
  }

  /** Clear white glass splits the light and loses none: the throughputs of all ends add up to 1. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 9})
  void glassKeepsTheLight(int limit) {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), glass(1.5))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();
    RayTracer tracer = new RayTracer(scene, 0, limit);
    for (int sample = 0; sample < 8; sample++) {
      RenderContext context = RenderContext.recordedBy(recorder);
      double found = radiance(tracer, AT_A_BALL, sample, context).r();
      List<PathVertex> vertices = recorder.vertices();
      assertThat(carriedToTheEnds(vertices)).isCloseTo(1, within(1e-12));
      double escaped =
          vertices.stream()
              .filter(vertex -> vertex.end() == End.ESCAPED)
              .mapToDouble(vertex -> vertex.throughput().r())
              .sum();
      assertThat(found).isCloseTo(escaped, within(1e-12));
      // The path inside the ball splits at its first four vertices and chooses at later ones.
      assertThat(context.rays()).isEqualTo(vertices.size());
      if (limit <= 5) {
        assertThat(vertices).hasSize(1 + 2 * Math.min(limit, 4) + (limit == 5 ? 1 : 0));
      } else {
        assertThat(vertices.size()).isBetween(10, 9 + limit - 4);
      }
      if (limit >= 4) {
        assertThat(found).isGreaterThan(.99);
      }
    }
    assertThat(radiance(new RayTracer(scene, 9, 0), AT_A_BALL, 0, plain)).isEqualTo(Rgb.BLACK);
  }

  /** Reflectance and transmittance color the two rays of a split. */
  @Test
  void coloredGlassColorsItsRays() {
    Rgb reflectance = new Rgb(1, .5, .25);
    Rgb transmittance = new Rgb(.25, 1, .5);
    Glass tinted =
        new Glass(
            Texture.constant(reflectance),
            Texture.constant(transmittance),
            ScalarTexture.constant(1.5),
            ScalarTexture.constant(0));
    Scene scene = empty().add(sphere(0, 0, 0, 1), tinted).build();
    radiance(new RayTracer(scene, 0, 1), AT_A_BALL, 0, recorded);
    List<PathVertex> vertices = recorder.vertices();
    assertThat(vertices).hasSize(3);
    PathVertex refracted = vertices.get(1);
    PathVertex mirrored = vertices.get(2);
    double share = mirrored.throughput().r();
    assertThat(share).isBetween(.01, .2);
    assertClose(mirrored.throughput(), reflectance.times(share));
    assertClose(refracted.throughput(), transmittance.times(1 - share));
    assertThat(mirrored.end()).isEqualTo(End.ESCAPED);
    assertThat(refracted.end()).isEqualTo(End.DEPTH);
    Vec3 normal = vertices.get(0).hit().orElseThrow().geometricNormal();
    Vec3 in = AT_A_BALL.direction();
    Vec3 expected = in.plus(-2 * in.dot(normal), normal);
    assertThat(mirrored.ray().direction().minus(expected).length()).isLessThan(1e-12);
    // Snell's law.
    double sineIn = in.cross(normal).length();
    double sineOut = refracted.ray().direction().cross(normal).length();
    assertThat(sineIn / sineOut).isCloseTo(1.5, within(1e-12));
    assertThat(refracted.ray().direction().dot(normal)).isNegative();
  }

  /** Beyond the critical angle, a ray in glass is reflected whole and not split. */
  @Test
  void totalReflectionIsNotSplit() {
    Scene scene = empty().add(floorFacingDown(), glass(1.5)).build();
    Ray flat = new Ray(new Vec3(0, -.1, 0), new Vec3(.96, .28, 0));
    radiance(new RayTracer(scene, 0, 1), flat, 0, recorded);
    List<PathVertex> vertices = recorder.vertices();
    assertThat(vertices).hasSize(2);
    assertThat(vertices.get(1).throughput().r()).isCloseTo(1, within(1e-12));
    assertThat(vertices.get(1).ray().direction().y()).isCloseTo(-.28, within(1e-12));
  }

  /** A surface seen from behind, as from the inside of glass. */
  private static Rectangle floorFacingDown() {
    return new Rectangle(TestScenes.at(0, 0, 0), 1e4, 1e4, true);
  }

  /** No random number is used for two purposes, and each has its own place within a vertex. */
  @Test
  void numbersAreUsedOnce() {
    Glass rough =
        new Glass(
            Texture.constant(Rgb.WHITE),
            Texture.constant(Rgb.WHITE),
            ScalarTexture.constant(1.5),
            ScalarTexture.constant(.3));
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), rough)
            .add(sphere(0, 0, 3, 1), glass(1.5))
            .add(sphere(0, 3, 0, 1), matte(.5))
            .addAreaLight(ceilingLamp(1, 1, 9), glow(3))
            .addAreaLight(ceilingLamp(1, 1, 8), glow(3))
            .add(point(new Vec3(4, 4, -4), 1))
            .build();
    for (Ray ray : List.of(AT_A_BALL, new Ray(new Vec3(.1, .2, 6), Vec3.Z.negated()))) {
      for (int sample = 0; sample < 20; sample++) {
        UsedNumbers numbers = new UsedNumbers(sampler);
        numbers.startSample(0, 0, sample);
        new RayTracer(scene, 3, 8).radiance(ray, numbers, plain);
        numbers.assertUsedAsAgreed();
        assertThat(numbers.count()).isGreaterThan(3);
      }
    }
  }

  /** Returns rough glass of the scene format, and of models. */
  private static List<Material> roughGlass() {
    Glass rough = Glass.of(1.5).withRoughness(.3);
    MetallicRoughness volume =
        MetallicRoughness.builder()
            .set(MaterialParameter.METALLIC, 0)
            .set(MaterialParameter.ROUGHNESS, .6)
            .set(MaterialParameter.TRANSMISSION, 1)
            .set(MaterialParameter.ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY)
            .build();
    return List.of(rough, rough.withMultipleScattering(), volume);
  }

  /** Rough glass continues in one direction, up to the limit. */
  @ParameterizedTest
  @MethodSource("roughGlass")
  void roughGlassContinuesOnce(Material rough) {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), rough)
            .add(point(new Vec3(0, 4, -4), 1))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();
    for (int limit = 0; limit < 4; limit++) {
      int deepest = 0;
      for (int sample = 0; sample < 50; sample++) {
        radiance(new RayTracer(scene, 9, limit), AT_A_BALL, sample, recorded);
        List<PathVertex> vertices = recorder.vertices();
        assertThat(vertices.size()).isBetween(1, limit + 1);
        deepest = Math.max(deepest, vertices.size());
        // Light from the point and the environment is sampled at every rough vertex.
        assertThat(vertices.get(0).contributions().get(0).lights())
            .extracting(FoundLight::source)
            .containsOnly(Source.LIGHT);
        for (PathVertex vertex : vertices) {
          assertThat(vertex.throughput().max()).isLessThan(1.5);
        }
      }
      assertThat(deepest).isEqualTo(limit + 1);
    }
  }
}
