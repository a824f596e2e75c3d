package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * A triangle mesh in world space, which rays hit from both sides. In a {@link Bvh}, each of its
 * triangles is an item. Use {@link MeshInstance} to place one mesh many times.
 */
public final class Mesh implements Shape {
  private final TriangleMesh world;
  private final MeshSurface surface;

  /** This mesh's own hierarchy, built on the first call of {@link #intersect}. */
  private volatile Bvh bvh;

  private Mesh(TriangleMesh world) {
    this.world = world;
    surface = new MeshSurface(world, Transform.IDENTITY);
  }

  /**
   * Returns a mesh whose vertices are mapped to world space once.
   *
   * @param local the mesh in local space
   * @param toWorld invertible
   * @throws IllegalArgumentException if the transform is singular
   */
  public static Mesh baked(TriangleMesh local, Transform toWorld) {
    return new Mesh(local.baked(Placement.invertible(toWorld)));
  }

  /** Returns the triangles in world space. */
  TriangleMesh triangles() {
    return world;
  }

  @Override
  public Bounds3 bounds() {
    return world.bounds();
  }

  @Override
  public boolean intersect(NearestHit nearest) {
    Bvh known = bvh;
    if (known == null) {
      known = Bvh.over(List.of(this));
      bvh = known;
    }
    return known.intersectPart(
        nearest.originX,
        nearest.originY,
        nearest.originZ,
        nearest.directionX,
        nearest.directionY,
        nearest.directionZ,
        nearest);
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    return surface.at(hit);
  }

  @Override
  public boolean isClosed() {
    return MeshBorder.isClosed(world);
  }

  @Override
  public double area() {
    return surface.area();
  }

  /** {@inheritDoc} Points are uniform by area, including points that the mesh itself occludes. */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    surface.sample(x, y, z, u, v, result);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    return surface.pdf(reference, onShape);
  }
}
