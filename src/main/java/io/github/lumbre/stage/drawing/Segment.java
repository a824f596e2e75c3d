package io.github.lumbre.stage.drawing;

import java.util.Optional;

/**
 * A segment of a stroke near the picture: the points within {@code radius} of a line from (ax, ay)
 * of length {@code length} in the unit direction (dx, dy).
 */
record Segment(double ax, double ay, double dx, double dy, double length, double radius) {
  /** Half the diagonal of a pixel, rounded up. */
  private static final double HALF_DIAGONAL = .70711;

  /**
   * Returns a segment, clipped so far outside of the picture that its ends are not seen; empty if
   * it does not reach the picture or has a coordinate that is not finite.
   */
  static Optional<Segment> of(Strokes strokes, int i, double radius, int width, int height) {
    double x = strokes.coordinate(i, 0);
    double y = strokes.coordinate(i, 1);
    // Halve before the subtraction, so that large coordinates do not overflow.
    double halfX = .5 * strokes.coordinate(i, 2) - .5 * x;
    double halfY = .5 * strokes.coordinate(i, 3) - .5 * y;
    double margin = radius + 1;
    double[] range = {0, 1};
    // Comparisons with NaN are false, so that it ends here.
    if (!(clip(x, halfX, -margin, width + margin, range)
        && clip(y, halfY, -margin, height + margin, range))) {
      return Optional.empty();
    }
    double ax = clamped(x + range[0] * halfX + range[0] * halfX, width, margin);
    double ay = clamped(y + range[0] * halfY + range[0] * halfY, height, margin);
    double ex = clamped(x + range[1] * halfX + range[1] * halfX, width, margin) - ax;
    double ey = clamped(y + range[1] * halfY + range[1] * halfY, height, margin) - ay;
    double length = Math.sqrt(ex * ex + ey * ey);
    return Optional.of(
        length > 0
            ? new Segment(ax, ay, ex / length, ey / length, length, radius)
            : new Segment(ax, ay, 1, 0, 0, radius));
  }

  /**
   * Narrows a range of a line's parameter to where a coordinate is between two bounds.
   *
   * @param half half of the change of the coordinate over the whole line
   * @return whether anything is left
   */
  private static boolean clip(double start, double half, double min, double max, double[] range) {
    if (half == 0) {
      return start >= min && start <= max;
    }
    double first = (.5 * min - .5 * start) / half;
    double last = (.5 * max - .5 * start) / half;
    range[0] = Math.max(range[0], Math.min(first, last));
    range[1] = Math.min(range[1], Math.max(first, last));
    return range[0] <= range[1];
  }

  private static double clamped(double value, int size, double margin) {
    return Math.max(-margin, Math.min(value, size + margin));
  }

  /** Returns the first row of pixels that the segment may touch. */
  int top() {
    return (int) Math.floor(Math.min(ay, ay + length * dy) - radius);
  }

  /** Returns the last row of pixels that the segment may touch. */
  int bottom() {
    return (int) Math.floor(Math.max(ay, ay + length * dy) + radius);
  }

  /** Returns the x of the leftmost or rightmost point that the segment has in a row of pixels. */
  double edge(int row, boolean isRight) {
    double first = at(row - radius);
    double last = at(row + 1 + radius);
    double from = ax + first * dx;
    double to = ax + last * dx;
    return isRight ? Math.max(from, to) + radius : Math.min(from, to) - radius;
  }

  /** Returns the distance along the segment at which it has a y, limited to the segment. */
  private double at(double y) {
    if (dy == 0) {
      return y < ay ? 0 : length;
    }
    return Math.max(0, Math.min((y - ay) / dy, length));
  }

  /** Returns which samples of a pixel are covered: one bit for each of {@link PixelSamples}. */
  long covered(int column, int row) {
    double centerDistance = distance(column + .5, row + .5);
    if (centerDistance > radius + HALF_DIAGONAL) {
      return 0;
    }
    if (centerDistance < radius - HALF_DIAGONAL) {
      return -1L;
    }
    long mask = 0;
    for (int i = 0; i < PixelSamples.COUNT; i++) {
      if (distance(column + PixelSamples.x(i), row + PixelSamples.y(i)) <= radius) {
        mask |= 1L << i;
      }
    }
    return mask;
  }

  private double distance(double x, double y) {
    double along = Math.max(0, Math.min((x - ax) * dx + (y - ay) * dy, length));
    double offX = x - ax - along * dx;
    double offY = y - ay - along * dy;
    return Math.sqrt(offX * offX + offY * offY);
  }
}
