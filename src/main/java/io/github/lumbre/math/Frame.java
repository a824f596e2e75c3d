package io.github.lumbre.math;

/**
 * Three unit vectors at right angles, the axes of a local space whose +z is {@code normal}. Either
 * handedness may occur: a mirrored texture has a mirrored frame.
 */
public record Frame(Vec3 tangent, Vec3 bitangent, Vec3 normal) {
  /** The world's own axes. */
  public static final Frame WORLD = new Frame(Vec3.X, Vec3.Y, Vec3.Z);

  /**
   * Returns a frame around a unit normal; its tangents are arbitrary but fixed.
   *
   * <p>Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
   */
  public static Frame around(Vec3 normal) {
    double sign = Math.copySign(1, normal.z());
    double a = -1 / (sign + normal.z());
    double b = normal.x() * normal.y() * a;
    return new Frame(
        new Vec3(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()),
        new Vec3(b, sign + normal.y() * normal.y() * a, -normal.y()),
        normal);
  }

  /**
   * Returns the frame around a unit normal that keeps the given tangents as well as it can: the
   * tangent is {@code u} without its part along the normal, the bitangent lies on the side of
   * {@code v}. If {@code u} is zero, not finite, or along the normal, the result is {@link
   * #around}.
   */
  public static Frame around(Vec3 normal, Vec3 u, Vec3 v) {
    double length = u.length();
    Vec3 tangent = u.plus(-u.dot(normal), normal);
    if (!(tangent.length() > 1e-12 * length) || !tangent.isFinite()) {
      return around(normal);
    }
    // A second projection removes what cancellation left in the first.
    tangent = tangent.normalized();
    tangent = tangent.plus(-tangent.dot(normal), normal).normalized();
    Vec3 bitangent = normal.cross(tangent);
    return new Frame(tangent, bitangent.times(bitangent.dot(v) < 0 ? -1 : 1), normal);
  }

  public Vec3 toLocal(Vec3 world) {
    return new Vec3(world.dot(tangent), world.dot(bitangent), world.dot(normal));
  }

  public Vec3 toWorld(Vec3 local) {
    return new Vec3(
        tangent.x() * local.x() + bitangent.x() * local.y() + normal.x() * local.z(),
        tangent.y() * local.x() + bitangent.y() * local.y() + normal.y() * local.z(),
        tangent.z() * local.x() + bitangent.z() * local.y() + normal.z() * local.z());
  }
}
