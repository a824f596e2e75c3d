package io.github.lumbre.light.internal;

import static io.github.lumbre.light.internal.LightSamplerTest.choose;
import static io.github.lumbre.light.internal.LightSamplerTest.probability;
import static io.github.lumbre.testing.Draws.direction;
import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the selection probabilities of the light tree. */
class LightTreeTest {
  private static final double SCENE = 5;

  /** Returns lights of all kinds, a few of them with unlimited range. */
  private static List<Light> lights(int count, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Light> lights = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Rgb color = Rgb.gray(Math.exp(random.nextDouble(-3, 3)));
      Vec3 position = inCube(random, SCENE);
      Transform place =
          Transform.translation(position)
              .times(Transform.rotationDegrees(inCube(random, 180)))
              .times(Transform.scale(new Vec3(1, 1, .5)));
      double size = Math.exp(random.nextDouble(-4, .5));
      Emission emission = new Emission(Texture.constant(color), random.nextInt(4) == 0);
      PointLight bulb = new PointLight(position, color, Falloff.INVERSE_SQUARE);
      lights.add(
          switch (i % 8) {
            case 0, 1, 2 -> new AreaLight(new Rectangle(place, size, .5, i % 3 == 0), emission);
            case 3 -> new AreaLight(new Sphere(place, size), emission);
            case 4 -> bulb;
            case 5, 6 -> spot(bulb, random);
            default ->
                i % 32 == 7
                    ? new DirectionalLight(direction(random), color)
                    : new PointLight(position, color, Falloff.NONE);
          });
    }
    return lights;
  }

  private static SpotLight spot(PointLight bulb, SplittableRandom random) {
    double angle = Math.exp(random.nextDouble(-7, Math.log(90)));
    return new SpotLight(bulb, direction(random), angle, random.nextDouble(0, angle));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 7, 8, 100, 1000})
  void probabilitiesSumToOne(int count) {
    List<Light> lights = lights(count, 1);
    LightSampler selector = LightSampler.over(lights);
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 30; i++) {
      Vec3 from = inCube(random, i % 3 == 0 ? 1000 : SCENE);
      Vec3 normal = i % 5 == 0 ? Vec3.ZERO : direction(random);
      double sum = 0;
      for (int index = 0; index < lights.size(); index++) {
        sum += probability(selector, from, normal, index);
      }
      assertThat(sum).isCloseTo(count == 0 ? 0 : 1, within(1e-12));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {6, 60})
  void choicesHaveTheirProbability(int count) {
    List<Light> lights = lights(count, 3);
    LightSampler selector = LightSampler.over(lights);
    SplittableRandom random = new SplittableRandom(4);
    int compared = 0;
    for (int i = 0; i < 30; i++) {
      Vec3 from = inCube(random, SCENE);
      Vec3 normal = i % 5 == 0 ? Vec3.ZERO : direction(random);
      int samples = 20_000;
      long[] counts = new long[lights.size()];
      double[] expected = new double[lights.size()];
      for (int sample = 0; sample < samples; sample++) {
        LightChoice choice = choose(selector, from, normal, random.nextDouble());
        counts[choice.emitter()]++;
        assertThat(choice.probability())
            .isCloseTo(probability(selector, from, normal, choice.emitter()), within(1e-14));
      }
      for (int index = 0; index < expected.length; index++) {
        expected[index] = samples * probability(selector, from, normal, index);
      }
      // At some points, one of few lights has the probability 1.
      if (Arrays.stream(expected).filter(e -> e > 10).count() > 1) {
        assertThat(ChiSquare.of(counts, expected).passes()).isTrue();
        compared++;
      }
    }
    assertThat(compared).isGreaterThan(10);
  }

  /** Every light that can light a point has a positive probability. */
  @Test
  void whatCanLightAPointCanBeChosen() {
    List<Light> lights = lights(500, 5);
    LightSampler selector = LightSampler.over(lights);
    SplittableRandom random = new SplittableRandom(6);
    int lit = 0;
    int left = 0;
    for (int i = 0; i < 1000; i++) {
      Vec3 from = inCube(random, i % 2 == 0 ? SCENE : 2 * SCENE);
      Vec3 normal = direction(random);
      for (int index = 0; index < lights.size(); index++) {
        Point2 u = new Point2(random.nextDouble(), random.nextDouble());
        Optional<LightSample> sample = lights.get(index).sample(from, u);
        double probability = probability(selector, from, normal, index);
        left += probability == 0 ? 1 : 0;
        if (sample.isPresent() && sample.get().wi().dot(normal) > 0) {
          lit++;
          assertThat(probability).isPositive();
        }
      }
    }
    assertThat(lit).isGreaterThan(50_000);
    assertThat(left).isGreaterThan(100_000);
  }

  /**
   * Spot lights of all widths, seen from just inside their edges, which are the hardest cones to
   * bound.
   */
  @ParameterizedTest
  @ValueSource(ints = {4, 40})
  void edgesOfConesCanBeChosen(int others) {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 2000; i++) {
      PointLight bulb = new PointLight(inCube(random, SCENE), Rgb.WHITE, Falloff.INVERSE_SQUARE);
      double degrees = Math.pow(10, random.nextDouble(-5, Math.log10(90)));
      Vec3 axis = direction(random);
      List<Light> lights = lights(others, i);
      lights.add(new SpotLight(bulb, axis, degrees, 0));
      double angle = Math.toRadians(degrees) * (1 - 1e-6);
      Vec3 along = axis.times(Math.cos(angle)).plus(Math.sin(angle), Frame.around(axis).tangent());
      Vec3 from = bulb.position().plus(random.nextDouble(.1, 9), along);
      assertThat(lights.get(others).sample(from, new Point2(0, 0))).isPresent();

      LightSampler selector = LightSampler.over(lights);

      assertThat(probability(selector, from, Vec3.ZERO, others)).isGreaterThan(1e-3);
    }
  }

  /** Far away, rounding is large beside the size of the lights. */
  @ParameterizedTest
  @ValueSource(doubles = {1e2, 1e4, 1e6, 1e9})
  void farPointsCanBeLitByAllLightsThatFaceThem(double distance) {
    SplittableRandom random = new SplittableRandom(8);
    Emission glow = new Emission(Texture.constant(Rgb.WHITE), false);
    List<Light> lights = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Transform place =
          Transform.translation(inCube(random, SCENE))
              .times(Transform.rotationDegrees(inCube(random, 180)));
      lights.add(new AreaLight(new Rectangle(place, .1, .1, false), glow));
    }
    LightSampler selector = LightSampler.over(lights);
    int lit = 0;
    for (int i = 0; i < 200; i++) {
      Vec3 from = direction(random).times(distance);
      // A surface that sees the lights at a grazing angle.
      Vec3 normal = Frame.around(from.normalized()).tangent();
      for (int index = 0; index < lights.size(); index++) {
        Optional<LightSample> sample = lights.get(index).sample(from, new Point2(.5, .5));
        if (sample.isPresent() && sample.get().wi().dot(normal) > 0) {
          lit++;
          assertThat(probability(selector, from, normal, index)).isPositive();
        }
      }
    }
    assertThat(lit).isGreaterThan(1000);
  }

  @Test
  void lightsBehindASurfaceOrFacingAwayAreLeftOut() {
    Emission glow = new Emission(Texture.constant(Rgb.WHITE), false);
    List<Light> lights = new ArrayList<>();
    for (int height = -2; height <= 2; height += 4) {
      for (int turn = 0; turn <= 180; turn += 180) {
        Transform place =
            Transform.translation(new Vec3(0, height, 0))
                .times(Transform.rotationDegrees(new Vec3(turn, 0, 0)));
        lights.add(new AreaLight(new Rectangle(place, 1, 1, false), glow));
      }
    }
    LightSampler selector = LightSampler.over(lights);

    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 3)).isEqualTo(1);
    assertThat(probability(selector, Vec3.ZERO, Vec3.Y.negated(), 0)).isEqualTo(1);
    assertThat(probability(selector, Vec3.ZERO, Vec3.ZERO, 0)).isCloseTo(.5, within(1e-12));
  }

  /**
   * Far from two lights of the same power, their probabilities are proportional to their
   * irradiance.
   */
  @Test
  void choicesFollowTheInverseSquare() {
    List<Light> lights =
        List.of(
            new PointLight(new Vec3(0, 1, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE),
            new PointLight(new Vec3(0, 3, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE));
    LightSampler selector = LightSampler.over(lights);

    // One eighth of the choices is uniform.
    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 0))
        .isCloseTo(.0625 + .875 * .9, within(1e-12));
  }

  /** Two near lights get at least a quarter, and a sun at least an eighth. */
  @Test
  void nearAndFarLightsAreChosenByIrradiance() {
    List<Light> lights =
        List.of(
            new DirectionalLight(Vec3.Y.negated(), Rgb.gray(3)),
            new PointLight(new Vec3(0, 1, 0), Rgb.gray(8), Falloff.INVERSE_SQUARE),
            new PointLight(new Vec3(0, 1, 0), Rgb.gray(1), Falloff.INVERSE_SQUARE));
    LightSampler selector = LightSampler.over(lights);

    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 0))
        .isCloseTo(.125 + .625 * 3 / (3 + 9), within(1e-12));
    assertThat(probability(selector, new Vec3(0, -2, 0), Vec3.Y, 0))
        .isCloseTo(.125 + .625 * 3 / (3 + 1), within(1e-12));
    assertThat(probability(selector, new Vec3(0, 2, 0), Vec3.Y, 0)).isEqualTo(1);
  }

  /**
   * The only local light is chosen where it is near; an environment image with mean ½ counts as 2π.
   */
  @Test
  void oneLampIsChosenByPlaceAgainstASky() {
    EnvironmentLight sky =
        EnvironmentLight.image(Frame.WORLD, (u, v) -> v > .5 ? Rgb.WHITE : Rgb.BLACK, 16, 8);
    Light bulb = new PointLight(new Vec3(0, 1, 0), Rgb.gray(2 * Math.PI), Falloff.INVERSE_SQUARE);
    LightSampler selector = LightSampler.over(List.of(sky, bulb));

    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 1))
        .isCloseTo(.25 + .625 / 2, within(1e-12));
    assertThat(probability(selector, new Vec3(0, -9, 0), Vec3.Y, 1))
        .isCloseTo(.25 + .625 / 101, within(1e-12));
  }

  /** Scattered rays find light of constant radiance best. */
  @Test
  void evenDomesAreNeverChosen() {
    Light bulb = new PointLight(new Vec3(0, 1, 0), Rgb.gray(Math.PI), Falloff.INVERSE_SQUARE);
    EnvironmentLight even = EnvironmentLight.uniform(Rgb.WHITE);
    LightSampler selector = LightSampler.over(List.of(even, bulb));
    for (double height : new double[] {0, .999, 9}) {
      Vec3 place = new Vec3(0, height, 0);
      assertThat(probability(selector, place, Vec3.Y, 0)).isZero();
      assertThat(probability(selector, place, Vec3.Y, 1)).isEqualTo(1);
    }
    Light sun = new DirectionalLight(Vec3.Y, Rgb.WHITE);
    LightSampler far = LightSampler.over(List.of(sun, even));
    assertThat(probability(far, Vec3.ZERO, Vec3.Y, 0)).isEqualTo(1);
    assertThat(probability(far, Vec3.ZERO, Vec3.Y, 1)).isZero();
    assertThat(LightSampler.over(List.of(even, even)).canChoose()).isFalse();
    assertThat(LightSampler.over(List.of(even, sun)).canChoose()).isTrue();
  }

  @Test
  void coincidentAndExtremeLightsHaveProbabilities() {
    List<Light> lights = new ArrayList<>();
    double[] sizes = {1e-300, 1e-150, 1, 1e100, 1e150};
    for (int i = 0; i < 200; i++) {
      double size = sizes[i % sizes.length];
      Vec3 position = new Vec3(size * (i % 3), 0, 0);
      lights.add(new PointLight(position, Rgb.gray(size), Falloff.INVERSE_SQUARE));
      Emission glow = new Emission(Texture.constant(Rgb.gray(1 / size)), false);
      lights.add(new AreaLight(new Sphere(Transform.translation(position), size), glow));
    }
    LightSampler selector = LightSampler.over(lights);
    for (double distance : new double[] {0, 1e-300, 1, 1e150, 1e300}) {
      Vec3 from = new Vec3(distance, distance, 0);
      double sum = 0;
      for (int index = 0; index < lights.size(); index++) {
        sum += probability(selector, from, Vec3.Y, index);
      }
      assertThat(sum).isCloseTo(1, within(1e-9));
      assertThat(choose(selector, from, Vec3.Y, 1 - 0x1p-53).emitter())
          .isBetween(0, lights.size() - 1);
    }
  }
}
