package io.github.lumbre.render.checkpoint;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Merges films of one picture that were rendered separately; the result is bit-identical to a
 * single render.
 */
public final class FilmMerge {
  private FilmMerge() {}

  /** A film and its name for messages. */
  public record Named(String name, FilmFile file) {}

  /**
   * Returns the merged film with the samples of all films.
   *
   * @param films at least one
   * @throws FilmMismatchException if the films have different scenes or settings, or if two of them
   *     may have a sample in common
   */
  public static FilmFile of(List<Named> films) throws FilmMismatchException {
    Named first = films.get(0);
    FilmHeader header = first.file().header();
    Crop window = header.window();
    for (Named film : films.subList(1, films.size())) {
      header.requireSame(film.file().header().identity(), first.name(), film.name());
      header.requireSameLayers(film.file().header(), first.name(), film.name());
      window = FilmPart.hull(window, film.file().header().window());
    }
    requireDisjoint(films);
    List<FilmPart> parts = new ArrayList<>();
    films.forEach(film -> parts.addAll(film.file().header().parts()));
    List<FilmPart> joined = joined(parts);
    int firstSample = joined.stream().mapToInt(FilmPart::first).min().orElse(0);
    Film sum = header.newFilm(window, firstSample);
    // Add the films in the order of their samples, which keeps the halves of the pixels known if
    // possible.
    films.stream()
        .map(film -> film.file().film())
        .sorted(Comparator.comparingInt(Film::firstSample))
        .forEach(sum::addAll);
    RenderStatistics faults =
        films.stream()
            .map(film -> film.file().header().faults())
            .reduce(RenderStatistics.ZERO, RenderStatistics::plus);
    return new FilmFile(header.withParts(window, joined, faults), sum);
  }

  private static void requireDisjoint(List<Named> films) throws FilmMismatchException {
    for (int i = 0; i < films.size(); i++) {
      for (int j = 0; j < i; j++) {
        for (FilmPart part : films.get(i).file().header().parts()) {
          Optional<FilmPart> other =
              films.get(j).file().header().parts().stream().filter(part::overlaps).findFirst();
          if (other.isPresent()) {
            throw new FilmMismatchException(
                "samples in common: %s has %s, and %s has %s"
                    .formatted(films.get(j).name(), other.get(), films.get(i).name(), part));
          }
        }
      }
    }
  }

  /**
   * Joins parts in pairs, first those with consecutive samples, then those with adjacent windows.
   */
  private static List<FilmPart> joined(List<FilmPart> parts) {
    List<FilmPart> result = new ArrayList<>(parts);
    boolean changed = true;
    while (changed) {
      changed = joinOnce(result, true) || joinOnce(result, false);
    }
    return result;
  }

  private static boolean joinOnce(List<FilmPart> parts, boolean sameWindow) {
    for (FilmPart one : parts) {
      for (FilmPart other : parts) {
        boolean same = one.window().equals(other.window());
        Optional<FilmPart> both = same == sameWindow ? one.joined(other) : Optional.empty();
        if (both.isPresent()) {
          parts.removeAll(List.of(one, other));
          parts.add(both.get());
          return true;
        }
      }
    }
    return false;
  }
}
