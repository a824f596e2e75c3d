package io.github.lumbre.geometry;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/**
 * Hits at the same t, which one search collects, so that a ray passes many surfaces at one place
 * without a search for each of them among all. Mutable; each {@link NearestHit} has one.
 */
final class CoincidingHits {
  private record Hit(int shape, int element, double b1, double b2) {}

  private static final Comparator<Hit> ORDER =
      Comparator.comparingInt(Hit::shape).thenComparingInt(Hit::element);

  /** From the last to the first, once they are sorted. */
  private final List<Hit> hits = new ArrayList<>();

  void clear() {
    hits.clear();
  }

  void add(int shape, int element, double b1, double b2) {
    hits.add(new Hit(shape, element, b1, b2));
  }

  /** Sorts the hits into the order in which a ray meets them. */
  void sort() {
    hits.sort(ORDER);
    Collections.reverse(hits);
  }

  /** Moves to the first hit that is left, and removes it; returns whether there was one. */
  boolean moveToNext(NearestHit nearest) {
    if (hits.isEmpty()) {
      return false;
    }
    Hit hit = hits.remove(hits.size() - 1);
    nearest.t = nearest.passedT;
    nearest.shape = hit.shape;
    nearest.element = hit.element;
    nearest.b1 = hit.b1;
    nearest.b2 = hit.b2;
    return true;
  }
}
