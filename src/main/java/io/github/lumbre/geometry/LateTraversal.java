package io.github.lumbre.geometry;

import java.util.function.Supplier;

/** A traversal that is built when the first ray needs it. Thread-safe. */
final class LateTraversal implements Traversal {
  private final Supplier<Traversal> build;

  /** Null before the first ray. */
  private volatile Traversal built;

  LateTraversal(Supplier<Traversal> build) {
    this.build = build;
  }

  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    Traversal known = built;
    return (known == null ? build() : known).traverse(ox, oy, oz, dx, dy, dz, nearest);
  }

  private synchronized Traversal build() {
    if (built == null) {
      built = build.get();
    }
    return built;
  }
}
