package io.github.lumbre.light;

import io.github.lumbre.math.Vec3;

/**
 * A point where light is sampled, and the emitter that a {@link LightSampler} selected for it.
 * Mutable: each thread moves one and the same from point to point.
 */
public final class LightChoice {
  static final int WEIGHTS = 8;

  /** Memory for the weights of a few emitters. */
  final double[] weights = new double[WEIGHTS];

  // The point, and the unit normal of the side from which it takes light; zero if from both.
  double x, y, z;
  double normalX, normalY, normalZ;

  private int emitter;
  private double probability;

  /** Makes the memory of a choice. */
  public LightChoice() {}

  /**
   * Moves to another point.
   *
   * @param normal unit normal of the side from which the point takes light, or zero if from both
   */
  public void moveTo(Vec3 point, Vec3 normal) {
    x = point.x();
    y = point.y();
    z = point.z();
    normalX = normal.x();
    normalY = normal.y();
    normalZ = normal.z();
  }

  /** Returns the x of {@link #point}. */
  public double x() {
    return x;
  }

  /** Returns the y of {@link #point}. */
  public double y() {
    return y;
  }

  /** Returns the z of {@link #point}. */
  public double z() {
    return z;
  }

  /** Returns the point, in world space, that light is sampled for. */
  public Vec3 point() {
    return new Vec3(x, y, z);
  }

  /** Returns whether the point takes light from both sides. */
  boolean isOpen() {
    return normalX == 0 && normalY == 0 && normalZ == 0;
  }

  void set(int newEmitter, double newProbability) {
    emitter = newEmitter;
    probability = newProbability;
  }

  /** Chooses the only emitter that there is. */
  public void setOnly() {
    set(0, 1);
  }

  /** Returns the emitter's index. */
  public int emitter() {
    return emitter;
  }

  /**
   * Returns the probability of this choice: the value of {@link LightSampler#probability}, without
   * its work.
   */
  public double probability() {
    return probability;
  }
}
