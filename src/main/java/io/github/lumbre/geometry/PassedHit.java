package io.github.lumbre.geometry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The hit that a ray has passed last, in the order of t, shape, and part of the shape: searches
 * find the first hit after it. If there are many at the same t, one search collects them, so that a
 * ray passes many surfaces at one place without a search for each of them among all. Mutable; each
 * {@link NearestHit} has one.
 */
final class PassedHit {
  /** A shape's number beyond all others: no hit at the same t comes after it. */
  static final int NONE = Integer.MAX_VALUE;

  /** The number of passed hits at the same t from which on all others there are collected. */
  private static final int MANY = 16;

  private record Hit(int shape, int element, double b1, double b2) {}

  private static final Comparator<Hit> LAST_FIRST =
      Comparator.comparingInt(Hit::shape).thenComparingInt(Hit::element).reversed();

  /** The t of the hit, or 0. Searches skip all boxes that end before it. */
  double t;

  /**
   * The shape of the hit; {@link #NONE} if the ray has passed nothing. During the test of a shape,
   * it is relative to the shape: see {@link #relativeTo}.
   */
  int shape = NONE;

  int element;

  /** The number of hits at the same t that the ray has passed before the hit. */
  private int atSameT;

  /** Whether the search collects all further hits at the same t and stores none. */
  boolean isCollecting;

  /** The number of the shape under test, for hits of its parts; set while the search collects. */
  int testedShape;

  private final List<Hit> collected = new ArrayList<>();

  /** Forgets the hit, for another ray. */
  void clear() {
    t = 0;
    shape = NONE;
    atSameT = 0;
  }

  /** Passes the next hit. */
  void moveTo(double newT, int newShape, int newElement) {
    atSameT = newT == t ? atSameT + 1 : 0;
    t = newT;
    shape = newShape;
    element = newElement;
  }

  /** Returns whether a hit comes after this one. */
  boolean isBefore(double newT, int newShape, int newElement) {
    return newT > t
        || newT == t && (newShape > shape || newShape == shape && newElement > element);
  }

  /** Returns the shape of this hit as if the shape with a number had the number 0. */
  int relativeTo(int number) {
    return shape < number ? -1 : shape == number ? 0 : NONE;
  }

  /** Returns whether there are so many hits at the same t that the others are collected. */
  boolean isOneOfMany() {
    return atSameT >= MANY;
  }

  /** Collects a hit of a shape. */
  void collect(int hitShape, int hitElement, double b1, double b2) {
    collected.add(new Hit(hitShape, hitElement, b1, b2));
  }

  /**
   * Moves to the next hit at the same t, which one search collects; returns whether there is one.
   *
   * @param end of the ray, excluded
   */
  boolean moveToCollected(Bvh search, NearestHit nearest, double end) {
    if (atSameT == MANY) {
      collected.clear();
      isCollecting = true;
      nearest.t = Math.nextUp(t);
      search.search(nearest);
      isCollecting = false;
      nearest.t = end;
      collected.sort(LAST_FIRST);
    }
    if (collected.isEmpty()) {
      return false;
    }
    Hit hit = collected.remove(collected.size() - 1);
    nearest.t = t;
    nearest.shape = hit.shape;
    nearest.element = hit.element;
    nearest.b1 = hit.b1;
    nearest.b2 = hit.b2;
    return true;
  }
}
