package io.github.lumbre.render.denoise;

import java.util.Arrays;
import java.util.Optional;

/**
 * The shadow on a ground that shows nothing else, in a picture with alpha. Alpha is the part of the
 * ground's light that is blocked, and has the noise of few samples. It is filtered as the gray
 * picture of a lit ground. Other pixels keep their alpha, so that the edges of the model stay
 * exact. Immutable.
 */
final class CaughtShadow {
  /** Normals whose mean is shorter are those of several surfaces. */
  private static final float ONE_SURFACE = .999f;

  /** Any albedo of the gray ground, which a model hardly has together with its normal. */
  private static final float ALBEDO = .5f;

  private final NoisyPicture picture;
  private final float[] albedo;
  private final float[] normal;
  private final boolean[] ground;

  private CaughtShadow(NoisyPicture picture, float[] albedo, float[] normal) {
    this.picture = picture;
    this.albedo = albedo;
    this.normal = normal;
    ground = new boolean[picture.alpha().length];
  }

  /** Returns the shadow of a picture, if it has one, and guides that show its ground. */
  static Optional<CaughtShadow> of(NoisyPicture picture) {
    if (picture.alpha().length == 0
        || picture.albedo().isEmpty()
        || picture.normal().isEmpty()
        || picture.background().isPresent()) {
      return Optional.empty();
    }
    CaughtShadow shadow =
        new CaughtShadow(picture, picture.albedo().get().mean(), picture.normal().get().mean());
    return shadow.findGround() ? Optional.of(shadow) : Optional.empty();
  }

  /** Finds the pixels of the ground; returns whether a shadow is on it. */
  private boolean findGround() {
    double[] up = new double[3];
    boolean isDark = false;
    for (int i = 0; i < ground.length; i++) {
      // What has a normal everywhere but is not seen everywhere is ground.
      ground[i] = picture.alpha()[i] < 1 && mayBeGround(i);
      isDark |= ground[i] && picture.alpha()[i] > 0;
      for (int c = 0; c < 3 && ground[i]; c++) {
        up[c] += normal[3 * i + c];
      }
    }
    double length = Math.sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]);
    for (int i = 0; i < ground.length; i++) {
      double along = up[0] * normal[3 * i] + up[1] * normal[3 * i + 1] + up[2] * normal[3 * i + 2];
      ground[i] |= along > ONE_SURFACE * length && mayBeGround(i);
    }
    return isDark;
  }

  /** Returns whether all samples of a pixel are black and on one flat surface. */
  private boolean mayBeGround(int pixel) {
    float squared = 0;
    float color = 0;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      squared += normal[i] * normal[i];
      color += Math.abs(picture.light().mean()[i]) + Math.abs(albedo[i]);
    }
    return color == 0 && squared > ONE_SURFACE * ONE_SURFACE;
  }

  /** Returns the gray picture of the lit ground, which is transparent elsewhere. */
  NoisyPicture picture() {
    float[] light = new float[3 * ground.length];
    float[] noise = new float[picture.alphaNoise().length == 0 ? 0 : light.length];
    float[] color = new float[light.length];
    Arrays.fill(color, ALBEDO);
    float[] alpha = new float[ground.length];
    float[] lit = lit();
    for (int i = 0; i < light.length; i++) {
      light[i] = lit[i / 3];
      if (ground[i / 3]) {
        alpha[i / 3] = 1;
        if (noise.length != 0) {
          noise[i] = picture.alphaNoise()[i / 3];
        }
      }
    }
    float[] albedoNoise = picture.albedo().get().noise();
    return new NoisyPicture(
        picture.width(),
        picture.height(),
        picture.left(),
        picture.top(),
        new NoisyPicture.Halves(light, noise),
        Optional.of(new NoisyPicture.Halves(color, albedoNoise)),
        picture.normal(),
        alpha,
        new float[0],
        0);
  }

  /**
   * Returns the part of light that reaches the ground; elsewhere the mean of the ground nearby, so
   * that filtering spreads nothing else from there. It is the mean in the smallest square of
   * pixels, in a pyramid of squares of 1, 2, 4, ... pixels, that has any ground.
   */
  private float[] lit() {
    int width = picture.width();
    float[] lit = new float[ground.length];
    for (int i = 0; i < lit.length; i++) {
      lit[i] = ground[i] ? 1 - picture.alpha()[i] : Float.NaN;
    }
    return filled(lit, width, picture.height());
  }

  private static float[] filled(float[] values, int width, int height) {
    if (values.length == 1) {
      return values;
    }
    int halfWidth = (width + 1) / 2;
    int halfHeight = (height + 1) / 2;
    float[] sums = new float[halfWidth * halfHeight];
    int[] counts = new int[sums.length];
    for (int i = 0; i < values.length; i++) {
      if (!Float.isNaN(values[i])) {
        int half = i / width / 2 * halfWidth + i % width / 2;
        sums[half] += values[i];
        counts[half]++;
      }
    }
    for (int i = 0; i < sums.length; i++) {
      sums[i] = counts[i] == 0 ? Float.NaN : sums[i] / counts[i];
    }
    float[] coarse = filled(sums, halfWidth, halfHeight);
    for (int i = 0; i < values.length; i++) {
      if (Float.isNaN(values[i])) {
        values[i] = coarse[i / width / 2 * halfWidth + i % width / 2];
      }
    }
    return values;
  }

  /**
   * Returns the picture with a denoised shadow.
   *
   * @param light the denoised light of {@link #picture}
   */
  NoisyPicture denoised(float[] light) {
    float[] alpha = picture.alpha().clone();
    for (int i = 0; i < alpha.length; i++) {
      if (ground[i]) {
        alpha[i] = Math.max(0, Math.min(1, 1 - light[3 * i]));
      }
    }
    return picture.withAlpha(alpha);
  }

  /** Removes light from the ground: what filtering spreads around the model. */
  void blacken(float[] light) {
    for (int i = 0; i < light.length; i++) {
      if (ground[i / 3]) {
        light[i] = 0;
      }
    }
  }
}
