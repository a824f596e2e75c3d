package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Elementary;

/** Marble: thin black veins across white stone, distorted by turbulence. */
public final class MarbleTexture implements TexelTexture {
  private static final double COARSEST = 128;
  private static final double BENDING = 4;
  private static final double VEINS_ACROSS = 5;
  private static final double VEINS_DOWN = 10;

  private final long seed;
  private final Noise noise;
  private final Texels gray;

  /**
   * Creates a texture.
   *
   * @param seed the seed of all random numbers
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @throws IllegalArgumentException if a size is out of range
   */
  public MarbleTexture(long seed, int width, int height) {
    this.seed = seed;
    noise = new Noise(seed, width, height, COARSEST);
    gray = new Texels(width, height, this::gray);
  }

  private double gray(int column, int row) {
    double halfTurns =
        VEINS_ACROSS * column / gray.width()
            + VEINS_DOWN * row / gray.height()
            + BENDING * noise.turbulence(column, row);
    return Math.abs(Elementary.sinTurns(halfTurns / 2));
  }

  /** Returns the seed of all random numbers. */
  public long seed() {
    return seed;
  }

  @Override
  public int width() {
    return gray.width();
  }

  @Override
  public int height() {
    return gray.height();
  }

  @Override
  public Rgb texel(int column, int row) {
    return Rgb.gray(gray.at(column, row));
  }
}
