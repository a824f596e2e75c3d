package io.github.lumbre.math;

import java.util.Objects;

/**
 * Three unit vectors at right angles, the axes of a local space whose +z is {@code normal}. Either
 * handedness may occur: a mirrored texture has a mirrored frame. Immutable.
 *
 * <p>Plain numbers, not three vectors: the compiler can do without an object that it has just made,
 * but hardly without those inside it.
 */
public final class Frame {
  /** The world's own axes. */
  public static final Frame WORLD = new Frame(Vec3.X, Vec3.Y, Vec3.Z);

  private final double tangentX, tangentY, tangentZ;
  private final double bitangentX, bitangentY, bitangentZ;
  private final double normalX, normalY, normalZ;

  /** Makes a frame of three unit vectors at right angles. */
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
   * Returns a frame around a unit normal; its tangents are arbitrary but fixed.
   *
   * <p>Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
   */
  public static Frame around(Vec3 normal) {
    return new Frame(tangentAround(normal), bitangentAround(normal), normal);
  }

  /** Returns the tangent of {@link #around(Vec3)}, for those who need no frame to be made. */
  public static Vec3 tangentAround(Vec3 normal) {
    double sign = Math.copySign(1, normal.z());
    double a = -1 / (sign + normal.z());
    double b = normal.x() * normal.y() * a;
    return new Vec3(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
  }

  /** Returns the bitangent of {@link #around(Vec3)}. */
  public static Vec3 bitangentAround(Vec3 normal) {
    double sign = Math.copySign(1, normal.z());
    double a = -1 / (sign + normal.z());
    double b = normal.x() * normal.y() * a;
    return new Vec3(b, sign + normal.y() * normal.y() * a, -normal.y());
  }

  /**
   * Returns the frame around a unit normal that keeps the given tangents as well as it can: the
   * tangent is {@code u} without its part along the normal, the bitangent lies on the side of
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

  /** Returns whether a vector is no tangent: zero, not finite, or along the unit normal. */
  public static boolean isAlong(Vec3 normal, Vec3 u) {
    Vec3 tangent = u.plus(-u.dot(normal), normal);
    return !(tangent.length() > 1e-12 * u.length()) || !tangent.isFinite();
  }

  /** Returns the unit tangent nearest to {@code u}, which is not {@link #isAlong}. */
  public static Vec3 tangentAround(Vec3 normal, Vec3 u) {
    Vec3 tangent = u.plus(-u.dot(normal), normal).normalized();
    // A second projection removes what cancellation left in the first.
    return tangent.plus(-tangent.dot(normal), normal).normalized();
  }

  /** Returns the direction across a normal and its tangent that lies on the side of {@code v}. */
  public static Vec3 bitangentAround(Vec3 normal, Vec3 tangent, Vec3 v) {
    Vec3 bitangent = normal.cross(tangent);
    return bitangent.times(bitangent.dot(v) < 0 ? -1 : 1);
  }

  public Vec3 toLocal(Vec3 world) {
    return new Vec3(world.dot(tangent()), world.dot(bitangent()), world.dot(normal()));
  }

  public Vec3 toWorld(Vec3 local) {
    return toWorld(tangent(), bitangent(), normal(), local);
  }

  /** Returns {@link #toWorld(Vec3)} of a frame that need not be made. */
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
