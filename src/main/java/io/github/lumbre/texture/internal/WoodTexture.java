package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.internal.Range;

/** Wood: dark rings around the center of the texture, distorted by turbulence. */
public final class WoodTexture implements TexelTexture {
  /** The valid numbers of rings. */
  public static final Range RINGS = Range.NOT_NEGATIVE;

  private static final double COARSEST = 32;
  private static final double BENDING = .035;
  private static final double RED = 80 / 255.0;
  private static final double GREEN_AND_BLUE = 30 / 255.0;

  private final long seed;
  private final Noise noise;
  private final double rings;
  private final Texels light;

  /**
   * Creates a texture.
   *
   * @param seed the seed of all random numbers
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param rings the number of dark rings from the center to the middle of a side; finite and ≥ 0
   * @throws IllegalArgumentException if a number is out of range
   */
  public WoodTexture(long seed, int width, int height, double rings) {
    this.seed = seed;
    this.rings = RINGS.require("rings", rings);
    noise = new Noise(seed, width, height, COARSEST);
    light = new Texels(width, height, this::light);
  }

  private double light(int column, int row) {
    double x = (double) column / light.width() - .5;
    double y = (double) row / light.height() - .5;
    double d = Math.sqrt(x * x + y * y) + BENDING * noise.turbulence(column, row);
    double turns = rings * d;
    // Removing whole turns does not change the result, but keeps the argument in the range of the
    // sine.
    return Math.abs(Elementary.sinTurns(turns - Math.floor(turns))) / 2;
  }

  /** Returns the seed of all random numbers. */
  public long seed() {
    return seed;
  }

  /** Returns the number of dark rings from the center to the middle of a side. */
  public double rings() {
    return rings;
  }

  @Override
  public int width() {
    return light.width();
  }

  @Override
  public int height() {
    return light.height();
  }

  @Override
  public Rgb texel(int column, int row) {
    double s = light.at(column, row);
    return new Rgb(RED + s, GREEN_AND_BLUE + s, GREEN_AND_BLUE);
  }
}
