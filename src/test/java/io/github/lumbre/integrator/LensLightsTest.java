package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Moments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests lights that are sampled through the lens against the part of the lens that sees them. */
class LensLightsTest {
  private static final double FOCUS = 4;
  private static final double RADIUS = .5;
  private static final double DISTANCE = 12;
  private static final double SIDE = .3;
  private static final double RADIANCE = 5;
  private static final double TANGENT = Math.tan(Math.toRadians(25));
  private static final int SAMPLES = 40_000;

  /** The part of the disk from which the lamp is seen through a point of the plane of focus. */
  private static final double PART =
      Math.pow(SIDE * FOCUS / (DISTANCE - FOCUS), 2) / (Math.PI * RADIUS * RADIUS);

  private static final Vec3 EYE = new Vec3(1, 2, 3);
  private static final Transform TURN = turned(20, -35, 10);
  private static final Frame AXES =
      new Frame(TURN.vector(Vec3.X), TURN.vector(Vec3.Y), TURN.vector(Vec3.Z));

  /** Where the lamp is beside the optical axis. */
  private double x = 2;

  private double y = -1;
  private Aperture aperture = Aperture.DISK;

  private SceneBuilder scene() {
    double size = aperture == Aperture.DISK ? RADIUS : 2 * RADIUS;
    return Scene.builder().seenBy(new ThinLensCamera(EYE, AXES, 1, 50, FOCUS, size, aperture));
  }

  private static Vec3 world(double x, double y, double z) {
    return EYE.plus(AXES.toWorld(new Vec3(x, y, z)));
  }

  /** A square that faces the lens. */
  private static Rectangle square(double x, double y, double z, double side) {
    Transform facing = TURN.times(turned(-90, 0, 0));
    Rectangle result =
        new Rectangle(Transform.translation(world(x, y, z)).times(facing), side, side, false);
    assertThat(result.onlyNormal().orElseThrow().dot(AXES.normal())).isCloseTo(-1, within(1e-12));
    return result;
  }

  private double u() {
    return (x / DISTANCE / TANGENT + 1) / 2;
  }

  private double v() {
    return (1 - y / DISTANCE / TANGENT) / 2;
  }

  /** Samples of the film point through which the middle of the lens sees the lamp's middle. */
  private Moments samples(Scene scene, PathOptions options, RenderContext context) {
    PathTracer tracer = new PathTracer(scene, options);
    IndependentSampler sampler = new IndependentSampler(5);
    CameraRay ray = new CameraRay();
    Moments moments = new Moments();
    for (int i = 0; i < SAMPLES; i++) {
      sampler.startSample(0, 0, i);
      assertThat(scene.camera().aim(u(), v(), sampler, ray)).isTrue();
      moments.add(tracer.radiance(ray, sampler, context).g());
    }
    return moments;
  }

  private Moments samples(Scene scene, MisHeuristic heuristic) {
    return samples(scene, PathOptions.toDepth(3).by(heuristic), new RenderContext());
  }

  private Scene lamp() {
    return scene().addAreaLight(square(x, y, DISTANCE, SIDE), glow(RADIANCE)).build();
  }

  /** A standard error is below 0.5 % with light sampling, so that 4 of them show 2 %. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void theMeanIsThePartOfTheLensThatSeesTheLamp(MisHeuristic heuristic) {
    for (double side : new double[] {0, 2, 4}) {
      x = side;
      assertMean(samples(lamp(), heuristic), RADIANCE * PART);
    }
  }

  /** Light samples of a parallel lamp are all equal, but for rounding. */
  private static void assertMean(Moments found, double expected) {
    if (found.variance() > 1e-20) {
      assertThat(found.z(expected)).isBetween(-4.0, 4.0);
    } else {
      assertThat(found.mean()).isCloseTo(expected, within(1e-9));
    }
  }

  /** Without light sampling, the variance is that of a hit with the probability of PART. */
  @Test
  void theVarianceIsAHundredthOfThatOfRandomLensPoints() {
    double chance = RADIANCE * RADIANCE * PART * (1 - PART);
    assertThat(samples(lamp(), MisHeuristic.BSDF).variance()).isBetween(.8 * chance, 1.2 * chance);
    assertThat(samples(lamp(), MisHeuristic.BOTH).variance()).isLessThan(.01 * chance);
  }

  /** Half of the disk's mask is open, and the lamp is seen from one of its four quarters. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void masksHideTheLampFromClosedParts(MisHeuristic heuristic) {
    aperture = Aperture.mask(new boolean[][] {{true, false}, {false, true}});
    double open = .5 * (2 * RADIUS) * (2 * RADIUS);
    double seen = Math.pow(SIDE * FOCUS / (DISTANCE - FOCUS), 2) / 2;
    assertMean(samples(lamp(), heuristic), RADIANCE * seen / open);
  }

  /** A screen hides half of the lamp, between the lens and the focus or between focus and lamp. */
  @ParameterizedTest
  @CsvSource({"1", "3", "5", "11"})
  void shadowRaysStartAtTheLens(double z) {
    double scale = z / DISTANCE;
    double wide = 3;
    Scene scene =
        scene()
            .addAreaLight(square(x, y, DISTANCE, SIDE), glow(RADIANCE))
            .add(square(x * scale + wide / 2, y * scale, z, wide), matte(0))
            .build();
    for (MisHeuristic heuristic : MisHeuristic.values()) {
      assertMean(samples(scene, heuristic), RADIANCE * PART / 2);
    }
  }

  /** Lamps at several distances, some of them not sampled, in the same cells of the grid. */
  @Test
  void lampsAreSelectedWithTheirProbabilities() {
    SceneBuilder builder = scene();
    for (int i = 0; i < 12; i++) {
      double z = 3 + i;
      double scale = z / DISTANCE;
      double radiance = 1 + i % 3 * 10;
      builder.addAreaLight(
          square(x * scale + .05 * i - .3, y * scale, z, .1 + .02 * i), glow(radiance));
      builder.addAreaLight(
          new Sphere(Transform.translation(world(x * scale, y * scale + .3, z + .5)), .1), glow(2));
    }
    Scene scene = builder.build();
    Moments expected = samples(scene, MisHeuristic.BSDF);
    for (MisHeuristic heuristic : MisHeuristic.values()) {
      assertThat(samples(scene, heuristic).z(expected)).isBetween(-4.0, 4.0);
    }
    assertThat(samples(scene, MisHeuristic.BOTH).variance()).isLessThan(.7 * expected.variance());
  }

  @Test
  void onlyBlurredLampsBehindTheFocusAreSampled() {
    assertThat(lensLights(lamp())).isTrue();
    assertThat(lensLights(with(square(x, y, 2, SIDE)))).isFalse();
    assertThat(lensLights(with(square(x, y, FOCUS, SIDE)))).isFalse();
    assertThat(lensLights(with(square(x, y, DISTANCE, 2)))).isFalse();
    Scene seenThroughACatcher =
        scene()
            .addAreaLight(square(x, y, DISTANCE, SIDE), glow(RADIANCE))
            .add(square(x, y, 8, 1), ShadowCatcher.of(Rgb.WHITE))
            .build();
    assertThat(lensLights(seenThroughACatcher)).isFalse();
    Aperture ofUnknownArea = Aperture.DISK::sample;
    aperture = ofUnknownArea;
    assertThat(lensLights(lamp())).isFalse();
  }

  private Scene with(Rectangle lamp) {
    return scene().addAreaLight(lamp, glow(RADIANCE)).build();
  }

  private static boolean lensLights(Scene scene) {
    return LensLights.of(ScatteredLight.sampling(scene)).isPresent();
  }

  /** Light that is sampled through the lens is reported with the camera ray. */
  @Test
  void recordedLightsAddUpToTheSample() {
    PathRecorder recorder = new PathRecorder();
    Scene scene = lamp();
    PathTracer tracer = new PathTracer(scene, 3);
    RenderContext recorded = RenderContext.recordedBy(recorder);
    RenderContext plain = new RenderContext();
    IndependentSampler sampler = new IndependentSampler(5);
    CameraRay ray = new CameraRay();
    int sampled = 0;
    for (int i = 0; i < 1000; i++) {
      sampler.startSample(0, 0, i);
      scene.camera().aim(u(), v(), sampler, ray);
      recorded.startSample();
      double found = tracer.radiance(ray, sampler, recorded).g();
      assertThat(found).isEqualTo(tracer.radiance(ray, sampler, plain).g());
      double sum = 0;
      for (Contribution contribution : recorder.vertices().get(0).contributions()) {
        for (FoundLight light : contribution.lights()) {
          sum += light.weighted().g();
          sampled += light.source() == Source.LENS ? 1 : 0;
        }
      }
      assertThat(sum).isCloseTo(found, within(1e-12));
    }
    assertThat(sampled).isGreaterThan(900);
  }

  /** Where a lamp is seen, alpha would count the camera rays alone. */
  @Test
  void transparentPicturesHaveNoLightThroughTheLens() {
    RenderSettings settings = RenderSettings.DEFAULT.toBuilder().transparent(true).build();
    assertThat(PathOptions.of(settings).transparent()).isTrue();
    assertThat(PathOptions.of(RenderSettings.DEFAULT).transparent()).isFalse();
    Moments found = samples(lamp(), PathOptions.toDepth(3).transparent(true), new RenderContext());
    double chance = RADIANCE * RADIANCE * PART * (1 - PART);
    assertThat(found.variance()).isBetween(.8 * chance, 1.2 * chance);
  }

  /** Whatever the sizes, radiance is finite. */
  @ParameterizedTest
  @CsvSource({"1e-200, 1e-200", "1e150, 1e100", "1e-9, 1e9", "1e9, 1e-9", "1e11, 1e-150"})
  void extremeLensesHaveFiniteRadiance(double focus, double size) {
    Scene scene =
        Scene.builder()
            .seenBy(new ThinLensCamera(EYE, AXES, 1, 50, focus, size, Aperture.DISK))
            .addAreaLight(square(x, y, DISTANCE, SIDE), glow(RADIANCE))
            .build();
    Moments found = samples(scene, PathOptions.toDepth(3), new RenderContext());
    assertThat(found.mean()).isBetween(0.0, RADIANCE);
    assertThat(found.variance()).isFinite();
  }
}
