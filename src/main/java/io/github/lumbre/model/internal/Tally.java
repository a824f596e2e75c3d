package io.github.lumbre.model.internal;

import java.util.LinkedHashMap;
import java.util.Map;

/** Counts the elements of a file that are left out, by the reasons. Mutable. */
public final class Tally {
  /** What meshes of numbers that are not finite lack. */
  public static final String BROKEN = "left out faces with a vertex that is not a finite number";

  /** What is left out of meshes since it has no surface. */
  public static final String FLAT = "dropped triangles of zero area";

  public static final String NARROW = "ignored faces of fewer than 3 corners";

  private final Map<String, Counter> counters = new LinkedHashMap<>();

  private static final class Counter {
    final String place;
    int count;

    Counter(String place) {
      this.place = place;
    }
  }

  /**
   * Counts an element.
   *
   * @param reason as in the warning; one of few constants
   * @param place of the element; the warning names the place of the first one
   */
  public void add(String reason, String place) {
    counters.computeIfAbsent(reason, r -> new Counter(place)).count++;
  }

  /** Adds a warning for each reason. */
  public void addTo(Warnings warnings) {
    counters.forEach(
        (reason, counter) -> warnings.add(reason, counter.place, reason + ": " + counter.count));
  }
}
