package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the sRGB transfer functions. */
class SrgbTest {
  @Test
  void everyByteSurvivesDecodingAndEncoding() {
    for (int b = 0; b < 256; b++) {
      assertThat(Srgb.toByte(Srgb.fromByte(b))).isEqualTo(b);
    }
  }

  @Test
  void everySixteenBitValueSurvivesDecodingAndEncoding() {
    for (int v = 0; v < 65536; v++) {
      assertThat(Math.round(65535 * Srgb.encode(Srgb.decode(v / 65535.0)))).isEqualTo(v);
    }
  }

  @Test
  void theTableIsTheCurve() {
    for (int b = 0; b < 256; b++) {
      assertThat(Srgb.fromByte(b)).isEqualTo(Srgb.decode(b / 255.0));
    }
  }

  @Test
  void knownValues() {
    assertThat(Srgb.decode(0)).isZero();
    assertThat(Srgb.decode(1)).isEqualTo(1);
    assertThat(Srgb.encode(1)).isEqualTo(1);
    assertThat(Srgb.decode(.5)).isCloseTo(0.21404114048223255, within(1e-15));
    assertThat(Srgb.decode(.04)).isCloseTo(.04 / 12.92, within(1e-17));
    assertThat(Srgb.encode(.18)).isCloseTo(0.46135612950044164, within(1e-15));
  }

  @Test
  void encodingClamps() {
    assertThat(Srgb.encode(-1)).isZero();
    assertThat(Srgb.encode(1.0000001)).isEqualTo(1);
    assertThat(Srgb.encode(Double.POSITIVE_INFINITY)).isEqualTo(1);
    assertThat(Srgb.encode(Double.NaN)).isZero();
    assertThat(Srgb.encode(Double.MIN_VALUE)).isBetween(0.0, 1e-300);
  }

  @Test
  void theCurveRises() {
    double last = -1;
    for (int i = 0; i <= 100_000; i++) {
      double v = Srgb.encode(i / 100_000.0);
      assertThat(v).isGreaterThan(last);
      last = v;
    }
  }

  @Test
  void bytesAreThoseOfTheFormulaOnBothSidesOfTheirLimits() {
    for (int b = 0; b < 256; b++) {
      double limit = Srgb.decode((b + .5) / 255);
      for (double share : new double[] {1e-3, 1e-9, 1.1e-12, 1e-12, 9e-13, 1e-14, 1e-15, 0}) {
        assertByteIsThatOfTheFormula(limit * (1 - share));
        assertByteIsThatOfTheFormula(limit * (1 + share));
      }
      for (double v = limit; v < limit * (1 + 1e-14); v = Math.nextUp(v)) {
        assertByteIsThatOfTheFormula(v);
      }
    }
  }

  @Test
  void bytesAreThoseOfTheFormulaEverywhere() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 300_000; i++) {
      assertByteIsThatOfTheFormula((float) random.nextDouble(1.01));
      assertByteIsThatOfTheFormula(Math.scalb(random.nextDouble(), -random.nextInt(40)));
    }
    for (double v : new double[] {0, -1, 1, 2, Double.NaN, Double.MIN_VALUE, Math.nextDown(1.)}) {
      assertByteIsThatOfTheFormula(v);
    }
  }

  private static void assertByteIsThatOfTheFormula(double linear) {
    assertThat(Srgb.toByte(linear)).isEqualTo((int) Math.round(255 * Srgb.encode(linear)));
  }
}
