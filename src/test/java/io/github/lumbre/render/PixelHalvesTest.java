package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the error estimate from two halves of a pixel's samples. */
class PixelHalvesTest {
  /**
   * For halves of n1 and n2 samples: (m1 - m2)² n1 n2 / (n1 + n2)², divided by m1 m2 plus a floor.
   */
  @Test
  void errorOfOneChannelIsAThirdOfThatOfAll() {
    PixelHalves red = new PixelHalves(4, new Rgb(3, 0, 0), 2, new Rgb(1, 0, 0));
    PixelHalves grey = new PixelHalves(4, Rgb.grey(3), 2, Rgb.WHITE);
    double expected = 4.0 * 4 * 2 / 36 / (3 + PixelHalves.FLOOR);
    assertThat(grey.relativeSquaredError()).isCloseTo(expected, within(1e-15));
    assertThat(red.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
    PixelHalves green = new PixelHalves(4, new Rgb(0, 3, 0), 2, new Rgb(0, 1, 0));
    PixelHalves blue = new PixelHalves(4, new Rgb(0, 0, 3), 2, new Rgb(0, 0, 1));
    assertThat(green.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
    assertThat(blue.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
  }

  @Test
  void evenPixelsHaveNoError() {
    assertThat(new PixelHalves(8, Rgb.grey(5), 8, Rgb.grey(5)).relativeSquaredError()).isZero();
    assertThat(new PixelHalves(8, Rgb.BLACK, 8, Rgb.BLACK).relativeSquaredError()).isZero();
  }

  /** Rounding may make the mean of a dark second half slightly negative. */
  @Test
  void slightlyNegativeMeansAreComparedWithTheFloor() {
    PixelHalves halves = new PixelHalves(1, Rgb.grey(1), 1, Rgb.grey(-1e-6));
    double expected = (1 + 1e-6) * (1 + 1e-6) / 4 / PixelHalves.FLOOR;
    assertThat(halves.relativeSquaredError()).isCloseTo(expected, within(1e-9 * expected));
  }

  /**
   * The cautious error divides by m √(m1 m2) plus a floor, for the smaller mean m: it does not
   * depend on the order of halves of equal size, and is not below the other estimate.
   */
  @Test
  void cautiousErrorDividesByTheSmallerMean() {
    double[] means = {0, .01, 1, 4, 9};
    for (double m1 : means) {
      for (double m2 : means) {
        PixelHalves halves = new PixelHalves(4, new Rgb(m1, 0, 0), 4, new Rgb(m2, 0, 0));
        PixelHalves turned = new PixelHalves(4, new Rgb(0, m2, 0), 4, new Rgb(0, m1, 0));
        PixelHalves blue = new PixelHalves(4, new Rgb(0, 0, m1), 4, new Rgb(0, 0, m2));
        double divisor = Math.min(m1, m2) * Math.sqrt(m1 * m2) + PixelHalves.FLOOR;
        double expected = (m1 - m2) * (m1 - m2) / 4 / divisor / 3;
        assertThat(halves.cautiousSquaredError()).isCloseTo(expected, within(1e-12));
        assertThat(turned.cautiousSquaredError()).isCloseTo(expected, within(1e-12));
        assertThat(blue.cautiousSquaredError()).isCloseTo(expected, within(1e-12));
        assertThat(halves.cautiousSquaredError())
            .isGreaterThanOrEqualTo(halves.relativeSquaredError() - 1e-12);
      }
    }
    PixelHalves negative = new PixelHalves(1, Rgb.grey(1), 1, Rgb.grey(-1e-6));
    assertThat(negative.cautiousSquaredError()).isCloseTo(.25 / PixelHalves.FLOOR, within(1e-3));
  }

  /** Uniform numbers around 100 have the variance 1/12, and the mean of n of them has 1/(12 n). */
  @Test
  void errorIsUnbiasedForIndependentSamples() {
    SplittableRandom random = new SplittableRandom(9);
    int runs = 4_000;
    double sum = 0;
    for (int run = 0; run < runs; run++) {
      Rgb first = Rgb.BLACK;
      Rgb second = Rgb.BLACK;
      for (int i = 0; i < 8; i++) {
        first = first.plus(uniform(random).times(1 / 8.0));
      }
      for (int i = 0; i < 5; i++) {
        second = second.plus(uniform(random).times(1 / 5.0));
      }
      sum += new PixelHalves(8, first, 5, second).relativeSquaredError() / runs;
    }
    double expected = 1 / 12.0 / 13 / 1e4;
    // The mean of 12,000 squares of normal numbers has a standard error of 1.3 %.
    assertThat(sum).isCloseTo(expected, within(.06 * expected));
  }

  private static Rgb uniform(SplittableRandom random) {
    return new Rgb(
        99.5 + random.nextDouble(), 99.5 + random.nextDouble(), 99.5 + random.nextDouble());
  }
}
