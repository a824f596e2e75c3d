package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.compare.PictureError;
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
    PixelHalves gray = new PixelHalves(4, Rgb.gray(3), 2, Rgb.WHITE);
    double expected = 4.0 * 4 * 2 / 36 / (3 + PictureError.FLOOR);
    assertThat(gray.relativeSquaredError()).isCloseTo(expected, within(1e-15));
    assertThat(red.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
    PixelHalves green = new PixelHalves(4, new Rgb(0, 3, 0), 2, new Rgb(0, 1, 0));
    PixelHalves blue = new PixelHalves(4, new Rgb(0, 0, 3), 2, new Rgb(0, 0, 1));
    assertThat(green.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
    assertThat(blue.relativeSquaredError()).isCloseTo(expected / 3, within(1e-15));
  }

  @Test
  void evenPixelsHaveNoError() {
    assertThat(new PixelHalves(8, Rgb.gray(5), 8, Rgb.gray(5)).relativeSquaredError()).isZero();
    assertThat(new PixelHalves(8, Rgb.BLACK, 8, Rgb.BLACK).relativeSquaredError()).isZero();
  }

  /** Rounding may make the mean of a dark second half slightly negative. */
  @Test
  void slightlyNegativeMeansAreComparedWithTheFloor() {
    PixelHalves halves = new PixelHalves(1, Rgb.gray(1), 1, Rgb.gray(-1e-6));
    double expected = (1 + 1e-6) * (1 + 1e-6) / 4 / PictureError.FLOOR;
    assertThat(halves.relativeSquaredError()).isCloseTo(expected, within(1e-9 * expected));
  }

  private static PixelHalves even(double first, double second) {
    return new PixelHalves(16, Rgb.gray(first), 16, Rgb.gray(second));
  }

  /** A pixel of .3 and one sample of 182.7 in 32: its error is 2.85² / (.3² + .01). */
  @Test
  void aBrightSampleIsComparedWithWhatSurroundsIt() {
    double expected = 2.85 * 2.85 / .1;
    assertThat(even(6, .3).squaredErrorAmong(Rgb.gray(.3))).isCloseTo(expected, within(1e-9));
    assertThat(even(.3, 6).squaredErrorAmong(Rgb.gray(.3))).isCloseTo(expected, within(1e-9));
    assertThat(even(6, .3).relativeSquaredError()).isLessThan(.06 * expected);
  }

  /**
   * Of 48 samples, the first 32 and the last 16 are the halves. A bright sample of 144 on black adds
   * 3 to the mean, whichever half has it.
   */
  @Test
  void aBrightSampleOfUnevenHalvesIsComparedWithWhatSurroundsIt() {
    PixelHalves first = new PixelHalves(32, Rgb.gray(4.5), 16, Rgb.BLACK);
    PixelHalves second = new PixelHalves(32, Rgb.BLACK, 16, Rgb.gray(9));
    assertThat(first.mean()).isEqualTo(Rgb.gray(3)).isEqualTo(second.mean());
    assertThat(first.squaredErrorAmong(Rgb.BLACK)).isCloseTo(4.5 * 4.5 * 2 / 9 / .01, within(1e-9));
    assertThat(second.squaredErrorAmong(Rgb.BLACK)).isCloseTo(81 * 2 / 9. / .01, within(1e-9));
  }

  /** Halves of 60 and 58 agree: the pixel is brighter than its neighbors, and not by chance. */
  @Test
  void aHighlightIsComparedWithItself() {
    double expected = 1 / (59 * 59 + .01);
    assertThat(even(60, 58).squaredErrorAmong(Rgb.WHITE))
        .isCloseTo(expected, within(.01 * expected));
    assertThat(even(.01, .012).squaredErrorAmong(Rgb.WHITE))
        .isCloseTo(1e-6 / .010121, within(1e-6));
  }

  @Test
  void eachChannelHasItsOwnSurroundings() {
    PixelHalves red = new PixelHalves(4, new Rgb(2, 0, 0), 4, new Rgb(0, 0, 0));
    double expected = 1 / (.25 + .01) / 3;
    assertThat(red.squaredErrorAmong(new Rgb(.5, 9, 9))).isCloseTo(expected, within(1e-12));
    PixelHalves blue = new PixelHalves(4, new Rgb(0, 0, 2), 4, new Rgb(0, 0, 0));
    assertThat(blue.squaredErrorAmong(new Rgb(9, 9, .5))).isCloseTo(expected, within(1e-12));
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
