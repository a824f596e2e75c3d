package io.github.lumbre.checkpoint;

import io.github.lumbre.render.Film;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Objects;
import java.util.Optional;

/**
 * Which samples a film has: each pixel of a window has those of consecutive numbers from the first
 * on.
 *
 * @param first number of each pixel's first sample
 * @param fewest samples that a pixel has
 * @param most samples that a pixel has
 */
public record FilmPart(Crop window, int first, int fewest, int most) {
  public FilmPart {
    Objects.requireNonNull(window, "window");
    if (first < 0 || fewest < 0 || most < fewest || (long) first + most > Integer.MAX_VALUE) {
      throw new IllegalArgumentException(
          "part: expected 0 <= fewest <= most, found first " + first + ", " + fewest + ", " + most);
    }
  }

  /** Returns what a film has that was rendered at one place. */
  public static FilmPart of(Film film) {
    return new FilmPart(
        film.window(), film.firstSample(), film.fewestSamples(), film.mostSamples());
  }

  /** Returns the number after that of the last sample of the pixel with the most. */
  public int end() {
    return first + most;
  }

  /** Returns whether there may be a sample that both have. */
  boolean overlaps(FilmPart o) {
    return first < o.end()
        && o.first < end()
        && window.x() < o.window.x() + o.window.width()
        && o.window.x() < window.x() + window.width()
        && window.y() < o.window.y() + o.window.height()
        && o.window.y() < window.y() + window.height();
  }

  /** Returns both as one, if that is a part: one continues where the other ends. */
  Optional<FilmPart> joined(FilmPart o) {
    if (window.equals(o.window)) {
      // All pixels must be as far as the other part begins.
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

  /** Returns whether the other window lies just right of this one or just below. */
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

  /** Returns the smallest window that holds both. */
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
    return "samples "
        + first
        + " to "
        + (end() - 1)
        + " of "
        + window.width()
        + "x"
        + window.height()
        + " pixels at "
        + window.x()
        + ","
        + window.y();
  }
}
