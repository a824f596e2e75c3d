package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Effort;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Compares the direct light of each kind of light with closed forms. Every estimate has a standard
 * error below 0.1 % of the reference. At the critical value of 4.89, the test therefore detects a
 * bias of 1 % with a probability above 0.99.
 */
class LightTransportTest {
  private static final double ALBEDO = .5;
  private static final double EPS = 0x1p-52;

  /** The irradiance under the center of a parallel rectangle (Howell's catalog of view factors). */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 0.752274688454107",
    "2, 2, 1, 1.74083950273421",
    "1, 1, 2, 0.230836797730171",
    "1, 1, 10, 0.00996678290640217",
    "1, 1, 100, 9.9996666783329e-5",
    "1, 1, .01, 3.14056468343318",
    "1, 1, 1e-6, 3.14159265357951",
    "1e-6, 1e-6, 1, 9.99999999999667e-13",
    "1, .1, 1, 0.0862304220629105",
    "1.3, 1.05, 5.488, 0.0446324746681278",
    "1e6, 1e6, 1, 3.14159265357951",
  })
  void rectangleLightsTheFloorBelowIt(double a, double b, double h, double irradiance) {
    Scene scene =
        empty().add(floor(), matte(ALBEDO)).addAreaLight(ceilingLamp(a, b, h), glow(1)).build();

    assertRadiance(scene, lookingDownAt(0, h / 1000), ALBEDO * irradiance / Math.PI);
  }

  /**
   * Over 12 orders of magnitude in each direction, the low-discrepancy mean is accurate to six
   * digits.
   */
  @ParameterizedTest
  @CsvSource({"1e-6, 9.99999999999667e-13", "1, 0.752274688454107", "1e6, 3.14159265357951"})
  void rectanglesOfAnySizeLightByTheirSolidAngle(double side, double irradiance) {
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .addAreaLight(ceilingLamp(side, side, 1), glow(1))
            .build();
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).by(MisHeuristic.LIGHT));
    Sampler sampler = new SobolSampler(Effort.seed(1));
    RenderContext scratch = new RenderContext();
    int samples = 1 << Effort.count(16, 22);
    double sum = 0;
    for (int sample = 0; sample < samples; sample++) {
      sampler.startSample(0, 0, sample);
      sum += tracer.radiance(lookingDownAt(0), sampler, scratch).r();
    }
    double expected = ALBEDO * irradiance / Math.PI;

    assertThat(sum / samples).isCloseTo(expected, within(1e-6 * expected));
  }

  @ParameterizedTest
  @CsvSource({"1, 0.435209875683552", "2, 0.652688257754038"})
  void rectangleLightsTheFloorBelowItsCorner(double side, double irradiance) {
    Shape lamp =
        new Rectangle(at(side / 2, 1, side / 2).times(turned(180, 0, 0)), side, side, false);
    Scene scene = empty().add(floor(), matte(ALBEDO)).addAreaLight(lamp, glow(1)).build();

    assertRadiance(scene, lookingDownAt(0), ALBEDO * irradiance / Math.PI);
  }

  /** A wall that rises from the floor, with a bottom corner at distance 1. */
  @Test
  void rectangleLightsTheFloorBesideIt() {
    Shape wall = new Rectangle(at(.5, .5, 1).times(turned(-90, 0, 0)), 1, 1, false);
    Scene scene = empty().add(floor(), matte(ALBEDO)).addAreaLight(wall, glow(1)).build();

    assertRadiance(scene, lookingDownAt(0), ALBEDO * 0.175094143856948 / Math.PI);
  }

  @Test
  void rectangleIsDarkFromBehindAndFromItsPlane() {
    Shape facesUp = new Rectangle(at(0, 1, 0), 1, 1, false);
    Shape inTheFloor = new Rectangle(at(3, 0, 0), 1, 1, false);
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .addAreaLight(facesUp, glow(1))
            .addAreaLight(inTheFloor, glow(1))
            .build();

    assertThat(Estimate.of(new PathTracer(scene, 1), lookingDownAt(0), 64).mean()).isZero();
  }

  /** π (R/d)² cos θ for a sphere wholly above the horizon; a clipped one numerically. */
  @ParameterizedTest
  @CsvSource({
    "1, 2, 0, .785398163397448",
    "1, 2, 30, .680174761587832",
    "1, 2, 60, .392699081698724",
    ".5, 3, 30, .0755749735097591",
    "1, 2, 90, .0905860737060795",
    "1, 1.000001, 0, 3.14158637041391",
    "1e-3, 1, 0, 3.14159265358979e-6",
    "1e-6, 1, 60, 1.5707963267949e-12",
  })
  void sphereLightsAPlane(double radius, double distance, double tilt, double irradiance) {
    Vec3 center = turned(tilt, 0, 0).vector(new Vec3(0, distance, 0));
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .addAreaLight(sphere(center.x(), center.y(), center.z(), radius), glow(1))
            .build();

    // The view ray comes from the side away from the light, and starts below it.
    double height = Math.min(1e-3, (distance - radius) / 10);
    assertRadiance(scene, lookingDownAt(0, height), ALBEDO * irradiance / Math.PI);
  }

  @Test
  void insideALampItIsDark() {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, .1), matte(ALBEDO))
            .addAreaLight(sphere(0, 0, 0, 1), glow(1))
            .build();
    Ray inside = new Ray(new Vec3(0, .5, 0), new Vec3(0, -1, 0));

    assertThat(Estimate.of(new PathTracer(scene, 1), inside, 16).mean()).isZero();
  }

  @Test
  void uniformDomeLightsAConvexSurfaceWithItsAlbedo() {
    Scene scene =
        empty()
            .add(sphere(0, 0, 0, 1), matte(ALBEDO))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();

    assertRadiance(scene, new Ray(new Vec3(.3, .2, -5), Vec3.Z), ALBEDO);
  }

  /** Next to a black sphere on the ground, 1 − R³/(x²+R²)^1.5 of the environment light remains. */
  @ParameterizedTest
  @CsvSource({
    ".5, .284458247, 1",
    "1, .646446609, 1",
    "2, .910557281, 1",
    "10, .999014815, 1",
    ".5, .284458247, 1e-6",
    "1, .646446609, 1e-6",
    "2, .910557281, 1e-6",
    ".5, .284458247, 1e-9",
    "1, .646446609, 1e9"
  })
  void sphereOnAPlaneHidesPartOfTheDome(double x, double share, double radius) {
    Scene scene =
        empty()
            .add(new Plane(Transform.IDENTITY, false), matte(ALBEDO))
            .add(sphere(0, radius, 0, radius), matte(0))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();

    assertRadiance(scene, lookingDownAt(x * radius, 1e-3 * radius), ALBEDO * share);
  }

  /** E = 2π / (n+2) under an environment light of radiance cosⁿ. */
  @ParameterizedTest
  @CsvSource({"0", "1", "2", "10"})
  void cosinePowerDomeLightsThePlane(int n) {
    int rows = 1024;
    EnvironmentLight dome =
        EnvironmentLight.image(
            Frame.WORLD,
            (u, v) -> Rgb.gray(v < .5 ? 0 : Math.pow(Math.sin((v - .5) * Math.PI), n)),
            64,
            rows);
    Scene scene = empty().add(floor(), matte(ALBEDO)).add(dome).build();

    assertRadiance(scene, lookingDownAt(0), ALBEDO * 2 / (n + 2));
  }

  @Test
  void pointLightFallsOffWithTheSquareOfDistance() {
    for (double height : new double[] {.1, 1, 10, 1000}) {
      for (double x : new double[] {0, 1, 50}) {
        Scene scene =
            empty().add(floor(), matte(ALBEDO)).add(point(new Vec3(0, height, 0), 3)).build();
        double d2 = height * height + x * x;
        double expected = ALBEDO / Math.PI * 3 * height / (d2 * Math.sqrt(d2));

        Estimate estimate = Estimate.of(new PathTracer(scene, 1), lookingDownAt(x), 1);

        assertThat(estimate.mean()).isCloseTo(expected, within(1e-12 * expected));
      }
    }
  }

  /** E = I cos θ / d², or I cos θ for lights without falloff, to the last digits. */
  @ParameterizedTest
  @EnumSource(Falloff.class)
  void irradianceOfOneLightIsExact(Falloff falloff) {
    for (double distance = .1; distance < 1e3; distance *= 3) {
      for (double degrees : new double[] {0, 10, 45, 80, 89, 89.9}) {
        double angle = Math.toRadians(degrees);
        Vec3 position = new Vec3(distance * Math.sin(angle), distance * Math.cos(angle), 0);
        Light light = new PointLight(position, Rgb.gray(3), falloff);
        Scene scene = empty().add(floor(), matte(ALBEDO)).add(light).build();
        double length = position.length();
        double fall = falloff == Falloff.NONE ? 1 : length * length;
        double expected = ALBEDO / Math.PI * 3 * (position.y() / length) / fall;

        assertThat(once(scene)).isCloseTo(expected, within(16 * EPS * expected));
      }
    }
  }

  @Test
  void irradianceOfADistantLightIsExact() {
    for (double degrees = 0; degrees < 90; degrees += 2.9) {
      double angle = Math.toRadians(degrees);
      Vec3 down = new Vec3(Math.sin(angle), -Math.cos(angle), 0).normalized();
      Light light = new DirectionalLight(down, Rgb.gray(3));
      Scene scene = empty().add(floor(), matte(ALBEDO)).add(light).build();
      double expected = ALBEDO / Math.PI * 3 * -down.y();

      assertThat(once(scene)).isCloseTo(expected, within(8 * EPS * expected));
    }
  }

  /** Returns the radiance of one sample whose ray hits the floor exactly at the origin. */
  private static double once(Scene scene) {
    Sampler sampler = new SobolSampler(0);
    sampler.startSample(1, 2, 3);
    Ray ray = new Ray(new Vec3(0, 1e-9, 0), new Vec3(0, -1, 0));
    return new PathTracer(scene, 1).radiance(ray, sampler, new RenderContext()).r();
  }

  @Test
  void coincidentLightsAddUp() {
    for (int k : new int[] {1, 2, 4, 7}) {
      SceneBuilder builder = empty().add(floor(), matte(ALBEDO));
      for (int i = 0; i < k; i++) {
        builder.add(point(new Vec3(0, 1, 0), Math.PI));
      }

      assertRadiance(builder.build(), lookingDownAt(0), k * ALBEDO);
    }
  }

  /** One wall is behind the point light, and another is behind the floor. */
  @Test
  void shadowsAreCastByWhatLiesBetweenOnly() {
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .add(ceilingLamp(50, 50, 3), matte(0))
            .add(new Rectangle(at(0, -1, 0), 50, 50, true), matte(0))
            .add(new Rectangle(at(0, 4, 0), 50, 50, true), matte(0))
            .add(point(new Vec3(0, 2, 0), 4 * Math.PI))
            .build();

    assertRadiance(scene, lookingDownAt(0), ALBEDO);
  }

  /**
   * A sphere occludes a distant light only if it lies in the light's direction, for any position of
   * the scene.
   */
  @Test
  void distantLightComesFromItsDirectionWhereverTheSceneStands() {
    Vec3 down = new Vec3(0, -1, 0);
    for (double x : new double[] {-100, 0, 100}) {
      Scene scene =
          empty()
              .add(new Rectangle(at(x, 0, 0), 9, 9, false), matte(ALBEDO))
              .add(sphere(.5 * x, 1, 0, .5), matte(0))
              .add(new DirectionalLight(down, Rgb.gray(Math.PI)))
              .build();

      double expected = x == 0 ? 0 : ALBEDO;
      assertThat(Estimate.of(new PathTracer(scene, 1), lookingDownAt(x), 1).mean())
          .isCloseTo(expected, within(1e-12));
    }
  }

  @Test
  void blackLightsChangeNothing() {
    SceneBuilder builder =
        empty().add(floor(), matte(ALBEDO)).addAreaLight(ceilingLamp(1, 1, 1), glow(1));
    Estimate without = Estimate.of(new PathTracer(builder.build(), 1), lookingDownAt(0), 16);
    builder.add(point(new Vec3(0, 2, 0), 0)).addBackground(Rgb.BLACK);

    assertThat(Estimate.of(new PathTracer(builder.build(), 1), lookingDownAt(0), 16))
        .isEqualTo(without);
  }

  @Test
  void imageOfTwoLampsIsTheSumOfTheirImages() {
    Shape first = ceilingLamp(1, 1, 1);
    Shape second = sphere(2, 1, 0, .5);
    Shape blocker = sphere(.7, .5, 0, .2);
    List<Estimate> estimates = new ArrayList<>();
    for (int mask = 1; mask <= 3; mask++) {
      SceneBuilder builder = empty().add(floor(), matte(ALBEDO)).add(blocker, matte(ALBEDO));
      builder.addAreaLight(first, glow((mask & 1) == 0 ? 0 : 1));
      builder.addAreaLight(second, glow((mask & 2) == 0 ? 0 : 2));
      estimates.add(Estimate.of(new PathTracer(builder.build(), 3), lookingDownAt(.2), 1024, mask));
    }
    Estimate sum =
        new Estimate(
            estimates.get(0).mean() + estimates.get(1).mean(),
            Math.hypot(estimates.get(0).error(), estimates.get(1).error()));

    assertThat(sum.error()).isLessThan(2e-3 * sum.mean());
    assertThat(sum.z(estimates.get(2))).isLessThan(Estimate.CRITICAL);
  }

  @Test
  void lightInsideAnOpaqueBodyStaysThere() {
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .add(sphere(0, 1, 0, .5), matte(ALBEDO))
            .add(point(new Vec3(0, 1, 0), 1))
            .addAreaLight(sphere(0, 1.1, 0, .1), glow(10))
            .build();

    assertThat(Estimate.of(new PathTracer(scene, 5), lookingDownAt(0), 64).mean()).isZero();
  }

  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void everyStrategyHasTheSameMean(MisHeuristic strategy) {
    // A large near light, a small light, an environment light and an emissive box, each partly
    // occluded.
    Shape box = new Box(at(-1, .3, .4).times(turned(10, 20, 30)), .3, .2, .4);
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .add(sphere(.5, .4, .2, .3), matte(.8))
            .addAreaLight(ceilingLamp(2, 1, 1), glow(1))
            .addAreaLight(sphere(1.5, .6, -.5, .3), glow(3))
            .add(box, Unlit.INSTANCE, new Emission(glow(2).radiance(), true))
            .add(EnvironmentLight.uniform(Rgb.gray(.2)))
            .build();
    Estimate both = Estimate.of(new PathTracer(scene, 3), lookingDownAt(0), 1024, 1);

    Estimate estimate =
        Estimate.of(
            new PathTracer(scene, PathOptions.toDepth(3).by(strategy)), lookingDownAt(0), 4096, 2);

    assertThat(both.error()).isLessThan(1e-3 * both.mean());
    assertThat(estimate.error()).isLessThan(2e-3 * both.mean());
    assertThat(estimate.z(both)).isLessThan(Estimate.CRITICAL);
  }

  @Test
  void transformedLampsKeepTheirEmissionAndGrowInArea() {
    Transform twice =
        at(0, 1, 0).times(turned(180, 0, 0)).times(Transform.scale(new Vec3(2, 1, 2)));
    Scene scene =
        empty()
            .add(floor(), matte(ALBEDO))
            .addAreaLight(new Rectangle(twice, 1, 1, false), glow(1))
            .build();

    assertRadiance(scene, lookingDownAt(0), ALBEDO * 1.74083950273421 / Math.PI);
  }

  private static void assertRadiance(Scene scene, Ray ray, double expected) {
    Estimate estimate = Estimate.of(new PathTracer(scene, 1), ray, 1024);

    assertThat(estimate.error()).isLessThan(1e-3 * expected);
    assertThat(estimate.z(expected)).isLessThan(Estimate.CRITICAL);
  }
}
