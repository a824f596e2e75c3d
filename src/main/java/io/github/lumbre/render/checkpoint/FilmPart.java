package io.github.lumbre.render.checkpoint;

import io.github.lumbre.render.Film;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Objects;
import java.util.Optional;

/**
 * A set of samples of a film: each pixel of a window has samples with consecutive numbers from the
 * first on.
 *
 * @param window window in the full frame
 * @param first number of each pixel's first sample, at least 0
 * @param fewest smallest number of samples of a pixel
 * @param most largest number of samples of a pixel
 */
public record FilmPart(Crop window, int first, int fewest, int most) {
  public FilmPart {
    Objects.requireNonNull(window, "window");
    if (first < 0 || fewest < 0 || most < fewest || (long) first + most > Integer.MAX_VALUE) {
      throw new IllegalArgumentException(
          "part: expected 0 <= fewest <= most, found first " + first + ", " + fewest + ", " + most);
    }
  }

  /** Returns the samples of a film that was not merged. */
  public static FilmPart of(Film film) {
    return new FilmPart(
        film.window(), film.firstSample(), film.fewestSamples(), film.mostSamples());
  }

  /** Returns the number after the last sample, in the pixel with the most samples. */
  public int end() {
    return first + most;
  }

  /** Returns whether the two parts may have a sample in common. */
  boolean overlaps(FilmPart o) {
    return first < o.end()
        && o.first < end()
        && window.x() < o.window.x() + o.window.width()
        && o.window.x() < window.x() + window.width()
        && window.y() < o.window.y() + o.window.height()
        && o.window.y() < window.y() + window.height();
  }

  /** Returns whether this part has all samples of another one. */
  public boolean contains(FilmPart o) {
    return equals(o) || first <= o.first && o.end() <= first + fewest && window.contains(o.window);
  }

  /**
   * Returns the union of the two parts if it is a part: the other part must continue where this one
   * ends, in samples or in pixels.
   */
  Optional<FilmPart> joined(FilmPart o) {
    if (window.equals(o.window)) {
      // All pixels of this part must end where the other part begins.
      return fewest == most && end() == o.first
          ? Optional.of(new FilmPart(window, first, most + o.fewest, most + o.most))
          : Optional.empty();
    }
    if (first != o.first || !continues(o)) {
      return Optional.empty();
    }
    return Optional.of(
        new FilmPart(
            hull(window, o.window), first, Math.min(fewest, o.fewest), Math.max(most, o.most)));
  }

  /** Returns whether the other window is directly to the right of this one or directly below it. */
  private boolean continues(FilmPart o) {
    boolean right =
        window.y() == o.window.y()
            && window.height() == o.window.height()
            && window.x() + window.width() == o.window.x();
    boolean below =
        window.x() == o.window.x()
            && window.width() == o.window.width()
            && window.y() + window.height() == o.window.y();
    return right || below;
  }

  /** Returns the smallest window that contains both. */
  static Crop hull(Crop a, Crop b) {
    int x = Math.min(a.x(), b.x());
    int y = Math.min(a.y(), b.y());
    return new Crop(
        x,
        y,
        Math.max(a.x() + a.width(), b.x() + b.width()) - x,
        Math.max(a.y() + a.height(), b.y() + b.height()) - y);
  }

  @Override
  public String toString() {
    return "samples %s to %s of %sx%s pixels at %s,%s"
        .formatted(first, end() - 1, window.width(), window.height(), window.x(), window.y());
  }
}
