package io.github.lumbre.render.preview;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.render.stopping.BudgetWatch;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings;
import java.util.Objects;
import java.util.Optional;

/**
 * Hands previews of a film to a listener while it is rendered: after passes, and within long ones,
 * which it pauses.
 *
 * <p>A preview costs the time to develop the picture, during which the render waits. The next one
 * is due once all of them together take at most 1 % of the time, apart from the first 0.3 s, and at
 * least 0.2 s later. Estimates of the error take at most 0.5 % besides, apart from the first 0.1 s.
 * While nobody is watching, nothing is paused or developed.
 *
 * <p>Mutable; for the films of one thread, one after the other.
 */
public final class Previews implements PassListener {
  private final RecordedLayers recorded;
  private final PreviewListener listener;
  private final PreviewPace previews = new PreviewPace(.01, 300_000_000, System::nanoTime);
  private final PreviewPace estimates = new PreviewPace(.005, 100_000_000, System::nanoTime);

  /**
   * @param recorded the layers of the films; see {@link RecordedLayers#of}
   */
  public Previews(RecordedLayers recorded, PreviewListener listener) {
    this.recorded = Objects.requireNonNull(recorded, "recorded");
    this.listener = Objects.requireNonNull(listener, "listener");
  }

  @Override
  public boolean isDue() {
    return listener.isWatching() && (previews.isDue() || listener.isUrgent());
  }

  @Override
  public void passed(Film film, PassResult soFar) {
    if (isDue() || soFar.complete() && isEstimateWanted(film)) {
      show(film, soFar.complete(), false);
    }
  }

  /** Hands out a film if anybody is watching, whether a preview is due or not. */
  public void showLast(Film film) {
    if (listener.isWatching()) {
      show(film, film.fewestSamples() == film.mostSamples(), true);
    }
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
    FilmPicture picture = FilmPicture.of(film, recorded, listener.layers());
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
