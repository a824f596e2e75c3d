package io.github.lumbre.light.internal;

import io.github.lumbre.math.Vec3;

/**
 * A point that receives light, and the emitter that a {@link LightSampler} selected for it.
 * Mutable: each thread reuses one instance for all points.
 */
public final class LightChoice {
  static final int WEIGHTS = 8;

  /** The weights at the point of the lights of {@link #weighedBy}. */
  final double[] weights = new double[WEIGHTS];

  /** The sum of the weights, and how many of them are positive. */
  double sum;

  int lit;

  /** The lights whose weights at the point are known; null if there are none. */
  FewLights weighedBy;

  // The point, and the unit normal of the side that receives light; zero if both sides do.
  double x, y, z;
  double normalX, normalY, normalZ;

  private int emitter;
  private double probability;

  /** Computes the probability when it is first needed; null if it is known. */
  private LightSampler pending;

  /** Creates an instance at the origin, without a selected emitter. */
  public LightChoice() {}

  /**
   * Moves to another point.
   *
   * @param point position in world space
   * @param normal unit world normal of the side that receives light, or zero if both sides do
   */
  public void moveTo(Vec3 point, Vec3 normal) {
    x = point.x();
    y = point.y();
    z = point.z();
    normalX = normal.x();
    normalY = normal.y();
    normalZ = normal.z();
    weighedBy = null;
    pending = null;
  }

  /** Returns the x coordinate of {@link #point}. */
  public double x() {
    return x;
  }

  /** Returns the y coordinate of {@link #point}. */
  public double y() {
    return y;
  }

  /** Returns the z coordinate of {@link #point}. */
  public double z() {
    return z;
  }

  /** Returns the point, in world space, that receives light. */
  public Vec3 point() {
    return new Vec3(x, y, z);
  }

  /** Returns whether the point receives light from both sides. */
  boolean isOpen() {
    return normalX == 0 && normalY == 0 && normalZ == 0;
  }

  void set(int newEmitter, double newProbability) {
    emitter = newEmitter;
    probability = newProbability;
    pending = null;
  }

  /**
   * Selects an emitter without computing its probability. Many samples turn out not to need it,
   * because something blocks them.
   */
  void setLazily(int newEmitter, LightSampler sampler) {
    emitter = newEmitter;
    pending = sampler;
  }

  /** Selects emitter 0, the only one of the scene, with probability 1. */
  public void setOnly() {
    set(0, 1);
  }

  /** Returns the index of the selected emitter among the scene's emitters. */
  public int emitter() {
    return emitter;
  }

  /**
   * Returns the probability with which the emitter was selected: the value of {@link
   * LightSampler#probability}, without computing it again.
   */
  public double probability() {
    if (pending != null) {
      probability = pending.probability(this, emitter);
      pending = null;
    }
    return probability;
  }
}
