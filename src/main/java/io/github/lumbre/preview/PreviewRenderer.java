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
 * Adds samples as another renderer does, and hands previews of the film to a listener: after passes,
 * and within long ones, which it pauses. The samples are the same, bit for bit.
 *
 * <p>A preview costs the time to develop the picture, during which the render waits. The next one is
 * due once all of them together take at most 1 % of the time, apart from the first tenth of a
 * second, and at least 0.2 s later. Estimates of the error take at most 0.5 % besides. While nobody
 * is watching, nothing is paused or developed.
 *
 * <p>Mutable; for the films of one thread, one after the other.
 */
public final class PreviewRenderer implements PassRenderer {
  private final PassRenderer renderer;
  private final RecordedLayers recorded;
  private final PreviewListener listener;
  private final PreviewPace previews = new PreviewPace(.01, 100_000_000, System::nanoTime);
  private final PreviewPace estimates = new PreviewPace(.005, 50_000_000, System::nanoTime);
  private Optional<Film> unseen = Optional.empty();
  private long lastEstimate;

  /**
   * Creates a renderer.
   *
   * @param renderer adds the samples
   * @param recorded the layers of its films; see {@link RecordedLayers#of}
   */
  public PreviewRenderer(
      PassRenderer renderer, RecordedLayers recorded, PreviewListener listener) {
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
      if (isWanted()) {
        show(film, part.complete());
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
      show(unseen.get(), unseen.get().fewestSamples() == unseen.get().mostSamples());
    }
  }

  private boolean isWanted() {
    return previews.isDue() && listener.isWatching();
  }

  private void show(Film film, boolean isEndOfPass) {
    long start = System.nanoTime();
    Set<Layer> layers = EnumSet.noneOf(Layer.class);
    layers.addAll(listener.layers());
    layers.retainAll(recorded.kinds());
    FilmPicture picture = FilmPicture.of(film, recorded, layers);
    long total = film.totalSamples();
    Optional<NoiseEstimate> noise =
        isEndOfPass && listener.wantsNoise() ? noise(film) : Optional.empty();
    long estimated = noise.isPresent() ? lastEstimate : 0;
    listener.show(
        new Preview(
            picture.image(), picture.layers(), film.meanSamples(), total, isEndOfPass, noise));
    unseen = Optional.empty();
    long elsewhere = (long) (1e9 * listener.secondsElsewhere());
    previews.spend(System.nanoTime() - start - estimated + elsewhere);
  }

  private Optional<NoiseEstimate> noise(Film film) {
    if (!estimates.isDue() || film.fewestSamples() < 2) {
      return Optional.empty();
    }
    long start = System.nanoTime();
    Budget any = Budget.ofSamples(RenderSettings.MAX_SAMPLES);
    Optional<NoiseEstimate> noise = new BudgetWatch(any).estimate(film);
    lastEstimate = System.nanoTime() - start;
    estimates.spend(lastEstimate);
    return noise;
  }
}
