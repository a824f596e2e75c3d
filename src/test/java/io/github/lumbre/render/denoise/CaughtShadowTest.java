package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests pictures of a model whose shadow is all that is seen of the ground. */
class CaughtShadowTest {
  private static final int WIDTH = 96;
  private static final int HEIGHT = 64;
  private static final int HORIZON = 16;
  private static final int SAMPLES = 8;

  private final float[] light = new float[3 * WIDTH * HEIGHT];
  private final float[] albedo = light.clone();
  private final float[] normal = light.clone();
  private final float[] alpha = new float[WIDTH * HEIGHT];
  private final float[] noise = alpha.clone();

  private static boolean isModel(int x, int y) {
    return x >= 20 && x < 40 && y >= 8 && y < 40;
  }

  /** Pixels on the border of the model, which it covers to a half. */
  private static boolean isEdge(int x, int y) {
    return !isModel(x, y) && isModel(x == 19 ? x + 1 : x - 1, y);
  }

  /** Returns the part of the ground's light that is blocked: a soft shadow right of the model. */
  private static double shadow(int x, int y) {
    double distance = Math.hypot(x - 44, y - 38);
    return Math.max(0, .8 - distance / 30);
  }

  /** Returns the picture with a number of samples in each pixel. */
  private NoisyPicture picture(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < alpha.length; i++) {
      int x = i % WIDTH;
      int y = i / WIDTH;
      double model = isModel(x, y) ? 1 : isEdge(x, y) ? .5 : 0;
      int covered = 0;
      for (int sample = 0; sample < SAMPLES; sample++) {
        boolean isOfModel = sample < model * SAMPLES;
        boolean isDark = y >= HORIZON && random.nextDouble() < shadow(x, y);
        covered += isOfModel || isDark ? 1 : 0;
      }
      alpha[i] = covered / (float) SAMPLES;
      noise[i] = (float) Math.sqrt(alpha[i] * (1 - alpha[i]) / (SAMPLES - 1));
      noise[i] *= random.nextBoolean() ? 1 : -1;
      for (int c = 0; c < 3; c++) {
        light[3 * i + c] = (float) (.4 * model);
        albedo[3 * i + c] = (float) (.5 * model);
      }
      normal[3 * i + 1] = (float) (y >= HORIZON ? 1 - model : 0);
      normal[3 * i + 2] = (float) model;
    }
    return new NoisyPicture(
        WIDTH,
        HEIGHT,
        0,
        0,
        halves(light),
        Optional.of(halves(albedo)),
        Optional.of(halves(normal)),
        alpha,
        noise,
        0);
  }

  private static NoisyPicture.Halves halves(float[] mean) {
    return new NoisyPicture.Halves(mean, new float[mean.length]);
  }

  @Test
  void shadowsLoseTheirNoise() throws InterruptedException {
    NoisyPicture noisy = picture(1);
    Image clean = BuiltInDenoiser.denoise(noisy, 2).image();
    double before = 0;
    double after = 0;
    double bias = 0;
    int count = 0;
    for (int i = 0; i < alpha.length; i++) {
      int x = i % WIDTH;
      int y = i / WIDTH;
      if (y >= HORIZON && !isModel(x, y) && !isEdge(x, y)) {
        before += Math.pow(alpha[i] - shadow(x, y), 2);
        after += Math.pow(clean.alpha(x, y) - shadow(x, y), 2);
        bias += clean.alpha(x, y) - shadow(x, y);
        count++;
      }
    }
    assertThat(after).isLessThan(before / 15);
    assertThat(bias / count).isCloseTo(0, within(.01));
  }

  @Test
  void theModelAndTheSkyKeepTheirAlpha() throws InterruptedException {
    Image clean = BuiltInDenoiser.denoise(picture(2), 2).image();
    for (int i = 0; i < alpha.length; i++) {
      int x = i % WIDTH;
      int y = i / WIDTH;
      if (y < HORIZON || isModel(x, y) || isEdge(x, y)) {
        assertThat(clean.alpha(x, y)).isEqualTo(alpha[i]);
      } else {
        assertThat(clean.rgb()[3 * i]).as("light at %s,%s", x, y).isZero();
      }
    }
  }

  /** A dark and colored model leaves no light seam on the ground beside it. */
  @Test
  void groundBesideAColoredModelKeepsItsShadow() throws InterruptedException {
    double lightest = 0;
    for (int seed = 5; seed < 9; seed++) {
      NoisyPicture noisy = picture(seed);
      for (int i = 0; i < albedo.length; i++) {
        albedo[i] *= i % 3 == 2 ? .8f : .04f;
        light[i] *= i % 3 == 2 ? .8f : .04f;
      }
      Image clean = BuiltInDenoiser.denoise(noisy, 2).image();
      for (int y = 28; y < 40; y++) {
        lightest = Math.max(lightest, shadow(41, y) - clean.alpha(41, y));
      }
    }
    assertThat(lightest).isLessThan(.075);
  }

  /** Far from the shadow, the ground stays transparent. */
  @Test
  void litGroundStays() throws InterruptedException {
    Image clean = BuiltInDenoiser.denoise(picture(3), 2).image();
    for (int y = HORIZON; y < HEIGHT; y++) {
      assertThat(clean.alpha(WIDTH - 1, y)).isLessThan(.01f);
    }
  }

  /** A black model whose alpha is that of its edges has no ground. */
  @Test
  void picturesWithoutGroundHaveNoShadow() {
    NoisyPicture noisy = picture(4);
    Arrays.fill(light, 0);
    Arrays.fill(albedo, 0);
    for (int i = 0; i < alpha.length; i++) {
      normal[3 * i + 1] = 0;
    }
    assertThat(CaughtShadow.of(noisy)).isEmpty();
  }
}
