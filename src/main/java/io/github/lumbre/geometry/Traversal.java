package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;

/**
 * A search for hits among the bounded items of a {@link Bvh}. All implementations find the same
 * hits, bit for bit: they differ in which items they skip, never in how an item is tested.
 * Immutable, shared by all threads.
 */
interface Traversal {
  /** Finds nothing. */
  Traversal NONE = (ray, ox, oy, oz, dx, dy, dz, nearest) -> false;

  /**
   * Looks for a hit before {@code nearest.t} along a ray given by its coordinates: for the nearest,
   * and at the same t for that of the lowest shape and element; or for any if {@code nearest.any}.
   * Uses the stacks of {@code nearest} from its {@code stackTop} on.
   *
   * @param ray the world's; only passed on to shapes that are not triangles
   * @return whether a hit was found and stored
   */
  boolean traverse(
      Ray ray,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz,
      NearestHit nearest);
}
