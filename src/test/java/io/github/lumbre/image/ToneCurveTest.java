package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.internal.Srgb;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Compares tone curves with their formulas. */
class ToneCurveTest {
  private static double gray(ToneCurve curve, double v) {
    return curve.apply(Rgb.gray(v)).g();
  }

  @Test
  void graysFollowTheFormulas() {
    assertThat(gray(ToneCurve.SRGB, .18)).isEqualTo(Srgb.encode(.18));
    assertThat(gray(ToneCurve.GAMMA22, .18)).isEqualTo(StrictMath.pow(.18, 1 / 2.2));
    assertThat(gray(ToneCurve.REINHARD, 3)).isCloseTo(Srgb.encode(.75), within(1e-15));
    assertThat(gray(ToneCurve.ACES, .5))
        .isCloseTo(Srgb.encode(.5 * 1.285 / (.5 * 1.805 + .14)), within(1e-15));
  }

  @Test
  void reinhardDividesByTheLuminanceAndKeepsRatios() {
    Rgb shown = ToneCurve.REINHARD.apply(new Rgb(.5, .25, 1));
    double y = .2126 * .5 + .7152 * .25 + .0722;
    assertThat(shown.r()).isCloseTo(Srgb.encode(.5 / (1 + y)), within(1e-15));
    assertThat(shown.g()).isCloseTo(Srgb.encode(.25 / (1 + y)), within(1e-15));
    assertThat(shown.b()).isCloseTo(Srgb.encode(1 / (1 + y)), within(1e-15));
  }

  /** The offset of a gray above 0.08 is 0.04; below, it is the square 6.25 x². */
  @Test
  void neutralSubtractsAnOffsetAndKeepsColorsThatAreNotBright() {
    assertThat(gray(ToneCurve.NEUTRAL, .5)).isCloseTo(Srgb.encode(.46), within(1e-15));
    assertThat(gray(ToneCurve.NEUTRAL, .04)).isCloseTo(Srgb.encode(.01), within(1e-15));
    Rgb saturated = ToneCurve.NEUTRAL.apply(new Rgb(.7, .3, 0));
    assertThat(saturated.r()).isCloseTo(Srgb.encode(.7), within(1e-15));
    assertThat(saturated.g()).isCloseTo(Srgb.encode(.3), within(1e-15));
    assertThat(saturated.b()).isZero();
  }

  /** The peak p becomes 1 - 0.24² / (p - 0.52), and the color moves towards white. */
  @Test
  void neutralCompressesHighlights() {
    assertThat(gray(ToneCurve.NEUTRAL, 1.04))
        .isCloseTo(Srgb.encode(1 - .0576 / .48), within(1e-14));
    Rgb red = ToneCurve.NEUTRAL.apply(new Rgb(2, 0, 0));
    double peak = 1 - .0576 / 1.48;
    double white = 1 - 1 / (.15 * (2 - peak) + 1);
    assertThat(red.r()).isCloseTo(Srgb.encode(peak), within(1e-14));
    assertThat(red.g()).isCloseTo(Srgb.encode(peak * white), within(1e-14));
    double below = gray(ToneCurve.NEUTRAL, .8 - 1e-9);
    assertThat(gray(ToneCurve.NEUTRAL, .8 + 1e-9)).isCloseTo(below, within(1e-8));
  }

  @Test
  void agxKeepsGraysGrayFromBlackToWhite() {
    assertThat(gray(ToneCurve.AGX, 0)).isZero();
    // Values of the polynomial at 16.5 stops, its end, and at middle gray, 10 stops above the
    // start.
    assertThat(gray(ToneCurve.AGX, 1e6)).isCloseTo(.99858, within(5e-4));
    assertThat(gray(ToneCurve.AGX, .18)).isBetween(.4, .55);
    double last = 0;
    for (double v = 1e-4; v < 20; v *= 1.1) {
      Rgb shown = ToneCurve.AGX.apply(Rgb.gray(v));
      assertThat(shown.r()).isCloseTo(shown.g(), within(1e-3));
      assertThat(shown.b()).isCloseTo(shown.g(), within(1e-3));
      assertThat(shown.g()).isGreaterThanOrEqualTo(last);
      last = shown.g();
    }
  }

  @Test
  void acesTreatsChannelsAlone() {
    Rgb shown = ToneCurve.ACES.apply(new Rgb(0, .5, 50));
    assertThat(shown.r()).isZero();
    assertThat(shown.g()).isEqualTo(gray(ToneCurve.ACES, .5));
    assertThat(shown.b()).isEqualTo(1);
  }

  @ParameterizedTest
  @EnumSource
  void blackStaysBlackAndNegativeCountsAsBlack(ToneCurve curve) {
    assertThat(curve.apply(Rgb.BLACK)).isEqualTo(Rgb.BLACK);
    assertThat(curve.apply(new Rgb(-1, -1e300, -Double.MIN_VALUE))).isEqualTo(Rgb.BLACK);
  }

  @ParameterizedTest
  @EnumSource
  void anyFiniteInputGivesValuesFromZeroToOne(ToneCurve curve) {
    double[] extremes = {
      Double.MAX_VALUE, 1e300, 1e154, 1e100, 1e38, 1, 1e-30, Double.MIN_VALUE, 0, -1, -1e308
    };
    for (double r : extremes) {
      for (double g : extremes) {
        for (double b : extremes) {
          Rgb shown = curve.apply(new Rgb(r, g, b));
          assertThat(shown.r()).isBetween(0.0, 1.0);
          assertThat(shown.g()).isBetween(0.0, 1.0);
          assertThat(shown.b()).isBetween(0.0, 1.0);
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void brighterNeverLooksDarker(ToneCurve curve) {
    double last = -1;
    for (double v = 1e-6; v < 1e300; v *= 1.1) {
      double shown = gray(curve, v);
      // For gray, Reinhard's curve approaches 1 from below, up to rounding.
      assertThat(shown).isGreaterThanOrEqualTo(last - 1e-15);
      last = shown;
    }
    // The polynomial of AgX ends at 0.99858 before it is encoded.
    assertThat(last).isCloseTo(1, within(curve == ToneCurve.AGX ? 1.4e-3 : 1e-15));
  }

  @Test
  void reinhardOfHugeColorsKeepsTheirRatios() {
    Rgb limit = ToneCurve.REINHARD.apply(new Rgb(1e60, 2e60, 4e59));
    Rgb huge = ToneCurve.REINHARD.apply(new Rgb(4e307, 8e307, 1.6e307));
    assertThat(huge.r()).isCloseTo(limit.r(), within(1e-14));
    assertThat(huge.g()).isCloseTo(limit.g(), within(1e-14));
    assertThat(huge.b()).isCloseTo(limit.b(), within(1e-14));
  }

  @ParameterizedTest
  @EnumSource
  void labelsNameTheCurves(ToneCurve curve) {
    assertThat(ToneCurve.of(curve.label())).contains(curve);
    assertThat(curve.label()).isEqualTo(curve.name().toLowerCase(Locale.ROOT));
  }

  @Test
  void otherLabelsNameNone() {
    assertThat(ToneCurve.of("SRGB")).isEmpty();
    assertThat(ToneCurve.of("")).isEmpty();
  }

  @Test
  void sameInputGivesSameBits() {
    assertThat(hash(EnumSet.range(ToneCurve.SRGB, ToneCurve.ACES)))
        .isEqualTo(-5707766972890663853L);
    assertThat(hash(EnumSet.allOf(ToneCurve.class))).isEqualTo(-1194544708337737439L);
  }

  private static long hash(Set<ToneCurve> curves) {
    SplittableRandom random = new SplittableRandom(7);
    long hash = 0;
    for (int i = 0; i < 10_000; i++) {
      Rgb c = new Rgb(random.nextDouble(2), random.nextDouble(2), random.nextDouble(2));
      for (ToneCurve curve : curves) {
        Rgb shown = curve.apply(c);
        hash = 31 * hash + Double.doubleToLongBits(shown.r() + 2 * shown.g() + 4 * shown.b());
      }
    }
    return hash;
  }
}
