package io.github.lumbre.lab.perf;

import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.OptionalDouble;

/** Estimates the speed of a render by a short pilot render of the scene. */
public final class SampleBudget {
  /** The longer side, in pixels, of the pilot render's frame, which shows the whole view. */
  private static final int PILOT_SIDE = 160;

  private SampleBudget() {}

  /**
   * Returns the number of samples per second of a scene on this machine; empty if stopped. Renders
   * small pictures, each with twice the samples of the previous one, until one takes long enough.
   *
   * @param seconds minimum time of the last picture
   */
  public static OptionalDouble rate(
      Scene scene, RenderSettings settings, double seconds, Progress progress)
      throws InterruptedException {
    RenderSettings small = shrunk(settings, PILOT_SIDE);
    for (int samples = 1; ; samples *= 2) {
      BucketRenderer renderer = new BucketRenderer(small.toBuilder().samples(samples).build());
      long start = System.nanoTime();
      boolean complete = renderer.render(scene, progress).complete();
      double taken = (System.nanoTime() - start) * 1e-9;
      if (!complete) {
        return OptionalDouble.empty();
      }
      if (taken >= seconds || samples > RenderSettings.MAX_SAMPLES / 2) {
        return OptionalDouble.of(samples * (double) small.width() * small.height() / taken);
      }
    }
  }

  /**
   * Returns settings with the same view in a frame whose longer side has at most a number of
   * pixels.
   */
  public static RenderSettings shrunk(RenderSettings settings, int side) {
    double factor = Math.min(1, side / (double) Math.max(settings.width(), settings.height()));
    return settings.toBuilder()
        .size(
            (int) Math.ceil(settings.width() * factor), (int) Math.ceil(settings.height() * factor))
        .build();
  }
}
