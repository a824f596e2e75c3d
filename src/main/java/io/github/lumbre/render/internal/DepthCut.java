package io.github.lumbre.render.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/**
 * An estimate of the energy lost to the path length limit: the light that longer paths add in a
 * pilot render of the full frame with 64×48 pixels and 2 samples per pixel. Deterministic for a
 * scene and its settings.
 *
 * <p>Both depths use the same random numbers, so each path has the same first vertices, and the
 * difference is the lost energy. The longer paths have 4 times the depth, or 32 more vertices if
 * that is greater.
 *
 * @param share the lost fraction of all energy, 0 to 1
 * @param standardError the standard error of the share
 */
public record DepthCut(double share, double standardError) {
  /**
   * The cost of the pilot renders, in samples: their fraction of a render's time is at most about
   * this number divided by the render's total number of samples.
   */
  public static final long COST_IN_SAMPLES = 20_000;

  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;
  private static final int SAMPLES = 2;
  private static final int BUCKET = 8;

  /** The minimum increase of the path depth. */
  private static final int DEEPER = 32;

  /**
   * Estimates the energy that a render with the given settings loses.
   *
   * @throws InterruptedException if the calling thread is interrupted
   */
  public static DepthCut of(Scene scene, RenderSettings settings) throws InterruptedException {
    RenderSettings shallow =
        settings.toBuilder()
            .size(WIDTH, HEIGHT)
            .crop(new RenderSettings.Crop(0, 0, WIDTH, HEIGHT))
            .samples(SAMPLES)
            .bucketSize(BUCKET)
            .adaptive(false)
            .clamp(Double.POSITIVE_INFINITY)
            .build();
    RenderSettings deep =
        shallow.toBuilder()
            .maxTraceDepth(deeper(settings.maxTraceDepth()))
            .rayDepths(
                deeper(settings.reflectionTraceDepth()), deeper(settings.refractionTraceDepth()))
            .build();
    return of(new PictureRenderer(shallow).render(scene), new PictureRenderer(deep).render(scene));
  }

  private static int deeper(int depth) {
    return (int) Math.min(RenderSettings.MAX_DEPTH, depth + Math.max(DEEPER, 3L * depth));
  }

  /** Returns the energy that the first picture lacks, compared with the second. */
  private static DepthCut of(Image shallow, Image deep) {
    double all = 0;
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        double light = light(deep, x, y);
        double difference = light - light(shallow, x, y);
        all += light;
        sum += difference;
        squares += difference * difference;
      }
    }
    if (all == 0) {
      return new DepthCut(0, 0);
    }
    int pixels = WIDTH * HEIGHT;
    double variance = Math.max(0, squares - sum * sum / pixels);
    return new DepthCut(Math.max(0, sum) / all, Math.sqrt(variance) / all);
  }

  private static double light(Image image, int x, int y) {
    Rgb color = image.pixel(x, y);
    return image.alpha(x, y) * (color.r() + color.g() + color.b()) / 3;
  }
}
