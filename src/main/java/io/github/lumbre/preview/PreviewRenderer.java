package io.github.lumbre.preview;

import io.github.lumbre.checkpoint.FilmPicture;
import io.github.lumbre.checkpoint.RecordedLayers;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.PassRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.stopping.Budget;
import io.github.lumbre.stopping.BudgetWatch;
import io.github.lumbre.stopping.NoiseEstimate;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * Adds samples as another renderer does, and hands previews of the film to a listener: after
 * passes, and within long ones, which it pauses. The samples are the same, bit for bit.
 *
 * <p>A preview costs the time to develop the picture, during which the render waits. The next one
 * is due once all of them together take at most 1 % of the time, apart from the first 0.3 s, and at
 * least 0.2 s later. Estimates of the error take at most 0.5 % besides, apart from the first 0.1 s.
 * While nobody is watching, nothing is paused or developed.
 *
 * <p>Mutable; for the films of one thread, one after the other.
 */
public final class PreviewRenderer implements PassRenderer {
  private final PassRenderer renderer;
  private final RecordedLayers recorded;
  private final PreviewListener listener;
  private final PreviewPace previews = new PreviewPace(.01, 300_000_000, System::nanoTime);
  private final PreviewPace estimates = new PreviewPace(.005, 100_000_000, System::nanoTime);
  private Optional<Film> unseen = Optional.empty();

  /**
   * Creates a renderer.
   *
   * @param renderer adds the samples
   * @param recorded the layers of its films; see {@link RecordedLayers#of}
   */
  public PreviewRenderer(PassRenderer renderer, RecordedLayers recorded, PreviewListener listener) {
    this.renderer = Objects.requireNonNull(renderer, "renderer");
    this.recorded = Objects.requireNonNull(recorded, "recorded");
    this.listener = Objects.requireNonNull(listener, "listener");
  }

  @Override
  public Schedule schedule() {
    return renderer.schedule();
  }

  @Override
  public OptionalDouble seconds(Film film, SampleTarget target) {
    return renderer.seconds(film, target);
  }

  @Override
  public PassResult addSamples(Film film, SampleTarget target, Progress progress)
      throws InterruptedException {
    // A pass whose time is known is always completed.
    boolean isPausable = renderer.seconds(film, target).isEmpty();
    Progress pausing = isPausable ? progress.cancelledAlsoIf(this::isWanted) : progress;
    RenderStatistics statistics = RenderStatistics.ZERO;
    while (true) {
      PassResult part = renderer.addSamples(film, target, pausing);
      statistics = statistics.plus(part.statistics());
      unseen = Optional.of(film);
      if (isWanted() || part.complete() && isEstimateWanted(film)) {
        show(film, part.complete(), false);
      }
      if (part.complete() || !isPausable || progress.isCancelled()) {
        return new PassResult(part.complete(), statistics);
      }
    }
  }

  /**
   * Hands out the last samples of a film, whether a preview is due or not; call this at the end of
   * a render.
   */
  public void finish() {
    if (unseen.isPresent() && listener.isWatching()) {
      show(unseen.get(), unseen.get().fewestSamples() == unseen.get().mostSamples(), true);
    }
  }

  /** Marks a film as not shown yet, so that {@link #finish} hands it out again. */
  public void touch(Film film) {
    unseen = Optional.of(film);
  }

  private boolean isWanted() {
    return listener.isWatching() && (previews.isDue() || listener.isUrgent());
  }

  private boolean isEstimateWanted(Film film) {
    return estimates.isDue()
        && listener.isWatching()
        && listener.wantsNoise()
        && film.fewestSamples() > 1;
  }

  private void show(Film film, boolean isEndOfPass, boolean isLast) {
    long start = System.nanoTime();
    boolean isForEstimate = !previews.isDue();
    Set<Layer> layers = EnumSet.noneOf(Layer.class);
    layers.addAll(listener.layers());
    layers.retainAll(recorded.kinds());
    FilmPicture picture = FilmPicture.of(film, recorded, layers);
    long developed = System.nanoTime();
    Optional<NoiseEstimate> noise =
        isEndOfPass && listener.wantsNoise() && (isLast || estimates.isDue())
            ? noise(film)
            : Optional.empty();
    long estimated = System.nanoTime();
    listener.show(
        new Preview(
            picture.image(),
            picture.layers(),
            film.meanSamples(),
            film.totalSamples(),
            isEndOfPass,
            noise,
            picture.metadata()));
    unseen = Optional.empty();
    long end = System.nanoTime();
    long elsewhere = (long) (1e9 * listener.secondsElsewhere());
    if (noise.isPresent()) {
      estimates.spend(isForEstimate ? end - start + elsewhere : estimated - developed);
    }
    if (!isForEstimate || noise.isEmpty()) {
      previews.spend(end - start - (estimated - developed) + elsewhere);
    }
  }

  private static Optional<NoiseEstimate> noise(Film film) {
    return film.fewestSamples() < 2
        ? Optional.empty()
        : new BudgetWatch(Budget.ofSamples(RenderSettings.MAX_SAMPLES)).estimate(film);
  }
}
