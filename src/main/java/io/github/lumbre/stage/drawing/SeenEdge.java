package io.github.lumbre.stage.drawing;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.Optional;
import java.util.function.Function;

/**
 * An edge in front of the camera, as a straight line in the picture.
 *
 * @param from one end, in world space
 * @param to the other end, in world space
 * @param start the first end in pixels
 * @param end the other end in pixels
 * @param ratio the depth of the first end over that of the other; 1 in parallel projection
 * @param low the least parameter in the picture, with a margin
 * @param high the largest parameter in the picture, with a margin
 */
record SeenEdge(
    Vec3 from, Vec3 to, Point2 start, Point2 end, double ratio, double low, double high) {
  /** Pixels around the picture where lines are still found, for half of a wide pen. */
  private static final double MARGIN = 20;

  /** The distance in pixels of the points whose visibility is found first. */
  private static final double STEP = 1;

  /** How many times the interval of a change is halved for pixels: to 1/16 of a pixel. */
  static final int FOR_PIXELS = 4;

  /** The same for vectors and dashes: to 1/1024 of a pixel. */
  static final int FOR_VECTORS = 10;

  /** The least depth, relative to the depth of the farther end. */
  private static final double NEAR = 1e-6;

  /** Returns the part of an edge in front of the camera, if it is in the picture. */
  static Optional<SeenEdge> of(Vec3 one, Vec3 other, Eye eye) {
    double depth = eye.depth(one);
    double otherDepth = eye.depth(other);
    double near = NEAR * Math.max(depth, otherDepth);
    if (!(near > 0)) {
      return Optional.empty();
    }
    Vec3 from =
        depth < near ? clipped(other, one, (otherDepth - near) / (otherDepth - depth)) : one;
    Vec3 to =
        otherDepth < near ? clipped(one, other, (depth - near) / (depth - otherDepth)) : other;
    Point2 start = eye.pixel(from);
    Point2 end = eye.pixel(to);
    double ratio =
        eye.pixels().isParallel() ? 1 : Math.max(depth, near) / Math.max(otherDepth, near);
    double[] range = {0, 1};
    boolean isIn =
        clip(start.x(), end.x(), eye.width(), range)
            && clip(start.y(), end.y(), eye.height(), range);
    return isIn
        ? Optional.of(new SeenEdge(from, to, start, end, ratio, range[0], range[1]))
        : Optional.empty();
  }

  private static Vec3 clipped(Vec3 inside, Vec3 outside, double share) {
    return inside.plus(share, outside.minus(inside));
  }

  /** Narrows a range of the parameter to where a coordinate is in the picture. */
  private static boolean clip(double start, double end, int size, double[] range) {
    if (start == end) {
      return start >= -MARGIN && start <= size + MARGIN;
    }
    double one = (-MARGIN - start) / (end - start);
    double other = (size + MARGIN - start) / (end - start);
    range[0] = Math.max(range[0], Math.min(one, other));
    range[1] = Math.min(range[1], Math.max(one, other));
    return range[0] < range[1];
  }

  /** Receives the parts of an edge whose points have one sight. */
  interface Receiver {
    void add(Sight sight, double fromX, double fromY, double toX, double toY);
  }

  /**
   * Divides the edge by the sight of its points.
   *
   * @param halvings of the interval in which the sight changes
   */
  void divide(Function<Vec3, Sight> sights, int halvings, Receiver receiver) {
    double pixels = length() * (high - low);
    int steps = (int) Math.max(1, Math.ceil(pixels / STEP));
    double step = (high - low) / steps;
    double begin = low;
    Sight before = sights.apply(point(low + .5 * step));
    for (int i = 1; i < steps; i++) {
      double middle = low + (i + .5) * step;
      Sight now = sights.apply(point(middle));
      if (now != before) {
        double change = change(middle - step, middle, before, sights, halvings);
        add(before, begin, change, receiver);
        begin = change;
        before = now;
      }
    }
    add(before, begin, high, receiver);
  }

  private double length() {
    double dx = end.x() - start.x();
    double dy = end.y() - start.y();
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Returns where the sight changes. */
  private double change(
      double one, double other, Sight first, Function<Vec3, Sight> sights, int halvings) {
    double low = one;
    double high = other;
    for (int i = 0; i < halvings; i++) {
      double middle = .5 * (low + high);
      if (sights.apply(point(middle)) == first) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return .5 * (low + high);
  }

  private void add(Sight sight, double one, double other, Receiver receiver) {
    double dx = end.x() - start.x();
    double dy = end.y() - start.y();
    receiver.add(
        sight,
        start.x() + one * dx,
        start.y() + one * dy,
        start.x() + other * dx,
        start.y() + other * dy);
  }

  /** Returns the point of the edge at a parameter of its line in the picture. */
  private Vec3 point(double parameter) {
    double weight = parameter * ratio;
    return from.plus(weight / (1 - parameter + weight), to.minus(from));
  }
}
