package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/** One placement of a shared mesh in world space. Rays hit it from both sides. */
public final class MeshInstance implements Shape {
  private final SharedMesh shared;
  private final Transform toWorld;
  private final MeshSurface surface;

  /**
   * Creates an instance.
   *
   * @param toWorld invertible
   * @throws IllegalArgumentException if the transform is singular
   */
  public MeshInstance(SharedMesh shared, Transform toWorld) {
    this.shared = shared;
    this.toWorld = Placement.invertible(toWorld);
    surface = new MeshSurface(shared.mesh(), toWorld);
  }

  /** Returns an instance of a mesh that only this instance and its moved copies share. */
  public static MeshInstance of(TriangleMesh mesh) {
    return new MeshInstance(new SharedMesh(mesh), Transform.IDENTITY);
  }

  /** Returns the map from local to world space. */
  public Transform toWorld() {
    return toWorld;
  }

  @Override
  public MeshInstance transformed(Transform outer) {
    return new MeshInstance(shared, outer.times(toWorld));
  }

  /** Returns the mesh and its hierarchy. */
  public SharedMesh shared() {
    return shared;
  }

  @Override
  public Bounds3 bounds() {
    return Placement.outward(toWorld, shared.mesh().bounds());
  }

  /**
   * {@inheritDoc} The local direction is not normalized, so t is the same in local and world space.
   */
  @Override
  public boolean intersect(NearestHit nearest) {
    return shared
        .bvh()
        .intersectPart(
            nearest.localOriginX(toWorld),
            nearest.localOriginY(toWorld),
            nearest.localOriginZ(toWorld),
            nearest.localDirectionX(toWorld),
            nearest.localDirectionY(toWorld),
            nearest.localDirectionZ(toWorld),
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
    return shared.mesh().isClosed();
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
    return "MeshInstance of " + shared.mesh().triangleCount() + " triangles";
  }
}
