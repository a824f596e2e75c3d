package io.github.lumbre.model.difference;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.Optional;
import java.util.function.UnaryOperator;

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

  /** Returns whether a motion moves each old vertex to a new one. */
  boolean isMatch(UnaryOperator<Vec3> motion) {
    for (int i = 0; i < old.vertexCount(); i++) {
      Vec3 p = motion.apply(old.centroid().plus(old.offset(i)));
      if (!nowGrid.isNear(p.x(), p.y(), p.z())) {
        return false;
      }
    }
    return true;
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
}
