package io.github.lumbre.geometry;

/**
 * A search for hits among the bounded items of a {@link Bvh}. All implementations find the same
 * hits, bit for bit: they differ in which items they skip, never in how an item is tested.
 * Immutable, shared by all threads.
 */
interface Traversal {
  /** Finds nothing. */
  Traversal NONE = (ox, oy, oz, dx, dy, dz, nearest) -> false;

  /**
   * Looks for a hit before {@code nearest.t} along a ray given by its coordinates: for the nearest,
   * and at the same t for that of the lowest shape and element; or for any if {@code nearest.any}.
   * Uses the stacks of {@code nearest} from its {@code stackTop} on.
   *
   * @return whether a hit was found and stored
   */
  boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest);
}
