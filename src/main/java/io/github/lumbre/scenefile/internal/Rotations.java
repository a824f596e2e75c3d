package io.github.lumbre.scenefile.internal;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/** Angles of the scene format. */
public final class Rotations {
  private Rotations() {}

  /**
   * Returns the {@code localRotation}, in degrees about z first, then x, then y, that turns the
   * world's axes to a frame's axes.
   *
   * @param axes right (x), up (y) and forward (z)
   */
  public static Vec3 degrees(Frame axes) {
    Vec3 forward = axes.normal();
    double pitch = Math.toDegrees(Elementary.asin(Math.max(-1, Math.min(1, -forward.y()))));
    double yaw;
    double roll;
    if (Math.abs(forward.y()) < 1 - 1e-12) {
      yaw = Math.toDegrees(Elementary.atan2(forward.x(), forward.z()));
      roll = Math.toDegrees(Elementary.atan2(axes.tangent().y(), axes.bitangent().y()));
    } else {
      yaw = Math.toDegrees(Elementary.atan2(-axes.tangent().z(), axes.tangent().x()));
      roll = 0;
    }
    return new Vec3(pitch, yaw, roll);
  }
}
