package io.github.lumbre.lab.gallery;

import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.MemoryEstimate;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.scene.RenderSettings;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** Renders each scene of a gallery in about the same time. */
public final class GalleryRenderer {
  /** The share of a picture's time for the timed part of its pilot render. */
  private static final double PILOT_SHARE = .03;

  private static final double MAX_PILOT_SECONDS = 5;

  private final SceneFolder scenes;
  private final double seconds;
  private final int threads;
  private final LabHost host;

  /**
   * @param seconds approximate time per picture
   * @param threads number of threads; 0 means one per processor
   * @param host reads the scenes and shows every render
   */
  public GalleryRenderer(SceneFolder scenes, double seconds, int threads, LabHost host) {
    this.scenes = scenes;
    this.seconds = seconds;
    this.threads = threads;
    this.host = host;
  }

  /**
   * A rendered scene.
   *
   * @param seconds rendering time
   */
  public record Rendered(
      SceneFile file, RenderSettings settings, RenderResult result, double seconds) {}

  /** Renders a scene; returns empty if stopped. */
  public Optional<Rendered> render(String scene)
      throws SceneFormatException, TaskException, InterruptedException {
    SceneParser parser =
        new SceneParser().overriding(inScene -> inScene.toBuilder().threads(threads).build());
    SceneFile file = host.read(scenes.file(scene), parser);
    MemoryEstimate.require(file.settings(), FilmLayers.NONE);
    OptionalDouble rate = rate(file);
    return rate.isEmpty() ? Optional.empty() : render(scene, file, rate.getAsDouble());
  }

  private OptionalDouble rate(SceneFile file) throws InterruptedException {
    double pilot = Math.min(PILOT_SHARE * seconds, MAX_PILOT_SECONDS);
    try (LabHost.Display display = host.display()) {
      return SampleBudget.rate(file, pilot, display);
    }
  }

  private Optional<Rendered> render(String scene, SceneFile file, double rate)
      throws InterruptedException {
    int samples = SampleBudget.samples(rate, seconds, file.settings());
    warnIfTooShort(scene, file.settings(), rate);
    RenderSettings settings = file.settings().toBuilder().samples(samples).build();
    long start = System.nanoTime();
    RenderResult result;
    try (LabHost.Display display = host.display()) {
      result = new BucketRenderer(settings).render(file.scene(), display);
    }
    double taken = (System.nanoTime() - start) * 1e-9;
    return result.complete()
        ? Optional.of(new Rendered(file, settings, result, taken))
        : Optional.empty();
  }

  /** Prints a warning if the minimum number of samples takes longer than the given time. */
  public void warnIfTooShort(String scene, RenderSettings settings, double rate) {
    double least = SampleBudget.leastSeconds(rate, settings);
    if (least > seconds) {
      host.warn(
          String.format(
              Locale.ROOT,
              "%s: --seconds %.0f is too short for the minimum of %d samples per pixel, which take"
                  + " about %.0f s",
              scene,
              seconds,
              SampleBudget.LEAST,
              Math.ceil(least)));
    }
  }
}
