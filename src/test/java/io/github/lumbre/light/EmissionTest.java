package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;

/** Tests one-sided, two-sided and textured emission. */
class EmissionTest {
  private static final Texture<Rgb> COORDINATES = (u, v) -> new Rgb(u, v, 0);
  private static final TexturePoint POINT = new TexturePoint(.25, .75);
  private static final Rgb THERE = new Rgb(.25, .75, 0);

  @Test
  void oneSidedEmissionLeavesTheOutsideOnly() {
    Emission emission = new Emission(COORDINATES, false);
    assertThat(emission.towards(new Vec3(5, 1e-9, 0), Vec3.Y, POINT)).isEqualTo(THERE);
    assertThat(emission.towards(Vec3.X, Vec3.Y, POINT)).isEqualTo(Rgb.BLACK);
    assertThat(emission.towards(new Vec3(5, -1e-9, 0), Vec3.Y, POINT)).isEqualTo(Rgb.BLACK);
  }

  @Test
  void twoSidedEmissionLeavesBothSides() {
    Emission emission = new Emission(COORDINATES, true);
    assertThat(emission.towards(Vec3.Y, Vec3.Y, POINT)).isEqualTo(THERE);
    assertThat(emission.towards(Vec3.Y.negated(), Vec3.Y, POINT)).isEqualTo(THERE);
  }

  @Test
  void meanRadianceIsTheMeanOfTheStrongestComponentOverTheTexture() {
    assertThat(mean((u, v) -> new Rgb(0, .7, .2))).isCloseTo(.7, within(1e-12));
    assertThat(mean((u, v) -> Rgb.gray(u))).isCloseTo(.5, within(1e-12));
    assertThat(mean((u, v) -> Rgb.gray(v))).isCloseTo(.5, within(1e-12));
    assertThat(mean((u, v) -> Rgb.gray(u < .25 && v > .5 ? 8 : 0))).isCloseTo(1, within(1e-12));
    assertThat(mean((u, v) -> new Rgb(u, 1 - u, 0))).isCloseTo(.75, within(1e-12));
  }

  private static double mean(Texture<Rgb> radiance) {
    return new Emission(radiance, false).meanRadiance();
  }

  @Test
  void emissionIsBlackOnlyIfItIsConstantAndBlack() {
    assertThat(new Emission(Texture.constant(Rgb.BLACK), false).isBlack()).isTrue();
    assertThat(new Emission(Texture.constant(Rgb.gray(1e-300)), false).isBlack()).isFalse();
    assertThat(new Emission((u, v) -> Rgb.BLACK, false).isBlack()).isFalse();
  }
}
