package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Warp;

/**
 * The sheen of cloth: fibers with the Charlie distribution (Estevez and Kulla 2017, "Production
 * Friendly Microfacet Sheen BRDF") and the visibility of Ashikhmin and Premoze 2007, on both sides
 * of the surface (KHR_materials_sheen). Divided by its largest albedo where that exceeds 1.
 *
 * @param color albedo factor, each component in [0,1]
 * @param roughness perceptual roughness in [0,1]; the exponent of the distribution is the inverse
 *     of its square
 */
record Sheen(Rgb color, double roughness) implements Lobe {
  private static final int ROWS = 17;
  private static final int COLUMNS = 33;

  /** Points per side of the quadrature. */
  private static final int POINTS = 24;

  private static final double MIN_ROUGHNESS = .07;

  /** Cosines and sines of the azimuths of the quadrature. */
  private static final double[] COSINES = new double[POINTS];

  private static final double[] SINES = new double[POINTS];

  private static final double[] ALBEDO = new double[ROWS * COLUMNS];

  /** The largest albedo of each row, at least 1. */
  private static final double[] MOST = new double[ROWS];

  static {
    for (int j = 0; j < POINTS; j++) {
      COSINES[j] = Elementary.cosTurns(.5 * (j + .5) / POINTS);
      SINES[j] = Elementary.sinTurns(.5 * (j + .5) / POINTS);
    }
    for (int r = 0; r < ROWS; r++) {
      double roughness = MIN_ROUGHNESS + square((double) r / (ROWS - 1)) * (1 - MIN_ROUGHNESS);
      MOST[r] = 1;
      for (int c = 0; c < COLUMNS; c++) {
        int entry = r * COLUMNS + c;
        ALBEDO[entry] = integrated(square((double) c / (COLUMNS - 1)), roughness);
        MOST[r] = Math.max(MOST[r], ALBEDO[entry]);
      }
    }
  }

  /** Returns the position of a roughness between the rows. */
  private static double row(double roughness) {
    double x = (Math.max(MIN_ROUGHNESS, roughness) - MIN_ROUGHNESS) / (1 - MIN_ROUGHNESS);
    return Math.sqrt(x) * (ROWS - 1);
  }

  /** Integrates over half of the azimuths, because the other half is its mirror image. */
  private static double integrated(double cosine, double roughness) {
    double mu = Math.max(1e-3, cosine);
    Vec3 wo = new Vec3(Math.sqrt((1 - mu) * (1 + mu)), 0, mu);
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
      // Squares, because the value changes fast near the horizon.
      double root = (i + .5) / POINTS;
      double z = square(root);
      double across = Math.sqrt((1 - z) * (1 + z));
      for (int j = 0; j < POINTS; j++) {
        Vec3 wi = new Vec3(across * COSINES[j], across * SINES[j], z);
        sum += 2 * root * unscaled(wo, wi, roughness);
      }
    }
    return sum * Elementary.TWO_PI / (POINTS * POINTS);
  }

  /** Returns f·cos θi for two directions above the surface, without color. */
  private static double unscaled(Vec3 o, Vec3 i, double roughness) {
    double exponent = 1 / square(Math.max(MIN_ROUGHNESS, roughness));
    double cosine = Math.min(1, o.plus(i).normalized().z());
    double sine = Math.sqrt((1 - cosine) * (1 + cosine));
    double density = (2 + exponent) * Elementary.pow(sine, exponent) / Elementary.TWO_PI;
    return density * i.z() / (4 * (o.z() + i.z() - o.z() * i.z()));
  }

  private static double square(double x) {
    return x * x;
  }

  /** Returns the albedo of white sheen for light from one direction. */
  static double albedo(double cosine, double roughness) {
    // Columns are at squares, because the albedo changes fast at grazing angles.
    double x = Math.sqrt(Math.min(1, cosine)) * (COLUMNS - 1);
    double y = row(roughness);
    int c = Math.min(COLUMNS - 2, (int) x);
    int r = Math.min(ROWS - 2, (int) y);
    int low = r * COLUMNS + c;
    int high = low + COLUMNS;
    double mean =
        mix(
            mix(ALBEDO[low], ALBEDO[low + 1], x - c),
            mix(ALBEDO[high], ALBEDO[high + 1], x - c),
            y - r);
    return mean * scale(roughness);
  }

  /** Returns the factor that keeps the albedo at most 1; it is continuous. */
  private static double scale(double roughness) {
    double y = row(roughness);
    int r = Math.min(ROWS - 2, (int) y);
    return 1 / mix(MOST[r], MOST[r + 1], y - r);
  }

  private static double mix(double a, double b, double t) {
    return a + t * (b - a);
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (!(woZ * wiZ > 0)) {
      result.clear();
      return;
    }
    double side = Math.signum(woZ);
    double value =
        unscaled(
            new Vec3(woX, woY, woZ).times(side), new Vec3(wiX, wiY, wiZ).times(side), roughness);
    result.set(color.times(value * scale(roughness)), .5 * Elementary.INV_PI);
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 up = Warp.uniformHemisphere(new Point2(u, v));
    result.setDirection(up.x(), up.y(), Math.copySign(up.z(), woZ));
    return up.z() != 0 && woZ != 0;
  }

  @Override
  public double importance(double cosine) {
    return color.max() * albedo(Math.abs(cosine), roughness);
  }

  @Override
  public Rgb albedo() {
    return color;
  }
}
