package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Distribution2d;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.GridMaxima;
import java.util.Objects;
import java.util.Optional;

/**
 * An environment light: light from infinity in all directions, either of one constant radiance or
 * from a latitude-longitude image. Seen from inside, the image is not mirrored; its center lies
 * towards the light's local +z and its top towards +y. Immutable.
 */
public final class EnvironmentLight implements Light {
  /** The largest radiance of a sky in files: the light of all its directions is finite. */
  public static final double MAX_RADIANCE = 1e150;

  /** The largest texture coordinate. Textures repeat, so at 1 the zenith would show the nadir. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** The smallest weight of a light, so that it is selected if it is the only one. */
  private static final double LEAST_SHARE = 1e-3;

  private final Frame axes;
  private final Texture<Rgb> radiance;
  private final Optional<Distribution2d> distribution;
  private final double meanBrightness;
  private final Optional<int[]> grid;
  private final double choiceShare;

  /** What {@link #besideBsdf} returns; null until it is needed. */
  private volatile EnvironmentLight besideBsdf;

  private EnvironmentLight(
      Frame axes,
      Texture<Rgb> radiance,
      Optional<Distribution2d> distribution,
      double meanBrightness,
      Optional<int[]> grid,
      double choiceShare) {
    this.grid = grid;
    this.choiceShare = choiceShare;
    this.axes = axes;
    this.radiance = radiance;
    this.distribution = distribution;
    this.meanBrightness = meanBrightness;
  }

  /** Returns an environment light with the same radiance in all directions. */
  public static EnvironmentLight uniform(Rgb radiance) {
    return new EnvironmentLight(
        Frame.WORLD,
        Texture.constant(radiance),
        Optional.empty(),
        radiance.max(),
        Optional.empty(),
        1);
  }

  /**
   * Returns an environment light from an image, sampled in proportion to the image's brightness.
   *
   * @param axes directions of the light's right, up and forward axes in world space
   * @param radiance radiance over (u, v) in [0,1]², with v = 1 at the top
   * @param columns number of columns of the grid on which brightness is tabulated, for example the
   *     width of the image
   * @param rows number of rows of that grid
   */
  public static EnvironmentLight image(Frame axes, Texture<Rgb> radiance, int columns, int rows) {
    Objects.requireNonNull(axes, "axes");
    Objects.requireNonNull(radiance, "radiance");
    double[][] weights =
        GridMaxima.table(radiance, columns, rows)
            .orElseGet(() -> brightest(radiance, columns, rows));
    double total = 0;
    for (int row = 0; row < rows; row++) {
      double solidAngle = solidAngle(row, rows);
      double[] cells = weights[row];
      for (int column = 0; column < columns; column++) {
        cells[column] *= solidAngle;
        total += cells[column];
      }
    }
    return new EnvironmentLight(
        axes,
        radiance,
        Optional.of(new Distribution2d(weights)),
        total / (2 * columns),
        Optional.of(new int[] {columns, rows}),
        1);
  }

  /**
   * Returns this light, to be sampled and selected as the sky's part of one image with the sun: in
   * proportion to its brightness above the mean over the sphere of both. Other environment lights
   * are selected in proportion to all their light.
   *
   * @param sun mean over the sphere of the sun's radiance, its largest color component, at least 0
   */
  public EnvironmentLight besideSun(double sun) {
    if (distribution.isEmpty() || meanBrightness == 0) {
      return this;
    }
    double[][] density = aboveMean(1 + sun / meanBrightness);
    double share = 0;
    for (double[] row : density) {
      for (double part : row) {
        share += part;
      }
    }
    EnvironmentLight result =
        new EnvironmentLight(
            axes, radiance, distribution, meanBrightness, grid, Math.max(LEAST_SHARE, share));
    result.besideBsdf = result.sampledBy(density);
    return result;
  }

  /**
   * Returns the factor of this light's weights when lights are selected at random: 1, or a part of
   * it for {@link #besideSun}.
   */
  public double choiceShare() {
    return choiceShare;
  }

  /** Returns the solid angle of a row of the grid, divided by 2π. */
  private static double solidAngle(int row, int rows) {
    return Elementary.sinTurns((row + 1.0) / rows / 2 - .25)
        - Elementary.sinTurns((double) row / rows / 2 - .25);
  }

  /**
   * Returns a brightness of each grid cell that is positive if the filtered radiance is positive
   * anywhere in the cell.
   */
  private static double[][] brightest(Texture<Rgb> radiance, int columns, int rows) {
    double[][] brightest = new double[rows][columns];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        brightest[row][column] = brightest(radiance, column, row, columns, rows);
      }
    }
    return brightest;
  }

  private static double brightest(
      Texture<Rgb> radiance, int column, int row, int columns, int rows) {
    double most = 0;
    for (int y = 0; y <= 2; y++) {
      for (int x = 0; x <= 2; x++) {
        double u = GridMaxima.coordinate(column, x, columns);
        double v = GridMaxima.coordinate(row, y, rows);
        most = Math.max(most, radiance.at(u, v).max());
      }
    }
    return most;
  }

  /** Returns the directions of the light's right, up and forward axes in world space. */
  public Frame axes() {
    return axes;
  }

  /** Returns the radiance over (u, v) in [0,1]², with v = 1 at the top. */
  public Texture<Rgb> radiance() {
    return radiance;
  }

  /** Returns the grid on which brightness is tabulated, {columns, rows}; empty if uniform. */
  public Optional<int[]> grid() {
    return grid.map(int[]::clone);
  }

  /**
   * Returns this light with a density that suits multiple importance sampling beside BSDF samples:
   * in proportion to the brightness above the mean over the sphere, and 0 for directions that are
   * not brighter. Those are left to BSDF samples, which find them at least as well (Karlík et al.
   * 2019, "MIS compensation"). The density alone cannot sample all light of the sky.
   */
  public EnvironmentLight besideBsdf() {
    if (distribution.isEmpty()) {
      return this;
    }
    EnvironmentLight result = besideBsdf;
    if (result == null) {
      result = sampledBy(aboveMean(1));
      besideBsdf = result;
    }
    return result;
  }

  private EnvironmentLight sampledBy(double[][] density) {
    Optional<Distribution2d> other = Optional.of(new Distribution2d(density));
    return new EnvironmentLight(axes, radiance, other, meanBrightness, grid, choiceShare);
  }

  /**
   * Returns the part of the light in each cell of the grid that is above a multiple of the mean.
   */
  private double[][] aboveMean(double factor) {
    Distribution2d brightness = distribution.get();
    int columns = grid.get()[0];
    int rows = grid.get()[1];
    double[][] weights = new double[rows][columns];
    for (int row = 0; row < rows; row++) {
      double even = factor * solidAngle(row, rows) / (2 * columns);
      for (int column = 0; column < columns; column++) {
        weights[row][column] = Math.max(0, brightness.probability(row, column) - even);
      }
    }
    return weights;
  }

  /** {@inheritDoc} An environment light cannot be moved. */
  @Override
  public EnvironmentLight transformed(Transform outer) {
    throw new IllegalArgumentException(
        "light: expected one that can be moved, found an environment light; add it to the scene");
  }

  /** Returns the radiance that arrives from a unit direction in world space. */
  public Rgb from(Vec3 direction) {
    if (distribution.isEmpty()) {
      return radiance.at(.5, .5);
    }
    Vec3 d = axes.toLocal(direction);
    return radiance.at(u(d), v(d));
  }

  @Override
  public double pdf(Vec3 direction) {
    if (distribution.isEmpty()) {
      return Warp.INV_FOUR_PI;
    }
    Vec3 d = axes.toLocal(direction);
    double cosLatitude = cosLatitude(d);
    if (cosLatitude == 0) {
      return 0;
    }
    return perSolidAngle(distribution.get().pdf(new Point2(u(d), v(d))), cosLatitude);
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    if (distribution.isEmpty()) {
      Vec3 wi = Warp.uniformSphere(new Point2(u, v));
      result.setInfinite(wi, from(wi), Warp.INV_FOUR_PI);
      return;
    }
    Distribution2d.Sample texel = distribution.get().sample(new Point2(u, v));
    double longitude = texel.x() - .5;
    double latitude = (texel.y() - .5) / 2;
    double across = Elementary.cosTurns(latitude);
    double pdf = across > 0 ? perSolidAngle(texel.pdf(), across) : 0;
    if (pdf == 0) {
      result.clear();
      return;
    }
    Vec3 wi =
        axes.toWorld(
            new Vec3(
                across * Elementary.sinTurns(longitude),
                Elementary.sinTurns(latitude),
                across * Elementary.cosTurns(longitude)));
    result.setInfinite(wi, radiance.at(texel.x(), texel.y()), pdf);
  }

  /**
   * Converts a density per unit area of the image to one per solid angle: dω = 2π² cos(latitude)
   * dA.
   */
  private static double perSolidAngle(double pdf, double cosLatitude) {
    return pdf / (2 * Math.PI * Math.PI * cosLatitude);
  }

  /**
   * Returns the horizontal image coordinate in [0,1) of a direction in the light's local space,
   * from left to right.
   */
  private static double u(Vec3 d) {
    return Math.min(.5 + Elementary.atan2(d.x(), d.z()) / Elementary.TWO_PI, BELOW_ONE);
  }

  /**
   * Returns the vertical image coordinate in [0,1) of a direction in the light's local space, from
   * bottom to top.
   */
  private static double v(Vec3 d) {
    // An arcsine would lose half the digits near the poles.
    return Math.min(.5 + Elementary.atan2(d.y(), cosLatitude(d)) / Math.PI, BELOW_ONE);
  }

  private static double cosLatitude(Vec3 d) {
    return Math.sqrt(d.x() * d.x() + d.z() * d.z());
  }

  @Override
  public double power(double sceneRadius) {
    return meanBrightness * Math.PI * Math.PI * sceneRadius * sceneRadius;
  }

  /**
   * {@inheritDoc}
   *
   * <p>For an image: the irradiance of a surface that faces a small spot with all the light of the
   * image. For a constant radiance 0: BSDF samples alone find this light best.
   */
  @Override
  public double farIrradiance() {
    return isEven() ? 0 : 4 * Math.PI * meanBrightness * choiceShare;
  }

  /** Returns whether the radiance is the same in all directions. */
  public boolean isEven() {
    return distribution.isEmpty();
  }

  @Override
  public boolean isBlack() {
    return meanBrightness == 0;
  }

  @Override
  public boolean isDelta() {
    return false;
  }
}
