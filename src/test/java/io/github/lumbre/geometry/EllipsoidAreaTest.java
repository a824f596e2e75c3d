package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares ellipsoid areas with numerical integrals. */
class EllipsoidAreaTest {
  private static final int STEPS = 200;

  /**
   * Returns the area by Fejér's first rule over the cosine of the colatitude and the trapezoidal
   * rule over the longitude. Both converge exponentially.
   */
  private static double byQuadrature(Transform m) {
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
      double colatitude = Math.PI * (i + .5) / STEPS;
      double sin = Math.sin(colatitude);
      double cos = Math.cos(colatitude);
      double ring = 0;
      for (int j = 0; j < STEPS; j++) {
        double longitude = 2 * Math.PI * j / STEPS;
        Vec3 n = new Vec3(sin * Math.cos(longitude), sin * Math.sin(longitude), cos);
        Vec3 u = new Vec3(-Math.sin(longitude), Math.cos(longitude), 0);
        Vec3 v = n.cross(u);
        ring += m.vector(u).cross(m.vector(v)).length();
      }
      sum += weight(i) * ring * 2 * Math.PI / STEPS;
    }
    return sum;
  }

  /** Returns the weight of a point in Fejér's rule. */
  private static double weight(int i) {
    double angle = Math.PI * (2 * i + 1) / STEPS;
    double sum = 0;
    for (int k = 1; k <= STEPS / 2; k++) {
      sum += Math.cos(k * angle) / (4.0 * k * k - 1);
    }
    return 2.0 / STEPS * (1 - 2 * sum);
  }

  @Test
  void areaIsTheIntegralOfTheElement() {
    for (Vec3 axes :
        List.of(
            new Vec3(1, 1, 1),
            new Vec3(1, 2, 3),
            new Vec3(3, 1, 2),
            new Vec3(1, 1, 2),
            new Vec3(2, 2, 1),
            new Vec3(.4, 1, .7),
            new Vec3(-1, 2, -.5),
            new Vec3(5, 6, 7))) {
      Transform m = Transform.scale(axes);
      double expected = byQuadrature(m);
      assertThat(EllipsoidArea.ofUnitSphere(m)).isCloseTo(expected, within(2e-13 * expected));
    }
  }

  @Test
  void areaOfTurnedAndShearedSpheresIsTheIntegralToo() {
    Random random = new Random(5);
    for (int i = 0; i < 20; i++) {
      Transform skew =
          Transform.scale(new Vec3(1, .6, 1.5))
              .times(Shapes.rotation(random))
              .times(Transform.scale(new Vec3(.8, 1.3, 1)))
              .times(Shapes.rotation(random));
      double expected = byQuadrature(skew);
      assertThat(EllipsoidArea.ofUnitSphere(skew)).isCloseTo(expected, within(2e-13 * expected));
    }
  }
}
