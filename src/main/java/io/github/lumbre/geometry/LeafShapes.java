package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;

/** Shapes that are no triangles, in the order of a hierarchy's leaves. Immutable. */
final class LeafShapes {
  private final Shape[] shapes;
  private final int[] numbers;

  /**
   * @param numbers the shapes' numbers in the hierarchy
   */
  LeafShapes(Shape[] shapes, int[] numbers) {
    this.shapes = shapes;
    this.numbers = numbers;
  }

  /** Asks all shapes; tells whether one had a hit, which is stored. */
  boolean intersect(Ray ray, NearestHit nearest) {
    return intersect(0, shapes.length, ray, nearest);
  }

  /** Asks the shapes of a leaf; tells whether one had a hit, which is stored. */
  boolean intersect(int leaf, Ray ray, NearestHit nearest) {
    int first = LeafRef.first(leaf);
    return intersect(first, first + LeafRef.count(leaf), ray, nearest);
  }

  private boolean intersect(int first, int end, Ray ray, NearestHit nearest) {
    boolean found = false;
    for (int i = first; i < end; i++) {
      found |= intersect(shapes[i], numbers[i], ray, nearest);
    }
    return found;
  }

  /** Asks one shape, for hits at the same t as the best too if its number is the lower. */
  private static boolean intersect(Shape shape, int number, Ray ray, NearestHit nearest) {
    double best = nearest.t;
    if (number < nearest.shape) {
      nearest.t = Math.nextUp(best);
    }
    if (shape.intersect(ray, nearest)) {
      nearest.shape = number;
      return true;
    }
    nearest.t = best;
    return false;
  }
}
