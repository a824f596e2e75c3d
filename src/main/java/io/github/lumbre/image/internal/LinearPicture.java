package io.github.lumbre.image.internal;

import io.github.lumbre.image.Image;
import java.util.Objects;

/**
 * A picture of linear light as its file has it. Colors and alpha are stored apart in some uses and
 * together in others: in an OpenEXR file, the color of a surface is multiplied by alpha, and light
 * such as a glow is added where alpha is 0.
 */
public final class LinearPicture {
  private static final float[] OPAQUE = {};

  private final int width;
  private final int height;
  private final float[] rgb;
  private final float[] alpha;

  /**
   * Creates a picture from its rasters, which are not copied.
   *
   * @param rgb three values per pixel, row by row from the top
   * @param alpha one value per pixel, any number, or an empty array without alpha
   */
  public LinearPicture(int width, int height, float[] rgb, float[] alpha) {
    this.width = width;
    this.height = height;
    this.rgb = Objects.requireNonNull(rgb, "rgb");
    this.alpha = Objects.requireNonNull(alpha, "alpha");
  }

  /**
   * Returns the picture as light, such as a sky: RGB as stored, without alpha. It shares its raster
   * with this picture.
   */
  public Image light() {
    return new Image(width, height, rgb, OPAQUE);
  }

  /**
   * Returns the picture as a surface: its straight color, which is RGB / A, and RGB where A is 0,
   * and A in [0,1]. Values of A outside are clamped, and NaN is 0. Without alpha, it shares its
   * raster with this picture.
   */
  public Image straight() {
    return alpha.length == 0 ? light() : straight(rgb.clone(), alpha.clone());
  }

  /** Returns {@link #straight} in the rasters of this picture, which must not be used any more. */
  Image intoStraight() {
    return straight(rgb, alpha);
  }

  private Image straight(float[] colors, float[] shares) {
    for (int i = 0; i < shares.length; i++) {
      shares[i] = shares[i] > 0 ? Math.min(1, shares[i]) : 0;
    }
    for (int i = 0; i < 3 * shares.length; i++) {
      if (shares[i / 3] > 0) {
        colors[i] = divided(colors[i], shares[i / 3]);
      }
    }
    return new Image(width, height, colors, shares);
  }

  /** Returns a color divided by alpha; the largest float if it would be infinite. */
  private static float divided(float color, float share) {
    float straight = color / share;
    return Float.isInfinite(straight) && Float.isFinite(color)
        ? Math.copySign(Float.MAX_VALUE, straight)
        : straight;
  }

  /** Returns the number of pixels whose alpha is outside [0,1], which {@link #straight} clamps. */
  public int clampedAlphas() {
    int count = 0;
    for (float share : alpha) {
      if (!(share >= 0 && share <= 1)) {
        count++;
      }
    }
    return count;
  }
}
