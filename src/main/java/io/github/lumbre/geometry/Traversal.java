package io.github.lumbre.geometry;

/**
 * A traversal that finds hits among the bounded items of a {@link Bvh}. The hits of all
 * implementations are bit-identical: they skip different items, but test each item in the same way.
 * Immutable; all threads share it.
 */
interface Traversal {
  /** The traversal of an empty hierarchy, which finds no hits. */
  Traversal NONE = (ox, oy, oz, dx, dy, dz, nearest) -> false;

  /**
   * Finds a hit before {@code nearest.t} along a ray given by its coordinates, beyond the one that
   * the ray has {@linkplain NearestHit#pass passed}. Finds the nearest hit, and of hits at the same
   * t the one with the lowest shape and element. If {@code nearest.any}, finds any hit. Uses the
   * stacks of {@code nearest} from its {@code stackTop} on.
   *
   * @return whether a hit was found and stored
   */
  boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest);
}
