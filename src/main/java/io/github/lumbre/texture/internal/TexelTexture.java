package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;

/**
 * A texture of width × height computed texels that repeats infinitely in both directions. A point
 * has the value of the texel that contains it, as in an {@link ImageTexture} with {@link
 * ImageTexture.Filter#NEAREST}. Observably immutable and thread-safe.
 */
public interface TexelTexture extends Texture<Rgb> {
  /** The largest width and height. */
  int MAX_SIDE = 16384;

  /** Returns the width in texels. */
  int width();

  /** Returns the height in texels. */
  int height();

  /**
   * Returns the value of a texel, in linear RGB.
   *
   * @param column counted from the left, 0 to {@link #width} - 1
   * @param row counted from the <b>top</b>, 0 to {@link #height} - 1
   */
  Rgb texel(int column, int row);

  @Override
  default Rgb at(double u, double v) {
    return texel(Texel.column(u, v, width()), Texel.row(u, v, height()));
  }
}
