package io.github.lumbre.lab;

import io.github.lumbre.image.Image;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/**
 * A render of one scene with one setting and one seed, with its cost so far. Samples can be added.
 * Mutable, not thread-safe.
 */
public final class Trial {
  private final FilmRenderer renderer;
  private final AllocationMeter meter;
  private final Film film;
  private RenderStatistics statistics = RenderStatistics.ZERO;
  private Cost time = new Cost(0, 0, 0);
  private int samples;

  /**
   * The result of a render.
   *
   * @param cost cost of all samples and of the picture
   */
  public record Outcome(Image picture, Cost cost, RenderStatistics statistics) {}

  /** Creates a trial without samples. */
  public Trial(FilmRenderer renderer, Progress progress) {
    this.renderer = renderer;
    meter = new AllocationMeter(progress);
    film = renderer.newFilm();
  }

  /**
   * Renders a scene with all samples of its settings. The cost includes the preparation of lights
   * and the development of the picture.
   *
   * @throws InterruptedException if the host cancels the render
   */
  public static Outcome render(Scene scene, RenderSettings settings, LabHost host)
      throws InterruptedException {
    return host.displayed(
        display -> {
          display.started(settings.window().pixels() * settings.samples());
          Cost start = Cost.now();
          Trial trial = new Trial(new FilmRenderer(settings, scene), display);
          trial.time = Cost.since(start);
          trial.to(settings.samples());
          return trial.develop();
        });
  }

  /**
   * Adds samples until each pixel has a given number.
   *
   * @param goal samples per pixel; the mean if the settings are adaptive
   * @throws InterruptedException if the progress listener cancels the render
   */
  public void to(int goal) throws InterruptedException {
    Cost start = Cost.now();
    PassResult result = new PassLoop(renderer, film, renderer.schedule(goal)).run(meter);
    statistics = statistics.plus(result.statistics());
    if (!result.complete()) {
      throw new InterruptedException("the render was cancelled");
    }
    time = time.plus(Cost.since(start));
    samples = goal;
  }

  /** Returns the picture with its cost, which includes its development. */
  public Outcome develop() {
    Cost start = Cost.now();
    Image picture = film.develop();
    return new Outcome(picture, cost().plus(Cost.since(start)), statistics);
  }

  /** Returns the film with the samples so far. */
  public Film film() {
    return film;
  }

  /** Returns the number of samples per pixel so far. */
  public int samples() {
    return samples;
  }

  /** Returns the numbers of samples and rays so far. */
  public RenderStatistics statistics() {
    return statistics;
  }

  /** Returns the cost of all samples so far. */
  public Cost cost() {
    return time.plus(new Cost(0, 0, meter.bytes()));
  }
}
