package io.github.lumbre.light.internal;

import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;

/**
 * The luminous intensity of a lamp by direction, from a table over two angles (type C photometry of
 * IES LM-63-2002). Between the angles of the table it is interpolated bilinearly, so that it never
 * leaves the range of the table, and the flux has a closed form. Immutable.
 *
 * <p>Directions are in the lamp's space: +z is the vertical angle 0 (nadir), +x the horizontal
 * angle 0, and +y the horizontal angle 90.
 */
public final class LightProfile {
  private final double[] vertical;
  private final double[] horizontal;

  /** The row of candelas of each horizontal angle. */
  private final int[] rows;

  /** Row by row; each has those of all vertical angles. */
  private final double[] candela;

  private final double largest;
  private final double flux;

  /**
   * Creates a profile. The arrays become its own.
   *
   * @param vertical at least one ascending angle in degrees, in [0,180]; no light leaves the lamp
   *     below the first and above the last
   * @param horizontal ascending angles in degrees: the first in [0,180], the last is the first plus
   *     360
   * @param rows for each horizontal angle the index of its row of candelas; angles may share rows
   * @param candela finite intensities in cd, at least 0, row by row; a row has those of all
   *     vertical angles
   */
  public LightProfile(double[] vertical, double[] horizontal, int[] rows, double[] candela) {
    if (rows.length != horizontal.length
        || rows.length < 2
        || horizontal[rows.length - 1] != horizontal[0] + 360) {
      throw new IllegalArgumentException(
          "horizontal: expected the angles of a full turn, each with a row, found "
              + horizontal.length
              + " angles and "
              + rows.length
              + " rows");
    }
    this.vertical = vertical;
    this.horizontal = horizontal;
    this.rows = rows;
    this.candela = candela;
    largest = Arrays.stream(candela).max().orElseThrow();
    flux = sphere();
  }

  /**
   * Returns a light with this profile. A scale does not change the profile; a mirrored space
   * mirrors it.
   *
   * @param source the point light that is multiplied by the intensities
   * @param toWorld from the lamp's space to world space; only its axes count
   */
  public Light light(PointLight source, Transform toWorld) {
    Frame axes =
        Frame.around(Directions.axis(toWorld), toWorld.vector(Vec3.X), toWorld.vector(Vec3.Y));
    return new ProfileLight(source, axes, this);
  }

  /**
   * Returns the intensity in cd.
   *
   * @param direction unit direction in which light leaves the lamp, in the lamp's space
   */
  public double intensity(Vec3 direction) {
    double across = Math.sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    double polar = Math.toDegrees(Elementary.atan2(across, direction.z()));
    if (polar < vertical[0] || polar > vertical[vertical.length - 1]) {
      return 0;
    }
    // 0 in place of -0, which would lie below the first angle.
    double turn = Math.toDegrees(Elementary.atan2(direction.y(), direction.x())) + 0.;
    double azimuth = turn < horizontal[0] ? turn + 360 : turn;
    int row = cell(horizontal, azimuth);
    double share = (azimuth - horizontal[row]) / (horizontal[row + 1] - horizontal[row]);
    return (1 - share) * ofRow(row, polar) + share * ofRow(row + 1, polar);
  }

  private double ofRow(int row, double polar) {
    if (vertical.length == 1) {
      return candela(row, 0);
    }
    int i = cell(vertical, polar);
    double share = (polar - vertical[i]) / (vertical[i + 1] - vertical[i]);
    return (1 - share) * candela(row, i) + share * candela(row, i + 1);
  }

  /** Returns the intensity of a horizontal and a vertical angle, by their indices. */
  private double candela(int row, int i) {
    return candela[rows[row] * vertical.length + i];
  }

  /** Returns the index of the first of the two angles around an angle. */
  private static int cell(double[] angles, double angle) {
    int found = Arrays.binarySearch(angles, angle);
    int below = found < 0 ? -found - 2 : found;
    return Math.min(below, angles.length - 2);
  }

  /** Returns the largest intensity of the table, in cd. */
  public double largest() {
    return largest;
  }

  /**
   * Returns the luminous flux in lm: the exact integral of {@link #intensity} over all directions.
   */
  public double flux() {
    return flux;
  }

  private double sphere() {
    double sum = 0;
    for (int i = 1; i < vertical.length; i++) {
      double from = vertical[i - 1];
      double to = vertical[i];
      // The integrals of sin θ, and of sin θ times the fraction of the way from one angle to the
      // next.
      double all = Elementary.cosDegrees(from) - Elementary.cosDegrees(to);
      double rising =
          (Elementary.sinDegrees(to) - Elementary.sinDegrees(from)) / Math.toRadians(to - from)
              - Elementary.cosDegrees(to);
      sum += (all - rising) * aroundAxis(i - 1) + rising * aroundAxis(i);
    }
    return sum;
  }

  /** Returns the integral of the intensity over a turn at a vertical angle. */
  private double aroundAxis(int i) {
    double sum = 0;
    for (int row = 1; row < horizontal.length; row++) {
      double mean = .5 * (candela(row - 1, i) + candela(row, i));
      sum += mean * Math.toRadians(horizontal[row] - horizontal[row - 1]);
    }
    return sum;
  }

  /** Returns the largest vertical angle at which light leaves the lamp, in degrees. */
  public double reach() {
    int last = 0;
    for (int i = 0; i < candela.length; i++) {
      if (candela[i] > 0) {
        last = Math.max(last, i % vertical.length);
      }
    }
    return vertical[Math.min(last + 1, vertical.length - 1)];
  }
}
