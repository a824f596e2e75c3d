package io.github.lumbre.geometry;

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

  boolean isEmpty() {
    return shapes.length == 0;
  }

  /** Asks all shapes; tells whether one had a hit, which is stored. */
  boolean intersect(NearestHit nearest) {
    return intersect(0, shapes.length, nearest);
  }

  /** Asks the shapes of a leaf; tells whether one had a hit, which is stored. */
  boolean intersect(int leaf, NearestHit nearest) {
    int first = LeafRef.first(leaf);
    return intersect(first, first + LeafRef.count(leaf), nearest);
  }

  private boolean intersect(int first, int end, NearestHit nearest) {
    boolean found = false;
    for (int i = first; i < end; i++) {
      found |= intersect(shapes[i], numbers[i], nearest);
    }
    return found;
  }

  /** Asks one shape, for hits at the same t as the best too if its number is the lower. */
  private static boolean intersect(Shape shape, int number, NearestHit nearest) {
    double best = nearest.t;
    if (number < nearest.shape) {
      nearest.t = Math.nextUp(best);
    }
    if (shape.intersect(nearest)) {
      nearest.shape = number;
      return true;
    }
    nearest.t = best;
    return false;
  }
}
