package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Draws;
import java.util.Optional;
import java.util.SplittableRandom;

/** Checks of invariants of every BSDF without delta lobes, and helper functions for them. */
final class BsdfLaws {
  static final double EPS = 0x1p-52;
  static final double LAST = 1 - 0x1p-53;

  /** From normal to grazing. */
  static final double[] COSINES = {1, .9, .5, .1, .01};

  private static final double[] EXTREME_COSINES = {
    0, 4.9e-324, 1e-308, 1e-160, 1e-80, 1e-17, 1e-9, .5, LAST, 1
  };
  private static final double[] EXTREME_NUMBERS = {0, 0x1p-53, 1e-9, .5, LAST};

  private BsdfLaws() {}

  /** Returns a unit direction with a given z, in a plane not aligned with the axes. */
  static Vec3 direction(double z) {
    double sin = Math.sqrt((1 - z) * (1 + z));
    return new Vec3(.8 * sin, -.6 * sin, z);
  }

  static Vec3 direction(SplittableRandom random) {
    double z = random.nextDouble(-1, 1);
    double phi = random.nextDouble(2 * Math.PI);
    double sin = Math.sqrt((1 - z) * (1 + z));
    return new Vec3(sin * Math.cos(phi), sin * Math.sin(phi), z);
  }

  static double relative(double found, double expected) {
    return found == expected ? 0 : Math.abs(found / expected - 1);
  }

  /** Checks that light is scattered alike in both directions, but for values that underflow. */
  static void assertReciprocal(Bsdf bsdf, Vec3 a, Vec3 b, double tolerance) {
    double there = bsdf.evaluate(a, b).f().g() / Math.abs(b.z());
    double back = bsdf.evaluate(b, a).f().g() / Math.abs(a.z());
    if (Math.max(there, back) > 1e-290) {
      assertThat(relative(there, back)).isLessThanOrEqualTo(tolerance);
    }
  }

  /** Checks that sampled directions follow their density, by a chi-square test of cells. */
  static void assertSamplesFollowPdf(
      Object what, Bsdf bsdf, Vec3 wo, int samples, int cells, SplittableRandom random) {
    ChiSquare test =
        ChiSquare.ofDirections(
            samples,
            () -> {
              BsdfSample sample = bsdf.sample(wo, random.nextDouble(), Draws.inSquare(random));
              return sample.pdf() > 0 ? Optional.of(sample.wi()) : Optional.empty();
            },
            wi -> bsdf.pdf(wo, wi),
            cells);
    assertThat(test.passes()).as("%s %s: %s", what, wo, test).isTrue();
  }

  /** Checks that sample, eval and pdf agree, to within a relative tolerance. */
  static void assertWeightIsEvalOverPdf(
      Bsdf bsdf, Vec3 wo, int samples, SplittableRandom random, double tolerance) {
    for (int i = 0; i < samples; i++) {
      BsdfSample sample = bsdf.sample(wo, random.nextDouble(), Draws.inSquare(random));
      if (sample.pdf() == 0) {
        assertThat(sample.isAbsorbed()).isTrue();
        continue;
      }
      assertUsable(sample);
      Rgb value = bsdf.evaluate(wo, sample.wi()).f();
      double pdf = bsdf.pdf(wo, sample.wi());
      assertEvaluatesAlike(bsdf, wo, sample.wi());
      assertThat(relative(sample.pdf(), pdf)).isLessThan(tolerance);
      assertThat(relative(sample.weight().r(), value.r() / pdf)).isLessThan(tolerance);
      assertThat(relative(sample.weight().g(), value.g() / pdf)).isLessThan(tolerance);
      assertThat(relative(sample.weight().b(), value.b() / pdf)).isLessThan(tolerance);
    }
  }

  /** Checks that a reused result receives a bit-identical value and density. */
  private static void assertEvaluatesAlike(Bsdf bsdf, Vec3 wo, Vec3 wi) {
    BsdfValue value = new BsdfValue();
    value.set(Rgb.WHITE, 7);
    bsdf.evaluate(wo.x(), wo.y(), wo.z(), wi.x(), wi.y(), wi.z(), value);
    assertThat(value.f()).isEqualTo(bsdf.evaluate(wo, wi).f());
    assertThat(value.pdf()).isEqualTo(bsdf.pdf(wo, wi));
  }

  /** Checks that a reused sample receives the same result as a new one. */
  static void assertSamplesAlike(Bsdf bsdf, Vec3 wo, double uLobe, Point2 u) {
    BsdfSample sample = bsdf.sample(wo, uLobe, u);
    BsdfSample used = new BsdfSample();
    used.set(Vec3.X, Rgb.WHITE, 7);
    bsdf.sample(wo.x(), wo.y(), wo.z(), uLobe, u.x(), u.y(), used);
    assertThat(used.weight()).isEqualTo(sample.weight());
    assertThat(used.pdf()).isEqualTo(sample.pdf());
    assertThat(used.wi()).isEqualTo(sample.wi());
  }

  private static void assertUsable(BsdfSample sample) {
    assertThat(sample.pdf()).isPositive().isFinite();
    assertThat(sample.wi().length()).isCloseTo(1, within(4 * EPS));
    assertHarmless(sample.weight());
  }

  private static void assertHarmless(Rgb color) {
    assertThat(color.isFinite()).isTrue();
    assertThat(Math.min(color.r(), Math.min(color.g(), color.b()))).isNotNegative();
  }

  /**
   * Checks that horizontal, opposite and equal directions and extreme random numbers give valid
   * results.
   */
  static void assertExtremesAreHarmless(Bsdf bsdf) {
    for (double cosO : EXTREME_COSINES) {
      for (double sign : new double[] {-1, 1}) {
        Vec3 wo = direction(sign * cosO);
        for (double cosI : EXTREME_COSINES) {
          Vec3 wi = direction(cosI);
          Vec3[] related = {
            wi,
            wi.negated(),
            new Vec3(-wi.x(), -wi.y(), wi.z()),
            new Vec3(wi.x(), wi.y(), -wi.z()),
            new Vec3(-wi.y(), wi.x(), wi.z()),
            Vec3.X
          };
          for (Vec3 each : related) {
            assertHarmless(bsdf.evaluate(wo, each).f());
            assertEvaluatesAlike(bsdf, wo, each);
            assertThat(bsdf.pdf(wo, each)).isNotNegative().isFinite();
            if (cosO == 0 || each.z() == 0) {
              assertThat(bsdf.evaluate(wo, each).f().isBlack()).isTrue();
            }
          }
        }
        assertExtremeNumbersAreHarmless(bsdf, wo);
      }
    }
  }

  private static void assertExtremeNumbersAreHarmless(Bsdf bsdf, Vec3 wo) {
    for (double x : EXTREME_NUMBERS) {
      for (double y : EXTREME_NUMBERS) {
        for (double lobe : EXTREME_NUMBERS) {
          assertSamplesAlike(bsdf, wo, lobe, new Point2(x, y));
          BsdfSample sample = bsdf.sample(wo, lobe, new Point2(x, y));
          if (!sample.isAbsorbed()) {
            assertUsable(sample);
            assertThat(sample.wi().z()).isNotZero();
          }
        }
      }
    }
  }

  /**
   * Returns the mean weight of samples at n points of a lattice that fills the unit cube evenly.
   */
  static double sampledAlbedo(Bsdf bsdf, Vec3 wo, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
      // Roberts 2018: steps of 1/p and 1/p², p³ = p + 1.
      Point2 u = new Point2(i * .7548776662466927 % 1, i * .5698402909980532 % 1);
      sum += bsdf.sample(wo, i * .41421356237309503 % 1, u).weight().g();
    }
    return sum / n;
  }
}
