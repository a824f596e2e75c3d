package io.github.lumbre.integrator;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.plastic;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.turned;
import static io.github.lumbre.testing.TestScenes.wall;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.Texture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Rays that pass straight through surfaces, in both modes, against closed forms. An estimate of
 * random passes has 256 × 64 samples, so that its standard error is below 0.004 of the difference
 * between its two outcomes: a bias of 0.03 of it is detected with a probability above 0.99. Values
 * without randomness are compared exactly.
 */
class TransparencyTest {
  private static final int SAMPLES = 64;
  private static final Ray FORWARD = new Ray(Vec3.ZERO, Vec3.Z);

  private static Integrator path(Scene scene) {
    return new PathTracer(scene, 8);
  }

  private static Integrator ray(Scene scene) {
    return new RayTracer(scene, 4, 8);
  }

  private static Material veil(double albedo, double opacity) {
    return plastic(albedo).set(OPACITY, ScalarChannel.of(opacity)).build();
  }

  /** Returns a pane without reflection that transmits a part of each color. */
  private static Material tinted(Rgb tint) {
    return plastic(1)
        .set(ROUGHNESS, ScalarChannel.of(0))
        .set(TRANSMISSION, ScalarChannel.of(1))
        .set(BASE_COLOR, ColorChannel.of(tint))
        .build();
  }

  /** Returns a small rectangle at a distance that faces the origin. */
  private static Rectangle pane(double z) {
    return new Rectangle(at(0, 0, z).times(turned(-90, 0, 0)), 1, 1, true);
  }

  private static void assertMean(Integrator integrator, Ray ray, double expected) {
    Estimate estimate = Estimate.of(integrator, ray, SAMPLES);
    assertThat(estimate.error()).isLessThan(.004);
    assertThat(estimate.z(expected))
        .as("%s, expected %s", estimate, expected)
        .isLessThan(Estimate.CRITICAL);
  }

  /** Returns the radiance of a single sample, for scenes in which all samples are equal. */
  private static Rgb radiance(Integrator integrator, Ray ray) {
    SobolSampler sampler = new SobolSampler(3);
    sampler.startSample(1, 2, 3);
    return integrator.radiance(ray, sampler, new RenderContext());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, .1, .5, .9, 1})
  void veilsMixTheirOwnLightWithThatBehindThem(double opacity) {
    // The veil emits its share of radiance 0.2, and scatters nothing.
    Scene scene =
        empty()
            .add(wall(1), veil(0, opacity), glow(.2 * opacity))
            .add(wall(2), Unlit.INSTANCE, glow(1))
            .build();
    double expected = .2 * opacity + 1 - opacity;
    assertMean(path(scene), FORWARD, expected);
    assertMean(ray(scene), FORWARD, expected);
  }

  @ParameterizedTest
  @ValueSource(doubles = {.25, .75})
  void veilsScatterTheirShare(double opacity) {
    Scene scene =
        empty()
            .add(wall(1), veil(.8, opacity))
            .add(wall(2), Unlit.INSTANCE, glow(1))
            .add(point(Vec3.ZERO, 1))
            .build();
    // A point light of intensity 1 at distance 1: irradiance 1 on the veil, radiance 0.8/π.
    double own = .8 / Math.PI;
    assertMean(ray(scene), FORWARD, opacity * own + 1 - opacity);
    assertMean(new PathTracer(scene, 1), FORWARD, opacity * own + 1 - opacity);
  }

  @Test
  void severalVeilsMultiply() {
    SceneBuilder scene = empty().add(wall(9), Unlit.INSTANCE, glow(1));
    for (int i = 1; i <= 3; i++) {
      scene.add(wall(i), veil(0, .2));
    }
    assertMean(path(scene.build()), FORWARD, Math.pow(.8, 3));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, .3, 1})
  void veilsDimPointLightsExactly(double opacity) {
    Ray down = new Ray(new Vec3(0, .5, 0), Vec3.Y.negated());
    Rectangle pane = new Rectangle(at(0, 1, 0), 10, 10, true);
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(pane, veil(0, opacity))
            .add(point(new Vec3(0, 2, 0), 4))
            .build();
    // Irradiance 4 / 2², radiance 0.5 / π of it, dimmed by the veil.
    double expected = (1 - opacity) * .5 / Math.PI;
    assertThat(radiance(ray(scene), down).g()).isCloseTo(expected, within(1e-12));
    assertThat(radiance(new PathTracer(scene, 1), down).g()).isCloseTo(expected, within(1e-12));
  }

  @Test
  void smoothPanesTintAndDimPointLightsByFresnelsLaw() {
    Ray down = new Ray(new Vec3(0, .5, 0), Vec3.Y.negated());
    Rgb tint = new Rgb(.9, .5, .1);
    Material glass =
        MetallicRoughness.builder()
            .set(METALLIC, ScalarChannel.of(0))
            .set(ROUGHNESS, ScalarChannel.of(0))
            .set(TRANSMISSION, ScalarChannel.of(1))
            .set(BASE_COLOR, ColorChannel.of(tint))
            .build();
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(new Rectangle(at(0, 1, 0), 10, 10, true), glass)
            .add(point(new Vec3(0, 2, 0), 4))
            .build();
    Rgb expected = tint.times((1 - .04) * .5 / Math.PI);
    for (Integrator integrator : new Integrator[] {ray(scene), new PathTracer(scene, 1)}) {
      Rgb found = radiance(integrator, down);
      assertThat(found.r()).isCloseTo(expected.r(), within(1e-12));
      assertThat(found.g()).isCloseTo(expected.g(), within(1e-12));
      assertThat(found.b()).isCloseTo(expected.b(), within(1e-12));
    }
  }

  @Test
  void pathsAreTintedOnTheAverage() {
    Scene scene =
        empty()
            .add(wall(1), tinted(new Rgb(.3, .6, .9)))
            .add(wall(2), Unlit.INSTANCE, glow(1))
            .build();
    assertMean(path(scene), FORWARD, .3);
    assertMean(ray(scene), FORWARD, .3);
  }

  /** The opacity of a mask is 0 or 1, here by the texture coordinate. */
  @Test
  void masksHaveHolesAndNothingInBetween() {
    ScalarChannel half = hit -> hit.u(0) < .5 ? 1 : 0;
    Material mask = plastic(0).set(OPACITY, half).build();
    Scene scene = empty().add(wall(1), mask).add(wall(2), Unlit.INSTANCE, glow(1)).build();
    double sum = 0;
    for (double x : new double[] {-1, 1}) {
      Ray one = new Ray(new Vec3(x, 0, 0), Vec3.Z);
      double found = radiance(path(scene), one).g();
      assertThat(found).isIn(0.0, 1.0);
      assertThat(radiance(ray(scene), one).g()).isEqualTo(found);
      sum += found;
    }
    assertThat(sum).isEqualTo(1);
  }

  @Test
  void backFacesOfSingleSidedSurfacesAreInvisibleToAllRays() {
    Material single = plastic(0).singleSided().build();
    Ray down = new Ray(new Vec3(0, .5, 0), Vec3.Y.negated());
    for (boolean facesUp : new boolean[] {true, false}) {
      Box lid = new Box(at(0, facesUp ? 1.5 : 0, 0), 4, 1, 4);
      // Shadow and camera rays leave the box through its back faces, and enter by its front faces.
      Scene scene =
          empty()
              .add(floor(), matte(.5))
              .add(lid, single)
              .add(point(new Vec3(0, 4, 0), 16))
              .build();
      double expected = facesUp ? 0 : .5 / Math.PI;
      assertThat(radiance(ray(scene), down).g()).isCloseTo(expected, within(1e-12));
      assertThat(radiance(new PathTracer(scene, 1), down).g()).isCloseTo(expected, within(1e-12));
    }
    Scene seen =
        empty()
            .add(new Box(at(0, 0, 0), 2, 2, 2), single)
            .add(wall(2), Unlit.INSTANCE, glow(1))
            .build();
    assertThat(radiance(path(seen), FORWARD).g()).isEqualTo(1);
    assertThat(radiance(ray(seen), FORWARD).g()).isEqualTo(1);
    Ray outside = new Ray(new Vec3(0, 0, -3), Vec3.Z);
    assertThat(radiance(path(seen), outside).g()).isZero();
  }

  /** Returns the color of white light after one unit of a medium with an absorption coefficient. */
  private static Rgb passed(Rgb sigma) {
    return new Rgb(Math.exp(-sigma.r()), Math.exp(-sigma.g()), Math.exp(-sigma.b()));
  }

  /** The box has the index of its surroundings, so that nothing is reflected or refracted. */
  @Test
  void mediaAbsorbByBeersLaw() {
    Rgb sigma = new Rgb(.1, .5, 2);
    Material medium =
        plastic(1)
            .set(TRANSMISSION, ScalarChannel.of(1))
            .set(IOR, 1)
            .set(ATTENUATION_COLOR, passed(sigma))
            .set(ATTENUATION_DISTANCE, 1)
            .build();
    Scene scene =
        empty()
            .add(new Box(at(0, 0, 3), 2, 2, 1.5), medium)
            .add(wall(9), Unlit.INSTANCE, glow(1))
            .build();
    for (Integrator integrator : new Integrator[] {path(scene), ray(scene)}) {
      Rgb found = radiance(integrator, FORWARD);
      assertThat(found.r()).isCloseTo(Math.exp(-.1 * 1.5), within(1e-9));
      assertThat(found.g()).isCloseTo(Math.exp(-.5 * 1.5), within(1e-9));
      assertThat(found.b()).isCloseTo(Math.exp(-2 * 1.5), within(1e-9));
    }
  }

  /** A transparent surface inside a medium does not shorten the way through it. */
  @Test
  void mediaAbsorbAlongTheWholeWayThroughVeils() {
    Material medium =
        plastic(1)
            .set(TRANSMISSION, ScalarChannel.of(1))
            .set(IOR, 1)
            .set(ATTENUATION_COLOR, passed(Rgb.gray(.5)))
            .set(ATTENUATION_DISTANCE, 1)
            .build();
    Rectangle inside = new Rectangle(at(0, 0, 3).times(turned(-90, 0, 0)), .5, .5, true);
    Scene scene =
        empty()
            .add(new Box(at(0, 0, 3), 2, 2, 1.5), medium)
            .add(inside, veil(0, 0))
            .add(wall(9), Unlit.INSTANCE, glow(1))
            .build();
    assertThat(radiance(path(scene), FORWARD).g()).isCloseTo(Math.exp(-.75), within(1e-9));
    assertThat(radiance(ray(scene), FORWARD).g()).isCloseTo(Math.exp(-.75), within(1e-9));
  }

  @Test
  void emittersThatScatterDoBoth() {
    Scene scene =
        empty()
            .add(wall(1), matte(.6), new Emission(Texture.constant(Rgb.gray(.3)), true))
            .add(point(Vec3.ZERO, 1))
            .build();
    double expected = .3 + .6 / Math.PI;
    assertThat(radiance(ray(scene), FORWARD).g()).isCloseTo(expected, within(1e-12));
    // Light sampling may select the emitter itself, which does not light a flat wall.
    assertMean(new PathTracer(scene, 1), FORWARD, expected);
  }

  /** In a closed box of albedo a that emits 1, the radiance is (1 - a^n) / (1 - a). */
  @Test
  void emittersThatScatterLightEachOther() {
    Scene scene =
        empty()
            .add(
                new Box(at(0, 0, 0), 4, 4, 4),
                matte(.5),
                new Emission(Texture.constant(Rgb.gray(.25)), true))
            .build();
    Estimate estimate = Estimate.of(new PathTracer(scene, 5), FORWARD, SAMPLES);
    double expected = .25 * (1 - Math.pow(.5, 6)) / .5;
    assertThat(estimate.z(expected)).as("%s %s", estimate, expected).isLessThan(Estimate.CRITICAL);
    assertThat(estimate.error()).isLessThan(.005);
  }

  @Test
  void onlyTheCameraSeesTheBackplate() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(wall(3), veil(0, .5))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .backplate(Backplate.plain(new Rgb(.125, .25, .5)))
            .build();
    Ray up = new Ray(Vec3.Y, Vec3.Y);
    assertThat(radiance(path(scene), up)).isEqualTo(new Rgb(.125, .25, .5));
    assertThat(radiance(ray(scene), up)).isEqualTo(new Rgb(.125, .25, .5));
    // It also shows through transparent surfaces.
    assertMean(path(scene), new Ray(Vec3.Y, Vec3.Z), .5 * .125);
    Scene lit =
        empty()
            .add(floor(), matte(.5))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .backplate(Backplate.plain(Rgb.BLACK))
            .build();
    assertMean(new PathTracer(lit, 1), new Ray(Vec3.Y, Vec3.Y.negated()), .5);
  }

  @Test
  void backplatesAreRecordedAsLightOfTheEnvironment() {
    Scene scene =
        empty()
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .backplate(Backplate.plain(new Rgb(.125, .25, .5)))
            .build();
    for (Integrator integrator : new Integrator[] {path(scene), ray(scene)}) {
      PathRecorder recorder = new PathRecorder();
      SobolSampler sampler = new SobolSampler(3);
      sampler.startSample(1, 2, 3);
      integrator.radiance(FORWARD, sampler, RenderContext.recordedBy(recorder));
      PathVertex only = recorder.vertices().get(0);
      assertThat(only.end()).isEqualTo(PathVertex.End.ESCAPED);
      assertThat(only.contributions()).hasSize(1);
      assertThat(only.contributions().get(0).lights().get(0).radiance())
          .isEqualTo(new Rgb(.125, .25, .5));
    }
  }

  @Test
  void eachPassedSurfaceCountsAsARay() {
    SceneBuilder builder = empty().add(wall(9), Unlit.INSTANCE, glow(1));
    for (int i = 1; i <= 5; i++) {
      builder.add(wall(i), veil(0, 0));
    }
    Scene scene = builder.build();
    for (Integrator integrator : new Integrator[] {path(scene), ray(scene)}) {
      RenderContext context = new RenderContext();
      SobolSampler sampler = new SobolSampler(3);
      sampler.startSample(1, 2, 3);
      assertThat(integrator.radiance(FORWARD, sampler, context)).isEqualTo(Rgb.WHITE);
      assertThat(context.rays()).isEqualTo(6);
    }
  }

  /**
   * Camera rays and shadow rays pass 65,536 surfaces; samples that meet more are rejected. The
   * scene is small, so that floats tell the surfaces apart: in one 100 wide, the boxes of about 18
   * overlap for the vector kernel, which then tests 15 times as many.
   */
  @ParameterizedTest
  @ValueSource(ints = {255, 256, 1000, 65_536, 65_537})
  void raysPassManySurfaces(int layers) {
    SceneBuilder builder = empty().add(pane(2), Unlit.INSTANCE, glow(1));
    SceneBuilder lit = empty().add(new Rectangle(at(0, 0, 0), 1, 1, true), matte(.5));
    lit.add(point(new Vec3(0, 2, 0), 4));
    for (int i = 1; i <= layers; i++) {
      double place = 1 + .5 * i / layers;
      builder.add(pane(place), veil(0, 0));
      lit.add(new Rectangle(at(0, place, 0), 1, 1, true), veil(0, 0));
    }
    Scene veils = builder.build();
    Scene veiled = lit.build();
    Ray down = new Ray(new Vec3(0, .5, 0), Vec3.Y.negated());
    for (Integrator integrator : new Integrator[] {path(veils), ray(veils)}) {
      assertPassed(radiance(integrator, FORWARD), 1, layers);
    }
    for (Integrator integrator : new Integrator[] {new PathTracer(veiled, 1), ray(veiled)}) {
      assertPassed(radiance(integrator, down), .5 / Math.PI, layers);
    }
  }

  private static void assertPassed(Rgb found, double expected, int layers) {
    assertThat(found.isFinite()).isEqualTo(layers <= 65_536);
    if (found.isFinite()) {
      assertThat(found.g()).isCloseTo(expected, within(1e-12));
    }
  }

  @Test
  void rejectedSamplesDoNotChangeTheNextOnes() {
    SceneBuilder builder = empty().add(wall(2), Unlit.INSTANCE, glow(1));
    for (int i = 0; i < 65_537; i++) {
      double z = 1 + i * 0x1p-17;
      builder.add(pane(z), veil(0, 0));
    }
    Scene scene = builder.build();
    for (Integrator integrator : new Integrator[] {path(scene), ray(scene)}) {
      RenderContext context = new RenderContext();
      SobolSampler sampler = new SobolSampler(3);
      for (int sample = 0; sample < 4; sample++) {
        sampler.startSample(1, 2, sample);
        context.startSample();
        boolean isBeside = sample % 2 == 0;
        Ray ray = new Ray(new Vec3(isBeside ? 2 : 0, 0, 0), Vec3.Z);
        Rgb found = integrator.radiance(ray, sampler, context);
        assertThat(found.isFinite()).isEqualTo(isBeside);
      }
    }
  }

  /** Light passes the faces of a half opaque box, and what is in it absorbs. */
  @Test
  void mediaDimPointLightsThatPassTheirBoundaries() {
    Material medium =
        plastic(1)
            .set(TRANSMISSION, ScalarChannel.of(1))
            .set(IOR, 1)
            .set(ATTENUATION_COLOR, passed(Rgb.gray(.5)))
            .set(ATTENUATION_DISTANCE, 1)
            .set(OPACITY, ScalarChannel.of(.25))
            .build();
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(new Box(at(0, 2, 0), 4, 1.5, 4), medium)
            .add(point(new Vec3(0, 4, 0), 16))
            .build();
    Ray down = new Ray(new Vec3(0, .5, 0), Vec3.Y.negated());
    double expected = .75 * .75 * Math.exp(-.75) * .5 / Math.PI;
    for (Integrator integrator : new Integrator[] {ray(scene), new PathTracer(scene, 1)}) {
      assertThat(radiance(integrator, down).g()).isCloseTo(expected, within(1e-9));
    }
  }

  static Stream<Arguments> integrators() {
    return Stream.of(1, 3)
        .flatMap(
            split ->
                Stream.of(
                    Arguments.of(
                        new PathTracer(everything(), PathOptions.toDepth(8).splitInto(split))),
                    Arguments.of(new RayTracer(everything(), 3, 6))));
  }

  /** Veils, panes, media, emitters that scatter, and a backplate. */
  private static Scene everything() {
    Material medium =
        plastic(1)
            .set(TRANSMISSION, ScalarChannel.of(1))
            .set(IOR, 1.5)
            .set(ATTENUATION_COLOR, passed(new Rgb(.1, .5, 2)))
            .set(ATTENUATION_DISTANCE, 1)
            .build();
    return empty()
        .add(floor(), matte(.7))
        .add(new Rectangle(at(0, 2, 0), 3, 3, true), veil(.5, .3))
        .add(new Rectangle(at(0, 3, 0), 3, 3, true), tinted(new Rgb(.3, .6, .9)))
        .add(new Box(at(.5, .7, .2), .8, .8, .8), medium)
        .add(
            new Rectangle(at(-1, 1, 0).times(turned(0, 0, -70)), 1, 1, true),
            veil(.4, .6),
            new Emission(Texture.constant(new Rgb(1, 2, 3)), true))
        .add(point(new Vec3(-1, 5, 1), 3))
        .add(EnvironmentLight.uniform(new Rgb(.1, .2, .3)))
        .addAmbient(Rgb.gray(.3))
        .backplate(Backplate.plain(new Rgb(.3, .2, .1)))
        .build();
  }

  @ParameterizedTest
  @MethodSource("integrators")
  void recordedContributionsAddUpToTheSampleBitForBit(Integrator integrator) {
    PathRecorder recorder = new PathRecorder();
    RenderContext recorded = RenderContext.recordedBy(recorder);
    RenderContext plain = new RenderContext();
    SobolSampler sampler = new SobolSampler(5);
    double light = 0;
    for (int sample = 0; sample < 400; sample++) {
      Ray ray =
          new Ray(
              new Vec3(.005 * sample - 1, 4, .002 * sample),
              new Vec3(.1, sample % 50 == 0 ? 1 : -1, -.1).normalized());
      sampler.startSample(0, 0, sample);
      Rgb expected = integrator.radiance(ray, sampler, plain);
      sampler.startSample(0, 0, sample);
      assertThat(integrator.radiance(ray, sampler, recorded)).isEqualTo(expected);
      Rgb sum = Rgb.BLACK;
      for (PathVertex vertex : recorder.vertices()) {
        for (Contribution contribution : vertex.contributions()) {
          sum = sum.plus(contribution.amount());
        }
      }
      assertThat(sum).as("sample %s", sample).isEqualTo(expected);
      light += expected.max();
    }
    assertThat(light).isPositive();
    assertThat(recorded.rays()).isEqualTo(plain.rays());
    assertThat(recorded.shadowRays()).isEqualTo(plain.shadowRays());
  }
}
