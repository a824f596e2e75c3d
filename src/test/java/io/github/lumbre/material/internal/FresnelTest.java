package io.github.lumbre.material.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.internal.Elementary;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Compares Fresnel reflectances with tables and closed forms. */
class FresnelTest {
  private static final double EPS = 0x1p-52;

  private final SplittableRandom random = new SplittableRandom(12);

  @Test
  void reflectanceIsTheTabulatedOne() {
    assertTable(1.1, .0022675736961451, .0130699669001, .193562762457);
    assertTable(1.33, .020059312199525, .0591255992474, .346916096262);
    assertTable(1.5, .04, .0891867128022, .387704354691);
    assertTable(2.4, .16955017301038, .209351260771, .433236034108);
    assertTable(3.0504, .25626031614535, .276636121267, .432822279413);
    assertTable(1e6, .999996000008, .999995000017, .999988135295);
  }

  /** Checks values to half a unit of the table's last digit, and to 1e-13 at normal incidence. */
  private static void assertTable(double eta, double at0, double at60, double at80) {
    assertThat(Fresnel.dielectric(1, eta)).isCloseTo(at0, within(eta < 1e6 ? 1e-13 : 6e-13));
    double sine = (eta - 1) / (eta + 1);
    assertThat(Fresnel.dielectric(1, eta)).isCloseTo(sine * sine, within(EPS));
    assertThat(Fresnel.dielectric(.5, eta)).isCloseTo(at60, within(6e-13));
    assertThat(Fresnel.dielectric(Elementary.cosDegrees(80), eta)).isCloseTo(at80, within(6e-13));
  }

  @Test
  void cosineWeightedAverageIsTheTabulatedOne() {
    double[][] table = {
      {1.1, .0251573573529},
      {1.33, .0659308492994},
      {1.5, .0917779593424},
      {2.4, .21018130201},
      {3.0504, .281317037702}
    };
    for (double[] row : table) {
      double average = integral(c -> 2 * c * Fresnel.dielectric(c, row[0]));
      assertThat(average).isCloseTo(row[1], within(2e-12));
    }
  }

  @Test
  void averageFromInsideFollowsFromTheOneFromOutside() {
    // Integrated over the cosine of the refracted angle, which is smooth.
    double n = 1.5;
    double belowCritical =
        integral(
            cosT -> {
              double cosI = Math.sqrt(1 - (1 - cosT * cosT) / (n * n));
              return 2 * cosT / (n * n) * Fresnel.dielectric(cosI, 1 / n);
            });
    double beyond = 1 - 1 / (n * n);
    assertThat(beyond + belowCritical).isCloseTo(.59634575970771, within(2e-12));
    assertThat(beyond + belowCritical).isCloseTo(1 - (1 - .0917779593424) / 2.25, within(2e-12));
  }

  /** Returns the integral over [0,1] by Simpson's rule. */
  private static double integral(DoubleUnaryOperator f) {
    int n = 100_000;
    double sum = f.applyAsDouble(0) + f.applyAsDouble(1);
    for (int i = 1; i < n; i++) {
      sum += (i % 2 == 0 ? 2 : 4) * f.applyAsDouble((double) i / n);
    }
    return sum / (3 * n);
  }

  private static double cosTransmitted(double cosI, double eta) {
    return Fresnel.cosTransmitted(cosI, (1 - cosI) * (1 + cosI), eta);
  }

  /**
   * The transmitted light is computed from its own amplitudes: 2 cosI/(…) (PBRT 4e, sec. 9.3.5).
   */
  @Test
  void reflectedAndTransmittedSumToOne() {
    for (int i = 0; i < 1_000_000; i++) {
      double eta = StrictMath.pow(10, random.nextDouble(-3, 6));
      double cosI = random.nextDouble();
      double reflected = Fresnel.dielectric(cosI, eta);
      double cosT = cosTransmitted(cosI, eta);
      double parallel = 2 * cosI / (eta * cosI + cosT);
      double perpendicular = 2 * cosI / (cosI + eta * cosT);
      double squares = parallel * parallel + perpendicular * perpendicular;
      double transmitted = .5 * eta * cosT / cosI * squares;
      if (Math.abs(reflected + transmitted - 1) > 4 * EPS) {
        assertThat(reflected + transmitted)
            .as("cos %s eta %s", cosI, eta)
            .isCloseTo(1, within(4 * EPS));
      }
    }
  }

  @Test
  void sameMediumReflectsNothingAtAnyAngle() {
    for (double cosI : new double[] {0, 1e-300, 1e-9, .3, 1, 1 + EPS}) {
      assertThat(Fresnel.dielectric(cosI, 1)).isZero();
      assertThat(cosTransmitted(cosI, 1)).isEqualTo(cosI);
    }
  }

  @Test
  void almostTheSameMediumReflectsAlmostNothingWithAllDigits() {
    double delta = (1 + 1e-12) - 1;
    assertThat(Fresnel.dielectric(1, 1 + 1e-12)).isCloseTo(2.5e-25, within(2.5e-28));
    for (double c : new double[] {1, .9, .71, .5, .2, .01}) {
      // To first order in delta, with second-order terms of delta/c².
      double twice = 2 * c * c - 1;
      double expected = delta * delta / (8 * c * c * c * c) * (1 + twice * twice);
      assertThat(Fresnel.dielectric(c, 1 + 1e-12)).isCloseTo(expected, within(1e-7 * expected));
    }
    assertThat(Fresnel.dielectric(Elementary.cosDegrees(80), 1 + 1e-12))
        .isCloseTo(2.6e-22, within(.1e-22));
  }

  @Test
  void everythingIsReflectedBeyondTheCriticalAngle() {
    assertThat(Fresnel.dielectric(Elementary.cosDegrees(30.001), .5)).isEqualTo(1);
    assertThat(Fresnel.dielectric(Elementary.cosDegrees(29.999), .5)).isLessThan(1);
    for (double cosI = 0; cosI < .74; cosI += .01) {
      assertThat(Fresnel.dielectric(cosI, 1 / 1.5)).isEqualTo(1);
      assertThat(cosTransmitted(cosI, 1 / 1.5)).isZero();
    }
  }

  @Test
  void reflectanceIsContinuousAtTheCriticalAngle() {
    double critical = StrictMath.asin(1 / 1.5);
    assertThat(Math.toDegrees(critical)).isCloseTo(41.810314895779, within(1e-12));
    double[] offsets = {-1e-12, 0, 1e-12};
    for (double offset : offsets) {
      double reflected = Fresnel.dielectric(StrictMath.cos(critical + offset), 1 / 1.5);
      assertThat(reflected).isCloseTo(1, within(1e-5)).isLessThanOrEqualTo(1);
    }
  }

  @Test
  void parallelLightPassesAtBrewstersAngle() {
    double c = StrictMath.cos(Math.toRadians(56.30993247402));
    // All reflected light is perpendicularly polarized: ((n² - 1)/(n² + 1))²/2.
    double perpendicular = 1.25 / 3.25;
    assertThat(Fresnel.dielectric(c, 1.5))
        .isCloseTo(perpendicular * perpendicular / 2, within(1e-12));
  }

  @Test
  void grazingLightIsReflected() {
    for (double eta : new double[] {1e-3, .5, 1 + 1e-6, 1.5, 1e6}) {
      assertThat(Fresnel.dielectric(0, eta)).isCloseTo(1, within(2 * EPS));
      assertThat(Fresnel.dielectric(1e-300, eta)).isCloseTo(1, within(2 * EPS));
    }
  }

  @Test
  void reflectanceIsTheSameFromBothSidesAlongOnePath() {
    for (int i = 0; i < 10_000; i++) {
      double eta = random.nextDouble(1.01, 4);
      double cosI = random.nextDouble(.05, 1);
      double cosT = cosTransmitted(cosI, eta);
      double outside = Fresnel.dielectric(cosI, eta);
      // A rounding error of cosT corresponds to an error of cosI that is at least 1/cosI times as
      // large.
      double error = 64 * EPS / cosI;
      assertThat(Fresnel.dielectric(cosT, 1 / eta)).isCloseTo(outside, within(error));
    }
  }
}
