package io.github.lumbre.integrator;

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
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.TestScenes;
import io.github.lumbre.texture.Texture;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares multiply scattered light in enclosures, mirrors and glass with closed forms. */
class InterreflectionTest {
  private static final Ray FROM_THE_CENTER = new Ray(new Vec3(.1, .2, -.3), new Vec3(.6, .64, .48));

  /** A point light of intensity π in the center of a unit sphere: L = ρ (1−ρᴺ) / (1−ρ). */
  @ParameterizedTest
  @CsvSource({
    ".2, 1",
    ".2, 2",
    ".2, 5",
    ".5, 1",
    ".5, 2",
    ".5, 3",
    ".5, 5",
    ".5, 10",
    ".8, 5",
    ".8, 10",
    ".8, 50",
    ".9, 50",
    ".95, 100",
  })
  void integratingSphereIsTruncatedAtTheDepth(double albedo, int depth) {
    Scene scene =
        empty().add(sphere(0, 0, 0, 1), matte(albedo)).add(point(Vec3.ZERO, Math.PI)).build();
    double expected = albedo * (1 - Math.pow(albedo, depth)) / (1 - albedo);

    Estimate estimate = Estimate.of(new PathTracer(scene, depth), FROM_THE_CENTER, 512);

    assertThat(estimate.error()).isLessThan(5e-3 * expected);
    assertThat(estimate.z(expected)).isLessThan(Estimate.CRITICAL);
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "8", "50"})
  void rouletteFromAnyVertexHasTheSameMean(int vertex) {
    Scene scene = empty().add(sphere(0, 0, 0, 1), matte(.5)).add(point(Vec3.ZERO, Math.PI)).build();
    double expected = .5 * (1 - Math.pow(.5, 20)) / (1 - .5);

    PathOptions options = PathOptions.toDepth(20).rouletteFrom(vertex);
    Estimate estimate = Estimate.of(new PathTracer(scene, options), FROM_THE_CENTER, 512);

    assertThat(estimate.error()).isLessThan(5e-3 * expected);
    assertThat(estimate.z(expected)).isLessThan(Estimate.CRITICAL);
  }

  /** L = ρ/π [E + ρΦ / (A(1−ρ))], with E from a light half a radius off the center. */
  @ParameterizedTest
  @CsvSource({"0, 1, 0, 2.5", "0, -1, 0, .7222222222", "1, 0, 0, .8577708764"})
  void integratingSphereSpreadsAnOffCenterLight(double x, double y, double z, double expected) {
    Scene scene =
        empty().add(sphere(0, 0, 0, 1), matte(.5)).add(point(new Vec3(0, .5, 0), Math.PI)).build();
    Vec3 target = new Vec3(x, y, z);
    Vec3 eye = new Vec3(.2, .1, .3);

    Estimate estimate =
        Estimate.of(new PathTracer(scene, 200), new Ray(eye, target.minus(eye).normalized()), 1024);

    assertThat(estimate.error()).isLessThan(2e-3 * expected);
    assertThat(estimate.z(expected)).isLessThan(Estimate.CRITICAL);
  }

  @Test
  void depthZeroShowsEmittersOnly() {
    Scene scene =
        empty().add(floor(), matte(.5)).addAreaLight(ceilingLamp(1, 1, 1), glow(3)).build();

    assertThat(radianceOnce(scene, 0, lookingDownAt(0))).isZero();
    assertThat(radianceOnce(scene, 0, new Ray(new Vec3(0, .5, 0), Vec3.Y))).isEqualTo(3);
  }

  @Test
  void emitterSeenInAMirrorKeepsItsRadiance() {
    SceneBuilder builder = empty().addAreaLight(ceilingLamp(1, 1, 1), glow(3));
    builder.add(floor(), new Mirror(Texture.constant(Rgb.gray(.5))));

    assertThat(radianceOnce(builder.build(), 1, new Ray(new Vec3(0, .5, 0), new Vec3(0, -1, 0))))
        .isEqualTo(1.5);
    assertThat(radianceOnce(builder.build(), 0, new Ray(new Vec3(0, .5, 0), new Vec3(0, -1, 0))))
        .isZero();
  }

  @Test
  void emitterSeenThroughGlassKeepsItsRadiance() {
    Scene scene =
        empty()
            .addAreaLight(ceilingLamp(1, 1, 1), glow(3))
            .add(sphere(0, .7, 0, .1), glass(1))
            .build();
    Ray up = new Ray(new Vec3(.01, .5, .02), Vec3.Y);

    assertThat(radianceOnce(scene, 2, up)).isEqualTo(3);
    assertThat(radianceOnce(scene, 1, up)).isZero();
  }

  @Test
  void thousandPerfectMirrorsLoseNothing() {
    // A long corridor of two mirrors, with a light at its far end.
    Mirror mirror = new Mirror(Texture.constant(Rgb.WHITE));
    Scene scene =
        empty()
            .add(new Rectangle(Transform.IDENTITY, 3000, 3000, false), mirror)
            .add(ceilingLamp(3000, 3000, 1), mirror)
            .addAreaLight(
                new Rectangle(
                    TestScenes.at(0, .5, 1000.25).times(turned(-90, 0, 0)), 10, 10, false),
                glow(1))
            .build();
    Ray zigzag = new Ray(new Vec3(0, .5, 0), new Vec3(0, -1, 1).normalized());

    assertThat(radianceOnce(scene, 999, zigzag)).isZero();
    assertThat(radianceOnce(scene, 1001, zigzag)).isCloseTo(1, within(1001 * 4 * 0x1p-52));
  }

  /** Near normal incidence: 0.04, 0.9616, 0.998464, 0.99993856 for 1 to 4 surface events. */
  @ParameterizedTest
  @CsvSource({"1, .04", "2, .9616", "3, .998464", "4, .99993856"})
  void glassSphereUnderADomeAddsUpItsReflections(int events, double expected) {
    Scene scene = empty().add(sphere(0, 0, 5, 1), glass(1.5)).addBackground(Rgb.WHITE).build();
    Ray central = new Ray(Vec3.ZERO, Vec3.Z);

    Rgb whitted = new RayTracer(scene, 0, events).radiance(central, sampler(), new RenderContext());
    Estimate path = Estimate.of(new PathTracer(scene, events), central, 1024);

    assertThat(whitted.r()).isCloseTo(expected, within(1e-12));
    assertThat(path.z(expected)).isLessThan(Estimate.CRITICAL);
  }

  @ParameterizedTest
  @ValueSource(doubles = {.5, 2 / 3.0, 1, 1 + 1e-12, 1.33, 1.5, 2.4})
  void glassUnderAWhiteDomeIsWhiteFromOutsideAndInside(double ior) {
    // Nested and overlapping spheres. Inside overlapping ones, total internal reflection can trap a
    // ray forever: in 4096 samples, this happens once, in the sphere of index 2.4.
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), glass(ior))
            .add(sphere(.1, 0, .1, .5), glass(1.7))
            .add(sphere(.9, .1, 0, .6), glass(1.2))
            .addBackground(Rgb.WHITE)
            .build();
    PathTracer tracer = new PathTracer(scene, 2000);

    for (Vec3 eye :
        new Vec3[] {new Vec3(.3, .2, -4), new Vec3(.1, .02, .1), new Vec3(0, -.1, -.3)}) {
      Estimate estimate = Estimate.of(tracer, new Ray(eye, new Vec3(.05, .02, 1).normalized()), 16);
      assertThat(estimate.mean()).isCloseTo(1, within(ior == 2.4 ? 1e-3 : 1e-9));
    }
  }

  /**
   * Except for grazing light, at most 20 parts per million enter, and hardly any of them leave
   * again.
   */
  @Test
  void densestGlassUnderAWhiteDomeIsAWhiteMirror() {
    Scene scene = empty().add(sphere(0, 0, 0, 1), glass(1e6)).addBackground(Rgb.WHITE).build();
    for (double x : new double[] {0, .5, .98}) {
      Ray ray = new Ray(new Vec3(x, 0, -4), Vec3.Z);
      assertThat(Estimate.of(new PathTracer(scene, 2000), ray, 16).mean())
          .isCloseTo(1, within(1e-3));
    }
  }

  @Test
  void glassOfIndexOneIsInvisible() {
    SceneBuilder builder =
        empty().add(floor(), matte(.7)).addAreaLight(ceilingLamp(4, 4, 4), glow(1));
    Ray ray = new Ray(new Vec3(.3, 2, .1), new Vec3(.05, -1, .03).normalized());
    Estimate without = Estimate.of(new PathTracer(builder.build(), 1), ray, 256);
    builder.add(sphere(.4, 1.2, .1, .5), glass(1));

    Estimate with = Estimate.of(new PathTracer(builder.build(), 5), ray, 1024, 5);

    // Two glass surfaces before the floor and two after: only scattered rays find the light,
    // because glass occludes it for light sampling.
    assertThat(with.error()).isLessThan(2e-3 * with.mean());
    assertThat(with.z(without)).isLessThan(Estimate.CRITICAL);
  }

  /**
   * The mean radiance of a cube's faces, lit by one emissive face, is 0.0999124478 and
   * 0.1000218880.
   */
  @ParameterizedTest
  @CsvSource({"0, 1, 0, .0999124478", "1, 0, 0, .1000218880"})
  void cubeIsLitByOneOfItsFaces(double nx, double ny, double nz, double expected) {
    SceneBuilder builder = empty();
    Vec3[] turns = {
      new Vec3(180, 0, 0),
      new Vec3(0, 0, 90),
      new Vec3(0, 0, -90),
      new Vec3(90, 0, 0),
      new Vec3(-90, 0, 0),
    };
    for (Vec3 turn : turns) {
      // A wall 0.5 units from the center, which faces the center.
      Transform placed =
          Transform.rotationDegrees(turn).times(Transform.translation(new Vec3(0, -.5, 0)));
      builder.add(new Rectangle(placed, 1, 1, false), matte(.5));
    }
    builder.addAreaLight(
        new Rectangle(Transform.translation(new Vec3(0, -.5, 0)), 1, 1, false), glow(1));
    PathTracer tracer = new PathTracer(builder.build(), 1);

    // Average over the face: a 16×16 grid of points, seen from just before it.
    double sum = 0;
    double variance = 0;
    Vec3 normal = new Vec3(nx, ny, nz);
    Vec3 u = new Vec3(ny, nz, nx);
    Vec3 v = new Vec3(nz, nx, ny);
    int n = 16;
    for (int i = 0; i < n * n; i++) {
      Vec3 onFace =
          normal.times(.5 - 1e-6).plus((i % n + .5) / n - .5, u).plus((i / n + .5) / n - .5, v);
      Estimate estimate = Estimate.of(tracer, new Ray(onFace, normal), 32, i);
      sum += estimate.mean() / (n * n);
      variance += estimate.error() * estimate.error() / Math.pow(n, 4);
    }

    // The midpoint rule over the grid has an error of about 1e-3 here.
    assertThat(Math.sqrt(variance)).isLessThan(5e-4 * expected);
    assertThat(sum).isCloseTo(expected, within(2e-3 * expected));
  }

  static List<Light> lightsOfNoSize() {
    Vec3 down = new Vec3(-1, -2, 1).normalized();
    return List.of(point(new Vec3(1, 2, -1), 4), new DirectionalLight(down, Rgb.WHITE));
  }

  @ParameterizedTest
  @MethodSource("lightsOfNoSize")
  void rayModeIsPathModeOfDepthOneForOneLightOfNoSize(Light light) {
    Scene scene =
        empty().add(floor(), matte(.7)).add(sphere(0, .5, 0, .5), matte(.3)).add(light).build();
    Sampler sampler = sampler();
    RenderContext scratch = new RenderContext();
    for (int i = 0; i < 1000; i++) {
      sampler.startSample(i, 3, 0);
      Vec3 eye = new Vec3(0, 1, -4);
      Vec3 target = new Vec3(i % 40 / 20.0 - 1, i / 40 / 25.0, 0);
      Ray ray = new Ray(eye, target.minus(eye).normalized());

      Rgb path = new PathTracer(scene, 1).radiance(ray, sampler, scratch);
      Rgb whitted = new RayTracer(scene, 2, 2).radiance(ray, sampler, scratch);

      assertThat(whitted.r()).isCloseTo(path.r(), within(1e-12));
    }
  }

  @Test
  void deepGlassInRayModeHasTheSameMeanAsInPathMode() {
    Scene scene =
        empty()
            .add(floor(), matte(.7))
            .add(sphere(0, .6, 0, .5), glass(1.5))
            .add(sphere(.1, .6, 0, .3), glass(1.2))
            .addAreaLight(ceilingLamp(3, 3, 3), glow(1))
            .build();
    Ray ray = new Ray(new Vec3(.2, .8, -3), new Vec3(0, -.05, 1).normalized());

    Estimate whitted = Estimate.of(new RayTracer(scene, 0, 9), ray, 256, 1);
    Estimate seven = Estimate.of(new RayTracer(scene, 0, 7), ray, 256, 2);

    // Direct light on the floor through glass: the rest after 7 events is below 1e-3 here.
    assertThat(whitted.mean()).isPositive();
    assertThat(seven.mean()).isCloseTo(whitted.mean(), within(2e-2 * whitted.mean()));
  }

  @Test
  void ambientLightReachesDiffuseSurfacesAtEveryBounce() {
    Scene scene = empty().add(sphere(0, 0, 0, 1), matte(.5)).addAmbient(Rgb.gray(Math.PI)).build();

    assertThat(radianceOnce(scene, 1, FROM_THE_CENTER)).isCloseTo(.5, within(1e-15));
    assertThat(radianceOnce(scene, 3, FROM_THE_CENTER)).isCloseTo(.875, within(1e-15));
  }

  private static double radianceOnce(Scene scene, int depth, Ray ray) {
    return new PathTracer(scene, depth).radiance(ray, sampler(), new RenderContext()).r();
  }

  private static Sampler sampler() {
    Sampler sampler = new SobolSampler(0);
    sampler.startSample(1, 2, 3);
    return sampler;
  }
}
