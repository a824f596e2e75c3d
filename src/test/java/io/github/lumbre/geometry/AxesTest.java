package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Tests the branch-free choices of an axis. */
class AxesTest {
  private static final double[] VALUES = {
    -Double.MAX_VALUE, -2, -1, -Double.MIN_VALUE, -0.0, 0, Double.MIN_VALUE, 1, 2, 1e300
  };

  @Test
  void signIsOneForNegativeNumbersAndMinusZero() {
    for (double value : VALUES) {
      boolean isNegative = Math.copySign(1, value) < 0;
      assertThat(Axes.sign(value)).as("%s", value).isEqualTo(isNegative ? 1 : 0);
    }
  }

  @Test
  void longestAxisIsTheLastOfEquals() {
    for (double x : VALUES) {
      for (double y : VALUES) {
        for (double z : VALUES) {
          double[] sizes = {Math.abs(x), Math.abs(y), Math.abs(z)};
          int expected = 0;
          for (int axis = 1; axis < 3; axis++) {
            expected = sizes[axis] >= sizes[expected] ? axis : expected;
          }
          assertThat(Axes.longest(x, y, z)).as("%s, %s, %s", x, y, z).isEqualTo(expected);
          assertThat(Axes.largest(x, y, z)).isEqualTo(sizes[expected]);
          assertThat(Axes.sum(x, y, z)).isEqualTo(sizes[0] + sizes[1] + sizes[2]);
        }
      }
    }
    assertThat(Axes.largest(1, Double.NaN, 2)).isNaN();
  }

  @Test
  void axesFollowInACircle() {
    assertThat(Axes.next(0)).isEqualTo(1);
    assertThat(Axes.next(1)).isEqualTo(2);
    assertThat(Axes.next(2)).isZero();
  }
}
