package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.Limits;
import java.util.Optional;

/** What is left of the limits while one scene is read. Mutable; confined to one thread. */
final class Allowance {
  private static final long BYTES_PER_TRIANGLE = 250;
  private static final long BYTES_PER_TEXEL = 12;

  private final Limits limits;
  private long bytes;
  private long texels;
  private long triangles;

  Allowance(Limits limits) {
    this.limits = limits;
  }

  /** Returns an allowance without limits. */
  static Allowance unlimited() {
    return new Allowance(Limits.NONE);
  }

  /**
   * Adds bytes of a file that is about to be read. Returns what to say if they are too many; they
   * are then not added.
   */
  Optional<String> addBytes(long more) {
    Optional<String> excess = Limits.excess("bytes in all files", limits.bytes(), bytes + more);
    if (excess.isEmpty()) {
      bytes += more;
    }
    return excess;
  }

  /** Adds the texels of a picture that was decoded with {@link #texelsLeft} as its limit. */
  void addTexels(long more) {
    texels += more;
  }

  /** Returns the largest number of texels of the next picture. */
  long texelsLeft() {
    return Math.max(0, limits.texels() - texels);
  }

  /**
   * Returns the largest number of texels of the next picture, if it is to fit into the memory by
   * itself.
   */
  long texelsLeft(int bytesPerTexel) {
    return Math.min(texelsLeft(), limits.memory() / bytesPerTexel);
  }

  /** Adds the triangles of a mesh, or the points of a cloud, that was read within {@link #left}. */
  void addTriangles(long more) {
    triangles += more;
  }

  /** Returns about how many bytes of memory the scene takes, with the files that it is made of. */
  long memory() {
    return bytes + BYTES_PER_TRIANGLE * triangles + BYTES_PER_TEXEL * texels;
  }

  /** Returns the limits for the next mesh or model. */
  Limits left() {
    return limits
        .withTriangles(Math.max(0, limits.triangles() - triangles))
        .withTexels(texelsLeft());
  }
}
