package io.github.lumbre.difference;

import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;
import java.util.Optional;

/**
 * Finds the motion that makes one surface another: all vertices meet within a tolerance, in both
 * directions. Confined to one thread.
 */
final class ShapeMatch {
  /** The pairs of vertices that are tried, which bounds the work for symmetric shapes. */
  private static final int MOST_TRIED = 2000;

  /** The vertices that are tried for one axis. */
  private static final int MOST_ON_AXIS = 200;

  private final PartShape old;
  private final PartShape now;
  private final double tolerance;
  private final PointGrid oldGrid;
  private final PointGrid nowGrid;

  /**
   * @param tolerance largest distance of vertices that meet
   */
  ShapeMatch(PartShape old, PartShape now, double tolerance) {
    this.old = old;
    this.now = now;
    this.tolerance = tolerance;
    oldGrid = new PointGrid(old.vertices(), tolerance);
    nowGrid = new PointGrid(now.vertices(), tolerance);
  }

  /** Returns whether the surfaces are the same at the same place. */
  boolean isInPlace() {
    Vec3 offset = old.centroid().minus(now.centroid());
    return offset.length() <= 4 * tolerance
        && meets(old, nowGrid, Motion.by(Vec3.ZERO), old.centroid())
        && meets(now, oldGrid, Motion.by(Vec3.ZERO), now.centroid());
  }

  /** Returns the motion that makes the old surface the new one; empty if none is found. */
  Optional<Motion> motion() {
    Motion shift = Motion.by(now.centroid().minus(old.centroid()));
    return isMatch(shift) ? Optional.of(shift) : rotation(shift.shift());
  }

  private boolean isMatch(Motion motion) {
    Motion back = new Motion(motion.to(), motion.from(), motion.shift().times(-1));
    return meets(old, nowGrid, motion, now.centroid()) && meets(now, oldGrid, back, old.centroid());
  }

  /** Returns whether all vertices of a part, moved, meet others. */
  private static boolean meets(PartShape part, PointGrid grid, Motion motion, Vec3 centroid) {
    for (int i = 0; i < part.vertexCount(); i++) {
      Vec3 p = centroid.plus(motion.rotated(part.offset(i)));
      if (!grid.isNear(p.x(), p.y(), p.z())) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the smallest rotation with a shift: two vertices far from the centroid and from each
   * other are carried to pairs of vertices at the same distances.
   */
  private Optional<Motion> rotation(Vec3 shift) {
    Vec3 first = farthest(Vec3.ZERO);
    Vec3 second = farthest(first);
    if (first.cross(second).length() <= tolerance * first.length()) {
      return Optional.empty();
    }
    Frame from = frame(first, second);
    Optional<Motion> best = Optional.empty();
    int tried = 0;
    int onAxis = 0;
    for (int i = 0; i < now.vertexCount() && onAxis < MOST_ON_AXIS; i++) {
      Vec3 one = now.offset(i);
      if (!isClose(one.length(), first.length())) {
        continue;
      }
      onAxis++;
      for (int j = 0; j < now.vertexCount() && tried < MOST_TRIED; j++) {
        Vec3 other = now.offset(j);
        if (isClose(other.length(), second.length())
            && isClose(other.minus(one).length(), second.minus(first).length())) {
          tried++;
          Motion motion = new Motion(from, frame(one, other), shift);
          double most = best.map(Motion::degrees).orElse(360.);
          if (motion.degrees() < most && isMatch(motion)) {
            best = Optional.of(motion);
          }
        }
      }
    }
    return best;
  }

  private boolean isClose(double length, double wanted) {
    return Math.abs(length - wanted) <= 2 * tolerance;
  }

  /** Returns the offset of the old vertex that is farthest from an axis, or from the centroid. */
  private Vec3 farthest(Vec3 axis) {
    Vec3 farthest = Vec3.ZERO;
    double most = -1;
    for (int i = 0; i < old.vertexCount(); i++) {
      Vec3 offset = old.offset(i);
      double distance = axis.equals(Vec3.ZERO) ? offset.length() : offset.cross(axis).length();
      if (distance > most) {
        most = distance;
        farthest = offset;
      }
    }
    return farthest;
  }

  /** Returns axes: along one vector, and in a plane with another. */
  private static Frame frame(Vec3 one, Vec3 other) {
    Vec3 x = one.normalized();
    Vec3 z = one.cross(other).normalized();
    return new Frame(x, z.cross(x), z);
  }

  /**
   * A motion of a part: a rotation about its centroid and a shift.
   *
   * @param from axes of the part before
   * @param to the same axes after
   * @param shift of the centroid
   */
  record Motion(Frame from, Frame to, Vec3 shift) {
    /** Returns a motion without rotation. */
    static Motion by(Vec3 shift) {
      return new Motion(Frame.WORLD, Frame.WORLD, shift);
    }

    /** Returns an offset from the centroid, rotated. */
    Vec3 rotated(Vec3 offset) {
      return from == to ? offset : to.toWorld(from.toLocal(offset));
    }

    /** Returns the angle of the rotation in degrees, from 0 to 180. */
    double degrees() {
      if (from == to) {
        return 0;
      }
      double trace = rotated(Vec3.X).x() + rotated(Vec3.Y).y() + rotated(Vec3.Z).z();
      double cosine = Math.max(-1, Math.min(1, (trace - 1) / 2));
      Vec3 axis =
          new Vec3(
              rotated(Vec3.Y).z() - rotated(Vec3.Z).y(),
              rotated(Vec3.Z).x() - rotated(Vec3.X).z(),
              rotated(Vec3.X).y() - rotated(Vec3.Y).x());
      return Math.toDegrees(Elementary.atan2(axis.length() / 2, cosine));
    }
  }

  /** Points in space that are found by their place, within a tolerance. Immutable. */
  private static final class PointGrid {
    private static final int NONE = -1;

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
      for (long i = cell(x - tolerance); i <= cell(x + tolerance); i++) {
        for (long j = cell(y - tolerance); j <= cell(y + tolerance); j++) {
          for (long k = cell(z - tolerance); k <= cell(z + tolerance); k++) {
            if (isInCell(i, j, k, x, y, z)) {
              return true;
            }
          }
        }
      }
      return false;
    }

    private boolean isInCell(long i, long j, long k, double x, double y, double z) {
      for (int n = first[slot(i, j, k)]; n != NONE; n = next[n]) {
        double dx = points[3 * n] - x;
        double dy = points[3 * n + 1] - y;
        double dz = points[3 * n + 2] - z;
        if (dx * dx + dy * dy + dz * dz <= tolerance * tolerance) {
          return true;
        }
      }
      return false;
    }
  }
}
