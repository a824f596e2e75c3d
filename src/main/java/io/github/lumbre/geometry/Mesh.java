package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * A triangle mesh in world space, solid from both sides. The {@link Bvh} takes its triangles in
 * singly; for a mesh that stands in many places there is {@link MeshInstance}.
 */
public final class Mesh implements Shape {
  private final TriangleMesh world;
  private final MeshSurface surface;

  /** A hierarchy of its own, made only if someone intersects this shape by itself. */
  private volatile Bvh bvh;

  private Mesh(TriangleMesh world) {
    this.world = world;
    surface = new MeshSurface(world, Transform.IDENTITY);
  }

  /**
   * Returns a mesh in its place: its vertices are mapped to the world once.
   *
   * @param toWorld invertible
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

  /** {@inheritDoc} Points are uniform by area, also where the mesh hides itself. */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    surface.sample(x, y, z, u, v, result);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    return surface.pdf(reference, onShape);
  }
}
