package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;

/**
 * Maps the unit square (s, v) to facets: the fraction 1 − s² of their area is less steep, and v is
 * the azimuth. Unlike sampled facets, they include hidden ones. In these coordinates, integrals and
 * histograms of rough surfaces are smooth for any roughness, also at the steep end, s = 0.
 */
record FacetMap(MicrofacetDistribution kind, double alpha) {
  private static final int CELLS = Effort.count(16, 64);
  private static final int POINTS = Effort.count(24, 10);

  /**
   * The number of points per side in cells where a million samples resolve the edge of the density.
   */
  private static final int FINE_POINTS = Effort.count(24, 80);

  /** The distance from a cell's corners at which they are evaluated. */
  private static final double CORNER = 1e-3;

  /** The maximum error of the sum over the cells. */
  private static final double ERROR = 1e-3;

  Microfacets distribution() {
    return Microfacets.of(kind, alpha);
  }

  private Vec3 facet(double s, double v) {
    double rest = s * s;
    double squared = kind == MicrofacetDistribution.BECKMANN ? -Math.log(rest) : (1 - rest) / rest;
    double slope = alpha * Math.sqrt(squared);
    double phi = 2 * Math.PI * v;
    return new Vec3(slope * Math.cos(phi), slope * Math.sin(phi), 1).normalized();
  }

  /** Returns the density of normals per solid angle: D cos θ ds/d(s²). */
  private double density(Vec3 m) {
    double s = steepness(m);
    double tail = kind == MicrofacetDistribution.BECKMANN ? s * s : s * s * s * s;
    return tail / (Math.PI * alpha * alpha * Math.pow(m.z(), 3)) / (2 * s);
  }

  /** Returns s, from 1 for a flat facet to 0 for an upright one. */
  private double steepness(Vec3 m) {
    double squared = (m.x() * m.x() + m.y() * m.y()) / (alpha * alpha * m.z() * m.z());
    return kind == MicrofacetDistribution.BECKMANN
        ? Math.exp(-.5 * squared)
        : 1 / Math.sqrt(1 + squared);
  }

  /** The direction into which a facet reflects or refracts wo, and its density in this map. */
  private record Scattered(Vec3 wi, double density) {
    static final Scattered NOTHING = new Scattered(Vec3.Z, 0);
  }

  /**
   * @param eta 0 to reflect; otherwise the index behind the facets divided by the index in front
   */
  private Scattered scatter(Vec3 wo, Vec3 m, double eta) {
    double cos = wo.dot(m);
    if (cos <= 0) {
      return Scattered.NOTHING;
    }
    if (eta == 0) {
      return new Scattered(m.times(2 * cos).minus(wo), density(m) / (4 * cos));
    }
    double squared = 1 - (1 - cos * cos) / (eta * eta);
    if (squared <= 0) {
      return Scattered.NOTHING;
    }
    double cosT = Math.sqrt(squared);
    Vec3 wi = m.times(cos / eta - cosT).minus(wo.times(1 / eta));
    double bending = cos - eta * cosT;
    return new Scattered(wi, density(m) * eta * eta * cosT / (bending * bending));
  }

  /**
   * Returns the integral of a function of wi over all directions into which facets reflect (eta =
   * 0) or refract wo.
   *
   * @param wo above the surface
   */
  double integral(Vec3 wo, double eta, int n, ToDoubleFunction<Vec3> f) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        Scattered scattered = scatter(wo, facet((i + .5) / n, (j + .5) / n), eta);
        sum += scattered.density == 0 ? 0 : f.applyAsDouble(scattered.wi) / scattered.density;
      }
    }
    return sum / (n * n);
  }

  /**
   * Checks that samples follow their density, and that the fraction of rejected samples is 1 minus
   * its integral.
   */
  void assertSamplesFollowPdf(
      Bsdf bsdf, Vec3 wo, double eta, int samples, SplittableRandom random) {
    int sheets = eta == 0 ? 1 : 2;
    int absorbed = sheets * CELLS * CELLS;
    long[] counts = new long[absorbed + 1];
    double side = Math.signum(wo.z());
    for (int i = 0; i < samples; i++) {
      BsdfSample sample = bsdf.sample(wo, random.nextDouble(), Draws.inSquare(random));
      if (sample.pdf() == 0) {
        counts[absorbed]++;
        continue;
      }
      assertThat(bsdf.pdf(wo, sample.wi())).isPositive();
      counts[cell(turned(wo, side), turned(sample.wi(), side), eta)]++;
    }
    double[] expected = expected(bsdf, wo, eta, samples, absorbed);
    if (expected[absorbed] < ERROR * samples) {
      // So few that the quadrature error matters.
      assertThat(counts[absorbed]).isLessThan((long) (2 * ERROR * samples));
      expected[absorbed] = counts[absorbed];
    }
    ChiSquare test = ChiSquare.of(counts, expected);
    assertThat(test.passes()).as("%s, wo %s: %s", this, wo, test).isTrue();
  }

  private double[] expected(Bsdf bsdf, Vec3 wo, double eta, int samples, int absorbed) {
    double[] expected = new double[absorbed + 1];
    double side = Math.signum(wo.z());
    Vec3 o = turned(wo, side);
    double all = 0;
    for (int i = 0; i < absorbed; i++) {
      boolean passes = i >= CELLS * CELLS;
      double integral =
          cellIntegral(
              i % (CELLS * CELLS),
              m -> {
                Scattered scattered = scatter(o, m, passes ? eta : 0);
                return scattered.density == 0 || scattered.wi.z() < 0 != passes
                    ? 0
                    : bsdf.pdf(wo, turned(scattered.wi, side)) / scattered.density;
              });
      all += integral;
      // In a corner too small for the quadrature, nothing is impossible.
      expected[i] = Math.max(1e-9, samples * integral);
    }
    assertThat(all).isLessThan(1 + ERROR);
    expected[absorbed] = Math.max(0, samples * (1 - all));
    return expected;
  }

  /** Negates z, which is equivalent to turning an isotropic surface over. */
  private static Vec3 turned(Vec3 w, double side) {
    return new Vec3(w.x(), w.y(), side * w.z());
  }

  private int cell(Vec3 wo, Vec3 wi, double eta) {
    boolean passes = wi.z() < 0;
    Vec3 half = (passes ? wo.plus(eta, wi) : wo.plus(wi)).normalized();
    Vec3 m = half.z() < 0 ? half.negated() : half;
    double v = Math.atan2(m.y(), m.x()) / (2 * Math.PI);
    int row = Math.min((int) (CELLS * steepness(m)), CELLS - 1);
    int column = Math.min((int) (CELLS * (v - Math.floor(v))), CELLS - 1);
    return (passes ? CELLS * CELLS : 0) + row * CELLS + column;
  }

  /** Integrates over a cell, and more finely where f becomes 0 inside it, even only at a corner. */
  private double cellIntegral(int cell, ToDoubleFunction<Vec3> f) {
    int positive = 0;
    for (int corner = 0; corner < 4; corner++) {
      double s = corner / 2 == 0 ? CORNER : 1 - CORNER;
      double v = corner % 2 == 0 ? CORNER : 1 - CORNER;
      positive += f.applyAsDouble(facet(cell, s, v)) > 0 ? 1 : 0;
    }
    return cellIntegral(cell, f, positive == 0 || positive == 4 ? POINTS : FINE_POINTS);
  }

  private double cellIntegral(int cell, ToDoubleFunction<Vec3> f, int points) {
    double sum = 0;
    for (int i = 0; i < points; i++) {
      for (int j = 0; j < points; j++) {
        sum += f.applyAsDouble(facet(cell, (i + .5) / points, (j + .5) / points));
      }
    }
    return sum / (points * points * CELLS * CELLS);
  }

  /** Returns the facet at a position in a cell. */
  private Vec3 facet(int cell, double s, double v) {
    return facet((cell / CELLS + s) / CELLS, (cell % CELLS + v) / CELLS);
  }
}
