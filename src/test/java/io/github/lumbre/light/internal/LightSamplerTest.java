package io.github.lumbre.light.internal;

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
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the selection probabilities of light samplers. */
class LightSamplerTest {
  private static final Rgb TWO = new Rgb(1, 2, .5);

  @Test
  void equalPowersHaveTheSameChance() {
    for (int n : new int[] {1, 2, 3, 10, 10_000}) {
      double[] powers = new double[n];
      Arrays.fill(powers, 7);
      LightSampler selector = LightSampler.byPower(powers);
      double sum = 0;
      for (int i = 0; i < n; i++) {
        assertThat(choose(selector, Vec3.ZERO, Vec3.Z, (i + .5) / n).emitter()).isEqualTo(i);
        sum += probability(selector, Vec3.ZERO, Vec3.Z, i);
      }
      assertThat(sum).isCloseTo(1, within(1e-12));
      assertThat(choose(selector, Vec3.ZERO, Vec3.Z, 0).emitter()).isZero();
      assertThat(choose(selector, Vec3.ZERO, Vec3.Z, 1 - 0x1p-53).emitter()).isEqualTo(n - 1);
    }
  }

  @Test
  void choicesAreHalfByPowerAndHalfEven() {
    LightSampler selector = LightSampler.byPower(1, 0, 3);

    assertThat(probability(selector, Vec3.ZERO, Vec3.Z, 0))
        .isCloseTo(.5 / 3 + .5 / 4, within(1e-15));
    assertThat(probability(selector, Vec3.ZERO, Vec3.Z, 1)).isCloseTo(.5 / 3, within(1e-15));
    assertThat(probability(selector, Vec3.ZERO, Vec3.Z, 2))
        .isCloseTo(.5 / 3 + .5 * 3 / 4, within(1e-15));
  }

  @Test
  void strongLightAmongManyWeakOnesIsChosenEveryOtherTime() {
    double[] powers = new double[10_000];
    Arrays.fill(powers, 1e-9);
    powers[1234] = 1;
    LightSampler selector = LightSampler.byPower(powers);

    // The variance of one sample is 1/p − 1 times its square: 1, compared with 9999 for a uniform
    // choice.
    assertThat(1 / probability(selector, Vec3.ZERO, Vec3.Z, 1234) - 1).isCloseTo(1, within(2e-4));
  }

  @Test
  void powersThatCannotBeComparedMakeEvenChoices() {
    assertThat(probability(LightSampler.byPower(0, 0), Vec3.ZERO, Vec3.Z, 0)).isEqualTo(.5);
    assertThat(probability(LightSampler.byPower(Double.POSITIVE_INFINITY, 1), Vec3.ZERO, Vec3.Z, 1))
        .isEqualTo(.5);
  }

  @Test
  void powerIsFluxOfTheStrongestComponent() {
    Transform place = Transform.translation(new Vec3(1, 2, 3));
    Emission oneSided = new Emission(Texture.constant(TWO), false);
    Emission twoSided = new Emission(Texture.constant(TWO), true);
    PointLight bulb = new PointLight(Vec3.ZERO, TWO, Falloff.INVERSE_SQUARE);
    double cap = .5 * (1 - Elementary.cosDegrees(30));

    assertThat(new AreaLight(new Rectangle(place, 3, 2, false), oneSided).power(9))
        .isCloseTo(2 * Math.PI * 6, within(1e-12));
    assertThat(new AreaLight(new Sphere(place, 1), twoSided).power(9))
        .isCloseTo(2 * 2 * Math.PI * 4 * Math.PI, within(1e-9));
    assertThat(bulb.power(9)).isCloseTo(8 * Math.PI, within(1e-12));
    assertThat(new SpotLight(bulb, Vec3.Z, 30, 0).power(9))
        .isCloseTo(8 * Math.PI * cap, within(1e-12));
    assertThat(new PointLight(Vec3.ZERO, TWO, Falloff.NONE).power(3))
        .isCloseTo(2 * Math.PI * 9, within(1e-12));
    assertThat(new DirectionalLight(Vec3.Z, TWO).power(3)).isCloseTo(18 * Math.PI, within(1e-12));
    assertThat(EnvironmentLight.uniform(TWO).power(3))
        .isCloseTo(18 * Math.PI * Math.PI, within(1e-12));
  }

  @Test
  void powerOfAPicturedDomeIsItsMeanOverTheSphere() {
    EnvironmentLight half =
        EnvironmentLight.image(Frame.WORLD, (u, v) -> v > .5 ? TWO : Rgb.BLACK, 16, 8);

    assertThat(half.power(3)).isCloseTo(9 * Math.PI * Math.PI, within(1e-9));
  }

  @Test
  void pointThatMovesHasTheProbabilitiesOfANewOne() {
    List<Light> lights = List.of(bulb(1, 1), bulb(3, 2), EnvironmentLight.uniform(TWO));
    LightSampler first = LightSampler.over(lights);
    LightSampler second = LightSampler.over(List.of(bulb(1, 5), bulb(3, 2), lights.get(2)));
    LightChoice moved = new LightChoice();
    for (double height : new double[] {0, 2, 2.5}) {
      Vec3 point = new Vec3(.1, height, 0);
      moved.moveTo(point, Vec3.ZERO);
      for (LightSampler sampler : List.of(first, second, first)) {
        sampler.choose(.3, moved);
        for (int i = 0; i < 3; i++) {
          assertThat(sampler.probability(moved, i))
              .isEqualTo(probability(sampler, point, Vec3.ZERO, i));
        }
        assertThat(moved.probability())
            .isEqualTo(choose(sampler, point, Vec3.ZERO, .3).probability());
      }
    }
  }

  private static Light bulb(double height, double intensity) {
    return new PointLight(new Vec3(0, height, 0), Rgb.gray(intensity), Falloff.INVERSE_SQUARE);
  }

  private static List<Light> bulbs(double... intensities) {
    return Arrays.stream(intensities).mapToObj(i -> bulb(1, i)).toList();
  }

  @Test
  void methodFollowsTheNumberOfLightsOfLimitedReach() {
    Light sun = new DirectionalLight(Vec3.Y.negated(), TWO);
    assertThat(LightSampler.over(List.of()).method()).isEqualTo(LightSampler.Method.FIXED);
    assertThat(LightSampler.over(List.of(sun, sun, sun)).method())
        .isEqualTo(LightSampler.Method.FIXED);
    assertThat(LightSampler.over(bulbs(new double[8])).method())
        .isEqualTo(LightSampler.Method.ONE_BY_ONE);
    assertThat(LightSampler.over(bulbs(new double[9])).method())
        .isEqualTo(LightSampler.Method.HIERARCHY);
  }

  @Test
  void lightsInOnePlaceAreChosenByIntensity() {
    LightSampler selector = LightSampler.over(bulbs(1, 8));

    // One eighth of the choices is uniform.
    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 1))
        .isCloseTo(.0625 + .875 * 8 / 9, within(1e-12));
  }

  /** The grid over a texture may contain only black points, or infinitely bright ones. */
  @Test
  void lightsOfUnknownIntensityAreChosenByPlace() {
    for (double intensity : new double[] {0, Double.POSITIVE_INFINITY}) {
      LightSampler selector = LightSampler.over(List.of(bulb(1, intensity), bulb(3, intensity)));
      assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 0))
          .isCloseTo(.0625 + .875 * .9, within(1e-12));
    }
  }

  @Test
  void manyLightsInOnePlaceCountTogetherAgainstASun() {
    List<Light> lights = new ArrayList<>(bulbs(1, 2, 3, 4, 5, 6, 7, 8, 9));
    lights.add(new DirectionalLight(Vec3.Y.negated(), Rgb.gray(15)));
    LightSampler selector = LightSampler.over(lights);

    // The near lights get at least a quarter and the sun an eighth; the rest depends on the
    // irradiance.
    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 9))
        .isCloseTo(.125 + .625 * 15 / (15 + 45), within(1e-12));
  }

  @Test
  void sunThatOutshinesAllLeavesThemAQuarter() {
    List<Light> lights =
        List.of(bulb(1, 1e-200), new DirectionalLight(Vec3.Y.negated(), Rgb.gray(1e200)));
    LightSampler selector = LightSampler.over(lights);

    assertThat(probability(selector, Vec3.ZERO, Vec3.Y, 0)).isCloseTo(.25, within(1e-12));
  }

  @Test
  void equalLightsHaveHalfOpenHalvesOfTheNumbers() {
    LightSampler selector = LightSampler.over(bulbs(1, 1));

    assertThat(choose(selector, Vec3.ZERO, Vec3.Y, 0).emitter()).isZero();
    assertThat(choose(selector, Vec3.ZERO, Vec3.Y, .5 - 0x1p-54).emitter()).isZero();
    assertThat(choose(selector, Vec3.ZERO, Vec3.Y, .5).emitter()).isEqualTo(1);
  }

  @Test
  void lightsAreChosenEvenlyWhereOneOfFewIsInfinitelyNear() {
    LightSampler selector = LightSampler.over(List.of(bulb(1, 1), bulb(2, 5), bulb(3, 1)));

    for (int i = 0; i < 3; i++) {
      assertThat(probability(selector, Vec3.Y, Vec3.Y, i)).isCloseTo(1 / 3.0, within(1e-15));
      assertThat(choose(selector, Vec3.Y, Vec3.Y, (i + .5) / 3).emitter()).isEqualTo(i);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 7, 8, 9, 30})
  void extremeNumbersChooseOnlyWhatMayLightThePoint(int count) {
    SplittableRandom random = new SplittableRandom(count);
    Emission glow = new Emission(Texture.constant(Rgb.WHITE), false);
    List<Light> lights = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vec3 position = new Vec3(random.nextDouble(-9, 9), 2, random.nextDouble(-9, 9));
      Transform place =
          Transform.translation(position)
              .times(Transform.rotationDegrees(new Vec3(random.nextInt(2) * 180, 0, 0)));
      lights.add(new AreaLight(new Rectangle(place, .01, .01, false), glow));
    }
    LightSampler selector = LightSampler.over(lights);
    for (int i = 0; i < 300; i++) {
      Vec3 point =
          new Vec3(random.nextDouble(-9, 9), random.nextInt(2) * 4, random.nextDouble(-9, 9));
      for (double u : new double[] {0, .125, 1 - 0x1p-53}) {
        LightChoice choice = choose(selector, point, Vec3.ZERO, u);
        double probability = probability(selector, point, Vec3.ZERO, choice.emitter());
        assertThat(choice.probability()).isPositive().isCloseTo(probability, within(1e-15));
      }
    }
  }

  /** Pairs of panels are back to back: seen from below, those that face up are dark. */
  @Test
  void panelsThatFaceAwayAreNeverChosenAmongMany() {
    Emission glow = new Emission(Texture.constant(Rgb.WHITE), false);
    List<Light> lights = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      Transform place =
          Transform.translation(new Vec3((i / 2) * (i / 2), 2, 0))
              .times(Transform.rotationDegrees(new Vec3(isTurned(i) ? 180 : 0, 0, 0)));
      lights.add(new AreaLight(new Rectangle(place, .1, .1, false), glow));
    }
    LightSampler selector = LightSampler.over(lights);
    for (int i = 0; i < 20; i++) {
      double probability = probability(selector, new Vec3(33, 0, 0), Vec3.ZERO, i);
      assertThat(probability > 0).isEqualTo(isTurned(i));
    }
  }

  /** Returns whether a panel faces down: one of each pair does. */
  private static boolean isTurned(int panel) {
    return panel % 2 == panel / 2 % 2;
  }

  @Test
  void noLightIsChosenLessThanAnEighthAsOftenAsByPureChance() {
    List<Light> lights = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      lights.add(bulb(1 + i * i * i, i % 3 + .1));
    }
    LightSampler selector = LightSampler.over(lights);
    for (int i = 0; i < 12; i++) {
      assertThat(probability(selector, Vec3.ZERO, Vec3.Y, i))
          .isGreaterThanOrEqualTo(.125 / 12 - 1e-15);
    }
  }

  @Test
  void pointsAreOpenOnlyWithoutANormal() {
    LightSampler selector = LightSampler.over(bulbs(1, 1));
    for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
      LightChoice choice = new LightChoice();
      choice.moveTo(Vec3.ZERO, axis);
      assertThat(choice.isOpen()).isFalse();
      List<Light> pair =
          List.of(
              new PointLight(axis, TWO, Falloff.INVERSE_SQUARE),
              new PointLight(axis.negated(), TWO, Falloff.INVERSE_SQUARE));
      assertThat(probability(LightSampler.over(pair), Vec3.ZERO, axis, 1)).isZero();
      assertThat(probability(LightSampler.over(pair), Vec3.ZERO, Vec3.ZERO, 1)).isEqualTo(.5);
    }
    assertThat(choose(selector, Vec3.ZERO, Vec3.ZERO, 0).isOpen()).isTrue();
  }

  @Test
  void onlyEmitterIsChosenSurely() {
    LightChoice choice = new LightChoice();
    choice.set(5, .1);
    choice.setOnly();
    assertThat(choice.emitter()).isZero();
    assertThat(choice.probability()).isEqualTo(1);
  }

  @Test
  void onlySeveralSelectableEmittersNeedARandomNumber() {
    Light sky = EnvironmentLight.uniform(Rgb.WHITE);
    List<Light> bulb = bulbs(1);
    assertThat(LightSampler.over(bulb).isRandom()).isFalse();
    assertThat(LightSampler.over(List.of(sky, bulb.get(0))).isRandom()).isFalse();
    assertThat(LightSampler.over(bulbs(1, 1)).isRandom()).isTrue();
    assertThat(LightSampler.byPower(1).isRandom()).isFalse();
    assertThat(LightSampler.byPower(1, 2).isRandom()).isTrue();
    Light sun = new DirectionalLight(Vec3.Y, TWO);
    assertThat(LightSampler.over(List.of(sun, bulb.get(0))).isRandom()).isTrue();
  }

  static LightChoice choose(LightSampler selector, Vec3 point, Vec3 normal, double u) {
    LightChoice choice = new LightChoice();
    choice.moveTo(point, normal);
    selector.choose(u, choice);
    return choice;
  }

  static double probability(LightSampler selector, Vec3 point, Vec3 normal, int emitter) {
    LightChoice asked = new LightChoice();
    asked.moveTo(point, normal);
    return selector.probability(asked, emitter);
  }
}
