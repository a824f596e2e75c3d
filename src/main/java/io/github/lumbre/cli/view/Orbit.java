package io.github.lumbre.cli.view;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.CameraPose;

/**
 * A camera that turns around a target. Immutable.
 *
 * @param target what it looks at, in world space
 * @param distance from the target, more than 0
 * @param pitch {@code localRotation.x} in degrees: how far it looks down, in [-90, 90]
 * @param yaw {@code localRotation.y} in degrees
 * @param roll {@code localRotation.z} in degrees
 */
record Orbit(Vec3 target, double distance, double pitch, double yaw, double roll) {
  private static final double STEEPEST = 89.9;
  private static final double LEAST_FACTOR = 1e-3;

  /** Significant digits of positions, relative to the distance. */
  private static final double DIGITS = 1e5;

  /**
   * Returns the orbit of a scene's camera: around the point in the middle of the picture, or the
   * scene's radius away if there is none.
   */
  static Orbit of(Scene scene) {
    CameraPose pose = CameraPose.of(scene.camera());
    Vec3 forward = scene.camera().axes().normal();
    NearestHit hit = new NearestHit();
    boolean isHit = scene.intersect(new Ray(pose.position(), forward), hit);
    double radius = scene.radius();
    double far = radius > 0 && Double.isFinite(radius) ? radius : 1;
    double distance = isHit && hit.t() > 0 && Double.isFinite(hit.t()) ? hit.t() : far;
    Vec3 rotation = pose.rotation();
    return new Orbit(
        pose.position().plus(distance, forward),
        distance,
        rotation.x(),
        rotation.y(),
        rotation.z());
  }

  /**
   * Returns this orbit, turned.
   *
   * @param right degrees by which the camera moves to the right around the target
   * @param up degrees by which it moves up
   */
  Orbit turned(double right, double up) {
    double newPitch = Math.max(-STEEPEST, Math.min(STEEPEST, pitch + up));
    return new Orbit(target, distance, newPitch, wrapped(yaw - right), roll);
  }

  /** Returns this orbit with another distance. */
  Orbit nearer(double factor) {
    double limited = Math.max(LEAST_FACTOR, Math.min(factor, 1 / LEAST_FACTOR));
    return new Orbit(target, Math.max(1e-12, Math.min(distance * limited, 1e12)), pitch, yaw, roll);
  }

  /** Returns this orbit, moved to the right and up by multiples of the distance. */
  Orbit moved(double right, double up) {
    Frame axes = axes();
    Vec3 moved =
        target.plus(right * distance, axes.tangent()).plus(up * distance, axes.bitangent());
    return new Orbit(moved, distance, pitch, yaw, roll);
  }

  /** Returns the pose, with few digits so that it can be read and copied. */
  CameraPose pose() {
    Vec3 rotation = new Vec3(rounded(pitch, .01), rounded(yaw, .01), rounded(roll, .01));
    Vec3 forward = axes(rotation).normal();
    Vec3 eye = target.plus(-distance, forward);
    double unit = Math.pow(10, Math.ceil(Math.log10(distance))) / DIGITS;
    return new CameraPose(
        new Vec3(rounded(eye.x(), unit), rounded(eye.y(), unit), rounded(eye.z(), unit)), rotation);
  }

  private Frame axes() {
    return axes(new Vec3(pitch, yaw, roll));
  }

  private static Frame axes(Vec3 rotation) {
    double sinX = Elementary.sinDegrees(rotation.x());
    double cosX = Elementary.cosDegrees(rotation.x());
    double sinY = Elementary.sinDegrees(rotation.y());
    double cosY = Elementary.cosDegrees(rotation.y());
    Vec3 forward = new Vec3(cosX * sinY, -sinX, cosX * cosY);
    Vec3 right = new Vec3(cosY, 0, -sinY);
    return new Frame(right, forward.cross(right), forward);
  }

  private static double wrapped(double degrees) {
    double turn = degrees % 360;
    return turn > 180 ? turn - 360 : turn <= -180 ? turn + 360 : turn;
  }

  /** Returns the multiple of a unit that is nearest; the result has no superfluous digits. */
  private static double rounded(double value, double unit) {
    double inverse = Math.rint(1 / unit);
    double result =
        inverse >= 1 ? Math.rint(value * inverse) / inverse : Math.rint(value / unit) * unit;
    return result + 0.0; // not -0
  }
}
