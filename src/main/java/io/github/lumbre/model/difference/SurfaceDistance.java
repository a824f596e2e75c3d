package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Vec3;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;

/**
 * Finds how far one surface is from another one at most (the one-sided distance of Hausdorff): the
 * distance from a triangle is convex, so that it is largest at corners. A piece that is beside the
 * triangle nearest to its middle is divided along a side of this triangle. Confined to one thread.
 */
final class SurfaceDistance {
  /** Pieces this many times smaller than the limit are not divided. */
  private static final double SMALLEST = 8;

  /** Distances above this part of the limit are found more exactly, by smaller pieces. */
  private static final double FINE = .1;

  /** Pieces that are divided for the sake of exactness alone. */
  private static final long FOR_EXACTNESS = 300_000;

  private static final int CHECK_MASK = 0xfff;

  private final TriangleTree.Nearest nearest = new TriangleTree.Nearest();

  /** The limit, less the size of the smallest pieces. */
  private final double limit;

  private long left;
  private long divided;

  /** A piece of a surface. */
  private record Piece(Vec3 a, Vec3 b, Vec3 c) {}

  /**
   * @param limit the largest distance that is found
   * @param steps the most pieces that are looked at, in all calls
   */
  SurfaceDistance(double limit, long steps) {
    this.limit = limit / (1 + 1 / SMALLEST);
    left = steps;
  }

  /** Returns how many more pieces may be looked at; less than 0 if there was too much work. */
  long left() {
    return left;
  }

  /**
   * Returns a distance that no point of a surface exceeds; empty if it is above the limit, or too
   * much work.
   *
   * @param surface whose points are taken
   * @param motion of these points
   * @param other the surface from which distances are
   */
  OptionalDouble of(TriangleTree surface, UnaryOperator<Vec3> motion, TriangleTree other) {
    double most = 0;
    Deque<Piece> pieces = new ArrayDeque<>();
    for (int t = 0; t < surface.count(); t++) {
      pieces.push(
          new Piece(
              motion.apply(surface.corner(t, 0)),
              motion.apply(surface.corner(t, 1)),
              motion.apply(surface.corner(t, 2))));
      while (!pieces.isEmpty()) {
        double found = distance(pieces.pop(), other, pieces);
        if (found == Double.POSITIVE_INFINITY || --left < 0) {
          return OptionalDouble.empty();
        }
        if ((left & CHECK_MASK) == 0) {
          Interrupts.check();
        }
        most = Math.max(most, found);
      }
    }
    return OptionalDouble.of(most);
  }

  /** Returns the distance of a piece, infinite if it is too far; or 0 after dividing it. */
  private double distance(Piece piece, TriangleTree other, Deque<Piece> pieces) {
    Vec3 middle = piece.a.plus(piece.b).plus(piece.c).times(1. / 3);
    other.find(middle, limit, nearest);
    int triangle = nearest.triangle();
    if (triangle < 0) {
      return Double.POSITIVE_INFINITY;
    }
    double ofCorners =
        Math.sqrt(
            Math.max(
                other.squaredDistance(triangle, piece.a),
                Math.max(
                    other.squaredDistance(triangle, piece.b),
                    other.squaredDistance(triangle, piece.c))));
    boolean isDivided = ofCorners > limit || ofCorners > FINE * limit && divided < FOR_EXACTNESS;
    if (isDivided && divide(piece, triangle, other, pieces)) {
      divided++;
      return 0;
    }
    boolean isLoose = isDivided && ofCorners > 2 * nearest.distance() + FINE * limit;
    if (ofCorners <= limit && isLoose) {
      divided++;
      divide(piece, pieces);
      return 0;
    }
    if (ofCorners <= limit) {
      return ofCorners;
    }
    double size =
        Math.max(
            piece.a.minus(middle).length(),
            Math.max(piece.b.minus(middle).length(), piece.c.minus(middle).length()));
    if (size < limit / SMALLEST) {
      return nearest.distance() + size;
    }
    divide(piece, pieces);
    return 0;
  }

  /** Divides a piece along the plane on a side of a triangle that it crosses most, if any. */
  private boolean divide(Piece piece, int triangle, TriangleTree other, Deque<Piece> pieces) {
    Vec3[] t = {other.corner(triangle, 0), other.corner(triangle, 1), other.corner(triangle, 2)};
    Vec3 normal = t[1].minus(t[0]).cross(t[2].minus(t[0]));
    Vec3[] corners = {piece.a, piece.b, piece.c};
    double[] heights = {};
    double most = FINE * limit;
    for (int side = 0; side < 3; side++) {
      Vec3 from = t[side];
      Vec3 out = t[(side + 1) % 3].minus(from).cross(normal);
      double[] h = new double[3];
      double length = out.length();
      Arrays.setAll(h, i -> out.dot(corners[i].minus(from)) / length);
      double high = Math.max(h[0], Math.max(h[1], h[2]));
      double low = Math.min(h[0], Math.min(h[1], h[2]));
      if (high > most && low < -FINE * limit) {
        heights = h;
        most = high;
      }
    }
    if (heights.length == 0) {
      return false;
    }
    divide(corners, heights, pieces);
    return true;
  }

  /** Divides a triangle where heights of its corners are 0. */
  private static void divide(Vec3[] corners, double[] heights, Deque<Piece> pieces) {
    int alone = 0;
    for (int i = 0; i < 3; i++) {
      boolean isUp = heights[i] > 0;
      if (heights[(i + 1) % 3] > 0 != isUp && heights[(i + 2) % 3] > 0 != isUp) {
        alone = i;
      }
    }
    int next = (alone + 1) % 3;
    int last = (alone + 2) % 3;
    Vec3 p = between(corners, heights, alone, next);
    Vec3 q = between(corners, heights, alone, last);
    pieces.push(new Piece(corners[alone], p, q));
    pieces.push(new Piece(p, corners[next], corners[last]));
    pieces.push(new Piece(p, corners[last], q));
  }

  private static Vec3 between(Vec3[] corners, double[] heights, int from, int to) {
    double share = heights[from] / (heights[from] - heights[to]);
    return corners[from].plus(share, corners[to].minus(corners[from]));
  }

  /** Divides a piece across its longest side. */
  private static void divide(Piece piece, Deque<Piece> pieces) {
    Vec3 a = piece.a;
    Vec3 b = piece.b;
    Vec3 c = piece.c;
    double ab = b.minus(a).length();
    double bc = c.minus(b).length();
    double ca = a.minus(c).length();
    if (bc > ab && bc >= ca) {
      divide(b, c, a, pieces);
    } else if (ca > ab) {
      divide(c, a, b, pieces);
    } else {
      divide(a, b, c, pieces);
    }
  }

  private static void divide(Vec3 a, Vec3 b, Vec3 opposite, Deque<Piece> pieces) {
    Vec3 middle = a.plus(b).times(.5);
    pieces.push(new Piece(a, middle, opposite));
    pieces.push(new Piece(middle, b, opposite));
  }
}
