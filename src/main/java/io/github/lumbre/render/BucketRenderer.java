package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;

/**
 * Renders scenes to pictures in passes of increasing length (see {@link Passes}). Use {@link
 * FilmRenderer} to control the render between passes. Immutable; several threads may use one
 * instance at once. Pictures are bit-identical for any number of threads, bucket size and order of
 * work.
 */
public final class BucketRenderer {
  private final RenderSettings settings;

  /** Creates a renderer. */
  public BucketRenderer(RenderSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /**
   * Renders a scene without progress reports.
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have then ended
   * @throws RenderException if a worker failed
   */
  public Image render(Scene scene) throws InterruptedException {
    return render(scene, Progress.NONE).image();
  }

  /**
   * * Renders a scene. *
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have then ended
   * @throws RenderException if a worker failed
   */
  public RenderResult render(Scene scene, Progress progress) throws InterruptedException {
    return render(new FilmRenderer(settings, scene), progress);
  }

  RenderResult render(Scene scene, Integrator integrator, Progress progress)
      throws InterruptedException {
    return render(new FilmRenderer(settings, scene, integrator), progress);
  }

  /**
   * Renders with a given film renderer.
   *
   * @param renderer with the same settings as this
   */
  RenderResult render(FilmRenderer renderer, Progress progress) throws InterruptedException {
    Film film = renderer.newFilm();
    RenderSettings.Crop window = settings.window();
    progress.started((long) window.width() * window.height() * settings.samples());
    RenderStatistics statistics = RenderStatistics.ZERO;
    boolean complete = true;
    Schedule schedule = renderer.schedule();
    for (Optional<SampleTarget> target = schedule.next(film);
        complete && target.isPresent();
        target = schedule.next(film)) {
      PassResult pass = renderer.addSamples(film, target.get(), progress);
      statistics = statistics.plus(pass.statistics());
      complete = pass.complete();
    }
    return new RenderResult(film.develop(), complete, statistics);
  }
}
