package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.util.Arrays;

/** Points in space that are found by their place, within a tolerance. Immutable. */
final class PointGrid {
  /** No point. */
  static final int NONE = -1;

  /** Cells beyond are one. */
  private static final double FARTHEST = 1e15;

  private static final int INTERRUPT_MASK = 0xffff;

  private final double[] points;
  private final double tolerance;
  private final double cell;
  private final int[] first;
  private final int[] next;

  /**
   * @param points three coordinates each; not copied
   * @param tolerance the largest distance in which a point is found, &gt; 0
   */
  PointGrid(double[] points, double tolerance) {
    this.points = points;
    this.tolerance = tolerance;
    cell = 4 * tolerance;
    int count = points.length / 3;
    first = new int[Integer.highestOneBit(Math.max(1, count)) * 4];
    Arrays.fill(first, NONE);
    next = new int[count];
    for (int i = 0; i < count; i++) {
      if ((i & INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      int slot = slot(cell(points[3 * i]), cell(points[3 * i + 1]), cell(points[3 * i + 2]));
      next[i] = first[slot];
      first[slot] = i;
    }
  }

  private long cell(double coordinate) {
    return (long) Math.floor(Math.max(-FARTHEST, Math.min(coordinate / cell, FARTHEST)));
  }

  private int slot(long x, long y, long z) {
    long hash = x * 0x9E3779B97F4A7C15L + y * 0xC2B2AE3D27D4EB4FL + z * 0x165667B19E3779F9L;
    hash = (hash ^ hash >>> 29) * 0xBF58476D1CE4E5B9L;
    return (int) (hash >>> 32) & first.length - 1;
  }

  boolean isNear(double x, double y, double z) {
    return at(x, y, z) != NONE;
  }

  /** Returns the number of a point within the tolerance; {@link #NONE} if there is none. */
  int at(double x, double y, double z) {
    for (long i = cell(x - tolerance); i <= cell(x + tolerance); i++) {
      for (long j = cell(y - tolerance); j <= cell(y + tolerance); j++) {
        for (long k = cell(z - tolerance); k <= cell(z + tolerance); k++) {
          int found = inCell(i, j, k, x, y, z);
          if (found != NONE) {
            return found;
          }
        }
      }
    }
    return NONE;
  }

  private int inCell(long i, long j, long k, double x, double y, double z) {
    for (int n = first[slot(i, j, k)]; n != NONE; n = next[n]) {
      double dx = points[3 * n] - x;
      double dy = points[3 * n + 1] - y;
      double dz = points[3 * n + 2] - z;
      if (dx * dx + dy * dy + dz * dz <= tolerance * tolerance) {
        return n;
      }
    }
    return NONE;
  }
}
