package io.github.lumbre.model.explosion;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The axis along which two boxes move apart. Stateless. */
final class Direction {
  static final int AXES = 3;

  /** The axes in the order in which they are preferred: upwards first. */
  private static final List<Integer> PREFERRED = List.of(1, 0, 2);

  /** How near centers on one axis are, and how equal sides across it, relative to the sides. */
  private static final double SAME = .02;

  /** How equal the sides of a box across the axis of a turned or screwed body are. */
  private static final double ROUND = .2;

  private Direction() {}

  /**
   * Returns the axis of two boxes. Boxes beside each other keep the axis on which they are farthest
   * apart. Others have a common axis if one passes through the other, or their centers lie on it;
   * without one, it is the thinnest side of their overlap.
   */
  static int of(Bounds3 a, Bounds3 b) {
    int apart = widest(a, b);
    return distance(a, b, apart) >= 0 ? apart : common(a, b).orElseGet(() -> thinnest(a, b));
  }

  /** Returns the distance of two boxes along an axis; negative where they overlap. */
  static double distance(Bounds3 a, Bounds3 b, int axis) {
    return Math.max(
        a.min().get(axis) - b.max().get(axis), b.min().get(axis) - a.max().get(axis));
  }

  private static int widest(Bounds3 a, Bounds3 b) {
    int widest = PREFERRED.get(0);
    for (int axis : PREFERRED) {
      widest = distance(a, b, axis) > distance(a, b, widest) ? axis : widest;
    }
    return widest;
  }

  private static int thinnest(Bounds3 a, Bounds3 b) {
    int thinnest = PREFERRED.get(0);
    for (int axis : PREFERRED) {
      thinnest = overlap(a, b, axis) < (1 - SAME) * overlap(a, b, thinnest) ? axis : thinnest;
    }
    return thinnest;
  }

  private static double overlap(Bounds3 a, Bounds3 b, int axis) {
    return Math.min(a.max().get(axis), b.max().get(axis))
        - Math.max(a.min().get(axis), b.min().get(axis));
  }

  private static Optional<Integer> common(Bounds3 a, Bounds3 b) {
    List<Integer> through = PREFERRED.stream().filter(k -> passes(a, b, k)).toList();
    List<Integer> centered = PREFERRED.stream().filter(k -> isCentered(a, b, k)).toList();
    if (through.size() == 1 || through.isEmpty() && centered.size() != 1) {
      return through.stream().findFirst();
    }
    List<Integer> both = new ArrayList<>(centered);
    if (!through.isEmpty()) {
      both.retainAll(through);
    }
    if (both.size() == 1) {
      return Optional.of(both.get(0));
    }
    Bounds3 inner = a.radius() < b.radius() ? a : b;
    return through.stream().filter(k -> isRound(inner, k)).findFirst();
  }

  /** Returns whether, seen along an axis, one box is inside of the other. */
  private static boolean passes(Bounds3 a, Bounds3 b, int axis) {
    return isInside(a, b, axis) || isInside(b, a, axis);
  }

  private static boolean isInside(Bounds3 inner, Bounds3 outer, int axis) {
    for (int k = 0; k < AXES; k++) {
      double margin = SAME * side(inner, k);
      if (k != axis
          && (inner.min().get(k) < outer.min().get(k) - margin
              || inner.max().get(k) > outer.max().get(k) + margin)) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether the centers of two boxes are on one line along an axis. */
  private static boolean isCentered(Bounds3 a, Bounds3 b, int axis) {
    Vec3 apart = a.center().minus(b.center());
    for (int k = 0; k < AXES; k++) {
      if (k != axis && Math.abs(apart.get(k)) > SAME * Math.min(side(a, k), side(b, k))) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether a box has equal sides across an axis, and another one along it. */
  private static boolean isRound(Bounds3 box, int axis) {
    double first = side(box, (axis + 1) % AXES);
    double second = side(box, (axis + 2) % AXES);
    double across = Math.max(first, second);
    return Math.abs(first - second) <= ROUND * across
        && Math.abs(side(box, axis) - across) > ROUND * across;
  }

  private static double side(Bounds3 box, int axis) {
    return box.max().get(axis) - box.min().get(axis);
  }
}
