package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Texture;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

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

    // The variance of one sample is 1/p − 1 times its square: 1, where even choice has 9999.
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

  private static LightChoice choose(LightSampler selector, Vec3 point, Vec3 normal, double u) {
    LightChoice choice = new LightChoice();
    choice.moveTo(point, normal);
    selector.choose(u, choice);
    return choice;
  }

  private static double probability(LightSampler selector, Vec3 point, Vec3 normal, int emitter) {
    LightChoice asked = new LightChoice();
    asked.moveTo(point, normal);
    return selector.probability(asked, emitter);
  }
}
