package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;

/**
 * The infinite local xz plane with normal +y. Its texture coordinates are u = x / 10 and v = z / 10
 * in local units. Rays from behind pass through the plane unless it is two-sided.
 */
public final class Plane implements Shape {
  private static final double INF = Double.POSITIVE_INFINITY;
  private static final double TEXTURE_SIZE = 10;

  private final Transform toWorld;
  private final boolean twoSided;
  private final Vec3 normal;
  private final Frame shading;

  /**
   * Creates a plane.
   *
   * @param toWorld invertible
   * @param twoSided whether rays from behind hit the plane
   * @throws IllegalArgumentException if the transform is singular
   */
  public Plane(Transform toWorld, boolean twoSided) {
    this.toWorld = Placement.invertible(toWorld);
    this.twoSided = twoSided;
    normal = toWorld.normal(Vec3.Y);
    shading = Frame.around(normal, toWorld.vector(Vec3.X), toWorld.vector(Vec3.Z));
  }

  /** Returns a horizontal plane at a height, which rays from below pass. */
  public static Plane floor(double y) {
    return new Plane(Placement.at(new Vec3(0, y, 0)), false);
  }

  /** Returns the map from local to world space. */
  public Transform toWorld() {
    return toWorld;
  }

  /** Returns whether rays from behind hit the plane. */
  public boolean isTwoSided() {
    return twoSided;
  }

  @Override
  public Plane transformed(Transform outer) {
    return new Plane(outer.times(toWorld), twoSided);
  }

  @Override
  public Bounds3 bounds() {
    return new Bounds3(new Vec3(-INF, -INF, -INF), new Vec3(INF, INF, INF));
  }

  @Override
  public boolean intersect(NearestHit nearest) {
    double dy = nearest.localDirectionY(toWorld);
    if (dy >= 0 && !twoSided) {
      return false;
    }
    double t = -nearest.localOriginY(toWorld) / dy;
    if (!(t < nearest.t && nearest.isAfterPassed(t, 0))) {
      return false;
    }
    nearest.t = t;
    nearest.element = 0;
    return true;
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    Vec3 world = hit.origin().plus(hit.t, hit.direction());
    double x = toWorld.inversePointX(world.x(), world.y(), world.z());
    double z = toWorld.inversePointZ(world.x(), world.y(), world.z());
    Vec3 local = new Vec3(x, 0, z);
    return hit.surface.set(
        toWorld.point(local),
        normal,
        shading,
        new TexturePoint(x / TEXTURE_SIZE, z / TEXTURE_SIZE),
        hit.backwards(),
        toWorld.pointError(local, normal));
  }

  @Override
  public boolean isBehind(Bounds3 box) {
    return !twoSided && Placement.isInFront(box, toWorld);
  }

  @Override
  public boolean isClosed() {
    return false;
  }

  @Override
  public double area() {
    return INF;
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    throw new UnsupportedOperationException("an infinite plane cannot be sampled");
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    return 0;
  }

  /** Returns where it is, for people. */
  @Override
  public String toString() {
    return "Plane through " + toWorld.point(Vec3.ZERO) + " with normal " + normal;
  }
}
