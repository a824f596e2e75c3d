package io.github.lumbre.denoise;

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

  /** Distance in pixels of the ground whose light stands in for that of other pixels. */
  private static final int NEAR = 8;

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
    float[] color = albedo.clone();
    float[] alpha = new float[ground.length];
    float[] lit = lit();
    for (int i = 0; i < light.length; i++) {
      light[i] = lit[i / 3];
      if (ground[i / 3]) {
        color[i] = ALBEDO;
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
   * that filtering spreads nothing else from there.
   */
  private float[] lit() {
    int width = picture.width();
    double[] light = new double[ground.length];
    double[] pixels = new double[ground.length];
    float[] lit = new float[ground.length];
    for (int i = 0; i < lit.length; i++) {
      lit[i] = ground[i] ? 1 - picture.alpha()[i] : 1;
      int row = i / width * width;
      for (int near = Math.max(row, i - NEAR); near <= i + NEAR && near < row + width; near++) {
        light[i] += ground[near] ? 1 - picture.alpha()[near] : 0;
        pixels[i] += ground[near] ? 1 : 0;
      }
    }
    for (int i = 0; i < lit.length; i++) {
      double sum = 0;
      double count = 0;
      for (int row = -NEAR; row <= NEAR && !ground[i]; row++) {
        int near = i + row * width;
        if (0 <= near && near < lit.length) {
          sum += light[near];
          count += pixels[near];
        }
      }
      lit[i] = count > 0 ? (float) (sum / count) : lit[i];
    }
    return lit;
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
