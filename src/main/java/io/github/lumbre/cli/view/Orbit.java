package io.github.lumbre.cli.view;

import io.github.lumbre.camera.internal.Projection;
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
 * @param height of the frame of a parallel camera; 0 in perspective
 */
record Orbit(
    Vec3 target, double distance, double pitch, double yaw, double roll, double height) {
  private static final double STEEPEST = 89.9;
  private static final double LEAST_FACTOR = 1e-3;

  /** How far the film of a parallel camera reaches below its middle, relative to its height. */
  private static final double BELOW_FILM = .6;

  /** The largest distance of a parallel camera, relative to the usual one. */
  private static final double FARTHEST = 1e3;

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
    boolean isParallel =
        Projection.of(scene.camera(), 1, 1).filter(Projection::isParallel).isPresent();
    Vec3 rotation = pose.rotation();
    return new Orbit(
        pose.position().plus(distance, forward),
        isParallel ? Math.max(distance, 2 * far) : distance,
        rotation.x(),
        rotation.y(),
        rotation.z(),
        isParallel ? Projection.frameHeight(scene.camera()) : 0);
  }

  /** Creates the orbit of a camera in perspective. */
  Orbit(Vec3 target, double distance, double pitch, double yaw, double roll) {
    this(target, distance, pitch, yaw, roll, 0);
  }

  boolean isParallel() {
    return height > 0;
  }

  /**
   * Returns this orbit, turned.
   *
   * @param right degrees by which the camera moves to the right around the target
   * @param up degrees by which it moves up
   */
  Orbit turned(double right, double up) {
    double newPitch = Math.max(-STEEPEST, Math.min(STEEPEST, pitch + up));
    return new Orbit(target, distance, newPitch, wrapped(yaw - right), roll, height);
  }

  /** Returns this orbit with another distance; a parallel camera has another height instead. */
  Orbit nearer(double factor) {
    double limited = Math.max(LEAST_FACTOR, Math.min(factor, 1 / LEAST_FACTOR));
    return isParallel()
        ? new Orbit(target, distance, pitch, yaw, roll, within(height * limited))
        : new Orbit(target, within(distance * limited), pitch, yaw, roll);
  }

  private static double within(double length) {
    return Math.max(1e-12, Math.min(length, 1e12));
  }

  /**
   * Returns this orbit, moved to the right and up by multiples of the distance; of the height of
   * what a parallel camera shows.
   */
  Orbit moved(double right, double up) {
    Frame axes = axes();
    double unit = isParallel() ? height : distance;
    Vec3 moved = target.plus(right * unit, axes.tangent()).plus(up * unit, axes.bitangent());
    return new Orbit(moved, distance, pitch, yaw, roll, height);
  }

  /**
   * Returns the distance of the eye from the target: a parallel camera that looks down has its film
   * above the target, so that a floor is seen.
   */
  private double eyeDistance() {
    double sin = Elementary.sinDegrees(pitch);
    return isParallel() && sin > 0
        ? Math.max(
            distance,
            Math.min(
                BELOW_FILM * height * Elementary.cosDegrees(pitch) / sin, FARTHEST * distance))
        : distance;
  }

  /** Returns the pose, with few digits so that it can be read and copied. */
  CameraPose pose() {
    Vec3 rotation = new Vec3(rounded(pitch, .01), rounded(yaw, .01), rounded(roll, .01));
    Vec3 forward = axes(rotation).normal();
    Vec3 eye = target.plus(-eyeDistance(), forward);
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
