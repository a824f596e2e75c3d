package io.github.lumbre.math;

import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests vector operations over the full range of doubles. */
class Vec3Test {
  private static final double EPS = 0x1p-52;

  private final SplittableRandom random = new SplittableRandom(1);

  @Test
  void normalizedIsOfUnitLengthAtAnyScale() {
    for (int exponent = -300; exponent <= 300; exponent++) {
      double scale = Double.parseDouble("1e" + exponent);
      for (int i = 0; i < 100; i++) {
        Vec3 v = inCube(random, 1);
        Vec3 unit = v.times(scale).normalized();
        assertThat(unit.length()).isCloseTo(1, within(2 * EPS));
        assertThat(unit.minus(v.normalized()).length()).isLessThan(4 * EPS);
      }
    }
  }

  @Test
  void normalizedReachesTheEndsOfTheRange() {
    assertThat(new Vec3(0, -Double.MIN_VALUE, 0).normalized()).isEqualTo(new Vec3(0, -1, 0));
    assertThat(new Vec3(Double.MAX_VALUE, 0, 0).normalized().x()).isCloseTo(1, within(EPS));
    assertThat(new Vec3(3, 4, 0).times(1e307).normalized().y()).isCloseTo(.8, within(2 * EPS));
  }

  @Test
  void normalizedZeroIsNotANumber() {
    assertThat(Vec3.ZERO.normalized().x()).isNaN();
  }

  @Test
  void normalizedIsUnchangedByPowersOfTwo() {
    for (int i = 0; i < 1000; i++) {
      Vec3 v = inCube(random, 1);
      assertThat(v.times(0x1p-480).normalized()).isEqualTo(v.times(0x1p500).normalized());
    }
  }

  @Test
  void lengthIsRightAtAnyScale() {
    Vec3 v = new Vec3(2, -3, 6);
    for (int exponent = -1070; exponent <= 1020; exponent++) {
      double scale = Math.scalb(1.0, exponent);
      assertThat(v.times(scale).length()).isEqualTo(7 * scale);
    }
    assertThat(new Vec3(0, 0, Double.MIN_VALUE).length()).isEqualTo(Double.MIN_VALUE);
    assertThat(Vec3.ZERO.length()).isZero();
    assertThat(new Vec3(1, Double.NEGATIVE_INFINITY, 1).length()).isInfinite();
    assertThat(new Vec3(1, Double.NaN, 1).length()).isNaN();
  }

  @Test
  void crossProductIsCyclicAndOrthogonal() {
    assertThat(Vec3.X.cross(Vec3.Y)).isEqualTo(Vec3.Z);
    assertThat(Vec3.Y.cross(Vec3.Z)).isEqualTo(Vec3.X);
    assertThat(Vec3.Z.cross(Vec3.X)).isEqualTo(Vec3.Y);
    Vec3 a = inCube(random, 1);
    Vec3 b = inCube(random, 1);
    assertThat(a.cross(b).dot(a)).isCloseTo(0, within(4 * EPS));
    assertThat(a.cross(b).dot(b)).isCloseTo(0, within(4 * EPS));
  }

  @Test
  void arithmeticIsByCoordinate() {
    Vec3 a = new Vec3(1, 2, 3);
    Vec3 b = new Vec3(-4, 5, 16);
    assertThat(a.plus(b)).isEqualTo(new Vec3(-3, 7, 19));
    assertThat(a.minus(b)).isEqualTo(new Vec3(5, -3, -13));
    assertThat(a.plus(2, b)).isEqualTo(new Vec3(-7, 12, 35));
    assertThat(a.dot(b)).isEqualTo(54);
    assertThat(a.negated()).isEqualTo(new Vec3(-1, -2, -3));
    assertThat(b.maxAbs()).isEqualTo(16);
    assertThat(b.get(0) + 10 * b.get(1) + 100 * b.get(2)).isEqualTo(1646);
  }
}
