package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Distribution2d;
import io.github.lumbre.sampling.Warp;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.Objects;
import java.util.Optional;

/**
 * Light from all around, infinitely far: a dome, of one radiance or of a latitude-longitude image.
 * An image reads unmirrored from inside, its centre towards the dome's +z, its top up. Immutable.
 */
public final class EnvironmentLight implements Light {
  private final Frame axes;
  private final Texture<Rgb> radiance;
  private final Optional<Distribution2d> distribution;
  private final boolean black;

  private EnvironmentLight(
      Frame axes, Texture<Rgb> radiance, Optional<Distribution2d> distribution, boolean black) {
    this.axes = axes;
    this.radiance = radiance;
    this.distribution = distribution;
    this.black = black;
  }

  /** Returns a dome of one radiance in all directions. */
  public static EnvironmentLight uniform(Rgb radiance) {
    return new EnvironmentLight(
        Frame.WORLD, Texture.constant(radiance), Optional.empty(), radiance.isBlack());
  }

  /**
   * Returns a dome that shows an image and is sampled in proportion to its brightness.
   *
   * @param axes the dome's right, up and forward in the world
   * @param radiance over u, v in [0,1]², v = 1 at the top
   * @param columns of the grid on which the brightness is tabulated: the image's own, for instance
   * @param rows likewise
   */
  public static EnvironmentLight image(
      Frame axes, Texture<Rgb> radiance, int columns, int rows) {
    Objects.requireNonNull(axes, "axes");
    Objects.requireNonNull(radiance, "radiance");
    double[][] weights = new double[rows][columns];
    double total = 0;
    for (int row = 0; row < rows; row++) {
      double solidAngle =
          Elementary.sinTurns((row + 1.0) / rows / 2 - .25)
              - Elementary.sinTurns((double) row / rows / 2 - .25);
      for (int column = 0; column < columns; column++) {
        weights[row][column] =
            solidAngle * brightest(radiance, column, row, columns, rows);
        total += weights[row][column];
      }
    }
    return new EnvironmentLight(
        axes, radiance, Optional.of(new Distribution2d(weights)), total == 0);
  }

  /** Returns a brightness that is positive wherever the cell's radiance is, filtering included. */
  private static double brightest(
      Texture<Rgb> radiance, int column, int row, int columns, int rows) {
    double most = 0;
    for (double dy = 0; dy <= 1; dy += .5) {
      for (double dx = 0; dx <= 1; dx += .5) {
        // Just inside the cell, so that an unfiltered neighbour does not count.
        double u = (column + .001 + .998 * dx) / columns;
        double v = (row + .001 + .998 * dy) / rows;
        most = Math.max(most, radiance.at(new TexturePoint(u, v)).max());
      }
    }
    return most;
  }

  /** Returns the radiance that arrives from a unit direction. */
  public Rgb from(Vec3 direction) {
    return radiance.at(texturePoint(direction));
  }

  /** Returns the density per solid angle with which {@link #sample} draws a unit direction. */
  public double pdf(Vec3 direction) {
    if (distribution.isEmpty()) {
      return Warp.INV_FOUR_PI;
    }
    TexturePoint p = texturePoint(direction);
    double cosLatitude = Elementary.cosTurns((p.v() - .5) / 2);
    return cosLatitude <= 0 ? 0 : density(new Point2(p.u(), p.v()), cosLatitude);
  }

  @Override
  public Optional<LightSample> sample(Vec3 reference, Point2 u) {
    if (distribution.isEmpty()) {
      Vec3 wi = Warp.uniformSphere(u);
      return Optional.of(arriving(wi, from(wi), Warp.INV_FOUR_PI));
    }
    Point2 p = distribution.get().sample(u);
    double longitude = p.x() - .5;
    double latitude = (p.y() - .5) / 2;
    double across = Elementary.cosTurns(latitude);
    if (across <= 0) {
      return Optional.empty();
    }
    Vec3 wi =
        axes.toWorld(
            new Vec3(
                across * Elementary.sinTurns(longitude),
                Elementary.sinTurns(latitude),
                across * Elementary.cosTurns(longitude)));
    return Optional.of(
        arriving(wi, radiance.at(new TexturePoint(p.x(), p.y())), density(p, across)));
  }

  /** Per solid angle: the square's area element is dω / (2π² cos latitude). */
  private double density(Point2 p, double cosLatitude) {
    return distribution.get().pdf(p) / (2 * Math.PI * Math.PI * cosLatitude);
  }

  private static LightSample arriving(Vec3 wi, Rgb radiance, double pdf) {
    return new LightSample(wi, radiance, pdf, LightSample.AtInfinity.INSTANCE);
  }

  private TexturePoint texturePoint(Vec3 direction) {
    if (distribution.isEmpty()) {
      return new TexturePoint(0, 0);
    }
    Vec3 d = axes.toLocal(direction);
    return new TexturePoint(
        .5 + Elementary.atan2(d.x(), d.z()) / Elementary.TWO_PI,
        .5 + Elementary.asin(d.y()) * Elementary.INV_PI);
  }

  @Override
  public boolean isBlack() {
    return black;
  }

  @Override
  public boolean isDelta() {
    return false;
  }
}
