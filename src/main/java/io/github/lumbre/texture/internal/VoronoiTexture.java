package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.sampling.internal.Hash;

/**
 * A Voronoi diagram of random points, each with a random color. The points are stratified: the
 * texture is divided into one part per point, all of equal area, and each part contains one point.
 */
public final class VoronoiTexture implements TexelTexture {
  /** The maximum number of cells. */
  public static final int MAX_SAMPLES = 1_000_000;

  /** The random numbers per cell: two for its position, three for its color. */
  private static final int NUMBERS = 5;

  private final long seed;
  private final int samples;
  private final boolean blackAndWhite;
  private final ToroidalSites sites;
  private final Texels nearest;

  /**
   * Creates a texture.
   *
   * @param seed the seed of all random numbers
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param samples the number of cells, 1 to {@value #MAX_SAMPLES}
   * @param blackAndWhite whether the colors are shades of gray
   * @throws IllegalArgumentException if a number is out of range
   */
  public VoronoiTexture(long seed, int width, int height, int samples, boolean blackAndWhite) {
    Texels.requireSize(width, height);
    if (samples < 1 || samples > MAX_SAMPLES) {
      throw new IllegalArgumentException(
          "samples: expected 1 to " + MAX_SAMPLES + ", found " + samples);
    }
    this.seed = seed;
    this.samples = samples;
    this.blackAndWhite = blackAndWhite;
    sites = stratified(width, height, samples);
    nearest = new Texels(width, height, (i, j) -> sites.nearest(i + .5, j + .5));
  }

  /**
   * Returns one point in each part. The parts are horizontal bands, cut into equal pieces; the
   * height of a band is proportional to its number of points.
   */
  private ToroidalSites stratified(int width, int height, int samples) {
    double[] x = new double[samples];
    double[] y = new double[samples];
    double ideal = Math.rint(Math.sqrt((double) samples * height / width));
    int bands = (int) Math.max(1, Math.min(samples, ideal));
    for (int band = 0; band < bands; band++) {
      int first = (int) ((long) samples * band / bands);
      int end = (int) ((long) samples * (band + 1) / bands);
      for (int i = first; i < end; i++) {
        x[i] = (i - first + random(i, 0)) / (end - first) * width;
        y[i] = (first + (end - first) * random(i, 1)) / samples * height;
      }
    }
    return new ToroidalSites(x, y, width, height);
  }

  private double random(int sample, int number) {
    return Hash.unit(Hash.of(seed, (long) NUMBERS * sample + number));
  }

  /** Returns the seed of all random numbers. */
  public long seed() {
    return seed;
  }

  /** Returns the number of cells. */
  public int samples() {
    return samples;
  }

  /** Returns whether the colors are shades of gray. */
  public boolean isBlackAndWhite() {
    return blackAndWhite;
  }

  @Override
  public int width() {
    return nearest.width();
  }

  @Override
  public int height() {
    return nearest.height();
  }

  @Override
  public Rgb texel(int column, int row) {
    int cell = (int) nearest.at(column, row);
    return blackAndWhite
        ? Rgb.gray(random(cell, 2))
        : new Rgb(random(cell, 2), random(cell, 3), random(cell, 4));
  }
}
