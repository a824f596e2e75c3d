package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.light.LightChoice;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.UnreadablePoints;
import java.util.ArrayDeque;
import java.util.Deque;

/** Memory and counters that a thread reuses from sample to sample. Mutable, one for each thread. */
public final class Scratch {
  NearestHit hit = new NearestHit();
  Vertex vertex = new Vertex();
  final Path path = new Path();
  final BsdfSample scattered = new BsdfSample();
  final BsdfValue value = new BsdfValue();
  final LightChoice choice = new LightChoice();
  final LightSample light = new LightSample();
  final Deque<RayTracer.Branch> branches = new ArrayDeque<>();
  private final NearestHit shadow = new NearestHit();
  private NearestHit otherHit = new NearestHit();
  private Vertex otherVertex = new Vertex();
  long rays;
  boolean metSomething;
  private long shadowRays;

  /** Makes the memory of one thread. */
  public Scratch() {}

  /**
   * Returns the vertex where the path is, with its hit, and goes on in other memory, so that the
   * vertex stays until this is asked for again.
   */
  Vertex keepVertex() {
    Vertex kept = vertex;
    vertex = otherVertex;
    otherVertex = kept;
    NearestHit keptHit = hit;
    hit = otherHit;
    otherHit = keptHit;
    return kept;
  }

  /** Tells whether anything stands between a surface and the sample of light. */
  boolean isOccluded(Scene scene, SurfaceHit surface) {
    shadowRays++;
    light.aimShadowRay(surface, shadow);
    return scene.isOccluded(shadow);
  }

  /** Returns how many rays were followed to what they meet. */
  public long rays() {
    return rays;
  }

  /** Returns how many rays were followed to see whether they meet anything. */
  public long shadowRays() {
    return shadowRays;
  }

  /**
   * Returns how many points of textures that this thread evaluated were not finite, since this was
   * last called.
   */
  public long takeUnreadablePoints() {
    return UnreadablePoints.take();
  }

  /** Forgets whether a ray met anything, for the next ray from the camera. */
  public void startSample() {
    metSomething = false;
  }

  /** Tells whether the ray from the camera met a surface. */
  public boolean metSomething() {
    return metSomething;
  }
}
