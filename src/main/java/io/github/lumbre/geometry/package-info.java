/**
 * Shapes, and the search for the nearest hit along a ray.
 *
 * <p>A {@link io.github.lumbre.geometry.Shape} implements its exact intersection formulas. The
 * search has two phases. During the traversal of a {@link io.github.lumbre.geometry.Bvh}, a {@link
 * io.github.lumbre.geometry.NearestHit} stores only distances and numbers. For the nearest hit
 * alone, the shape then computes a {@link io.github.lumbre.geometry.SurfaceHit} with position,
 * normals, frame and texture coordinates. The traversal has two kernels, {@code BinaryTraversal}
 * and {@code VectorTraversal}, between which {@link io.github.lumbre.geometry.Kernel} chooses.
 *
 * <p>Rays, hits and shapes are in world space; {@link io.github.lumbre.geometry.TriangleMesh} and
 * {@link io.github.lumbre.geometry.SharedMesh} are in local space. Geometric normals point outward
 * for hits from either side; normals of planes and rectangles point to their front side. The origin
 * of a ray that leaves a surface is offset by an error bound computed from the hit, not by a fixed
 * epsilon; only {@code SurfaceHit} does this.
 */
@NullMarked
package io.github.lumbre.geometry;

import org.jspecify.annotations.NullMarked;
