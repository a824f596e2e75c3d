package io.github.lumbre.light;

import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the spatial and directional bounds of lights. */
class LightBoundsTest {
  private static final Bounds3 BOX = Bounds3.of(new Vec3(-1, -2, -2), new Vec3(1, 2, 2));
  private static final double RADIUS = 3;

  private final SplittableRandom random = new SplittableRandom(82);

  private static double between(Vec3 a, Vec3 b) {
    return StrictMath.atan2(a.cross(b).length(), a.dot(b));
  }

  /**
   * The measure of a cone is the integral of its brightness over the sphere: 1 inside the spread,
   * then the cosine of the angle beyond it, up to the falloff angle.
   */
  @ParameterizedTest
  @CsvSource({
    "0, 1.5707963267948966",
    "3.141592653589793, 1.5707963267948966",
    "0, .3",
    "1, 0",
    "1, .5",
    ".7, 1.5",
    "2, 1.5",
    "3, .1"
  })
  void costIsIntensityTimesSizeTimesTheMeasureOfTheCone(double spread, double fall) {
    double reach = Math.min(spread + fall, Math.PI);
    int n = 20_000;
    double measure = 0;
    for (int i = 0; i < n; i++) {
      double inside = spread * (i + .5) / n;
      double beyond = spread + (reach - spread) * (i + .5) / n;
      measure += spread / n * StrictMath.sin(inside);
      measure += (reach - spread) / n * StrictMath.cos(beyond - spread) * StrictMath.sin(beyond);
    }
    double expected = 5 * RADIUS * RADIUS * 2 * Math.PI * measure;
    assertThat(new LightBounds(BOX, Vec3.X, spread, fall, 5).cost())
        .isCloseTo(expected, within(1e-7 * expected));
  }

  @Test
  void boundsOfAConeAreHardlyWiderThanIt() {
    LightBounds bounds = LightBounds.towards(BOX, Vec3.X, .3, .2, 1);
    assertThat(bounds.spread()).isBetween(.3, .3 + 1e-8);
    assertThat(bounds.fall()).isBetween(.2, .2 + 1e-8);
  }

  @Test
  void unionHoldsTheConesAndBoxesOfBoth() {
    for (int i = 0; i < 10_000; i++) {
      LightBounds one = any();
      LightBounds other = any();
      LightBounds both = one.union(other);
      for (LightBounds part : new LightBounds[] {one, other}) {
        assertThat(between(both.axis(), part.axis()) + part.spread())
            .isLessThanOrEqualTo(both.spread() + (both.spread() == Math.PI ? Math.PI : 1e-13));
        assertThat(both.fall()).isGreaterThanOrEqualTo(part.fall());
        assertThat(both.box().union(part.box())).isEqualTo(both.box());
      }
      assertThat(both.axis().length()).isCloseTo(1, within(1e-12));
      assertThat(both.intensity()).isEqualTo(one.intensity() + other.intensity());
    }
  }

  private LightBounds any() {
    double spread = random.nextDouble() < .5 ? random.nextDouble(1e-3) : random.nextDouble(Math.PI);
    return new LightBounds(
        Bounds3.of(inCube(random, 1), inCube(random, 1)),
        inCube(random, 1).normalized(),
        spread,
        random.nextDouble(1.5),
        2);
  }

  @Test
  void unionIsNoWiderThanBothTogether() {
    LightBounds one = new LightBounds(BOX, Vec3.X, .1, .5, 1);
    LightBounds other = new LightBounds(BOX, Vec3.Y, .3, .4, 1);
    LightBounds both = one.union(other);
    assertThat(both.spread()).isCloseTo((.1 + Math.PI / 2 + .3) / 2, within(1e-8));
    assertThat(other.union(one).spread()).isEqualTo(both.spread());
    LightBounds inside = new LightBounds(BOX, new Vec3(.1, 0, 1).normalized(), .1, .5, 1);
    LightBounds wide = new LightBounds(BOX, Vec3.Z, .5, .5, 1);
    assertThat(inside.union(wide).spread()).isEqualTo(.5);
    assertThat(inside.union(wide).axis()).isEqualTo(Vec3.Z);
  }

  @Test
  void unionOfConesThatLeaveLittleOutIsTheSphere() {
    LightBounds wide = new LightBounds(BOX, Vec3.X, 3, .5, 1);
    LightBounds across = new LightBounds(BOX, Vec3.Y, 2, .5, 1);
    assertThat(wide.union(across).spread()).isEqualTo(Math.PI);
    LightBounds opposite = new LightBounds(BOX, Vec3.X.negated(), .1, .5, 1);
    assertThat(new LightBounds(BOX, Vec3.X, .1, .5, 1).union(opposite).spread()).isEqualTo(Math.PI);
  }
}
