package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.Texture;

/**
 * A photo studio as a sky: white walls, a bright key light to the left in front of the object, a
 * weaker fill light to the right and a rim light behind. All edges are smooth, so that it adds no
 * noise. It has the coordinates of a latitude-longitude image: u = 0.5 is forward, v = 1 is up.
 */
public enum StudioSky implements Texture<Rgb> {
  INSTANCE;

  /** The resolution at which the sky can be tabulated without losing a light. */
  public static final int COLUMNS = 256;

  /** The number of rows that belongs to {@link #COLUMNS}. */
  public static final int ROWS = 128;

  @Override
  public Rgb at(double u, double v) {
    double elevation = Math.max(0, Math.min(1, v)) / 2 - .25;
    double azimuth = u - .5;
    double y = Elementary.sinTurns(elevation);
    double horizontal = Elementary.cosTurns(elevation);
    double x = horizontal * Elementary.sinTurns(azimuth);
    double z = horizontal * Elementary.cosTurns(azimuth);
    double walls = .22 + .2 * smooth(.5 + .5 * y);
    double key = 4 * lobe(x, y, z, -.55, .6, -.58, .86);
    double fill = 1 * lobe(x, y, z, .75, .25, -.61, .75);
    double rim = 2 * lobe(x, y, z, .35, .55, .76, .9);
    double light = walls + key + fill + rim;
    return new Rgb(light, light, light);
  }

  /** Returns 1 towards a direction, falling smoothly to 0 at a cosine. */
  private static double lobe(
      double x, double y, double z, double lx, double ly, double lz, double edge) {
    double cosine = (x * lx + y * ly + z * lz) / Math.sqrt(lx * lx + ly * ly + lz * lz);
    return smooth((cosine - edge) / (1 - edge));
  }

  /** Returns 3t² - 2t³ with t clamped to [0,1]. */
  private static double smooth(double t) {
    double c = Math.max(0, Math.min(1, t));
    return c * c * (3 - 2 * c);
  }
}
