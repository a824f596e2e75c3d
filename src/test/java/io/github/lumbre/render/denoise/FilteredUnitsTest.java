package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Noisy discs on a background with hardly any noise, most of which the network need not filter. */
class FilteredUnitsTest {
  private static final int WIDTH = 448;
  private static final int HEIGHT = 40;
  private static final float BACKGROUND = .4f;

  /** Less noise than this, relative to the light, is invisible whatever the network does. */
  private static final double LIMIT = 1. / 1024;

  /** Along both axes: 3 pixels over which variances are smoothed, 8 of context, 15 of a square. */
  private static final double FAR = (3 + 8 + 15) * Math.sqrt(2);

  private static double distance(int x, int y) {
    return Math.min(Math.hypot(x - 60, y - 16), Math.hypot(x - 222, y - 38)) - 14;
  }

  private static boolean isDisc(int i) {
    return distance(i / 3 % WIDTH, i / 3 / WIDTH) < 0;
  }

  /** Returns the light of the discs and around them. */
  private static double truth(int i) {
    return isDisc(i) ? .7 : BACKGROUND;
  }

  /**
   * @param deviation of the background's noise, relative to its light
   * @param alpha of the background; its light is black if it is 0
   */
  private static NoisyPicture discs(double deviation, float alpha) {
    Random random = new Random(3);
    float[] mean = new float[3 * WIDTH * HEIGHT];
    float[] noise = new float[mean.length];
    float[] normal = new float[mean.length];
    float[] alphas = new float[WIDTH * HEIGHT];
    for (int i = 0; i < mean.length; i++) {
      double light = isDisc(i) ? .7 : alpha * BACKGROUND;
      double size = isDisc(i) ? .2 : alpha * deviation * BACKGROUND;
      mean[i] = (float) (light + size * random.nextGaussian());
      noise[i] = (float) (random.nextBoolean() ? size : -size);
      normal[i] = isDisc(i) ? .5f : 0;
      alphas[i / 3] = isDisc(i) ? 1 : alpha;
    }
    return new NoisyPicture(
        WIDTH,
        HEIGHT,
        new NoisyPicture.Halves(mean, noise),
        Optional.empty(),
        Optional.of(new NoisyPicture.Halves(normal, new float[0])),
        alpha == 1 ? new float[0] : alphas,
        0);
  }

  /** Noise that is hardly seen would change in any pixel that is filtered. */
  @Test
  void farFromNoiseThePictureStaysAsItWasRendered() throws InterruptedException {
    NoisyPicture noisy = discs(.9 * LIMIT, 1);
    float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
    int same = 0;
    int far = 0;
    for (int i = 0; i < clean.length; i++) {
      boolean isFar = distance(i / 3 % WIDTH, i / 3 / WIDTH) > FAR;
      far += isFar ? 1 : 0;
      same += isFar && clean[i] == noisy.light().mean()[i] ? 1 : 0;
      if (!isDisc(i) && distance(i / 3 % WIDTH, i / 3 / WIDTH) > 3) {
        assertThat(clean[i]).isCloseTo(noisy.light().mean()[i], within(BACKGROUND / 256));
      }
    }
    assertThat(far).isGreaterThan(clean.length / 4);
    assertThat(same).isEqualTo(far);
  }

  /** With a little more noise everything is filtered: the discs must not gain by that. */
  @Test
  void whatIsFilteredIsAsCleanAsInAPictureThatIsFilteredAsAWhole() throws InterruptedException {
    float[] part = BuiltInDenoiser.denoise(discs(.9 * LIMIT, 1), 2).image().rgb();
    float[] whole = BuiltInDenoiser.denoise(discs(1.5 * LIMIT, 1), 2).image().rgb();
    double error = 0;
    double difference = 0;
    int count = 0;
    for (int i = 0; i < part.length; i++) {
      if (isDisc(i)) {
        error += Math.pow(whole[i] - truth(i), 2);
        difference += Math.pow(whole[i] - part[i], 2);
        count++;
      }
    }
    assertThat(error / count).isLessThan(.2 * .2 / 10);
    assertThat(difference).isLessThan(error / 100);
  }

  @Test
  void tilesAndThreadsDoNotCount() throws InterruptedException {
    NoisyPicture noisy = discs(.9 * LIMIT, 1);
    Denoised expected = BuiltInDenoiser.denoise(noisy, 1, Integer.MAX_VALUE);
    int half = (WIDTH / 2 + BuiltInDenoiser.MARGIN) * HEIGHT;
    Denoised tiled = BuiltInDenoiser.denoise(noisy, 3, half);
    assertThat(tiled.image().rgb()).isEqualTo(expected.image().rgb());
    assertThat(tiled.relativeError()).isEqualTo(expected.relativeError());
  }

  @Test
  void noiseOfPixelsThatAreNotFilteredIsInTheError() throws InterruptedException {
    float[] light = new float[3 * WIDTH * HEIGHT];
    float[] noise = new float[light.length];
    Arrays.fill(light, BACKGROUND);
    Arrays.fill(noise, (float) (.9 * LIMIT * BACKGROUND));
    NoisyPicture quiet =
        new NoisyPicture(
            WIDTH,
            HEIGHT,
            new NoisyPicture.Halves(light, noise),
            Optional.empty(),
            Optional.empty(),
            new float[0],
            0);
    Denoised clean = BuiltInDenoiser.denoise(quiet, 2);
    assertThat(clean.image().rgb()).isEqualTo(light);
    double squared = Math.pow(noise[0], 2) / (Math.pow(BACKGROUND, 2) + Denoised.FLOOR);
    assertThat(clean.relativeError().getAsDouble())
        .isCloseTo(
            Math.sqrt(BuiltInDenoiser.UNSEEN * Math.pow(squared, 7. / 6)), withinPercentage(.01));
  }

  /** Black is filtered, since samples may have missed its light, unless it is transparent. */
  @Test
  void transparentPixelsAreNotFilteredButBlackOnesAre() throws InterruptedException {
    try (Workers workers = new Workers(2)) {
      FilteredUnits transparent = FilteredUnits.of(new Features(discs(0, 0)), workers);
      assertThat(transparent.contains(400, 8)).isFalse();
      assertThat(transparent.contains(60, 16)).isTrue();
      NoisyPicture light = discs(0, 0);
      NoisyPicture black =
          new NoisyPicture(
              WIDTH, HEIGHT, light.light(), light.albedo(), light.normal(), new float[0], 0);
      assertThat(FilteredUnits.of(new Features(black), workers).contains(400, 8)).isTrue();
    }
  }

  private static boolean isFilteredFarAway(NoisyPicture picture) throws InterruptedException {
    try (Workers workers = new Workers(1)) {
      return FilteredUnits.of(new Features(picture), workers).contains(400, 8);
    }
  }

  @Test
  void visibleNoiseIsFiltered() throws InterruptedException {
    assertThat(isFilteredFarAway(discs(.9 * LIMIT, 1))).isFalse();
    assertThat(isFilteredFarAway(discs(1.5 * LIMIT, 1))).isTrue();
  }

  /** Differences of neighbors may be noise. */
  @Test
  void whereNoiseIsUnknownPixelsThatDifferAreFiltered() throws InterruptedException {
    assertThat(isFilteredFarAway(withoutNoise(discs(0, 1)))).isFalse();
    NoisyPicture uneven = withoutNoise(discs(0, 1));
    uneven.light().mean()[3 * (8 * WIDTH + 400) + 2] *= 1 + 3.9f / 1024;
    assertThat(isFilteredFarAway(uneven)).isFalse();
    uneven.light().mean()[3 * (8 * WIDTH + 400) + 2] *= 1.0005f;
    assertThat(isFilteredFarAway(uneven)).isTrue();
  }

  private static NoisyPicture withoutNoise(NoisyPicture picture) {
    return new NoisyPicture(
        WIDTH,
        HEIGHT,
        new NoisyPicture.Halves(picture.light().mean(), new float[0]),
        picture.albedo(),
        picture.normal(),
        new float[0],
        0);
  }

  /** The kernels of coarser levels reach into what is not filtered. */
  @Test
  void whatIsNotFilteredIsPooledEvenly() throws InterruptedException {
    Features picture = new Features(discs(.9 * LIMIT, 1));
    FilterLevel[] levels = {new FilterLevel(0, 64, 16, 12), new FilterLevel(1, 32, 8, 12)};
    try (Workers workers = new Workers(1)) {
      FilteredPart part = new FilteredPart(FilteredUnits.of(picture, workers), 384, 0, 64, 0);
      assertThat(part.end(0, 0)).isEqualTo(64);
      FilterLevel.Light light = (x, y, rows, count) -> picture.writeLight(384 + x, y, rows, count);
      new LevelFilter(Network.get().head(0), levels[0], levels[1], light)
          .apply(new Maps(64, 0, 16, 0), 0, 16, part);
    }
    float[][] rows = new float[12][2];
    picture.writeLight(384 + 6, 5, rows, 2);
    float lower = rows[0][0] + rows[0][1];
    picture.writeLight(384 + 6, 4, rows, 2);
    float mean = (lower + rows[0][0] + rows[0][1]) / 4;
    assertThat(levels[1].light[0][2 * 32 + 3]).isCloseTo(mean, within(1e-6f));
    assertThat(levels[1].weight[2 * 32 + 3]).isEqualTo(1);
  }
}
