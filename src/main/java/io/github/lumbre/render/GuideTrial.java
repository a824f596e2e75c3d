package io.github.lumbre.render;

import io.github.lumbre.guiding.Guide;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.internal.Hash;
import io.github.lumbre.sampling.internal.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;

/**
 * A trial of {@code --guide auto}: pixels that are spread over the full frame are rendered with
 * unguided and with guided paths, and their errors and rays are compared. The gain that the pilot's
 * records predict is not enough, for two reasons. Some noise does not come from scattered
 * directions, so that guiding does not lower it. And the steps in a guide's density spoil the even
 * distribution of Sobol points, which makes the noise of smooth light much lower than records tell.
 *
 * <p>Its work is fixed, sums are taken in the order of the pixels, and cost is counted in rays, as
 * in {@link GuidePilot}.
 */
final class GuideTrial {
  /** Samples of each of two independent means. Their difference shows their error. */
  static final int SAMPLES = 16;

  private static final int SEQUENCES = 2;

  /** The largest number of pixels. */
  private static final int MOST_PIXELS = 2048;

  /** Paths of the pilot for each pixel. A pixel takes 64 paths of the trial. */
  private static final int PATHS_PER_PIXEL = 128;

  private static final int LEAST_PIXELS = 256;

  /** Number of groups of pixels. The jackknife leaves out one group at a time. */
  private static final int GROUPS = 16;

  /** How many standard errors the gain must be above 1. */
  private static final double CERTAINTY = 2;

  /** The smallest gain in rays that counts. Guided rays take up to 1.3 times as long as others. */
  private static final double LEAST_GAIN = 1.3;

  private static final long SEED = 0x677569646520747aL;

  private final RenderSettings settings;
  private final Scene scene;
  private final PilotRows crew;
  private final PilotGrid pixels;

  private GuideTrial(RenderSettings settings, Scene scene, int paths, PilotRows crew) {
    this.settings = settings;
    this.scene = scene;
    this.crew = crew;
    pixels =
        PilotGrid.of(
            settings, Math.max(LEAST_PIXELS, Math.min(MOST_PIXELS, paths / PATHS_PER_PIXEL)));
  }

  /**
   * The outcome.
   *
   * @param gain squared error times rays of unguided paths, over the product for guided ones; 1 if
   *     neither has an error
   * @param isBetter whether guided paths are certainly better, and by enough
   * @param rays of the trial
   */
  record Outcome(double gain, boolean isBetter, long rays) {}

  /**
   * Compares unguided paths with guided ones.
   *
   * @param paths number of paths of the pilot
   */
  static Outcome of(RenderSettings settings, Scene scene, Guide guide, int paths, PilotRows crew)
      throws InterruptedException, PilotRows.Stopped {
    return new GuideTrial(settings, scene, paths, crew).run(guide);
  }

  private Outcome run(Guide guide) throws InterruptedException, PilotRows.Stopped {
    Side unguided = side(Guide.NONE);
    Side guided = side(guide);
    List<Rgb[]> means = new ArrayList<>();
    for (int i = 0; i < unguided.means.size(); i++) {
      Rgb[] off = unguided.means.get(i);
      Rgb[] on = guided.means.get(i);
      means.add(new Rgb[] {off[0], off[1], on[0], on[1]});
    }
    double[] squares = PilotErrors.squares(pixels, means);
    double[] before = errors(unguided, squares);
    double[] after = errors(guided, squares);
    return judge(before, after, unguided.rays, guided.rays);
  }

  /**
   * Compares unguided with guided paths by their errors and rays.
   *
   * @param before error of each pixel with unguided paths, at least 0
   * @param after error of each pixel with guided paths
   */
  static Outcome judge(double[] before, double[] after, long raysBefore, long raysAfter) {
    // One limit for both: the limit of the side with more noise.
    double limit = Math.max(PilotErrors.limit(before), PilotErrors.limit(after));
    double price = (double) raysBefore / raysAfter;
    double gain = price * ratio(before, after, limit, Jackknife.NONE);
    double bound =
        Jackknife.bound(GROUPS, CERTAINTY, group -> price * ratio(before, after, limit, group));
    return new Outcome(
        gain > 0 && gain < Double.POSITIVE_INFINITY ? gain : 1,
        gain >= LEAST_GAIN && bound > 1,
        raysBefore + raysAfter);
  }

  /** Two means of each pixel, row by row, and the rays of all. */
  private record Side(List<Rgb[]> means, long rays) {}

  private Side side(Guide guide) throws InterruptedException, PilotRows.Stopped {
    PilotSamples samples = new PilotSamples(settings, scene, Integrator.of(scene, settings, guide));
    List<Rgb[]> means = new ArrayList<>();
    long rays = 0;
    for (Side row : crew.render(pixels.rows(), number -> row(samples, number))) {
      means.addAll(row.means);
      rays += row.rays;
    }
    return new Side(means, rays);
  }

  private Side row(PilotSamples samples, int row) throws InterruptedException, PilotRows.Stopped {
    RenderContext context = new RenderContext();
    List<Rgb[]> means = new ArrayList<>();
    for (int column = 0; column < pixels.columns(); column++) {
      crew.check();
      Rgb[] pair = new Rgb[SEQUENCES];
      for (int sequence = 0; sequence < SEQUENCES; sequence++) {
        Sampler sampler = new SobolSampler(Hash.of(settings.seed() ^ SEED, sequence));
        pair[sequence] =
            samples.mean(pixels.x(column), pixels.y(row), 0, SAMPLES, sampler, context);
      }
      means.add(pair);
    }
    return new Side(means, context.rays() + context.shadowRays());
  }

  private static double[] errors(Side side, double[] squares) {
    double[] errors = new double[squares.length];
    for (int i = 0; i < errors.length; i++) {
      Rgb[] pair = side.means.get(i);
      errors[i] = PilotErrors.of(pair[0], pair[1], squares[i]);
    }
    return errors;
  }

  /** Returns the ratio of the limited errors, without the pixels of a group. */
  private static double ratio(double[] before, double[] after, double limit, int without) {
    double sumBefore = 0;
    double sumAfter = 0;
    for (int i = 0; i < before.length; i++) {
      if (i % GROUPS != without) {
        sumBefore += Math.min(limit, before[i]);
        sumAfter += Math.min(limit, after[i]);
      }
    }
    return sumBefore / sumAfter;
  }
}
