package io.github.lumbre.math;

import java.util.Objects;

/**
 * An orthonormal frame: the unit axes of a local space, in which {@code normal} is +z. It may have
 * either handedness, because mirrored textures have mirrored frames. Immutable.
 *
 * <p>It stores plain numbers instead of three vectors. The JIT can remove the allocation of a
 * short-lived object, but rarely the allocation of objects inside it.
 */
public final class Frame {
  /** The world's own axes. */
  public static final Frame WORLD = new Frame(Vec3.X, Vec3.Y, Vec3.Z);

  private final double tangentX, tangentY, tangentZ;
  private final double bitangentX, bitangentY, bitangentZ;
  private final double normalX, normalY, normalZ;

  /** Creates a frame from three perpendicular unit vectors. */
  public Frame(Vec3 tangent, Vec3 bitangent, Vec3 normal) {
    tangentX = tangent.x();
    tangentY = tangent.y();
    tangentZ = tangent.z();
    bitangentX = bitangent.x();
    bitangentY = bitangent.y();
    bitangentZ = bitangent.z();
    normalX = normal.x();
    normalY = normal.y();
    normalZ = normal.z();
  }

  /**
   * Returns the axes of something at {@code eye} whose +z points to {@code target}: right (x), up
   * (y) and forward (z), as cameras have them.
   *
   * @param up direction that the up axis is nearest to, of any length
   * @throws IllegalArgumentException if a number is not finite, the two points are the same, or
   *     {@code up} is zero or along the view
   */
  public static Frame lookingAt(Vec3 eye, Vec3 target, Vec3 up) {
    requireFinite("eye", eye);
    requireFinite("target", target);
    requireFinite("up", up);
    Vec3 way = target.minus(eye);
    if (!(way.maxAbs() > 0) || !way.isFinite()) {
      throw new IllegalArgumentException(
          "target: expected a point other than the eye " + eye + ", found " + target);
    }
    Vec3 forward = way.normalized();
    if (!(up.maxAbs() > 0) || isAlong(forward, up)) {
      throw new IllegalArgumentException(
          "up: expected a direction other than that of the view, found " + up);
    }
    Vec3 upright = tangentAround(forward, up);
    return new Frame(
        withoutSign(upright.cross(forward)), withoutSign(upright), withoutSign(forward));
  }

  private static void requireFinite(String name, Vec3 vector) {
    if (!vector.isFinite()) {
      throw new IllegalArgumentException(name + ": expected finite numbers, found " + vector);
    }
  }

  /** Returns the vector with 0 in place of -0. */
  private static Vec3 withoutSign(Vec3 v) {
    return new Vec3(v.x() + 0., v.y() + 0., v.z() + 0.);
  }

  /** Returns the local +x axis, a unit vector. */
  public Vec3 tangent() {
    return new Vec3(tangentX, tangentY, tangentZ);
  }

  /** Returns the local +y axis, a unit vector. */
  public Vec3 bitangent() {
    return new Vec3(bitangentX, bitangentY, bitangentZ);
  }

  /** Returns the local +z axis, a unit vector. */
  public Vec3 normal() {
    return new Vec3(normalX, normalY, normalZ);
  }

  /**
   * Returns a frame around a unit normal. Its tangents are arbitrary, but always the same for the
   * same normal.
   *
   * <p>Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
   */
  public static Frame around(Vec3 normal) {
    return new Frame(tangentAround(normal), bitangentAround(normal), normal);
  }

  /** Returns the tangent of {@link #around(Vec3)} without creating a frame. */
  public static Vec3 tangentAround(Vec3 normal) {
    double sign = Math.copySign(1, normal.z());
    double a = -1 / (sign + normal.z());
    double b = normal.x() * normal.y() * a;
    return new Vec3(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
  }

  /** Returns the bitangent of {@link #around(Vec3)} without creating a frame. */
  public static Vec3 bitangentAround(Vec3 normal) {
    double sign = Math.copySign(1, normal.z());
    double a = -1 / (sign + normal.z());
    double b = normal.x() * normal.y() * a;
    return new Vec3(b, sign + normal.y() * normal.y() * a, -normal.y());
  }

  /**
   * Returns the frame around a unit normal that best preserves the given tangents. Its tangent is
   * {@code u} without the component along the normal, normalized; its bitangent lies on the side of
   * {@code v}. If {@code u} is {@linkplain #isAlong along the normal}, the result is {@link
   * #around(Vec3)}.
   */
  public static Frame around(Vec3 normal, Vec3 u, Vec3 v) {
    if (isAlong(normal, u)) {
      return around(normal);
    }
    Vec3 tangent = tangentAround(normal, u);
    return new Frame(tangent, bitangentAround(normal, tangent, v), normal);
  }

  /**
   * Returns whether a vector cannot serve as a tangent, because it is zero, not finite, or parallel
   * to the unit normal.
   */
  public static boolean isAlong(Vec3 normal, Vec3 u) {
    Vec3 tangent = u.plus(-u.dot(normal), normal);
    return !(tangent.length() > 1e-12 * u.length()) || !tangent.isFinite();
  }

  /**
   * Returns the unit tangent closest to {@code u}.
   *
   * @param u vector for which {@link #isAlong} is false
   */
  public static Vec3 tangentAround(Vec3 normal, Vec3 u) {
    Vec3 tangent = u.plus(-u.dot(normal), normal).normalized();
    // A second projection removes the error that cancellation left in the first.
    return tangent.plus(-tangent.dot(normal), normal).normalized();
  }

  /**
   * Returns the unit vector perpendicular to a normal and its tangent that lies on the side of
   * {@code v}.
   */
  public static Vec3 bitangentAround(Vec3 normal, Vec3 tangent, Vec3 v) {
    Vec3 bitangent = normal.cross(tangent);
    return bitangent.times(bitangent.dot(v) < 0 ? -1 : 1);
  }

  /** Returns the coordinates in this frame of a direction in world space. */
  public Vec3 toLocal(Vec3 world) {
    return new Vec3(world.dot(tangent()), world.dot(bitangent()), world.dot(normal()));
  }

  /** Returns the direction in world space that has coordinates in this frame. */
  public Vec3 toWorld(Vec3 local) {
    return toWorld(tangent(), bitangent(), normal(), local);
  }

  /**
   * Returns the world direction of a local one, given the axes of a frame; see {@link
   * #toWorld(Vec3)}.
   */
  public static Vec3 toWorld(Vec3 tangent, Vec3 bitangent, Vec3 normal, Vec3 local) {
    return new Vec3(
        tangent.x() * local.x() + bitangent.x() * local.y() + normal.x() * local.z(),
        tangent.y() * local.x() + bitangent.y() * local.y() + normal.y() * local.z(),
        tangent.z() * local.x() + bitangent.z() * local.y() + normal.z() * local.z());
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Frame frame
        && tangent().equals(frame.tangent())
        && bitangent().equals(frame.bitangent())
        && normal().equals(frame.normal());
  }

  @Override
  public int hashCode() {
    return Objects.hash(tangent(), bitangent(), normal());
  }

  @Override
  public String toString() {
    return "Frame[" + tangent() + ", " + bitangent() + ", " + normal() + "]";
  }
}
