package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;

/** Memory and counters that a thread reuses from sample to sample. Mutable, one for each thread. */
public final class Scratch {
  final NearestHit hit = new NearestHit();
  long rays;
  long shadowRays;
  boolean metSomething;

  /** Returns how many rays were followed to what they meet. */
  public long rays() {
    return rays;
  }

  /** Returns how many rays were followed to see whether they meet anything. */
  public long shadowRays() {
    return shadowRays;
  }

  /** Tells whether the last ray from the camera met a surface. */
  public boolean metSomething() {
    return metSomething;
  }
}
