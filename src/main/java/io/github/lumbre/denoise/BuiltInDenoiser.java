package io.github.lumbre.denoise;

import java.util.OptionalDouble;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Denoises by first-order regression on albedo, normals and positions, with the same bits on every
 * machine and for any number of threads; see {@link LocalRegression}.
 *
 * <p>The steps: remove noise from the guides; explain each half of the samples with weights from
 * the other half, so that noise does not explain itself; repeat with weights from this first
 * result; do the same at a half and a quarter of the size, and take the coarse structure from there
 * wherever that has the smaller estimated error.
 */
public final class BuiltInDenoiser {
  private static final int LEVELS = 3;
  private static final int SMALLEST_SIDE = 16;
  private static final int WINDOW = 9;
  private static final int GUIDE_WINDOW = 6;
  private static final double FIRST_COLOR = 1;
  private static final double SECOND_COLOR = .7;
  private static final double FIRST_FEATURE = .6;
  private static final double SECOND_FEATURE = 4;

  /** More light counts as this much, so that squares and their sums are finite floats. */
  private static final float BRIGHTEST = 1e15f;

  /** The result stays within this many standard deviations of the noisy picture. */
  private static final double FARTHEST = 4;

  /**
   * How much larger the squared error is than what the two filtered halves show: their bias is
   * mostly the same. Measured over twelve scenes.
   */
  private static final double UNSEEN = 1.8;

  private static final NoisyPicture.Halves NO_GUIDE =
      new NoisyPicture.Halves(new float[0], new float[0]);

  private final ExecutorService threads;

  private BuiltInDenoiser(ExecutorService threads) {
    this.threads = threads;
  }

  /**
   * Denoises a picture. Light above 10^15 counts as 10^15, guides outside [-1,1] as -1 or 1.
   *
   * @param noisy a picture whose noise is known; without guides, less noise is removed
   * @param threads number of threads, at least 1; the result does not depend on it
   * @throws IllegalArgumentException if the noise of the picture is not known
   * @throws InterruptedException if the thread is interrupted
   */
  public static Denoised denoise(NoisyPicture noisy, int threads) throws InterruptedException {
    if (!noisy.light().isNoiseKnown()) {
      throw new IllegalArgumentException(
          "noisy: expected a picture whose noise is known, with at least 2 samples per pixel");
    }
    ExecutorService pool = Executors.newFixedThreadPool(threads, BuiltInDenoiser::daemon);
    try {
      return new BuiltInDenoiser(pool).denoise(noisy);
    } finally {
      pool.shutdownNow();
    }
  }

  private static Thread daemon(Runnable task) {
    Thread thread = new Thread(task, "denoise");
    thread.setDaemon(true);
    return thread;
  }

  private Denoised denoise(NoisyPicture noisy) throws InterruptedException {
    Estimates light = halves(noisy, noisy.light(), BRIGHTEST);
    Estimates guides = halves(noisy, NO_GUIDE, 1);
    if (noisy.albedo().isPresent()) {
      guides = beside(guides, filteredGuide(halves(noisy, noisy.albedo().get(), 1)));
    }
    if (noisy.normal().isPresent()) {
      guides = beside(guides, filteredGuide(halves(noisy, noisy.normal().get(), 1)));
    }
    Estimates calm = Spikes.limited(light);
    Estimates result = filtered(calm, guides, 1);
    double relative = Math.sqrt(UNSEEN * result.relativeError());
    float[] values = within(result.mean(), light).values();
    return Denoised.of(noisy, values, "built-in", OptionalDouble.of(relative));
  }

  /**
   * Returns the two halves of some values, limited to a magnitude; the same ones if their noise is
   * not known.
   */
  private static Estimates halves(NoisyPicture noisy, NoisyPicture.Halves values, float largest) {
    int channels = values.mean().length / (noisy.width() * noisy.height());
    Raster mean =
        new Raster(noisy.width(), noisy.height(), channels, limited(values.mean(), largest));
    return values.isNoiseKnown()
        ? Estimates.of(
            mean,
            new Raster(noisy.width(), noisy.height(), channels, limited(values.noise(), largest)))
        : new Estimates(mean, mean);
  }

  private static float[] limited(float[] values, float largest) {
    float[] limited = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      limited[i] = Math.max(-largest, Math.min(largest, values[i]));
    }
    return limited;
  }

  private static Estimates beside(Estimates left, Estimates right) {
    return new Estimates(left.first().beside(right.first()), left.second().beside(right.second()));
  }

  /** Returns the variance of the mean of two halves, itself blurred. */
  private static Raster variance(Estimates halves, int radius) {
    return halves.noise().squared().blurred(radius);
  }

  /** Returns a guide with less noise, as where the lens is out of focus. */
  private Estimates filteredGuide(Estimates guide) throws InterruptedException {
    Raster none = new Raster(guide.first().width(), guide.first().height(), 0);
    Raster variance = variance(guide, 1).blurred(1).times(2);
    return crossed(
        guide, none, none, variance, new Similarity.Scales(FIRST_COLOR, 1), GUIDE_WINDOW, false);
  }

  /** Filters each half with weights from the other one. */
  private Estimates crossed(
      Estimates halves,
      Raster features,
      Raster featureVariance,
      Raster variance,
      Similarity.Scales scales,
      int radius,
      boolean isFirstOrder)
      throws InterruptedException {
    Raster first = halves.first();
    Raster second = halves.second();
    Similarity bySecond = Similarity.of(second, variance, features, featureVariance, scales);
    Similarity byFirst = Similarity.of(first, variance, features, featureVariance, scales);
    return new Estimates(
        new LocalRegression(bySecond, radius, isFirstOrder).of(first, threads),
        new LocalRegression(byFirst, radius, isFirstOrder).of(second, threads));
  }

  /**
   * Limits how far a result is from the noisy picture; where there is no noise, nothing changes.
   */
  private static Raster within(Raster result, Estimates light) {
    Raster noisy = light.mean();
    // The noise of a spike is its own, not that of its surroundings.
    Raster variance = variance(light, 2).with(light.noise().squared(), Math::max);
    Raster limited = new Raster(result.width(), result.height(), result.channels());
    for (int i = 0; i < result.values().length; i++) {
      double most = FARTHEST * Math.sqrt(Math.max(0, variance.values()[i]));
      double change = result.values()[i] - noisy.values()[i];
      double value = noisy.values()[i] + Math.max(-most, Math.min(most, change));
      limited.values()[i] = (float) Math.max(0, value);
    }
    return limited;
  }

  private Estimates filtered(Estimates light, Estimates guides, int level)
      throws InterruptedException {
    Raster features = guides.mean();
    Raster featureVariance = variance(guides, 1);
    Raster variance = variance(light, 1);
    Estimates pilot =
        crossed(
            light,
            features,
            featureVariance,
            variance.times(2),
            new Similarity.Scales(FIRST_COLOR, FIRST_FEATURE),
            WINDOW,
            true);
    Similarity byPilot =
        Similarity.of(
            pilot.mean(),
            variance(pilot, 2),
            features,
            featureVariance,
            new Similarity.Scales(SECOND_COLOR, SECOND_FEATURE));
    Raster both =
        new LocalRegression(byPilot, WINDOW, true)
            .of(light.first().beside(light.second()), threads);
    Estimates fine = new Estimates(both.part(0, 3), both.part(3, 3));
    if (level == LEVELS || Math.min(features.width(), features.height()) <= SMALLEST_SIDE) {
      return fine;
    }
    Estimates coarse = filtered(light.halved(), guides.halved(), level + 1);
    return Estimates.better(fine, fine.over(coarse), light);
  }
}
