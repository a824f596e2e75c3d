package io.github.lumbre.geometry;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * The hit surface, in world space. Only this class offsets ray origins from a surface, by the error
 * bound of the hit.
 *
 * <p>Mutable; each {@link NearestHit} has one, which shapes overwrite at each hit. It stores plain
 * numbers to avoid allocation. The values that its methods return are immutable.
 */
public final class SurfaceHit extends AttributedPoint {
  private double x, y, z;
  private double geometricX, geometricY, geometricZ;
  private double tangentX, tangentY, tangentZ;
  private double bitangentX, bitangentY, bitangentZ;
  private double normalX, normalY, normalZ;
  private double outX, outY, outZ;
  private double error;

  /** Where rays leave the surface: at the position, unless it is {@linkplain #lift lifted}. */
  private double originX, originY, originZ;

  /** From the position to the smooth surface, and its normal; valid only if {@link #hasLift}. */
  private double liftX, liftY, liftZ;

  private double smoothX, smoothY, smoothZ;

  private boolean hasLift;
  private boolean isLifted;

  /** Creates an empty hit; {@link #set} fills it. */
  public SurfaceHit() {}

  /**
   * Sets all values of the hit.
   *
   * @param position on the surface, as exactly as the shape can compute it
   * @param geometricNormal the outward unit normal of the true surface, for hits from either side
   * @param shading the shading frame: the shading normal (interpolated on smooth meshes, at most
   *     90° from the geometric normal), and tangents along increasing u and v
   * @param texture the texture coordinates
   * @param wo the unit direction back along the ray
   * @param newError a bound of the position's distance from the true surface along the normal, in
   *     world units
   * @return this
   */
  public SurfaceHit set(
      Vec3 position,
      Vec3 geometricNormal,
      Frame shading,
      TexturePoint texture,
      Vec3 wo,
      double newError) {
    shadeBy(shading);
    return set(position, geometricNormal, texture, wo, newError);
  }

  /** Sets all values of the hit but the shading frame, which the caller sets next. */
  SurfaceHit set(
      Vec3 position, Vec3 geometricNormal, TexturePoint texture, Vec3 wo, double newError) {
    x = position.x();
    y = position.y();
    z = position.z();
    geometricX = geometricNormal.x();
    geometricY = geometricNormal.y();
    geometricZ = geometricNormal.z();
    u = texture.u();
    v = texture.v();
    outX = wo.x();
    outY = wo.y();
    outZ = wo.z();
    error = newError;
    originX = x;
    originY = y;
    originZ = z;
    hasLift = false;
    isLifted = false;
    hasAttributes = false;
    return this;
  }

  /**
   * Adds where the smooth surface is that vertex normals imply; its normal is the shading normal.
   *
   * @param lift from the position, to the side that the ray hit
   */
  void liftBy(Vec3 lift) {
    liftX = lift.x();
    liftY = lift.y();
    liftZ = lift.z();
    smoothX = normalX;
    smoothY = normalY;
    smoothZ = normalZ;
    hasLift = true;
  }

  /** Replaces the texture coordinates. */
  SurfaceHit textureAt(TexturePoint texture) {
    u = texture.u();
    v = texture.v();
    return this;
  }

  /** Replaces the shading frame. */
  public void shadeBy(Frame frame) {
    shadeBy(frame.tangent(), frame.bitangent(), frame.normal());
  }

  /** Replaces the shading frame with one around the geometric normal. */
  public void shadeFlat() {
    shadeAround(geometricX, geometricY, geometricZ);
  }

  /** Replaces the shading frame with {@link Frame#around(Vec3)}. */
  private void shadeAround(double nx, double ny, double nz) {
    Vec3 normal = new Vec3(nx, ny, nz);
    shadeBy(Frame.tangentAround(normal), Frame.bitangentAround(normal), normal);
  }

  /** Replaces the shading frame with {@link Frame#around(Vec3, Vec3, Vec3)}. */
  void shadeAround(Vec3 normal, Vec3 u, Vec3 v) {
    // Escape analysis cannot remove an object that comes from two branches, as a Frame would, or
    // that is passed to a method that the JIT does not inline because it is called rarely.
    if (Frame.isAlong(normal, u)) {
      shadeAround(normal.x(), normal.y(), normal.z());
    } else {
      Vec3 tangent = Frame.tangentAround(normal, u);
      shadeBy(tangent, Frame.bitangentAround(normal, tangent, v), normal);
    }
  }

  /**
   * Replaces the shading normal with another unit normal, in world space, and realigns the tangents
   * as {@link Frame#around} does. Normal maps perturb the normal this way.
   */
  public void perturb(Vec3 normal) {
    Vec3 u = new Vec3(tangentX, tangentY, tangentZ);
    Vec3 v = new Vec3(bitangentX, bitangentY, bitangentZ);
    shadeAround(normal, u, v);
  }

  private void shadeBy(Vec3 tangent, Vec3 bitangent, Vec3 normal) {
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

  /** Returns the position on the surface. */
  public Vec3 position() {
    return new Vec3(x, y, z);
  }

  /** Returns where rays leave the surface, before their offset: the position, unless lifted. */
  public Vec3 origin() {
    return new Vec3(originX, originY, originZ);
  }

  /**
   * Returns whether vertex normals imply a smooth surface on the side that the ray hit, above the
   * flat triangle.
   */
  public boolean hasLift() {
    return hasLift;
  }

  /** Returns the unit normal of the smooth surface; requires {@link #hasLift}. */
  public Vec3 smoothNormal() {
    return new Vec3(smoothX, smoothY, smoothZ);
  }

  /** Aims {@code next} at the smooth surface, which is at t = 1; requires {@link #hasLift}. */
  public void aimAlongLift(NearestHit next) {
    double side = Math.copySign(error, frontal());
    next.aim(
        x + side * geometricX,
        y + side * geometricY,
        z + side * geometricZ,
        liftX,
        liftY,
        liftZ,
        1);
  }

  /**
   * Lets rays leave from near the smooth surface, all to the side that the ray hit, also those that
   * point below the flat triangle; requires {@link #hasLift}.
   *
   * @param part of the way there, in [0,1]
   */
  public void lift(double part) {
    originX = x + part * liftX;
    originY = y + part * liftY;
    originZ = z + part * liftZ;
    isLifted = true;
  }

  /** Returns the outward unit normal of the true surface, for hits from either side. */
  public Vec3 geometricNormal() {
    return new Vec3(geometricX, geometricY, geometricZ);
  }

  /** Returns the shading frame, whose tangents point along increasing u and v. */
  public Frame shading() {
    return new Frame(
        new Vec3(tangentX, tangentY, tangentZ),
        new Vec3(bitangentX, bitangentY, bitangentZ),
        shadingNormal());
  }

  /** Returns the unit normal of the shading frame. */
  public Vec3 shadingNormal() {
    return new Vec3(normalX, normalY, normalZ);
  }

  /** Returns a world-space direction in coordinates of the shading frame. */
  public Vec3 toLocal(Vec3 world) {
    double dx = world.x();
    double dy = world.y();
    double dz = world.z();
    return new Vec3(
        dx * tangentX + dy * tangentY + dz * tangentZ,
        dx * bitangentX + dy * bitangentY + dz * bitangentZ,
        dx * normalX + dy * normalY + dz * normalZ);
  }

  /** Returns the world-space direction of a direction in coordinates of the shading frame. */
  public Vec3 toWorld(Vec3 local) {
    double dx = local.x();
    double dy = local.y();
    double dz = local.z();
    return new Vec3(worldX(dx, dy, dz), worldY(dx, dy, dz), worldZ(dx, dy, dz));
  }

  /** Returns the x coordinate of {@link #toWorld}. */
  public double worldX(double dx, double dy, double dz) {
    return tangentX * dx + bitangentX * dy + normalX * dz;
  }

  /** Returns the y coordinate of {@link #toWorld}. */
  public double worldY(double dx, double dy, double dz) {
    return tangentY * dx + bitangentY * dy + normalY * dz;
  }

  /** Returns the z coordinate of {@link #toWorld}. */
  public double worldZ(double dx, double dy, double dz) {
    return tangentZ * dx + bitangentZ * dy + normalZ * dz;
  }

  /** Returns the first texture coordinate. */
  public double u() {
    return u;
  }

  /** Returns the second texture coordinate. */
  public double v() {
    return v;
  }

  /** Returns whether the ray hit the side that the geometric normal points to. */
  public boolean isFrontal() {
    return frontal() > 0;
  }

  private double frontal() {
    return outX * geometricX + outY * geometricY + outZ * geometricZ;
  }

  /**
   * Returns whether the ray that hit the surface starts on it, as far as rounding can tell. The
   * surface then coincides with the one that the ray leaves, which has the smaller error bound:
   * that bound is exceeded twice at most by the ray's origin, and once by the hit.
   */
  public boolean isAtOriginOf(NearestHit ray) {
    double distance =
        (x - ray.originX) * geometricX
            + (y - ray.originY) * geometricY
            + (z - ray.originZ) * geometricZ;
    return Math.abs(distance) <= 3 * error;
  }

  /** Returns the unit direction back along the ray. */
  public Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /**
   * Returns a bound of the position's distance from the true surface along the normal, in world
   * units.
   */
  public double error() {
    return error;
  }

  /**
   * Returns the ray that leaves the surface in a unit direction. Its origin is offset to the side
   * that the direction points to.
   */
  public Ray spawn(Vec3 direction) {
    double side = side(direction.x(), direction.y(), direction.z());
    return new Ray(origin().plus(side, geometricNormal()), direction);
  }

  /** Aims {@code next} along the ray that leaves the surface in the unit direction (dx, dy, dz). */
  public void spawn(double dx, double dy, double dz, NearestHit next) {
    double side = side(dx, dy, dz);
    double ox = originX + side * geometricX;
    double oy = originY + side * geometricY;
    double oz = originZ + side * geometricZ;
    next.aim(ox, oy, oz, dx, dy, dz, Double.POSITIVE_INFINITY);
  }

  /**
   * Aims {@code next} along the ray to a point. The ray ends at the point, excluded, with t = 1.
   */
  public void spawnTowards(Vec3 point, NearestHit next) {
    aimTowards(next, point.x(), point.y(), point.z());
  }

  private void aimTowards(NearestHit next, double px, double py, double pz) {
    double side = side(px - originX, py - originY, pz - originZ);
    double ox = originX + side * geometricX;
    double oy = originY + side * geometricY;
    double oz = originZ + side * geometricZ;
    next.aim(ox, oy, oz, px - ox, py - oy, pz - oz, 1);
  }

  /**
   * Aims {@code next} along the ray to a sampled point of another surface. The ray ends just before
   * that surface, so that a light does not occlude itself.
   */
  public void spawnTowards(SurfaceSample sample, NearestHit next) {
    Vec3 end = sample.position();
    Vec3 normal = sample.normal();
    double side = sample.sideTowards(originX, originY, originZ);
    aimTowards(
        next,
        end.x() + side * normal.x(),
        end.y() + side * normal.y(),
        end.z() + side * normal.z());
  }

  /** Returns the signed offset of a ray's origin along the geometric normal, in world units. */
  private double side(double dx, double dy, double dz) {
    return isLifted
        ? Math.copySign(2 * error, frontal())
        : Math.copySign(error, dx * geometricX + dy * geometricY + dz * geometricZ);
  }
}
