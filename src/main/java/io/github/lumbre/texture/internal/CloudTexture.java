package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;

/** Clouds: turbulence that blends from sky blue to white, in linear RGB. */
public final class CloudTexture implements TexelTexture {
  private static final double GREEN_OF_SKY = .753;
  private static final double GREEN_OF_CLOUDS = .247;

  private final long seed;
  private final double density;
  private final Texels thickness;

  /**
   * Creates a texture.
   *
   * @param seed the seed of all random numbers
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param density the size of the largest clouds in texels, finite and ≥ 1
   * @throws IllegalArgumentException if a number is out of range
   */
  public CloudTexture(long seed, int width, int height, double density) {
    this.seed = seed;
    this.density = density;
    thickness = new Texels(width, height, new Noise(seed, width, height, density)::turbulence);
  }

  /** Returns the seed of all random numbers. */
  public long seed() {
    return seed;
  }

  /** Returns the size of the largest clouds in texels. */
  public double density() {
    return density;
  }

  @Override
  public int width() {
    return thickness.width();
  }

  @Override
  public int height() {
    return thickness.height();
  }

  @Override
  public Rgb texel(int column, int row) {
    double t = thickness.at(column, row);
    return new Rgb(t, GREEN_OF_SKY + GREEN_OF_CLOUDS * t, 1);
  }
}
