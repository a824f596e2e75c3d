package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the built-in denoiser on synthetic pictures, whose truth is known. */
class BuiltInDenoiserTest {
  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;

  /** A value of the true picture at a pixel. */
  private interface Truth {
    double at(int x, int y);
  }

  private static float[] sampled(Truth truth) {
    float[] values = new float[3 * WIDTH * HEIGHT];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) truth.at(i / 3 % WIDTH, i / 3 / WIDTH);
    }
    return values;
  }

  /** Returns a picture with independent normal noise of a standard deviation in each half. */
  private static NoisyPicture noisy(Truth truth, Truth albedo, double deviation, long seed) {
    Random random = new Random(seed);
    float[] mean = sampled(truth);
    float[] noise = new float[mean.length];
    for (int i = 0; i < mean.length; i++) {
      double a = deviation * random.nextGaussian();
      double b = deviation * random.nextGaussian();
      mean[i] += (float) ((a + b) / 2);
      noise[i] = (float) ((a - b) / 2);
    }
    return new NoisyPicture(
        WIDTH,
        HEIGHT,
        new NoisyPicture.Halves(mean, noise),
        Optional.of(new NoisyPicture.Halves(sampled(albedo), new float[0])),
        Optional.of(new NoisyPicture.Halves(sampled((x, y) -> .5), new float[0])),
        new float[0],
        0);
  }

  private static double squaredError(float[] values, Truth truth) {
    float[] expected = sampled(truth);
    double sum = 0;
    for (int i = 0; i < values.length; i++) {
      sum += (values[i] - expected[i]) * (values[i] - expected[i]);
    }
    return sum / values.length;
  }

  @Test
  void smoothLightLosesMostOfItsNoise() throws InterruptedException {
    Truth truth = (x, y) -> .5 + .3 * Math.sin(x * .05) + .004 * y;
    NoisyPicture noisy = noisy(truth, (x, y) -> .7, .1, 1);
    Denoised denoised = BuiltInDenoiser.denoise(noisy, 2);
    double before = squaredError(noisy.light().mean(), truth);
    double after = squaredError(denoised.image().rgb(), truth);
    assertThat(before).isCloseTo(.005, within(.0005));
    assertThat(after).isLessThan(before / 25);
  }

  @Test
  void edgesAndTexturesOfTheAlbedoStaySharp() throws InterruptedException {
    Truth albedo = (x, y) -> (x / 4 + y / 4) % 2 == 0 ? .2 : .8;
    Truth truth = (x, y) -> albedo.at(x, y) * (.5 + .01 * x);
    NoisyPicture noisy = noisy(truth, albedo, .1, 2);
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    assertThat(squaredError(clean, truth))
        .isLessThan(squaredError(noisy.light().mean(), truth) / 5);
  }

  @Test
  void edgesOfLightThatNoGuideKnowsStay() throws InterruptedException {
    Truth truth = (x, y) -> x + y / 2 < 40 ? .1 : .9;
    NoisyPicture noisy = noisy(truth, (x, y) -> .5, .05, 3);
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    assertThat(squaredError(clean, truth))
        .isLessThan(squaredError(noisy.light().mean(), truth) / 3);
  }

  /** From noise that can hardly be seen to noise that hides everything. */
  @ParameterizedTest
  @ValueSource(doubles = {.05, .2, .8, 2})
  void errorEstimateIsNearTheError(double deviation) throws InterruptedException {
    Truth truth = (x, y) -> .5 + .3 * Math.sin(x * .05) + .004 * y;
    float[] expected = sampled(truth);
    double actual = 0;
    double estimated = 0;
    for (int seed = 4; seed < 8; seed++) {
      NoisyPicture noisy = noisy(truth, (x, y) -> .7, deviation, seed);
      float[] light = noisy.light().mean();
      for (int i = 0; i < light.length; i++) {
        light[i] = Math.max(0, light[i]);
      }
      Denoised denoised = BuiltInDenoiser.denoise(noisy, 2);
      estimated += Math.pow(denoised.relativeError().getAsDouble(), 2);
      for (int i = 0; i < expected.length; i++) {
        double error = denoised.image().rgb()[i] - expected[i];
        actual +=
            error * error / (expected[i] * expected[i] + Denoised.FLOOR) / expected.length;
      }
    }
    assertThat(Math.sqrt(estimated / actual)).isBetween(1 / 1.5, 1.5);
  }

  @Test
  void aPictureWithoutNoiseHardlyChanges() throws InterruptedException {
    Truth truth = (x, y) -> .5 + .3 * Math.sin(x * .2) * Math.cos(y * .3);
    Denoised denoised = BuiltInDenoiser.denoise(noisy(truth, (x, y) -> .7, 0, 5), 2);
    assertThat(denoised.change()).isLessThan(.01);
  }

  @Test
  void anyNumberOfThreadsGivesTheSameBits() throws InterruptedException {
    NoisyPicture noisy = noisy((x, y) -> .2 + .01 * x, (x, y) -> .01 * y, .3, 6);
    float[] one = BuiltInDenoiser.denoise(noisy, 1).image().rgb();
    assertThat(BuiltInDenoiser.denoise(noisy, 3).image().rgb()).isEqualTo(one);
  }

  @Test
  void aSpikeIsRemoved() throws InterruptedException {
    NoisyPicture noisy = noisy((x, y) -> .5, (x, y) -> .7, .05, 7);
    int spike = 3 * (20 * WIDTH + 30);
    for (int c = 0; c < 3; c++) {
      noisy.light().mean()[spike + c] = 100;
      noisy.light().noise()[spike + c] = 99.5f;
    }
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    assertThat(squaredError(clean, (x, y) -> .5)).isLessThan(.001);
  }

  @Test
  void lightIsDividedByAlpha() throws InterruptedException {
    NoisyPicture opaque = noisy((x, y) -> .5, (x, y) -> .7, .05, 8);
    float[] alpha = new float[WIDTH * HEIGHT];
    Arrays.fill(alpha, .5f);
    alpha[0] = 0;
    alpha[9] = Float.MIN_VALUE;
    NoisyPicture half =
        new NoisyPicture(WIDTH, HEIGHT, opaque.light(), opaque.albedo(), opaque.normal(), alpha, 0);
    float[] clean = BuiltInDenoiser.denoise(half, 2).image().rgb();
    assertThat(clean[3]).isCloseTo(1, within(.1f));
    assertThat(clean[0]).isZero();
    assertThat(clean[27]).isFinite();
  }

  @Test
  void smallPicturesAndMissingGuidesAreFine() throws InterruptedException {
    NoisyPicture pixel =
        new NoisyPicture(
            1,
            1,
            new NoisyPicture.Halves(new float[] {1, 2, 3}, new float[] {.1f, .1f, .1f}),
            Optional.empty(),
            Optional.empty(),
            new float[0],
            0);
    assertThat(BuiltInDenoiser.denoise(pixel, 1).image().rgb()[1]).isCloseTo(2, within(.01f));
  }

  /** Pictures of other programs may have neither noise nor guides. */
  @Test
  void withoutNoiseOrGuidesLessIsRemoved() throws InterruptedException {
    Truth truth = (x, y) -> .5 + .3 * Math.sin(x * .05) + .004 * y;
    NoisyPicture noisy = noisy(truth, (x, y) -> .7, .1, 9);
    NoisyPicture.Halves light = new NoisyPicture.Halves(noisy.light().mean(), new float[0]);
    NoisyPicture bare =
        new NoisyPicture(WIDTH, HEIGHT, light, Optional.empty(), Optional.empty(), new float[0], 0);
    Denoised denoised = BuiltInDenoiser.denoise(bare, 1);
    assertThat(denoised.relativeError()).isEmpty();
    assertThat(squaredError(denoised.image().rgb(), truth)).isLessThan(.005 / 8);
  }

  /**
   * Every size has pixels at borders, and in tiles that have none of the network's smaller sizes.
   */
  @Test
  void oddSizesAreFine() throws InterruptedException {
    for (int[] size : new int[][] {{1, 1}, {1, 40}, {17, 1}, {2, 3}, {7, 9}, {16, 16}, {33, 31}}) {
      float[] mean = new float[3 * size[0] * size[1]];
      float[] noise = new float[mean.length];
      Random random = new Random(size[0]);
      for (int i = 0; i < mean.length; i++) {
        noise[i] = (float) (.02 * random.nextGaussian());
        mean[i] = .5f + (float) (.02 * random.nextGaussian());
      }
      NoisyPicture.Halves light = new NoisyPicture.Halves(mean, noise);
      NoisyPicture picture =
          new NoisyPicture(
              size[0], size[1], light, Optional.empty(), Optional.empty(), new float[0], 0);
      for (float value : BuiltInDenoiser.denoise(picture, 2).image().rgb()) {
        assertThat(value).as(Arrays.toString(size)).isCloseTo(.5f, within(.08f));
      }
    }
  }

  /**
   * Tiles overlap by as much as the network sees, so that their seams have the bits of the whole.
   */
  @Test
  void tilesGiveTheBitsOfTheWhole() throws InterruptedException {
    for (NoisyPicture picture : List.of(large(448, 24), large(24, 448))) {
      Denoised whole = BuiltInDenoiser.denoise(picture, 2, Integer.MAX_VALUE);
      Denoised tiled = BuiltInDenoiser.denoise(picture, 2, (224 + BuiltInDenoiser.MARGIN) * 24);
      assertThat(tiled.image().rgb()).isEqualTo(whole.image().rgb());
      assertThat(tiled.relativeError()).isEqualTo(whole.relativeError());
    }
  }

  /** Noise of strengths from none to far above the light, so that kernels of all sizes matter. */
  private static NoisyPicture large(int width, int height) {
    Random random = new Random(12);
    NoisyPicture.Halves[] halves = new NoisyPicture.Halves[3];
    for (int k = 0; k < 3; k++) {
      float[] mean = new float[3 * width * height];
      float[] noise = new float[mean.length];
      for (int i = 0; i < mean.length; i++) {
        double deviation = .5 * (1 + StrictMath.sin(.0001 * i));
        noise[i] = (float) (deviation * random.nextGaussian());
        mean[i] = (float) Math.abs(.3 + deviation * random.nextGaussian());
      }
      halves[k] = new NoisyPicture.Halves(mean, noise);
    }
    return new NoisyPicture(
        width, height, halves[0], Optional.of(halves[1]), Optional.of(halves[2]), new float[0], 0);
  }

  /**
   * A crop is filtered by the levels' grid of the full frame. All blocks of 8x8 pixels of this
   * picture are alike, so that any crop has the exposure of the whole.
   */
  @Test
  void cropsAreFilteredAsTheWhole() throws InterruptedException {
    int whole = 2 * BuiltInDenoiser.MARGIN + 96;
    int left = 13;
    int part = whole - 24;
    float[] expected = BuiltInDenoiser.denoise(periodic(whole, 0), 2).image().rgb();
    float[] found = BuiltInDenoiser.denoise(periodic(part, left), 2).image().rgb();
    for (int x = BuiltInDenoiser.MARGIN + left; x < left + part - BuiltInDenoiser.MARGIN; x++) {
      for (int y = 0; y < 16; y++) {
        int of = 3 * (y * whole + x);
        int at = 3 * (y * part + x - left);
        assertThat(found[at]).isCloseTo(expected[of], within(1e-5f));
      }
    }
  }

  /** Returns 16 rows of a picture that repeats itself, from a column on. */
  private static NoisyPicture periodic(int width, int left) {
    float[] mean = new float[3 * width * 16];
    float[] noise = new float[mean.length];
    for (int i = 0; i < mean.length; i++) {
      int pixel = i / 3;
      int cell = pixel / width % 8 * 8 + (pixel % width + left) % 8;
      mean[i] = (cell * 37 % 64 + 1) / 64f;
      noise[i] = (cell * 23 % 64 - 32) / 256f;
    }
    NoisyPicture.Halves light = new NoisyPicture.Halves(mean, noise);
    return new NoisyPicture(
        width,
        16,
        left,
        0,
        light,
        Optional.empty(),
        Optional.empty(),
        new float[0],
        new float[0],
        0);
  }

  /**
   * The same bits on every machine, with and without compilers: the hash is that of any of them.
   */
  @Test
  void bitsAreThoseOfEveryMachine() throws InterruptedException {
    NoisyPicture noisy = large(61, 47);
    Denoised denoised = BuiltInDenoiser.denoise(noisy, 2);
    assertThat(Arrays.hashCode(denoised.image().rgb())).isEqualTo(130042607);
    assertThat(denoised.relativeError().getAsDouble()).isEqualTo(.2842918078718804);
  }

  /** In sparse light, neighborhoods that all samples missed have no noise that could be seen. */
  @Test
  void sparseLightLeavesNoHoles() throws InterruptedException {
    NoisyPicture noisy = noisy((x, y) -> 0, (x, y) -> .7, 0, 13);
    Random random = new Random(13);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      boolean isLit = random.nextInt(25) == 0;
      for (int c = 0; c < 3; c++) {
        noisy.light().mean()[3 * i + c] = isLit ? 12.5f : 0;
        noisy.light().noise()[3 * i + c] = isLit ? 12.5f : 0;
      }
    }
    int holes = 0;
    for (float value : BuiltInDenoiser.denoise(noisy, 2).image().rgb()) {
      holes += value < .02f ? 1 : 0;
    }
    assertThat(holes).isZero();
  }

  /** What the network darkens is given back where the means of neighborhoods tell it surely. */
  @Test
  void lightThatFilteringLosesIsGivenBack() {
    float[] filtered = sampled((x, y) -> x < 32 ? .3 : .5);
    NoisyPicture noisy = noisy((x, y) -> .5, (x, y) -> .7, .1, 14);
    LostLight lost = new LostLight(new Features(noisy), filtered);
    float[] row = new float[3 * WIDTH];
    lost.write(24, 0, WIDTH, row);
    assertThat(row[3 * 5]).isCloseTo(.5f, within(.02f));
    assertThat(row[3 * 60]).isCloseTo(.5f, within(.02f));
    assertThat(Arrays.hashCode(row)).isEqualTo(691362158);
    float[] noise = sampled((x, y) -> (x + y) % 2 == 0 ? 9 : -9);
    System.arraycopy(noise, 0, noisy.light().noise(), 0, noise.length);
    new LostLight(new Features(noisy), filtered).write(24, 0, WIDTH, row);
    assertThat(row[3 * 5]).isEqualTo(.3f);
  }

  @Test
  void interruptionEndsIt() {
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> BuiltInDenoiser.denoise(large(61, 47), 2))
        .isInstanceOf(InterruptedException.class);
    assertThat(Thread.interrupted()).isFalse();
  }

  /**
   * Noise of light paths is skewed: few bright samples among many dark ones. The limit on spikes
   * takes some of their light: 7 % of exponentially distributed halves.
   */
  @Test
  void skewedNoiseLosesLittleLight() throws InterruptedException {
    NoisyPicture noisy = noisy((x, y) -> .5, (x, y) -> .7, 0, 11);
    Random random = new Random(11);
    float[] mean = noisy.light().mean();
    for (int i = 0; i < mean.length; i += 3) {
      double a = -.5 * Math.log(1 - random.nextDouble());
      double b = -.5 * Math.log(1 - random.nextDouble());
      for (int c = 0; c < 3; c++) {
        mean[i + c] = (float) ((a + b) / 2);
        noisy.light().noise()[i + c] = (float) ((a - b) / 2);
      }
    }
    double before = 0;
    double after = 0;
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    for (int i = 0; i < clean.length; i++) {
      before += mean[i] / clean.length;
      after += clean[i] / clean.length;
    }
    assertThat(after).isBetween(.9 * before, 1.01 * before);
    assertThat(squaredError(clean, (x, y) -> .5)).isLessThan(squaredError(mean, (x, y) -> .5) / 25);
  }

  /** Single bright pixels that no guide knows, eight standard deviations above all others. */
  @Test
  void nothingMovesByMoreThanItsNoiseAllows() throws InterruptedException {
    float deviation = .02f;
    NoisyPicture noisy =
        noisy((x, y) -> x % 8 == 3 && y % 8 == 3 ? .5 + 8 * .02 : .5, (x, y) -> .7, 0, 10);
    Random random = new Random(10);
    float[] noise = noisy.light().noise();
    for (int i = 0; i < noise.length; i++) {
      noise[i] = random.nextBoolean() ? deviation : -deviation;
    }
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    for (int i = 0; i < clean.length; i++) {
      assertThat(clean[i]).isCloseTo(noisy.light().mean()[i], within(4.001f * deviation));
    }
  }

  /** Values that a file may have, however unlikely: the result is a picture, not NaN. */
  @Test
  void extremeValuesGiveFinitePictures() throws InterruptedException {
    float[] extremes = {
      0,
      -0f,
      -1,
      Float.MIN_VALUE,
      -Float.MIN_VALUE,
      1e-30f,
      1,
      1e10f,
      1e19f,
      -1e19f,
      1e30f,
      Float.MAX_VALUE,
      -Float.MAX_VALUE
    };
    for (int seed = 0; seed < 20; seed++) {
      Random random = new Random(seed);
      float rare = random.nextFloat();
      int size = 1 + random.nextInt(24);
      NoisyPicture.Halves[] halves = new NoisyPicture.Halves[3];
      for (int k = 0; k < 3; k++) {
        float[] mean = new float[3 * size * 16];
        float[] noise = new float[mean.length];
        for (int i = 0; i < mean.length; i++) {
          boolean isExtreme = random.nextFloat() < rare;
          mean[i] = isExtreme ? extremes[random.nextInt(extremes.length)] : random.nextFloat();
          noise[i] = isExtreme ? extremes[random.nextInt(extremes.length)] : .1f;
        }
        halves[k] = new NoisyPicture.Halves(mean, noise);
      }
      NoisyPicture picture =
          new NoisyPicture(
              size, 16, halves[0], Optional.of(halves[1]), Optional.of(halves[2]), new float[0], 0);
      for (float value : BuiltInDenoiser.denoise(picture, 2).image().rgb()) {
        assertThat(value).as("seed " + seed).isBetween(0f, Float.MAX_VALUE);
      }
    }
  }
}
