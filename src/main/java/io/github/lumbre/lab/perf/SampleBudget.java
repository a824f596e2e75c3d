package io.github.lumbre.lab.perf;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.OptionalDouble;

/** Estimates the number of samples that fit into a time, by a short pilot render of the scene. */
public final class SampleBudget {
  /** The minimum number of samples per pixel of a useful picture. */
  public static final int LEAST = 64;

  private static final int MULTIPLE = 16;

  /** The longer side, in pixels, of the pilot render's frame, which shows the whole view. */
  private static final int PILOT_SIDE = 160;

  private SampleBudget() {}

  /**
   * Returns the number of samples per second of a scene on this machine; empty if stopped. Renders
   * small pictures, each with twice the samples of the previous one, until one takes long enough.
   *
   * @param seconds minimum time of the last picture
   */
  public static OptionalDouble rate(SceneFile file, double seconds, Progress progress)
      throws InterruptedException {
    return rate(file.scene(), file.settings(), seconds, progress);
  }

  /** Returns the number of samples per second of a scene with other settings; empty if stopped. */
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

  /**
   * Returns the number of samples per pixel that fits into a time: a multiple of 16, at least 64.
   * The scene's own number is ignored.
   *
   * @param rate in samples per second
   */
  public static int samples(double rate, double seconds, RenderSettings settings) {
    double fitting = rate * seconds / ((double) settings.width() * settings.height());
    int samples = (int) Math.min(fitting, RenderSettings.MAX_SAMPLES);
    return Math.max(LEAST, samples - samples % MULTIPLE);
  }

  /**
   * Returns the time in seconds of {@value #LEAST} samples per pixel, the minimum that {@link
   * #samples} returns.
   *
   * @param rate in samples per second
   */
  public static double leastSeconds(double rate, RenderSettings settings) {
    return LEAST * (double) settings.width() * settings.height() / rate;
  }
}
