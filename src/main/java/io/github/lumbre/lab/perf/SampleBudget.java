package io.github.lumbre.lab.perf;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.OptionalDouble;

/** How many samples fit into a given time, by a short pilot of the same scene. */
public final class SampleBudget {
  /** The least number of samples that makes a picture worth looking at. */
  public static final int LEAST = 64;

  private static final int MULTIPLE = 16;

  /** The longer side of the pilot's frame, which shows all of the scene. */
  private static final int PILOT_SIDE = 160;

  private SampleBudget() {}

  /**
   * Returns how many samples per second this machine takes of a scene; nothing if that was stopped.
   * Renders small pictures, each with twice the samples of the last, until one takes long enough.
   *
   * @param seconds that the last of them takes at least
   */
  public static OptionalDouble rate(SceneFile file, double seconds, Progress progress)
      throws InterruptedException {
    return rate(file.scene(), file.settings(), seconds, progress);
  }

  /** Returns the same of a scene with other settings. */
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

  /** Returns settings of the same view in a frame whose longer side is at most so many pixels. */
  public static RenderSettings shrunk(RenderSettings settings, int side) {
    double factor = Math.min(1, side / (double) Math.max(settings.width(), settings.height()));
    return settings.toBuilder()
        .size(
            (int) Math.ceil(settings.width() * factor), (int) Math.ceil(settings.height() * factor))
        .build();
  }

  /**
   * Returns the number of samples per pixel, whatever the scene asks for: a multiple of 16, at
   * least 64.
   *
   * @param rate in samples per second
   */
  public static int samples(double rate, double seconds, RenderSettings settings) {
    double fitting = rate * seconds / ((double) settings.width() * settings.height());
    int samples = (int) Math.min(fitting, RenderSettings.MAX_SAMPLES);
    return Math.max(LEAST, samples - samples % MULTIPLE);
  }

  /**
   * Returns the seconds that {@value #LEAST} samples per pixel take, the fewest that {@link
   * #samples} returns.
   *
   * @param rate in samples per second
   */
  public static double leastSeconds(double rate, RenderSettings settings) {
    return LEAST * (double) settings.width() * settings.height() / rate;
  }
}
