package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;

/**
 * Renders scenes to pictures, in passes that grow (see {@link Passes}); {@link FilmRenderer} is for
 * those who want to decide between passes. Immutable and reusable, by several threads at once; the
 * number of threads, the size of the buckets and the order of work do not change a bit of the
 * picture.
 */
public final class BucketRenderer {
  private final RenderSettings settings;

  public BucketRenderer(RenderSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /** Renders without anybody listening. */
  public Image render(Scene scene) throws InterruptedException {
    return render(scene, Progress.NONE).image();
  }

  /**
   * Renders.
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have ended then
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
   * @param renderer of this one's settings
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
