package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the Phong lobe against tables and BSDF invariants. */
class PhongLobeTest {
  private static final double[] EXPONENTS = {0, 1, 10, 52, 1e3, 1e6, 1e9};
  private static final int CELLS = Effort.count(16, 64);
  private static final int POINTS = 16;
  private static final int FINE_POINTS = 128;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(43));

  private static PhongLobe lobe(double exponent) {
    return new PhongLobe(Rgb.WHITE, exponent);
  }

  private static Vec3 mirrored(Vec3 wo) {
    return new Vec3(-wo.x(), -wo.y(), wo.z());
  }

  /** Returns a direction around the mirror direction whose cosine to the power n + 1 is t. */
  private static Vec3 around(Vec3 wo, double exponent, double t, double v) {
    double log = Math.log(t) / (exponent + 1);
    double sin = Math.sqrt(-Math.expm1(2 * log));
    double phi = 2 * Math.PI * v;
    Vec3 local = new Vec3(sin * Math.cos(phi), sin * Math.sin(phi), Math.exp(log));
    return Frame.around(mirrored(wo)).toWorld(local);
  }

  /**
   * Returns the integral of eval over wi, to about ten digits. It integrates over the angle from
   * the mirror direction, separately where the full ring is above the surface and where only a part
   * is.
   */
  static double albedo(PhongLobe lobe, Vec3 wo) {
    double clipped = Math.pow(Math.hypot(wo.x(), wo.y()), lobe.exponent() + 1);
    return Quadrature.between(0, clipped, t -> ring(lobe, wo, t))
        + Quadrature.between(clipped, 1, t -> ring(lobe, wo, t));
  }

  /** Returns the integral of eval around the mirror direction, divided by the density of t. */
  private static double ring(PhongLobe lobe, Vec3 wo, double t) {
    double n = lobe.exponent();
    double log = Math.log(Math.min(1, t)) / (n + 1);
    double cos = Math.exp(log);
    double sin = Math.sqrt(Math.abs(Math.expm1(2 * log)));
    Vec3 mirrored = mirrored(wo);
    double side = Math.signum(wo.z());
    double sine = Math.hypot(wo.x(), wo.y());
    Vec3 upward =
        sine == 0
            ? Vec3.X
            : new Vec3(0, 0, side).minus(mirrored.times(Math.abs(wo.z()))).times(1 / sine);
    Vec3 sideways = mirrored.cross(upward);
    double horizon = -cos * Math.abs(wo.z()) / (sin * sine);
    double most = sine > 0 && horizon > -1 ? Math.acos(horizon) : Math.PI;
    double density = (n + 1) * Math.pow(t, n / (n + 1));
    return Quadrature.between(
            -most,
            most,
            phi -> {
              Vec3 across = upward.times(Math.cos(phi)).plus(Math.sin(phi), sideways);
              return lobe.evaluate(wo, mirrored.times(cos).plus(sin, across)).f().g();
            })
        / density;
  }

  @ParameterizedTest
  @CsvSource({
    "0, 1, .9330127, .75, .58682409, .5087262",
    "1, 1, .88084278, .60899778, .40994525, .32708457",
    "10, 1, .86602853, .50473595, .22805629, .13196043",
    "52, 1, .8660254, .5000015, .18032104, .06421969",
    "1e3, 1, .8660254, .5, .17364818, .02321229",
    "1e6, 1, .8660254, .5, .17364818, .01745241",
  })
  void albedoIsTheTabulatedOne(
      double exponent, double normal, double at30, double at60, double at80, double at89) {
    double[] expected = {normal, at30, at60, at80, at89};
    double[] degrees = {0, 30, 60, 80, 89};
    for (int i = 0; i < 5; i++) {
      Vec3 wo = direction(Math.cos(Math.toRadians(degrees[i])));
      assertThat(albedo(lobe(exponent), wo)).isCloseTo(expected[i], within(1e-6));
      double sampled = BsdfLaws.sampledAlbedo(lobe(exponent), wo, 20_000);
      assertThat(sampled).isCloseTo(expected[i], within(1e-3));
      assertThat(sampled).isLessThanOrEqualTo(1 + 1e-4);
      assertThat(BsdfLaws.sampledAlbedo(lobe(exponent), mirrored(wo).negated(), 20_000))
          .isCloseTo(expected[i], within(1e-3));
    }
  }

  @Test
  void scatteringIsReciprocal() {
    for (double exponent : EXPONENTS) {
      for (int i = 0; i < 10_000; i++) {
        Vec3 a = direction(random);
        double near = 2 / Math.sqrt(exponent + 1);
        Vec3 b =
            i % 2 == 0 ? direction(random) : mirrored(a).plus(near, direction(random)).normalized();
        BsdfLaws.assertReciprocal(lobe(exponent), a, b, 64 * EPS);
      }
    }
  }

  @Test
  void sampledDirectionsFollowPdfAndThoseBelowTheHorizonAreRefused() {
    for (double exponent : EXPONENTS) {
      for (double cos : new double[] {1, .9, -.5, .1, -.01}) {
        assertSamplesFollowPdf(lobe(exponent), direction(cos), Effort.count(40_000, 1_000_000));
      }
    }
  }

  private void assertSamplesFollowPdf(PhongLobe lobe, Vec3 wo, int samples) {
    double n = lobe.exponent();
    Frame frame = Frame.around(mirrored(wo));
    long[] counts = new long[CELLS * CELLS + 1];
    for (int i = 0; i < samples; i++) {
      BsdfSample sample = lobe.sample(wo, .5, Draws.inSquare(random));
      Vec3 local = frame.toLocal(sample.wi());
      double sin2 = local.x() * local.x() + local.y() * local.y();
      double t = Math.exp(.5 * (n + 1) * Math.log1p(-sin2));
      double v = Math.atan2(local.y(), local.x()) / (2 * Math.PI);
      int column = Math.min((int) (CELLS * (v - Math.floor(v))), CELLS - 1);
      int row = Math.min((int) (CELLS * t), CELLS - 1);
      counts[sample.pdf() == 0 ? CELLS * CELLS : row * CELLS + column]++;
    }
    double[] expected = new double[counts.length];
    double all = 0;
    for (int cell = 0; cell < CELLS * CELLS; cell++) {
      double integral = cellIntegral(lobe, wo, cell);
      all += integral;
      expected[cell] = Math.max(1e-9, samples * integral);
    }
    assertThat(all).isLessThan(1 + 1e-6);
    expected[CELLS * CELLS] = Math.max(1e-9, samples * (1 - all));
    ChiSquare test = ChiSquare.of(counts, expected);
    assertThat(test.passes()).as("%s, wo %s: %s", lobe, wo, test).isTrue();
  }

  /** Integrates over a cell, and more finely where the horizon cuts it, even only at a corner. */
  private static double cellIntegral(PhongLobe lobe, Vec3 wo, int cell) {
    int above = 0;
    for (int corner = 0; corner < 4; corner++) {
      double t = (cell / CELLS + corner / 2) / (double) CELLS;
      double v = (cell % CELLS + corner % 2) / (double) CELLS;
      above += around(wo, lobe.exponent(), t, v).z() * wo.z() > 0 ? 1 : 0;
    }
    return midpoints(lobe, wo, cell, above == 0 || above == 4 ? POINTS : FINE_POINTS);
  }

  private static double midpoints(PhongLobe lobe, Vec3 wo, int cell, int points) {
    double n = lobe.exponent();
    double sum = 0;
    for (int i = 0; i < points; i++) {
      double t = (cell / CELLS + (i + .5) / points) / CELLS;
      double density = (n + 1) / (2 * Math.PI) * Math.pow(t, n / (n + 1));
      for (int j = 0; j < points; j++) {
        double v = (cell % CELLS + (j + .5) / points) / CELLS;
        sum += lobe.pdf(wo, around(wo, n, t, v)) / density;
      }
    }
    return sum / (points * points * CELLS * CELLS);
  }

  @Test
  void weightIsEvalOverPdf() {
    for (double exponent : EXPONENTS) {
      PhongLobe lobe = new PhongLobe(new Rgb(.2, .5, .9), exponent);
      for (double cos : COSINES) {
        BsdfLaws.assertWeightIsEvalOverPdf(lobe, direction(cos), 1000, random, 1e-12);
        BsdfLaws.assertWeightIsEvalOverPdf(lobe, direction(-cos), 1000, random, 1e-12);
      }
    }
  }

  @Test
  void extremesAreHarmless() {
    for (double exponent : EXPONENTS) {
      BsdfLaws.assertExtremesAreHarmless(lobe(exponent));
    }
    BsdfLaws.assertExtremesAreHarmless(lobe(Phong.SHARPEST));
  }

  @Test
  void lobeOfExponentZeroIsConstant() {
    for (int i = 0; i < 1000; i++) {
      Vec3 wo = direction(random);
      Vec3 wi = around(wo, 0, random.nextDouble(.01, 1), random.nextDouble());
      if (wo.z() * wi.z() > 0) {
        assertThat(lobe(0).pdf(wo, wi)).isEqualTo(1 / (2 * Math.PI));
        assertThat(lobe(0).evaluate(wo, wi).f().g())
            .isCloseTo(Math.abs(wi.z()) / Math.PI, within(EPS));
      }
    }
    // Also at right angles to the mirror direction.
    assertThat(lobe(0).pdf(new Vec3(.6, 0, .8), new Vec3(.8, 0, .6))).isPositive();
  }

  /** Half of a sharp lobe lies within √(2 ln 2 / n) of the mirror direction. */
  @Test
  void medianOfASharpLobeKeepsItsDigits() {
    double n = 1e9;
    BsdfSample sample = lobe(n).sample(Vec3.Z, 0, new Point2(.5, .125));
    double sin = Math.hypot(sample.wi().x(), sample.wi().y());
    assertThat(relative(Math.asin(sin), Math.sqrt(2 * Math.log(2) / n))).isLessThan(1e-9);
  }

  /** A lobe of any sharpness loses no energy to rounding: it becomes a mirror times the cosine. */
  @Test
  void sharpestLobeKeepsItsEnergy() {
    for (double cos : COSINES) {
      double albedo = BsdfLaws.sampledAlbedo(lobe(Phong.SHARPEST), direction(cos), 1000);
      assertThat(albedo).isCloseTo(cos, within(1e-6));
    }
  }
}
