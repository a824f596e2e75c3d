package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Compares samples of pixel filters with the filters' densities. */
class PixelFilterTest {
  private static final int POINTS = 1 << 16;

  /** The unnormalized densities by definition; x is the offset from the center in pixels. */
  private static final Map<PixelFilter, DoubleUnaryOperator> DENSITIES =
      new EnumMap<>(
          Map.of(
              PixelFilter.BOX, x -> 1,
              PixelFilter.TENT, x -> 1 - Math.abs(x),
              PixelFilter.GAUSSIAN, x -> Math.exp(-2 * x * x) - Math.exp(-4.5),
              PixelFilter.BLACKMAN_HARRIS, PixelFilterTest::blackmanHarris));

  private static double blackmanHarris(double x) {
    double phase = 2 * Math.PI * (x / 3 + .5);
    return .35875
        - .48829 * Math.cos(phase)
        + .14128 * Math.cos(2 * phase)
        - .01168 * Math.cos(3 * phase);
  }

  /**
   * Returns the integral of x^power times a filter's density, where x is the offset from the
   * center.
   */
  private static double moment(PixelFilter filter, int power, double upTo) {
    double width = (upTo + filter.radius()) / POINTS;
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
      double x = -filter.radius() + (i + .5) * width;
      sum += Math.pow(x, power) * DENSITIES.get(filter).applyAsDouble(x) * width;
    }
    return sum;
  }

  @ParameterizedTest
  @EnumSource
  void samplesFollowTheDensity(PixelFilter filter) {
    double all = moment(filter, 0, filter.radius());
    for (double u = 1 / 64.; u < 1; u += 1 / 64.) {
      double x = filter.sample(u) - .5;
      assertThat(moment(filter, 0, x) / all).as("u %s", u).isCloseTo(u, within(2e-6));
    }
  }

  @ParameterizedTest
  @EnumSource
  void meanAndSpreadAreThoseOfTheDensity(PixelFilter filter) {
    double mean = 0;
    double square = 0;
    for (int i = 0; i < POINTS; i++) {
      double x = filter.sample((i + .5) / POINTS) - .5;
      mean += x / POINTS;
      square += x * x / POINTS;
    }
    double all = moment(filter, 0, filter.radius());
    assertThat(mean).isCloseTo(0, within(1e-9));
    assertThat(square).isCloseTo(moment(filter, 2, filter.radius()) / all, within(2e-6));
  }

  @ParameterizedTest
  @EnumSource
  void samplesAreSymmetricMonotonicAndWithinTheRadius(PixelFilter filter) {
    double before = .5 - filter.radius();
    for (int i = 0; i < 4096; i++) {
      double u = i / 4096.;
      double x = filter.sample(u);
      assertThat(x).isGreaterThanOrEqualTo(before);
      if (i > 0) {
        assertThat(x + filter.sample(1 - u)).isCloseTo(1, within(1e-10));
      }
      before = x;
    }
    double last = filter.sample(Math.nextDown(1.));
    assertThat(last).isBetween(.5 + .97 * filter.radius(), .5 + filter.radius());
    assertThat(filter.sample(0)).isCloseTo(.5 - filter.radius(), within(.03 * filter.radius()));
  }

  @ParameterizedTest
  @EnumSource
  void smallestNumbersAreFinite(PixelFilter filter) {
    for (double u : new double[] {0, Double.MIN_VALUE, 0x1p-60, 0x1p-53}) {
      assertThat(filter.sample(u)).isBetween(.5 - filter.radius(), .5);
    }
  }

  /** The tables are made of these densities, which are known up to a factor. */
  @Test
  void tabulatedDensitiesAreInProportionToTheirDefinitions() {
    assertInProportion(PixelFilter.GAUSSIAN, PixelFilter::gaussian);
    assertInProportion(PixelFilter.BLACKMAN_HARRIS, PixelFilter::blackmanHarris);
  }

  private static void assertInProportion(PixelFilter filter, DoubleUnaryOperator density) {
    DoubleUnaryOperator expected = DENSITIES.get(filter);
    double factor = density.applyAsDouble(0) / expected.applyAsDouble(0);
    assertThat(factor).isPositive();
    for (double t = -1; t <= 1; t += 1 / 64.) {
      assertThat(density.applyAsDouble(t))
          .isCloseTo(factor * expected.applyAsDouble(t * filter.radius()), within(1e-14));
    }
  }

  /** The Blackman-Harris window ends at 6e-5 of its peak (Harris 1978, table 1). */
  @Test
  void gaussianEndsInZeroAndBlackmanHarrisNearlySo() {
    assertThat(PixelFilter.gaussian(1)).isZero();
    assertThat(PixelFilter.gaussian(-1)).isZero();
    assertThat(PixelFilter.blackmanHarris(1)).isCloseTo(6e-5, within(1e-15));
    assertThat(PixelFilter.blackmanHarris(0)).isCloseTo(1, within(1e-15));
  }
}
