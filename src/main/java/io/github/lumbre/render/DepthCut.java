package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/**
 * How much of the light lies beyond the greatest depth of paths, and so is not in a picture: what
 * deeper paths add to a few thousand samples of the whole frame. The same for the same scene and
 * settings.
 *
 * <p>Both depths take the same random numbers, so that each path begins as it does in the render,
 * and the difference is what was cut off, up to paths four times as deep, or 32 vertices deeper.
 *
 * @param share of all light, 0 to 1
 * @param standardError of the share
 */
public record DepthCut(double share, double standardError) {
  /** What the pilot takes at most of a render's time is about this over its samples. */
  public static final long COST_IN_SAMPLES = 20_000;

  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;
  private static final int SAMPLES = 2;
  private static final int BUCKET = 8;

  /** By how much deeper it looks than the scene asks. */
  private static final int DEEPER = 32;

  /**
   * Estimates what a render by some settings cuts off.
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
    return of(new BucketRenderer(shallow).render(scene), new BucketRenderer(deep).render(scene));
  }

  private static int deeper(int depth) {
    return (int) Math.min(RenderSettings.MAX_DEPTH, depth + Math.max(DEEPER, 3L * depth));
  }

  /** Returns what the first picture lacks of the second. */
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
    Rgb colour = image.pixel(x, y);
    return image.alpha(x, y) * (colour.r() + colour.g() + colour.b()) / 3;
  }
}
