package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Trial;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/** Estimates the speed of a render by a short pilot render of the scene. */
public final class SampleBudget {
  /** The longer side, in pixels, of the pilot render's frame, which shows the whole view. */
  private static final int PILOT_SIDE = 160;

  private SampleBudget() {}

  /**
   * Returns the number of samples per second of a scene on this machine. Renders small pictures,
   * each with twice the samples of the previous one, until one takes long enough.
   *
   * @param seconds minimum time of the last picture
   */
  public static double rate(Scene scene, RenderSettings settings, double seconds)
      throws InterruptedException {
    RenderSettings small = shrunk(settings, PILOT_SIDE);
    for (int samples = 1; ; samples *= 2) {
      Trial trial = new Trial(new FilmRenderer(small, scene), Progress.NONE);
      trial.to(samples);
      double taken = trial.cost().seconds();
      if (taken >= seconds || samples > RenderSettings.MAX_SAMPLES / 2) {
        return trial.film().totalSamples() / taken;
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
