package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.texture.Texture;

/**
 * A photo studio as a sky: walls and soft lamps. All edges are smooth, so that it adds no noise. It
 * has the coordinates of a latitude-longitude image: u = 0.5 is forward, v = 1 is up.
 */
public enum StudioSky implements Texture<Rgb> {
  /**
   * White walls, a bright key light to the left in front of the object, a weaker fill light to the
   * right and a rim light behind.
   */
  SOFT(
      256,
      .22,
      .2,
      new Lamp(4, -.55, .6, -.58, .86),
      new Lamp(1, .75, .25, -.61, .75),
      new Lamp(2, .35, .55, .76, .9)),

  /**
   * Dark walls, a high key light to the left in front, two rim lights behind, and two low cards:
   * sides of an object differ in brightness, and dark plastics show edges and sheen.
   */
  RELIEF(
      64,
      .08,
      .12,
      new Lamp(4.1, -.6, 1.3, -.15, .8),
      new Lamp(1.8, -.4, .36, .82, .86),
      new Lamp(1.4, .7, .4, .7, .88),
      new Lamp(1.1, .5, .05, -1, .2));

  private final int columns;

  /** The radiance of the walls straight below, and how much more there is straight above. */
  private final double floor;

  private final double rise;
  private final Lamp[] lamps;

  StudioSky(int columns, double floor, double rise, Lamp... lamps) {
    this.columns = columns;
    this.floor = floor;
    this.rise = rise;
    this.lamps = lamps;
  }

  /**
   * A soft lamp.
   *
   * @param strength radiance in its middle
   * @param edge cosine of the angle between its middle and its edge
   * @param length of the vector to its middle
   */
  private record Lamp(
      double strength, double x, double y, double z, double edge, double length) {
    Lamp(double strength, double x, double y, double z, double edge) {
      this(strength, x, y, z, edge, Math.sqrt(x * x + y * y + z * z));
    }

    /** Returns 1 towards the lamp's middle, falling smoothly to 0 at its edge. */
    double lobe(double toX, double toY, double toZ) {
      double cosine = (toX * x + toY * y + toZ * z) / length;
      return smooth((cosine - edge) / (1 - edge));
    }
  }

  /** Returns the columns of a grid, half as high, that is fine enough to sample the lamps. */
  public int columns() {
    return columns;
  }

  @Override
  public Rgb at(double u, double v) {
    double elevation = Math.max(0, Math.min(1, v)) / 2 - .25;
    double azimuth = u - .5;
    double y = Elementary.sinTurns(elevation);
    double horizontal = Elementary.cosTurns(elevation);
    double x = horizontal * Elementary.sinTurns(azimuth);
    double z = horizontal * Elementary.cosTurns(azimuth);
    double light = floor + rise * smooth(.5 + .5 * y);
    for (Lamp lamp : lamps) {
      light += lamp.strength * lamp.lobe(x, y, z);
    }
    return new Rgb(light, light, light);
  }

  /** Returns 3t² - 2t³ with t clamped to [0,1]. */
  private static double smooth(double t) {
    double c = Math.max(0, Math.min(1, t));
    return c * c * (3 - 2 * c);
  }
}
