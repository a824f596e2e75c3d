package io.github.lumbre.material;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;

/**
 * The directional albedo of GGX reflection with Schlick's Fresnel approximation: the fraction of
 * light from one direction that single scattering reflects. It is linear in F0 and F90, E = F0 a +
 * F90 b, so that two tables over direction and roughness suffice (Karis 2013, "Real Shading in
 * Unreal Engine 4"). A resource contains the tables, which GgxAlbedoQuadrature computes among the
 * tests.
 */
final class GgxAlbedo {
  static final int SIDE = 49;

  /** The tables {@link #A}, {@link #B}, {@link #MEAN_A} and {@link #MEAN_B}, as doubles. */
  static final String RESOURCE = "ggx-albedo.doubles";

  private static final double MIN_ALPHA = 1e-3;

  /** The fourth root of {@link #MIN_ALPHA}. */
  private static final double FIRST_ROOT = Math.sqrt(Math.sqrt(MIN_ALPHA));

  private static final double[] A = new double[SIDE * SIDE];
  private static final double[] B = new double[SIDE * SIDE];
  private static final double[] MEAN_A = new double[SIDE];
  private static final double[] MEAN_B = new double[SIDE];

  static {
    try (InputStream in = GgxAlbedo.class.getResourceAsStream(RESOURCE)) {
      DoubleBuffer values = ByteBuffer.wrap(in.readAllBytes()).asDoubleBuffer();
      values.get(A).get(B).get(MEAN_A).get(MEAN_B);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private GgxAlbedo() {}

  static double alpha(int row) {
    return fourthPower(FIRST_ROOT + (1 - FIRST_ROOT) * row / (SIDE - 1));
  }

  static double cosine(int column) {
    return Math.max(1e-6, fourthPower((double) column / (SIDE - 1)));
  }

  /** Columns and rows are at fourth powers: albedos change fast at small cosines and roughness. */
  private static double fourthPower(double x) {
    return x * x * x * x;
  }

  private static double fourthRoot(double x) {
    return Math.sqrt(Math.sqrt(Math.max(0, Math.min(1, x))));
  }

  private static double column(double cosine) {
    return fourthRoot(cosine) * (SIDE - 1);
  }

  private static double row(double alpha) {
    return Math.max(0, fourthRoot(alpha) - FIRST_ROOT) / (1 - FIRST_ROOT) * (SIDE - 1);
  }

  /** Returns the value of a table between two columns. */
  static double interpolated(double[] table, double cosine, int row) {
    double x = column(cosine);
    int i = Math.min(SIDE - 2, (int) x);
    double left = table[row * SIDE + i];
    return left + (x - i) * (table[row * SIDE + i + 1] - left);
  }

  private static double interpolated(double[] table, double cosine, double alpha) {
    double y = row(alpha);
    int row = Math.min(SIDE - 2, (int) y);
    double low = interpolated(table, cosine, row);
    return low + (y - row) * (interpolated(table, cosine, row + 1) - low);
  }

  private static double interpolated(double[] means, double alpha) {
    double y = row(alpha);
    int row = Math.min(SIDE - 2, (int) y);
    return means[row] + (y - row) * (means[row + 1] - means[row]);
  }

  /**
   * Returns the albedo for light from one direction.
   *
   * @param cosine between the direction and the normal, in [0,1]
   * @param alpha roughness of the distribution, in [0,1]
   */
  static double of(double f0, double f90, double cosine, double alpha) {
    return f0 * interpolated(A, cosine, alpha) + f90 * interpolated(B, cosine, alpha);
  }

  /** Returns the mean albedo under uniform radiance. */
  static double mean(double f0, double f90, double alpha) {
    return f0 * interpolated(MEAN_A, alpha) + f90 * interpolated(MEAN_B, alpha);
  }
}
