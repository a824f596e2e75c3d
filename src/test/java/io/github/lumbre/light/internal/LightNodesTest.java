package io.github.lumbre.light.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the importance of light tree nodes with irradiance. */
class LightNodesTest {
  private static final Vec3 PLACE = new Vec3(1, 2, 3);
  private static final double INTENSITY = 7;
  private static final double DISTANCE = 2.5;

  private static double importance(LightBounds bounds, Vec3 point, Vec3 normal) {
    LightChoice asked = new LightChoice();
    asked.moveTo(point, normal);
    return new LightNodes(bounds).importance(0, asked);
  }

  private static Vec3 turned(double angle) {
    return new Vec3(0, StrictMath.sin(angle), StrictMath.cos(angle));
  }

  /** For a point light, E = I cos θ / d² at any angle of the surface. */
  @ParameterizedTest
  @ValueSource(doubles = {0, .3, 1, 1.5})
  void importanceOfAPointIsItsIrradiance(double angle) {
    LightBounds bulb = LightBounds.allAround(Bounds3.of(PLACE), INTENSITY);
    Vec3 way = new Vec3(.48, -.6, .64);
    Vec3 across = new Vec3(.8, 0, -.6);
    Vec3 normal = way.times(-Math.cos(angle)).plus(Math.sin(angle), across);
    double irradiance = INTENSITY / (DISTANCE * DISTANCE);
    Vec3 point = PLACE.plus(DISTANCE, way);
    assertThat(importance(bulb, point, normal))
        .isCloseTo(irradiance * Math.cos(angle), within(1e-12));
    assertThat(importance(bulb, point, Vec3.ZERO)).isCloseTo(irradiance, within(1e-12));
    assertThat(importance(bulb, point, normal.negated())).isZero();
  }

  /**
   * Inside the spread, the importance is the full intensity; beyond it, the cosine of the angle to
   * its edge applies.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, .4, 1, 2})
  void importanceFallsWithTheCosineOfTheAngleBeyondTheSpread(double spread) {
    LightBounds cone =
        LightBounds.towards(Bounds3.of(PLACE), Vec3.Z, spread, Math.PI / 2, INTENSITY);
    double irradiance = INTENSITY / (DISTANCE * DISTANCE);
    for (double angle = 0; angle < Math.PI; angle += .1) {
      double beyond = Math.max(0, angle - spread);
      double expected = beyond < Math.PI / 2 ? irradiance * Math.cos(beyond) : 0;
      assertThat(importance(cone, PLACE.plus(DISTANCE, turned(angle)), Vec3.ZERO))
          .isCloseTo(expected, within(1e-7));
    }
  }

  /**
   * Inside the bounding sphere of lights, their direction is unknown, and the radius serves as the
   * distance.
   */
  @Test
  void importanceInTheSphereDependsOnItsRadiusAlone() {
    Vec3 half = new Vec3(3, 0, 4);
    Bounds3 box = Bounds3.of(PLACE.minus(half), PLACE.plus(half));
    LightBounds cone = LightBounds.towards(box, Vec3.X, .1, .2, INTENSITY);
    for (double distance : new double[] {0, 1e-3, 2, 5}) {
      for (Vec3 normal : new Vec3[] {Vec3.ZERO, Vec3.Z, Vec3.Z.negated()}) {
        assertThat(importance(cone, PLACE.plus(-distance, Vec3.Z), normal))
            .isCloseTo(INTENSITY / 25, within(1e-12));
      }
    }
  }
}
