package io.github.lumbre.render;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;

/**
 * Renders scenes to pictures in passes of increasing length (see {@link Passes}). Use {@link
 * FilmRenderer} to control the render between passes. Immutable; several threads may use one
 * instance at once. Pictures are bit-identical for any number of threads, bucket size and order of
 * work.
 */
public final class PictureRenderer {
  private final RenderSettings settings;
  private final Optional<Executor> executor;
  private final Limits limits;

  /** Creates a renderer. */
  public PictureRenderer(RenderSettings settings) {
    this(settings, Optional.empty(), Limits.NONE);
  }

  private PictureRenderer(RenderSettings settings, Optional<Executor> executor, Limits limits) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.executor = executor;
    this.limits = limits;
  }

  /**
   * Returns the same renderer on the threads of an executor, such as the pool of a server; see
   * {@link FilmRenderer#on}.
   */
  public PictureRenderer on(Executor newExecutor) {
    Objects.requireNonNull(newExecutor, "newExecutor");
    return new PictureRenderer(settings, Optional.of(newExecutor), limits);
  }

  /**
   * Returns the same renderer with limits. Before it allocates memory, it refuses pixels, samples
   * and memory beyond them with an {@link IllegalArgumentException}. When the time has passed, it
   * ends with a partial picture, as if the render were cancelled.
   */
  public PictureRenderer limitedTo(Limits newLimits) {
    Objects.requireNonNull(newLimits, "newLimits");
    return new PictureRenderer(settings, executor, newLimits);
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
   * Renders a scene.
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have then ended
   * @throws RenderException if a worker failed
   */
  public RenderResult render(Scene scene, Progress progress) throws InterruptedException {
    requireLimits(FilmLayers.of(settings, scene));
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    return render(executor.map(renderer::on).orElse(renderer), timed(progress));
  }

  private void requireLimits(FilmLayers layers) {
    long pixels = (long) settings.width() * settings.height();
    MemoryEstimate estimate = new MemoryEstimate(settings, layers, 0, limits.memory());
    Limits.excess("pixels", limits.pixels(), pixels)
        .or(() -> Limits.excess("samples per pixel", limits.samples(), settings.samples()))
        .or(() -> Limits.excess("bytes", limits.memory(), estimate.neededBytes()))
        .ifPresent(
            excess -> {
              throw new IllegalArgumentException("settings: " + excess);
            });
  }

  private Progress timed(Progress progress) {
    if (limits.time().equals(Limits.NO_TIME_LIMIT)) {
      return progress;
    }
    long start = System.nanoTime();
    long allowed = limits.time().toNanos();
    return progress.cancelledAlsoIf(() -> System.nanoTime() - start > allowed);
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
    progress.started(settings.window().pixels() * settings.samples());
    PassResult passes = new PassLoop(renderer, film).run(progress);
    return new RenderResult(film.develop(), passes.complete(), passes.statistics());
  }
}
