package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Elementary;

/** Wood: dark rings around the texture's centre, bent by turbulence. */
public final class WoodTexture implements TexelTexture {
  private static final double COARSEST = 32;
  private static final double BENDING = .035;
  private static final double RED = 80 / 255.0;
  private static final double GREEN_AND_BLUE = 30 / 255.0;

  private final Noise noise;
  private final double rings;
  private final Texels light;

  /**
   * @param seed everything random follows from it
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height likewise
   * @param rings how many dark rings there are from the centre to the middle of a side; finite and
   *     ≥ 0
   */
  public WoodTexture(long seed, int width, int height, double rings) {
    if (!(rings >= 0) || Double.isInfinite(rings)) {
      throw new IllegalArgumentException("rings: expected a finite number >= 0, found " + rings);
    }
    this.rings = rings;
    noise = new Noise(seed, width, height, COARSEST);
    light = new Texels(width, height, this::light);
  }

  private double light(int column, int row) {
    double x = (double) column / light.width() - .5;
    double y = (double) row / light.height() - .5;
    double d = Math.sqrt(x * x + y * y) + BENDING * noise.turbulence(column, row);
    double turns = rings * d;
    // Whole turns change nothing, but there may be too many for the sine.
    return Math.abs(Elementary.sinTurns(turns - Math.floor(turns))) / 2;
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
