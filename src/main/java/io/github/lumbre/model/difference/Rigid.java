package io.github.lumbre.model.difference;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * A rotation, and then a shift, of offsets from a centroid. Immutable.
 *
 * @param from right-handed axes before
 * @param to the same axes after
 */
record Rigid(Frame from, Frame to, Vec3 offset) {
  static Rigid shift(Vec3 offset) {
    return new Rigid(Frame.WORLD, Frame.WORLD, offset);
  }

  Vec3 apply(Vec3 p) {
    return (from == to ? p : to.toWorld(from.toLocal(p))).plus(offset);
  }

  Vec3 inverse(Vec3 p) {
    Vec3 back = p.minus(offset);
    return from == to ? back : from.toWorld(to.toLocal(back));
  }

  /** Returns the motion of a part whose centroid is shifted. */
  ShapeMatch.Motion motion(Vec3 shift) {
    return new ShapeMatch.Motion(from, to, shift);
  }

  Rigid shifted(Vec3 by) {
    return new Rigid(from, to, offset.plus(by));
  }

  /**
   * Returns this motion, followed by a rotation.
   *
   * @param rotation its axis, times its angle in radians
   */
  Rigid turned(Vec3 rotation) {
    double angle = rotation.length();
    if (!(angle > 0)) {
      return this;
    }
    double degrees = Math.toDegrees(angle);
    Vec3 axis = rotation.times(1 / angle);
    double sin = Elementary.sinDegrees(degrees);
    double cos = Elementary.cosDegrees(degrees);
    Vec3 x = turned(to.tangent(), axis, sin, cos).normalized();
    Vec3 z = x.cross(turned(to.bitangent(), axis, sin, cos)).normalized();
    return new Rigid(from, new Frame(x, z.cross(x), z), turned(offset, axis, sin, cos));
  }

  private static Vec3 turned(Vec3 v, Vec3 axis, double sin, double cos) {
    return v.times(cos).plus(sin, axis.cross(v)).plus((1 - cos) * axis.dot(v), axis);
  }
}
