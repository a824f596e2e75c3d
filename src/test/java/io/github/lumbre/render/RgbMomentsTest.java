package io.github.lumbre.render;

import static java.math.MathContext.DECIMAL128;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the numerical stability of the variance of colors. */
class RgbMomentsTest {
  private static final int COUNT = 20_000;

  /** The sum of squares minus the squared sum would lose all precision at 1e8. */
  @Test
  void varianceKeepsItsDigitsFarFromZero() {
    SplittableRandom random = new SplittableRandom(Effort.seed(50));
    double[] offsets = {1e8, 1, 0};
    double[][] values = new double[3][COUNT];
    RgbMoments found = new RgbMoments();
    Moments red = new Moments();
    for (int i = 0; i < COUNT; i++) {
      for (int channel = 0; channel < 3; channel++) {
        values[channel][i] = offsets[channel] + random.nextDouble();
      }
      found.add(new Rgb(values[0][i], values[1][i], values[2][i]));
      red.add(values[0][i]);
    }
    double expected = variance(values[0]);
    assertThat(found.variance().r()).isCloseTo(expected, within(1e-9 * expected));
    assertThat(red.variance()).isCloseTo(expected, within(1e-9 * expected));
    assertThat(found.variance().g()).isCloseTo(variance(values[1]), within(1e-12));
    assertThat(found.variance().b()).isCloseTo(variance(values[2]), within(1e-12));
  }

  /** Returns the variance, computed in two passes with 50 digits. */
  private static double variance(double[] values) {
    MathContext digits = new MathContext(50);
    BigDecimal sum = BigDecimal.ZERO;
    for (double value : values) {
      sum = sum.add(new BigDecimal(value), digits);
    }
    BigDecimal mean = sum.divide(new BigDecimal(values.length), digits);
    BigDecimal squares = BigDecimal.ZERO;
    for (double value : values) {
      BigDecimal difference = new BigDecimal(value).subtract(mean, digits);
      squares = squares.add(difference.multiply(difference, digits), digits);
    }
    return squares.divide(new BigDecimal(values.length - 1), DECIMAL128).doubleValue();
  }

  @Test
  void oneValueVariesNot() {
    RgbMoments moments = new RgbMoments();
    assertThat(moments.variance()).isEqualTo(Rgb.BLACK);
    moments.add(Rgb.WHITE);
    assertThat(moments.variance()).isEqualTo(Rgb.BLACK);
  }
}
