package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/**
 * The disk of the sun at the top of a latitude-longitude image, with the same radiance everywhere
 * and black around it. Its diameter is {@value #DIAMETER_DEGREES} degrees.
 *
 * @param radiance of the disk
 */
public record SunDisk(Rgb radiance) implements Texture<Rgb> {
  /** Diameter of the sun, as seen from the earth. */
  static final double DIAMETER_DEGREES = 2 * Air.SUN_RADIUS_DEGREES;

  /** Rows on the disk: samples of a row are closer to the center in proportion to 1 / distance. */
  private static final int ROWS_ON_DISK = 8;

  /** Number of rows of an image with texels so small that the disk's edge is between two rows. */
  public static final int ROWS = 676 * ROWS_ON_DISK;

  /** Just above the boundary of rows, which belongs to the row below. */
  private static final double EDGE = 1 - (double) ROWS_ON_DISK / ROWS + 1e-9;

  public SunDisk {
    Objects.requireNonNull(radiance, "radiance");
  }

  /**
   * Returns the sun with an irradiance.
   *
   * @param irradiance at normal incidence
   */
  public static SunDisk of(Rgb irradiance) {
    double sine = Elementary.sinDegrees(Air.SUN_RADIUS_DEGREES / 2);
    return new SunDisk(irradiance.times(1 / (4 * Math.PI * sine * sine)));
  }

  @Override
  public Rgb at(double u, double v) {
    return v > EDGE ? radiance : Rgb.BLACK;
  }
}
