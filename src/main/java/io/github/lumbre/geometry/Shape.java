package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/** A surface in world space that can be intersected, and sampled as an area light. Immutable. */
public sealed interface Shape
    permits Box, Mesh, MeshInstance, Plane, Rectangle, Sphere, SphereCloud, SphereCloud.Item {
  /**
   * Returns the world-space bounding box, rounded outward; infinite for infinite planes, empty for
   * a mesh without triangles.
   */
  Bounds3 bounds();

  /**
   * Finds the first hit along the ray of {@code nearest} beyond what it has {@linkplain
   * NearestHit#pass passed}, with 0 &lt; t &lt; {@code nearest.t}. If there is one, stores its t
   * and the data that {@link #surfaceAt} needs; otherwise changes nothing. The caller stores the
   * shape number.
   *
   * @return whether a hit was found and stored
   */
  boolean intersect(NearestHit nearest);

  /**
   * Returns the surface at the hit that {@link #intersect} stored last. The result belongs to
   * {@code hit}; the next call with the same {@code hit} overwrites it.
   */
  SurfaceHit surfaceAt(NearestHit hit);

  /**
   * Returns this shape after a further transform.
   *
   * @param outer invertible; applied to the points of this shape
   * @throws IllegalArgumentException if the transform is singular
   */
  Shape transformed(Transform outer);

  /** Returns the world-space surface area; infinite for infinite planes. */
  double area();

  /** Returns whether the surface encloses a volume. */
  boolean isClosed();

  /** Returns how the shading normal changes around the hit that {@link #intersect} stored last. */
  default NormalGradient normalGradientAt(NearestHit hit) {
    return NormalGradient.FLAT;
  }

  /**
   * Returns the outward world-space unit normal if it is known to be constant over the surface;
   * empty otherwise.
   */
  default Optional<Vec3> onlyNormal() {
    return Optional.empty();
  }

  /**
   * Returns whether the shape is flat, rays from behind pass through it, and a box in world space
   * lies wholly in front of its plane, with a distance far above rounding errors. The shape then
   * blocks no ray that ends in the box, wherever the ray starts.
   */
  default boolean isBehind(Bounds3 box) {
    return false;
  }

  /**
   * Samples a point of the surface for the lighting of a reference point. The result has pdf 0 if
   * no point is visible. Each shape chooses its own distribution; the pdf accounts for it. Plain
   * numbers and a reused result avoid allocation on this hot path. {@link #sample(Vec3, Point2)} is
   * a convenience method with the same result.
   *
   * @param x world-space x of the reference point
   * @param y world-space y of the reference point
   * @param z world-space z of the reference point
   * @param u first random number, uniform in [0,1)
   * @param v second random number, uniform in [0,1)
   * @param result receives the point
   * @throws UnsupportedOperationException if {@link #area} is infinite
   */
  void sample(double x, double y, double z, double u, double v, SurfaceSample result);

  /**
   * Samples a point of the surface for the lighting of a reference point. The result has pdf 0 if
   * no point is visible.
   *
   * @param reference the reference point in world space
   * @param u uniform in [0,1)²
   * @throws UnsupportedOperationException if {@link #area} is infinite
   */
  default SurfaceSample sample(Vec3 reference, Point2 u) {
    SurfaceSample result = new SurfaceSample();
    sample(reference.x(), reference.y(), reference.z(), u.x(), u.y(), result);
    return result;
  }

  /**
   * Returns the density, per solid angle at {@code reference}, with which {@link #sample} produces
   * a point. The result is 0 for a point that it never produces.
   *
   * @param reference the reference point in world space
   * @param onShape the point on this shape, as hit by a ray from the reference point
   */
  double pdf(Vec3 reference, SurfaceHit onShape);
}
