package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the space of a hierarchy's floats and its error bound. */
class UnitSpaceTest {
  private static final double[] SIZES = {1e-9, .1, 1, 3, 1e9};

  private static UnitSpace around(double x, double y, double z, double half) {
    return new UnitSpace(
        new double[] {x - half, x + half, y - half / 2, y + half / 2, z - half / 4, z + half / 4});
  }

  /**
   * All corners are within 1 and the farthest is beyond 0.5, so floats are used to their full
   * precision.
   */
  @Test
  void allThatThereIsFillsTheUnitCube() {
    for (double half : SIZES) {
      UnitSpace space = around(7 * half, -2 * half, half, half);
      assertThat(Math.getExponent(space.scale)).isEqualTo(Math.round(log2(space.scale)));
      assertThat(space.scale).isEqualTo(Math.scalb(1.0, Math.getExponent(space.scale)));
      assertThat(half * space.scale).isBetween(.5, 1.0);
      assertThat(space.centerX).isCloseTo(7 * half, within(1e-12 * half));
      assertThat(space.centerY).isCloseTo(-2 * half, within(1e-12 * half));
      assertThat(space.centerZ).isCloseTo(half, within(1e-12 * half));
      assertThat(space.centerReach / space.scale).isCloseTo(7 * half, within(1e-12 * half));
      for (int axis = 0; axis < 3; axis++) {
        double center = axis == 0 ? 7 * half : axis == 1 ? -2 * half : half;
        assertThat(space.nearest(axis, center + .3 * half) / space.scale)
            .isCloseTo(.3 * half, within(1e-6 * half));
      }
    }
  }

  private static double log2(double value) {
    return StrictMath.log(value) / StrictMath.log(2);
  }

  /** Each axis may be the longest. */
  @Test
  void longestSideSetsTheScale() {
    for (int axis = 0; axis < 3; axis++) {
      double[] box = {-1, 1, -1, 1, -1, 1};
      box[2 * axis] = -100;
      box[2 * axis + 1] = 100;
      assertThat(100 * new UnitSpace(box).scale).isBetween(.5, 1.0);
    }
  }

  @Test
  void boundsAreWidenedOutwardByAtLeastTheSlack() {
    SplittableRandom random = new SplittableRandom(1);
    UnitSpace space = around(5, -6, 7, 4);
    double slack = UnitSpace.slack(UnitSpace.INSIDE, space.coveredReach);
    double ulp = Math.ulp(1f);
    double[] centers = {5, -6, 7};
    for (int i = 0; i < 3000; i++) {
      int axis = i % 3;
      double world = centers[axis] + random.nextDouble(-4, 4);
      double local = (world - centers[axis]) * space.scale;
      assertThat((double) space.down(axis, world)).isBetween(local - slack - ulp, local - slack);
      assertThat((double) space.up(axis, world)).isBetween(local + slack, local + slack + ulp);
      assertThat((double) space.nearest(axis, world)).isCloseTo(local, within(ulp / 2));
    }
  }

  @Test
  void slackGrowsWithBothReaches() {
    double slack = UnitSpace.slack(1, 1);
    assertThat(slack).isPositive();
    // Four roundings of floats up to 2, and of doubles far from the center.
    assertThat(UnitSpace.slack(3, 1)).isGreaterThan(slack + 2 * 0x1p-24);
    assertThat(UnitSpace.slack(1, 1e6)).isGreaterThan(slack + 1e6 * 0x1p-52);
    assertThat(UnitSpace.slack(1, 1e6)).isLessThan(.01);
  }

  @Test
  void pointsInTheCubeAreInsideAndOthersAreNot() {
    double edge = UnitSpace.INSIDE;
    double beyond = Math.nextUp(edge);
    for (double sign : new double[] {-1, 1}) {
      assertThat(UnitSpace.isInside(sign * edge, sign * edge, sign * edge)).isTrue();
      assertThat(UnitSpace.isInside(sign * beyond, 0, 0)).isFalse();
      assertThat(UnitSpace.isInside(0, sign * beyond, 0)).isFalse();
      assertThat(UnitSpace.isInside(0, 0, sign * beyond)).isFalse();
    }
  }

  @Test
  void pointsSomeSizesAwayAreNearAndOthersAreNot() {
    UnitSpace space = around(300, 0, 0, 1);
    for (double sign : new double[] {-1, 1}) {
      assertThat(space.isNear(sign * 7, sign * 7, sign * 7)).isTrue();
      assertThat(space.isNear(sign * 9, 0, 0)).isFalse();
      assertThat(space.isNear(0, sign * 9, 0)).isFalse();
      assertThat(space.isNear(0, 0, sign * 9)).isFalse();
    }
    // The origin and the center, which is 300 * scale away from 0.
    double farthest = 300 * space.scale + 8 + 300 * space.scale;
    assertThat(space.nearReach).isBetween(farthest, farthest + 2);
  }

  /** So far from the origin that doubles have no precision left for floats. */
  @Test
  void nothingIsNearOutOfTheReachOfFloats() {
    UnitSpace far = around(0x1p50, 0, 0, 1);
    assertThat(far.isNear(0, 0, 0)).isFalse();
    assertThat(far.down(0, 0x1p50)).isZero();
    assertThat(far.up(0, 0x1p50)).isZero();
    assertThat(around(0x1p30, 0, 0, 1).isNear(0, 0, 0)).isTrue();
  }
}
