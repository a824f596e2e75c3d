package io.github.lumbre.material;

import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Warp;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;

/**
 * The fraction of light that single scattering by GGX facets of one roughness loses because it hits
 * a second facet: 1 - E, where E is the directional albedo of white facets that reflect and refract
 * by the exact Fresnel equations. With an infinite index they reflect everything, as the facets of
 * a white metal. The facets of a thin pane, which transmit into the mirrored direction, lose the
 * same.
 *
 * <p>The values lie between entries of a table over index, roughness, side and direction, which
 * FacetLossQuadrature computes among the tests. The entries are too small by {@link #MARGIN}, or by
 * more for indices near 1, so that E and the loss together exceed 1 nowhere.
 *
 * @param row of the table: the last one before the index and the roughness
 * @param towardsIndex place between two indices of the table, in [0,1]
 * @param towardsAlpha place between two roughnesses of the table, in [0,1]
 * @param isFlipped whether the denser side, which the table has below, is above
 */
record FacetLoss(int row, double towardsIndex, double towardsAlpha, boolean isFlipped) {
  static final int INDICES = 25;
  static final int ALPHAS = 33;
  static final int COLUMNS = 33;

  /**
   * The entries, as unsigned 16-bit fractions of 65535, and after them, as floats, two means of
   * each side of each row under uniform radiance: first with the values between the columns, then
   * with the average of each two neighboring columns.
   */
  static final String RESOURCE = "lost-light.table";

  /** What the entries lack, for indices from {@link #LEAST_SURE_INDEX}. */
  static final double MARGIN = .004;

  /** Below this index, light at grazing angles changes faster than the table resolves. */
  static final double LEAST_SURE_INDEX = 1.02;

  private static final double FIRST_ROOT = .1;

  /** The largest place between the columns. */
  private static final double LAST_COLUMN = Math.nextDown(COLUMNS - 1.0);

  /** The two sides of a row follow each other. */
  private static final short[] LOST = new short[INDICES * ALPHAS * 2 * COLUMNS];

  private static final float[] MEAN = new float[INDICES * ALPHAS * 2];
  private static final float[] STEPPED_MEAN = new float[MEAN.length];

  static {
    try (InputStream in = FacetLoss.class.getResourceAsStream(RESOURCE)) {
      ByteBuffer bytes = ByteBuffer.wrap(in.readAllBytes());
      bytes.asShortBuffer().get(LOST);
      bytes.position(LOST.length * Short.BYTES).asFloatBuffer().get(MEAN).get(STEPPED_MEAN);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns what facets lose.
   *
   * @param ior index of refraction below the surface relative to the one above, &gt; 0; may be
   *     infinite
   * @param alpha roughness of the distribution, in [0,1]
   */
  static FacetLoss of(double ior, double alpha) {
    double contrast = ior < Double.POSITIVE_INFINITY ? Math.abs(ior - 1) / (ior + 1) : 1;
    double x = cubeRoot(contrast) * (INDICES - 1);
    double y = Math.max(0, (cubeRoot(alpha) - FIRST_ROOT) / (1 - FIRST_ROOT)) * (ALPHAS - 1);
    int i = Math.min(INDICES - 2, (int) x);
    int j = Math.min(ALPHAS - 2, (int) y);
    return new FacetLoss(i * ALPHAS + j, x - i, y - j, ior < 1);
  }

  /** Returns the index of refraction of a part of the table. */
  static double index(int part) {
    double contrast = cube((double) part / (INDICES - 1));
    return (1 + contrast) / Math.max(1e-9, 1 - contrast);
  }

  /** Returns the roughness of a row within its part. */
  static double alpha(int row) {
    return cube(FIRST_ROOT + (1 - FIRST_ROOT) * row / (ALPHAS - 1));
  }

  static double cosine(int column) {
    return Math.max(1e-6, square((double) column / (COLUMNS - 1)));
  }

  /** Places are at powers: losses change fast at small contrasts, roughness and cosines. */
  private static double cube(double x) {
    return x * x * x;
  }

  private static double square(double x) {
    return x * x;
  }

  private static double cubeRoot(double x) {
    return x > 0 ? Elementary.pow(Math.min(1, x), 1.0 / 3) : 0;
  }

  /**
   * Returns the fraction of light from one direction that is lost.
   *
   * @param cosine between the direction and the normal; negative below the surface
   */
  double at(double cosine) {
    double x = column(cosine);
    int c = (int) x;
    int first = firstColumn(cosine < 0);
    double left = entry(first + c);
    return left + (x - c) * (entry(first + c + 1) - left);
  }

  /** Returns the place of a cosine between the columns, below the last. */
  private static double column(double cosine) {
    double x = Math.sqrt(Math.abs(cosine)) * (COLUMNS - 1);
    return Math.min(LAST_COLUMN, x);
  }

  private int firstColumn(boolean isBelow) {
    return isBelow != isFlipped ? COLUMNS : 0;
  }

  /** Returns the mean for one side under uniform radiance. */
  double mean(boolean isBelow) {
    return mean(MEAN, isBelow);
  }

  private double mean(float[] means, boolean isBelow) {
    int low = 2 * row + (isBelow != isFlipped ? 1 : 0);
    int high = low + 2 * ALPHAS;
    return between(means[low], means[low + 2], means[high], means[high + 2]);
  }

  /**
   * Returns the density per solid angle with which {@link #drawnCosine} draws a direction, which is
   * about in proportion to the loss times the cosine; 0 if nothing is lost on its side.
   */
  double density(double cosine) {
    double all = mean(STEPPED_MEAN, cosine < 0);
    int c = (int) column(cosine);
    int first = firstColumn(cosine < 0) + c;
    return all > 0
        ? .5 * (entry(first) + entry(first + 1)) / all * Warp.cosineHemispherePdf(Math.abs(cosine))
        : 0;
  }

  /**
   * Returns the absolute cosine of a drawn direction, at least 0.
   *
   * @param u uniform in [0,1)
   */
  double drawnCosine(double u, boolean isBelow) {
    int first = firstColumn(isBelow);
    double left = u * mean(STEPPED_MEAN, isBelow);
    double inner = 0;
    for (int c = 0; ; c++) {
      double outer = square(square((c + 1.0) / (COLUMNS - 1)));
      double step = .5 * (entry(first + c) + entry(first + c + 1)) * (outer - inner);
      if (left < step || c == COLUMNS - 2) {
        double rest = step > 0 ? Math.min(1, left / step) : 0;
        return Math.sqrt(inner + rest * (outer - inner));
      }
      left -= step;
      inner = outer;
    }
  }

  private double entry(int column) {
    int low = row * 2 * COLUMNS + column;
    int high = low + ALPHAS * 2 * COLUMNS;
    return between(
            LOST[low] & 0xffff,
            LOST[low + 2 * COLUMNS] & 0xffff,
            LOST[high] & 0xffff,
            LOST[high + 2 * COLUMNS] & 0xffff)
        / 65535;
  }

  /** Interpolates between two roughnesses of each of two indices. */
  private double between(double a, double b, double c, double d) {
    double first = a + towardsAlpha * (b - a);
    return first + towardsIndex * (c + towardsAlpha * (d - c) - first);
  }
}
