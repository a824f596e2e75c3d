package io.github.lumbre.geometry;

/**
 * The shapes other than triangles, in the order of a hierarchy's leaves. Immutable.
 *
 * @param numbers the number of each shape in the hierarchy
 */
record LeafShapes(Shape[] shapes, int[] numbers) {
  boolean isEmpty() {
    return shapes.length == 0;
  }

  /** Tests all shapes; returns whether a hit was found and stored. */
  boolean intersect(NearestHit nearest) {
    return intersect(0, shapes.length, nearest);
  }

  /** Tests the shapes of a leaf; returns whether a hit was found and stored. */
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

  /** Tests one shape. A hit at the same t as the best one wins if the shape's number is lower. */
  private static boolean intersect(Shape shape, int number, NearestHit nearest) {
    double best = nearest.t;
    if (number < nearest.shape) {
      nearest.t = Math.nextUp(best);
    }
    boolean found =
        nearest.passed.shape == PassedHit.NONE
            ? shape.intersect(nearest)
            : intersectBehind(shape, number, nearest);
    if (found) {
      nearest.shape = number;
      return true;
    }
    nearest.t = best;
    return false;
  }

  /** Tests one shape with a ray that has passed some hit. */
  private static boolean intersectBehind(Shape shape, int number, NearestHit nearest) {
    PassedHit passed = nearest.passed;
    int passedShape = passed.shape;
    int passedElement = passed.element;
    passed.shape = passed.relativeTo(number);
    passed.testedShape = number;
    boolean found = shape.intersect(nearest);
    while (found && passed.isCollecting) {
      nearest.collect(number, nearest.element, 0, 0);
      passed.shape = 0;
      passed.element = nearest.element;
      nearest.t = Math.nextUp(passed.t);
      found = shape.intersect(nearest);
    }
    passed.shape = passedShape;
    passed.element = passedElement;
    return found;
  }
}
