package io.github.lumbre.lab.checks;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Hash;
import io.github.lumbre.math.sampling.internal.Warp;

/** A reproducible stream of random numbers, determined by its key. Mutable. */
final class Draws {
  private final long key;
  private long count;

  Draws(long key) {
    this.key = key;
  }

  /** Returns a number in [0,1). */
  double unit() {
    return Hash.unit(Hash.of(key, ++count));
  }

  /** Returns a number in [low, high). */
  double between(double low, double high) {
    return low + (high - low) * unit();
  }

  /** Returns an integer in [0, n). */
  int below(int n) {
    return (int) (n * unit());
  }

  Point2 point() {
    return new Point2(unit(), unit());
  }

  /** Samples a uniform unit direction. */
  Vec3 direction() {
    return Warp.uniformSphere(point());
  }
}
