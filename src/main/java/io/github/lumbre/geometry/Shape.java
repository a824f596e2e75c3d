package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/** A surface in world space: how to hit it, and how to sample it as a light. Immutable. */
public sealed interface Shape permits Box, Mesh, MeshInstance, Plane, Rectangle, Sphere {
  /** Returns a box around the surface, rounded outward; with infinite sides for infinite planes. */
  Bounds3 bounds();

  /**
   * Looks along the ray of {@code nearest} for a hit with 0 &lt; t &lt; {@code nearest.t}. If there
   * is one, stores its t and what {@link #surfaceAt} needs, and returns true; otherwise changes
   * nothing. The shape's number is the caller's to store.
   */
  boolean intersect(NearestHit nearest);

  /**
   * Returns the surface at the hit that {@link #intersect} stored last. The result is the hit's
   * own, and is written anew by the next call with the same {@code hit}.
   */
  SurfaceHit surfaceAt(NearestHit hit);

  /** Returns the area in world units; infinite for infinite planes. */
  double area();

  /** Tells whether the surface encloses a volume, so that there is an inside. */
  boolean isClosed();

  /** Returns the outward unit normal if it is known to be the same everywhere. */
  default Optional<Vec3> onlyNormal() {
    return Optional.empty();
  }

  /**
   * Samples a point of the surface that lights a reference point, or none (pdf 0) where none is
   * visible. Each shape distributes its points as suits it; the density accounts for that. This is
   * the hot path: plain numbers and a reused result allocate nothing; {@link #sample(Vec3, Point2)}
   * is the same for other callers.
   *
   * @param x of the reference point, in world space, as are y and z
   * @param u uniform in [0,1), as is v: they determine the point
   * @param result receives the point
   * @throws UnsupportedOperationException if {@link #area} is infinite
   */
  void sample(double x, double y, double z, double u, double v, SurfaceSample result);

  /**
   * Samples a point of the surface that lights a reference point; its density is 0 if none is
   * visible.
   *
   * @param reference point in world space
   * @param u uniform in [0,1)²: determines the point
   * @throws UnsupportedOperationException if {@link #area} is infinite
   */
  default SurfaceSample sample(Vec3 reference, Point2 u) {
    SurfaceSample result = new SurfaceSample();
    sample(reference.x(), reference.y(), reference.z(), u.x(), u.y(), result);
    return result;
  }

  /**
   * Returns the density, per solid angle at {@code reference}, with which {@link #sample} draws the
   * hit that a ray from there found; 0 for a point it never draws.
   */
  double pdf(Vec3 reference, SurfaceHit onShape);
}
