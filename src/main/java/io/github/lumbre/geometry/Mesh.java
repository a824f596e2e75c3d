package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Optional;

/**
 * A triangle mesh in world space, which rays hit from both sides. In a {@link Bvh}, each of its
 * triangles is an item. Use {@link MeshInstance} to place one mesh many times.
 */
public final class Mesh implements Shape {
  private final TriangleMesh world;
  private final MeshSurface surface;

  /** What the mesh was made from; empty if it does not keep it, to save memory. */
  private final Optional<Source> source;

  /** This mesh's own hierarchy, built on the first call of {@link #intersect}. */
  private volatile Bvh bvh;

  /**
   * What a mesh was made from.
   *
   * @param toWorld from the mesh's local space to world space
   */
  public record Source(TriangleMesh mesh, Transform toWorld) {}

  private Mesh(TriangleMesh world, Optional<Source> source) {
    this.world = world;
    this.source = source;
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
    return new Mesh(local.baked(Placement.invertible(toWorld)), Optional.empty());
  }

  /**
   * Returns a mesh that keeps the mesh it is made from, so that it can be moved and written.
   *
   * @param local the mesh in local space
   * @param toWorld invertible
   * @throws IllegalArgumentException if the transform is singular
   */
  public static Mesh of(TriangleMesh local, Transform toWorld) {
    TriangleMesh world = local.baked(Placement.invertible(toWorld));
    return new Mesh(world, Optional.of(new Source(local, toWorld)));
  }

  /** Returns a mesh whose coordinates are in world space; see {@link #of}. */
  public static Mesh of(TriangleMesh mesh) {
    return of(mesh, Transform.IDENTITY);
  }

  /** Returns the arguments of {@link #of}; empty for a {@linkplain #baked baked} mesh. */
  public Optional<Source> source() {
    return source;
  }

  /** {@inheritDoc} A mesh without a {@linkplain #source source} is mapped again. */
  @Override
  public Mesh transformed(Transform outer) {
    return source
        .map(from -> of(from.mesh(), outer.times(from.toWorld())))
        .orElseGet(() -> baked(world, outer));
  }

  /** Returns the triangles in world space. */
  public TriangleMesh triangles() {
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
  public NormalGradient normalGradientAt(NearestHit hit) {
    return surface.normalGradientAt(hit);
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    return surface.at(hit);
  }

  @Override
  public boolean isClosed() {
    return world.isClosed();
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

  /** Returns the number of triangles, for people. */
  @Override
  public String toString() {
    return "Mesh of " + world.triangleCount() + " triangles";
  }
}
