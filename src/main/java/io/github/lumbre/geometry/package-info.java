/**
 * Shapes, and finding the nearest one along a ray.
 *
 * <p>A {@link io.github.lumbre.geometry.Shape} knows its exact formulas. Finding the nearest has
 * two phases: while the {@link io.github.lumbre.geometry.Bvh} searches, only distances and numbers
 * are kept, in a {@link io.github.lumbre.geometry.NearestHit}; the winner alone is then turned into
 * a {@link io.github.lumbre.geometry.SurfaceHit}, with position, normals, frame and texture
 * coordinates. The search has two kernels, {@code BinaryTraversal} and {@code VectorTraversal},
 * between which {@link io.github.lumbre.geometry.Kernel} chooses.
 *
 * <p>Everything public here is in world space. Geometric normals point outward (for planes: to the
 * side they are seen from), whichever side was hit. Rays leave a surface by an error bound computed
 * from the hit, never by a fixed epsilon: {@code SurfaceHit.spawn} is the only place that offsets.
 */
package io.github.lumbre.geometry;

