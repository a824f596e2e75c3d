package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.guiding.Guide;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.List;

/**
 * Compares guided paths with unguided ones. Each renders two independent sets of samples in pixels
 * that are spread over the frame. The error is the mean absolute difference of the two sets, over
 * blocks of pixels.
 *
 * <p>Where light is rarely found, the mean <em>squared</em> difference of a few samples is not a
 * measure: without the rare samples it is small, and with one it is huge, so that it favors the
 * technique that misses more light. The absolute difference of two sets that miss light is as large
 * as the light that they find, and it never exceeds their sum.
 *
 * @param gain the square of the ratio of errors, divided by the ratio of costs; 0 if unguided paths
 *     have no error
 * @param rays rays of all paths
 */
record GuideComparison(double gain, long rays) {
  /** How many times better guided paths must be. The measure has an error of its own. */
  static final double LEAST_GAIN = 1.3;

  /** The time of a ray of a guided path, in rays of other paths: the median of eight scenes. */
  private static final double RAY_COST = 1.4;

  private static final int MOST_PIXELS = 4096;

  /** Side of a block in pixels of the grid. */
  private static final int BLOCK = 4;

  /** Samples of a pixel in each set. */
  private static final int SAMPLES = 8;

  /** Part of the mean over the frame that is added to the divisor of a block's error. */
  private static final double FLOOR = .1;

  private static final long[] SEEDS = {0x6f662077686f6d65L, 0x20697420776f726bL};

  /** Compares a guide with none; see {@link GuidePilot#learn} for the parameters. */
  static GuideComparison of(RenderSettings settings, Scene scene, Guide guide, PilotRows crew)
      throws InterruptedException, PilotRows.Stopped {
    long pixels = (long) settings.width() * settings.height();
    int points = (int) Math.max(1, Math.min(MOST_PIXELS, pixels / BLOCK));
    PilotGrid grid = PilotGrid.of(settings, points);
    Blocks without = render(settings, scene, Guide.NONE, grid, crew);
    Blocks with = render(settings, scene, guide, grid, crew);
    double[] light = new double[without.sums()[0].length];
    double mean = 0;
    for (int i = 0; i < light.length; i++) {
      for (int set = 0; set < SEEDS.length; set++) {
        light[i] += without.sums()[set][i] + with.sums()[set][i];
      }
      mean += light[i] / light.length;
    }
    double before = without.error(light, mean);
    double after = with.error(light, mean);
    double cost = RAY_COST * with.rays() / Math.max(1, without.rays());
    double gain = before == 0 ? 0 : before * before / (after * after * cost + Double.MIN_NORMAL);
    return new GuideComparison(gain, without.rays() + with.rays());
  }

  /** The light of each set in each block, and the rays of all. */
  private record Blocks(double[][] sums, long rays) {
    double error(double[] light, double mean) {
      double error = 0;
      for (int i = 0; i < light.length; i++) {
        double difference = Math.abs(sums[0][i] - sums[1][i]);
        error += difference / (light[i] + FLOOR * mean + Double.MIN_NORMAL);
      }
      return error;
    }
  }

  /** The light of each set in each pixel of a row. */
  private record Row(double[][] light, long rays) {}

  private static Blocks render(
      RenderSettings settings, Scene scene, Guide guide, PilotGrid grid, PilotRows crew)
      throws InterruptedException, PilotRows.Stopped {
    Integrator integrator = Integrator.of(scene, settings, guide);
    List<Row> rows =
        crew.render(grid.rows(), row -> row(settings, scene, integrator, grid, row, crew));
    int columns = (grid.columns() + BLOCK - 1) / BLOCK;
    double[][] sums = new double[SEEDS.length][columns * ((grid.rows() + BLOCK - 1) / BLOCK)];
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        for (int set = 0; set < SEEDS.length; set++) {
          sums[set][row / BLOCK * columns + column / BLOCK] += rows.get(row).light()[set][column];
        }
      }
    }
    return new Blocks(sums, rows.stream().mapToLong(Row::rays).sum());
  }

  private static Row row(
      RenderSettings settings,
      Scene scene,
      Integrator integrator,
      PilotGrid grid,
      int row,
      PilotRows crew)
      throws InterruptedException, PilotRows.Stopped {
    RenderContext context = new RenderContext();
    CameraRay ray = new CameraRay();
    double[][] light = new double[SEEDS.length][grid.columns()];
    for (int set = 0; set < SEEDS.length; set++) {
      Sampler sampler = new SobolSampler(settings.seed() ^ SEEDS[set]);
      for (int i = 0; i < grid.columns() * SAMPLES; i++) {
        crew.check();
        int column = i / SAMPLES;
        context.startSample();
        if (CameraSamples.start(
            scene, settings, sampler, grid.x(column), grid.y(row), i % SAMPLES, ray)) {
          Rgb c = integrator.radiance(ray, sampler, context);
          light[set][column] += SampleLimit.isRejected(c) ? 0 : c.r() + c.g() + c.b();
        }
      }
    }
    return new Row(light, context.rays() + context.shadowRays());
  }
}
