package io.github.lumbre.difference;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

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
