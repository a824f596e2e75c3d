package io.github.lumbre.geometry;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * The surface where a ray hit it, in world space. The only home of the error bound that rays leave
 * a surface by.
 *
 * <p>Mutable, one for each {@link NearestHit}, which shapes fill anew at each hit: plain numbers,
 * because this is made for every ray. What its methods return is immutable and may be kept.
 */
public final class SurfaceHit {
  /** How far, relative to a ray's length, its meeting with a surface may be out of place. */
  private static final double ROUNDING = 16 * 0x1p-52;

  private double x, y, z;
  private double geometricX, geometricY, geometricZ;
  private double tangentX, tangentY, tangentZ;
  private double bitangentX, bitangentY, bitangentZ;
  private double normalX, normalY, normalZ;
  private double u, v;
  private double outX, outY, outZ;
  private double error;

  /** Makes the memory of a hit, which {@link #set} fills. */
  public SurfaceHit() {}

  /**
   * Describes another hit.
   *
   * @param position on the surface, as exactly as the shape can say
   * @param geometricNormal the true normal, outward, of unit length, whichever side was hit
   * @param shading the normal to shade with (interpolated on smooth meshes, never more than 90°
   *     from the geometric one), and tangents along growing u and v
   * @param texture texture coordinates
   * @param wo unit direction back to where the ray came from
   * @param newError bound of the position's distance from the true surface along the normal
   * @return this
   */
  public SurfaceHit set(
      Vec3 position,
      Vec3 geometricNormal,
      Frame shading,
      TexturePoint texture,
      Vec3 wo,
      double newError) {
    x = position.x();
    y = position.y();
    z = position.z();
    geometricX = geometricNormal.x();
    geometricY = geometricNormal.y();
    geometricZ = geometricNormal.z();
    shadeBy(shading);
    u = texture.u();
    v = texture.v();
    outX = wo.x();
    outY = wo.y();
    outZ = wo.z();
    error = newError;
    return this;
  }

  /** Replaces the frame to shade with, as normal maps do. */
  public void shadeBy(Frame frame) {
    shadeBy(frame.tangent(), frame.bitangent(), frame.normal());
  }

  /** Replaces the frame to shade with by one around the true normal. */
  public void shadeFlat() {
    Vec3 normal = geometricNormal();
    shadeBy(Frame.tangentAround(normal), Frame.bitangentAround(normal), normal);
  }

  /** Turns the frame to shade with to another unit normal, as {@link Frame#around} does. */
  public void bendTo(Vec3 normal) {
    Vec3 u = new Vec3(tangentX, tangentY, tangentZ);
    Vec3 v = new Vec3(bitangentX, bitangentY, bitangentZ);
    // No frame is made: the compiler would not do without it, chosen from two.
    if (Frame.isAlong(normal, u)) {
      shadeBy(Frame.tangentAround(normal), Frame.bitangentAround(normal), normal);
    } else {
      Vec3 tangent = Frame.tangentAround(normal, u);
      shadeBy(tangent, Frame.bitangentAround(normal, tangent, v), normal);
    }
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

  /** Returns the point of the surface. */
  public Vec3 position() {
    return new Vec3(x, y, z);
  }

  /** Returns the true normal, outward, of unit length. */
  public Vec3 geometricNormal() {
    return new Vec3(geometricX, geometricY, geometricZ);
  }

  /** Returns the frame to shade with: its tangents along growing u and v. */
  public Frame shading() {
    return new Frame(
        new Vec3(tangentX, tangentY, tangentZ),
        new Vec3(bitangentX, bitangentY, bitangentZ),
        shadingNormal());
  }

  /** Returns the normal of the frame to shade with. */
  public Vec3 shadingNormal() {
    return new Vec3(normalX, normalY, normalZ);
  }

  /** Returns a world direction in the frame to shade with. */
  public Vec3 toLocal(Vec3 world) {
    double dx = world.x();
    double dy = world.y();
    double dz = world.z();
    return new Vec3(
        dx * tangentX + dy * tangentY + dz * tangentZ,
        dx * bitangentX + dy * bitangentY + dz * bitangentZ,
        dx * normalX + dy * normalY + dz * normalZ);
  }

  /** Returns a direction in the frame to shade with in world space. */
  public Vec3 toWorld(Vec3 local) {
    double dx = local.x();
    double dy = local.y();
    double dz = local.z();
    return new Vec3(worldX(dx, dy, dz), worldY(dx, dy, dz), worldZ(dx, dy, dz));
  }

  /** Returns the x of {@link #toWorld}. */
  public double worldX(double dx, double dy, double dz) {
    return tangentX * dx + bitangentX * dy + normalX * dz;
  }

  /** Returns the y of {@link #toWorld}. */
  public double worldY(double dx, double dy, double dz) {
    return tangentY * dx + bitangentY * dy + normalY * dz;
  }

  /** Returns the z of {@link #toWorld}. */
  public double worldZ(double dx, double dy, double dz) {
    return tangentZ * dx + bitangentZ * dy + normalZ * dz;
  }

  /** Returns the texture coordinates. */
  public TexturePoint texture() {
    return new TexturePoint(u, v);
  }

  /** Returns the first texture coordinate. */
  public double u() {
    return u;
  }

  /** Returns the second texture coordinate. */
  public double v() {
    return v;
  }

  /** Returns the unit direction back to where the ray came from. */
  public Vec3 wo() {
    return new Vec3(outX, outY, outZ);
  }

  /** Returns a bound of the position's distance from the true surface along the normal. */
  public double error() {
    return error;
  }

  /** Returns the ray that leaves in a unit direction, on the side the direction points to. */
  public Ray spawn(Vec3 direction) {
    double side = side(direction.x(), direction.y(), direction.z());
    return new Ray(position().plus(side, geometricNormal()), direction);
  }

  /** Aims a search by the ray that leaves in a unit direction, given by its coordinates. */
  public void spawn(double dx, double dy, double dz, NearestHit next) {
    double side = side(dx, dy, dz);
    double ox = x + side * geometricX;
    double oy = y + side * geometricY;
    double oz = z + side * geometricZ;
    next.aim(ox, oy, oz, dx, dy, dz, Double.POSITIVE_INFINITY);
  }

  /** Aims a search by the ray to a point, which is its end and excluded: t = 1 there. */
  public void spawnTowards(Vec3 point, NearestHit next) {
    aimTowards(next, point.x(), point.y(), point.z());
  }

  private void aimTowards(NearestHit next, double px, double py, double pz) {
    double side = side(px - x, py - y, pz - z);
    double ox = x + side * geometricX;
    double oy = y + side * geometricY;
    double oz = z + side * geometricZ;
    next.aim(ox, oy, oz, px - ox, py - oy, pz - oz, 1);
  }

  /**
   * Aims a search by the ray to a point of another surface; it ends just before that surface, so
   * that a light does not block its own light.
   */
  public void spawnTowards(SurfaceSample sample, NearestHit next) {
    Vec3 end = sample.position();
    Vec3 normal = sample.normal();
    double wx = x - end.x();
    double wy = y - end.y();
    double wz = z - end.z();
    double margin =
        sample.error() + ROUNDING * Math.max(Math.abs(wx), Math.max(Math.abs(wy), Math.abs(wz)));
    double dot = wx * normal.x() + wy * normal.y() + wz * normal.z();
    double side = Math.copySign(margin, dot);
    aimTowards(
        next,
        end.x() + side * normal.x(),
        end.y() + side * normal.y(),
        end.z() + side * normal.z());
  }

  /** Returns how far, in world units, along the true normal a ray begins off the surface. */
  private double side(double dx, double dy, double dz) {
    return Math.copySign(error, dx * geometricX + dy * geometricY + dz * geometricZ);
  }
}
