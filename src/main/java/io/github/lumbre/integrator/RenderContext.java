package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.LightChoice;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Material;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.UnreadablePoints;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;

/**
 * The workspace of one thread: memory and counters that an {@link Integrator} reuses from sample to
 * sample. Mutable; one for each thread.
 */
public final class RenderContext {
  /** Whether {@link #listener} receives events: a branch is cheaper than a call for each. */
  final boolean isRecorded;

  final PathListener listener;
  NearestHit hit = new NearestHit();
  Vertex vertex = new Vertex();
  final Path path = new Path();
  final BsdfSample scattered = new BsdfSample();
  final BsdfValue value = new BsdfValue();
  final LightChoice choice = new LightChoice();
  final LightSample light = new LightSample();
  final Passing passing = new Passing();
  final Deque<RayTracer.Branch> branches = new ArrayDeque<>();
  private final NearestHit shadow = new NearestHit();
  private NearestHit otherHit = new NearestHit();
  private Vertex otherVertex = new Vertex();
  long rays;
  boolean hitSomething;
  private long shadowRays;

  /** Makes a workspace whose paths are not recorded. */
  public RenderContext() {
    this(new PathRecorder(), false);
  }

  private RenderContext(PathListener listener, boolean isRecorded) {
    this.listener = Objects.requireNonNull(listener, "listener");
    this.isRecorded = isRecorded;
  }

  /** Returns a workspace whose paths are recorded; its samples are bit-identical to others. */
  public static RenderContext recordedBy(PathRecorder recorder) {
    return new RenderContext(recorder, true);
  }

  /**
   * Returns the vertex where the path is, with its hit, and continues in other memory, so that the
   * vertex stays as it is until the next call.
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

  /**
   * Returns whether anything blocks the light that was sampled last from a surface. Surfaces that
   * let a part of it pass straight through dim the light.
   */
  boolean isOccluded(Scene scene, SurfaceHit surface) {
    shadowRays++;
    light.aimShadowRay(surface, shadow);
    return scene.hasTransparency() ? isBlocked(scene) : scene.isOccluded(shadow);
  }

  private boolean isBlocked(Scene scene) {
    for (int layer = 0; scene.intersect(shadow); layer++) {
      Material material = scene.primitiveAt(shadow).material();
      if (material.isOpaque() || layer == Passing.MAX_LAYERS) {
        return true;
      }
      SurfaceHit surface = scene.surfaceAt(shadow);
      Rgb passed = material.transmittance(surface);
      if (passed.isBlack()) {
        return true;
      }
      light.dim(passed);
      light.aimShadowRay(surface, shadow);
    }
    return false;
  }

  /** Returns how many rays were traced to their nearest hit. */
  public long rays() {
    return rays;
  }

  /** Returns how many shadow rays were traced. */
  public long shadowRays() {
    return shadowRays;
  }

  /**
   * Returns how many texture coordinates were invalid, that is, not finite, since the last call.
   */
  public long takeUnreadablePoints() {
    return UnreadablePoints.take();
  }

  /** Prepares for the next ray from the camera. */
  public void startSample() {
    hitSomething = false;
  }

  /** Returns whether the ray from the camera hit a surface. */
  public boolean hitSomething() {
    return hitSomething;
  }
}
