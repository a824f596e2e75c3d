package io.github.lumbre.material;

import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.nio.ByteBuffer;
import java.util.stream.IntStream;

/** Computes the table of {@link FacetLoss} by a fixed quadrature. */
final class FacetLossQuadrature {
  static final int ENTRIES = FacetLoss.INDICES * FacetLoss.ALPHAS * 2 * FacetLoss.COLUMNS;

  static final int BYTES = ENTRIES * Short.BYTES + 2 * ENTRIES / FacetLoss.COLUMNS * Float.BYTES;

  /** Points of the quadrature over the steepness of facets, and over half of their azimuths. */
  private static final int POINTS = 64;

  private static final int AZIMUTHS = 20;

  /** The margin that an index of 1 has more than others. */
  private static final double MORE_MARGIN = .03;

  private FacetLossQuadrature() {}

  /** Returns the contents of the resource. */
  static byte[] table() {
    return table(IntStream.range(0, ENTRIES).parallel().map(i -> entry(i)).toArray());
  }

  /** Returns the contents of a resource with some entries. */
  static byte[] table(int[] entries) {
    ByteBuffer bytes = ByteBuffer.allocate(BYTES);
    for (int entry : entries) {
      bytes.putShort((short) entry);
    }
    putMeans(bytes, entries, 64);
    putMeans(bytes, entries, 1);
    return bytes.array();
  }

  /** Puts the means of steps between the columns; each step has the average of its ends. */
  private static void putMeans(ByteBuffer bytes, int[] entries, int steps) {
    int last = FacetLoss.COLUMNS - 1;
    for (int side = 0; side < ENTRIES / FacetLoss.COLUMNS; side++) {
      int first = side * FacetLoss.COLUMNS;
      double mean = 0;
      for (int i = 0; i < last * steps; i++) {
        int c = i / steps;
        double t = (i % steps + .5) / steps;
        double entry = entries[first + c] + t * (entries[first + c + 1] - entries[first + c]);
        mean +=
            entry
                / 65535.0
                * (square((i + 1.0) / (last * steps)) - square((double) i / (last * steps)));
      }
      bytes.putFloat((float) mean);
    }
  }

  /** Returns the square of the cosine at a square root of the cosine. */
  private static double square(double root) {
    return root * root * root * root;
  }

  /** Returns an entry, from 0 to 65535. */
  static int entry(int place) {
    int column = place % FacetLoss.COLUMNS;
    boolean isBelow = place / FacetLoss.COLUMNS % 2 == 1;
    int row = place / FacetLoss.COLUMNS / 2;
    double ior = FacetLoss.index(row / FacetLoss.ALPHAS);
    double alpha = FacetLoss.alpha(row % FacetLoss.ALPHAS);
    double albedo =
        albedo(FacetLoss.cosine(column), alpha, isBelow ? 1 / ior : ior, POINTS, AZIMUTHS);
    return (int) (65535 * Math.max(0, 1 - albedo - margin(ior)));
  }

  private static double margin(double ior) {
    double near = Math.max(0, FacetLoss.LEAST_SURE_INDEX - ior) / (FacetLoss.LEAST_SURE_INDEX - 1);
    return FacetLoss.MARGIN + MORE_MARGIN * near;
  }

  /**
   * Integrates over facets m. The fraction 1 - s² of their area is less steep than a facet of
   * steepness s, so that dm = 2 s / (D cos θm) ds, which makes the integrand continuous.
   *
   * @param eta index on the other side, relative to the side of the direction
   */
  static double albedo(double cosine, double alpha, double eta, int points, int azimuths) {
    Ggx facets = new Ggx(alpha);
    Vec3 wo = new Vec3(Math.sqrt((1 - cosine) * (1 + cosine)), 0, cosine);
    double visible = facets.visible(cosine);
    double sum = 0;
    for (int i = 0; i < points; i++) {
      // Squares, because masking changes fast where facets are steep; a sine, because the
      // integrand has an infinite slope at s = 1.
      double root = (i + .5) / points;
      double s = Elementary.sinTurns(.25 * root * root);
      double rest = Elementary.cosTurns(.25 * root * root);
      double slope = alpha * rest / s;
      double up = 1 / Math.sqrt(1 + slope * slope);
      double across = slope * up;
      double sums = 0;
      for (boolean reflects : new boolean[] {true, false}) {
        // Only facets up to this azimuth reflect to above the surface, or are visible.
        double b = cosine * (reflects ? up - .5 / up : up);
        double last = GgxAlbedoQuadrature.lastAzimuth(b, wo.x() * across);
        for (int j = 0; j < azimuths; j++) {
          double turns = last * (j + .5) / azimuths;
          double x = across * Elementary.cosTurns(turns);
          Vec3 m = new Vec3(x, across * Elementary.sinTurns(turns), up);
          sums += last * scattered(facets, wo, m, eta, reflects);
        }
      }
      sum += 2 * Elementary.TWO_PI * root * rest * s * sums / (visible * up);
    }
    return sum / (points * azimuths);
  }

  private static double scattered(Ggx facets, Vec3 wo, Vec3 m, double eta, boolean reflects) {
    double cos = Math.min(1, wo.dot(m));
    if (!(cos > 0)) {
      return 0;
    }
    double fresnel = Fresnel.dielectric(cos, eta);
    double cosI =
        reflects
            ? 2 * cos * m.z() - wo.z()
            : wo.z() / eta
                - m.z() * (cos / eta - Fresnel.cosTransmitted(cos, (1 - cos) * (1 + cos), eta));
    double share = reflects ? fresnel : 1 - fresnel;
    return share > 0 && cosI > 0 ? cos * share * facets.maskingRatio(wo.z(), Math.min(1, cosI)) : 0;
  }
}
