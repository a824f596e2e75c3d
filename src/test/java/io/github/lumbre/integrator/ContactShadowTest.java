package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests contact shadows below a plate. */
class ContactShadowTest {
  /** A box of radius 1, so that the shadow reaches .5 high. */
  private static final Bounds3 BOX =
      new Bounds3(new Vec3(-.7, 0, -.7), new Vec3(.7, Math.sqrt(.08), .7));

  private static Scene plate(double height, double side) {
    return Scene.builder()
        .lookingAt(new Vec3(0, 1, -4), Vec3.ZERO, 40)
        .add(
            new Rectangle(Transform.translation(new Vec3(0, height, 0)), side, side, true),
            new Matte(Texture.constant(Rgb.WHITE)))
        .build();
  }

  private static double at(ContactShadow shadow, double x, double z) {
    return shadow.at(x, z, new RenderContext());
  }

  /**
   * Of rays in proportion to their cosine c, whose lengths are even up to the reach, a plate at the
   * part a of the reach blocks the integral of 2c(1 - a/c) over c from a to 1, which is (1 - a)².
   */
  @ParameterizedTest
  @ValueSource(doubles = {.02, .2, .5, .8})
  void belowAWidePlateItIsTheIntegral(double part) {
    ContactShadow shadow = new ContactShadow(plate(.5 * part, 100), BOX);
    assertThat(at(shadow, .1, -.2)).isCloseTo((1 - part) * (1 - part), within(.03));
  }

  @Test
  void itIsNoneOutOfReach() {
    ContactShadow shadow = new ContactShadow(plate(.1, 1), BOX);
    assertThat(at(shadow, 0, 0)).isGreaterThan(.4);
    assertThat(at(shadow, 1.15, 0)).isZero();
    assertThat(at(shadow, 0, -1e300)).isZero();
    assertThat(at(shadow, Double.NaN, 0)).isZero();
    ContactShadow above = new ContactShadow(plate(.51, 100), BOX);
    assertThat(at(above, 0, 0)).isZero();
  }

  /** Along a line, it falls without steps: grain of single rays would be steps of 1/64. */
  @Test
  void itHasNoGrain() {
    ContactShadow shadow = new ContactShadow(plate(.05, 1), BOX);
    double step = 1. / 512;
    for (double x = .1; x < 1; x += step) {
      double bend = at(shadow, x - step, .3) - 2 * at(shadow, x, .3) + at(shadow, x + step, .3);
      assertThat(bend).as("at " + x).isBetween(-.001, .001);
    }
  }

  /** What is computed where and when first does not matter. */
  @Test
  void itDoesNotDependOnTheOrder() {
    Scene scene = plate(.1, .8);
    ContactShadow shared = new ContactShadow(scene, BOX);
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      double x = 2 * random.nextDouble() - 1;
      double z = 2 * random.nextDouble() - 1;
      assertThat(at(shared, x, z)).isEqualTo(at(new ContactShadow(scene, BOX), x, z));
    }
  }
}
