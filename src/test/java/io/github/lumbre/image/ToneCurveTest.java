package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Compares tone curves with their formulas. */
class ToneCurveTest {
  private static double grey(ToneCurve curve, double v) {
    return curve.apply(Rgb.grey(v)).g();
  }

  @Test
  void greysFollowTheFormulas() {
    assertThat(grey(ToneCurve.SRGB, .18)).isEqualTo(Srgb.encode(.18));
    assertThat(grey(ToneCurve.GAMMA22, .18)).isEqualTo(StrictMath.pow(.18, 1 / 2.2));
    assertThat(grey(ToneCurve.REINHARD, 3)).isCloseTo(Srgb.encode(.75), within(1e-15));
    assertThat(grey(ToneCurve.ACES, .5))
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

  @Test
  void acesTreatsChannelsAlone() {
    Rgb shown = ToneCurve.ACES.apply(new Rgb(0, .5, 50));
    assertThat(shown.r()).isZero();
    assertThat(shown.g()).isEqualTo(grey(ToneCurve.ACES, .5));
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
      double shown = grey(curve, v);
      // For gray, Reinhard's curve approaches 1 from below, up to rounding.
      assertThat(shown).isGreaterThanOrEqualTo(last - 1e-15);
      last = shown;
    }
    assertThat(last).isCloseTo(1, within(1e-15));
  }

  @Test
  void reinhardOfHugeColoursKeepsTheirRatios() {
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
    SplittableRandom random = new SplittableRandom(7);
    long hash = 0;
    for (int i = 0; i < 10_000; i++) {
      Rgb c = new Rgb(random.nextDouble(2), random.nextDouble(2), random.nextDouble(2));
      for (ToneCurve curve : ToneCurve.values()) {
        Rgb shown = curve.apply(c);
        hash = 31 * hash + Double.doubleToLongBits(shown.r() + 2 * shown.g() + 4 * shown.b());
      }
    }
    assertThat(hash).isEqualTo(-5707766972890663853L);
  }
}
