package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;

/**
 * A texture of width × height computed texels, repeated in both directions without end. A point has
 * the value of the texel that it lies in, as in an {@link ImageTexture} that is not filtered.
 * Observably immutable and safe for use by any thread.
 */
public interface TexelTexture extends Texture<Rgb> {
  /** The largest width and height. */
  int MAX_SIDE = 16384;

  int width();

  int height();

  /**
   * Returns the value of a texel, linear light.
   *
   * @param column counted from the left
   * @param row counted from the <b>top</b>
   */
  Rgb texel(int column, int row);

  @Override
  default Rgb at(double u, double v) {
    return texel(Texel.column(u, v, width()), Texel.row(u, v, height()));
  }
}
