package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.GuideSample;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.internal.InvalidCoordinates;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;

/**
 * The per-thread workspace of a render, which an {@link Integrator} reuses from sample to sample:
 * the current path, scratch objects, and counters. Mutable and confined to one thread.
 */
public final class RenderContext {
  /** A ray of {@link #blocked} passes no more surfaces. */
  private static final int MOST_LAYERS = 64;

  /** Receives the events of the current path. */
  PathListener listener;

  /** Receives the events of each sample from its start. */
  private final PathListener first;

  NearestHit hit = new NearestHit();
  Vertex vertex = new Vertex();
  final Path path = new Path();
  final LightChoice choice = new LightChoice();
  final LensLights.Crossing crossing = new LensLights.Crossing();
  final SpecularLink link = new SpecularLink();
  private final NearestHit shadow = new NearestHit();
  private NearestHit otherHit = new NearestHit();
  private Vertex otherVertex = new Vertex();

  boolean hitSomething;

  /** The place of the current sample in the full frame, 0 at the upper edge and 1 at the lower. */
  double down;

  /** Whether the current sample's camera ray has passed straight through clear glass. */
  boolean passedGlass;

  /**
   * Whether a ray of the current sample has met more surfaces than it may pass. The sample's
   * radiance is NaN then, so that renders count it as rejected.
   */
  boolean isRejected;

  final Scratch scratch = new Scratch();
  final Counters counters = new Counters();

  /** What is computed at one vertex, and overwritten at the next. */
  static final class Scratch {
    final BsdfSample scattered = new BsdfSample();
    final BsdfValue value = new BsdfValue();
    final LightSample light = new LightSample();

    /** Whether the straight way to the light sample is blocked, or the vertex scatters nothing. */
    boolean isLightMissed;

    final Passing passing = new Passing();
    final GuideSample guided = new GuideSample();
    final GlassPath glassPath = new GlassPath();
    final MirrorLights.Reflection reflection = new MirrorLights.Reflection();
    final Deque<RayTracer.Branch> branches = new ArrayDeque<>();
  }

  /** The numbers of rays of all samples. */
  static final class Counters {
    /** Rays traced to their nearest hit. */
    long rays;

    private long shadowRays;
  }

  /** Creates a context that does not record paths. */
  public RenderContext() {
    this(PathListener.NONE);
  }

  private RenderContext(PathListener listener) {
    this.listener = Objects.requireNonNull(listener, "listener");
    first = listener;
  }

  /**
   * Returns a context that records paths. Its samples are bit-identical to those of a context
   * without a recorder.
   */
  public static RenderContext recordedBy(PathRecorder recorder) {
    return new RenderContext(recorder);
  }

  /** Returns a context that records where light was found, to learn a guide. */
  public static RenderContext recordedBy(GuideRecorder recorder) {
    return new RenderContext(recorder);
  }

  /** Returns a context that collects the layers of each sample. */
  public static RenderContext collecting(SampleLayers layers) {
    RenderContext context = new RenderContext(layers);
    layers.listenTo(context);
    return context;
  }

  /**
   * Returns whether a listener wants to hear of light that does not arrive, and of what a render
   * alone need not know.
   */
  boolean isRecorded() {
    return listener != PathListener.NONE;
  }

  /** Sends no more events of the current sample. */
  void stopRecording() {
    listener = PathListener.NONE;
  }

  /**
   * Starts a path.
   *
   * @param isOfCamera whether its first ray is one of the scene's own camera
   */
  void startPath(boolean isOfCamera) {
    path.begin();
    crossing.isUsed = isOfCamera;
    link.begin();
    listener.pathStarted();
  }

  /**
   * Returns the current vertex and replaces it and its hit by spare ones. The returned vertex
   * therefore stays unchanged until the next call.
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

  /** Adds light found at the path's current vertex, before the throughput. */
  void add(double r, double g, double b) {
    path.add(r, g, b);
    listener.lightAdded(r, g, b);
  }

  /**
   * Lets the rays of the current vertex leave from the smooth surface that vertex normals imply. If
   * another surface lies between, they leave from halfway there, so that no light leaks through it.
   */
  void lift(Scene scene) {
    if (vertex.isLiftable()) {
      counters.shadowRays++;
      vertex.surface().aimAlongLift(shadow);
      vertex.lift(scene.intersect(shadow) ? .5 * shadow.t() : 1);
    }
  }

  /**
   * Returns whether anything blocks the light that was sampled last from a surface. Surfaces that
   * let a part of it pass straight through dim the light.
   */
  boolean isOccluded(Scene scene, SurfaceHit surface) {
    counters.shadowRays++;
    LightSample light = scratch.light;
    light.aimShadowRay(surface, shadow);
    return scene.hasTransparency()
        ? isBlocked(scene)
        : scene.isLightOccluded(shadow, light.target() != LightSample.Target.INFINITY);
  }

  /** Returns whether anything blocks the light that was sampled last from a point in space. */
  boolean isOccluded(Scene scene, Vec3 point) {
    counters.shadowRays++;
    scratch.light.aimFrom(point, shadow);
    return scene.isOccluded(shadow);
  }

  /** Returns whether anything blocks a point of one surface from another surface. */
  boolean isOccluded(Scene scene, SurfaceHit surface, SurfaceSample point) {
    counters.shadowRays++;
    surface.spawnTowards(point, shadow);
    return scene.isOccluded(shadow);
  }

  /**
   * Returns the part of light along a ray that surfaces block; those that let light pass straight
   * through block none. The ray is not counted: a table that threads share holds the result.
   *
   * @param direction of length 1
   */
  double blocked(Scene scene, Vec3 from, Vec3 direction, double length) {
    shadow.aim(
        from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z(), length);
    if (!scene.hasTransparency()) {
      return scene.isOccluded(shadow) ? 1 : 0;
    }
    double passed = 1;
    for (int layer = 0; passed > 0 && layer < MOST_LAYERS && scene.intersect(shadow); layer++) {
      Material material = scene.primitiveAt(shadow).material();
      passed *= material.isOpaque() ? 0 : material.transmittance(scene.surfaceAt(shadow)).max();
      shadow.pass();
    }
    return 1 - passed;
  }

  /** Counts the rays of a search through glass as shadow rays. */
  void countSearch() {
    counters.shadowRays += scratch.glassPath.takeRays();
  }

  private boolean isBlocked(Scene scene) {
    LightSample light = scratch.light;
    double mediumStart = 0;
    for (int layer = 0; scene.intersect(shadow); layer++) {
      Material material = scene.primitiveAt(shadow).material();
      if (material.isOpaque()) {
        return true;
      }
      if (layer == Passing.MAX_LAYERS) {
        isRejected = true;
        return true;
      }
      SurfaceHit surface = scene.surfaceAt(shadow);
      if (!surface.isAtOriginOf(shadow)) {
        Rgb passed = material.transmittance(surface);
        if (passed.isBlack()) {
          return true;
        }
        light.dim(passed);
      }
      if (!material.absorption().isBlack()) {
        double length = (shadow.t() - mediumStart) * shadow.direction().length();
        light.dim(Passing.absorbed(material, surface, length));
        mediumStart = shadow.t();
      }
      shadow.pass();
    }
    return false;
  }

  /** Returns the number of rays traced to their nearest hit, shadow rays excluded. */
  public long rays() {
    return counters.rays;
  }

  /** Returns the number of shadow rays traced. */
  public long shadowRays() {
    return counters.shadowRays;
  }

  /**
   * Returns the number of invalid texture coordinates (NaN or infinite) on this thread since the
   * last call, and resets it to 0.
   */
  public long takeInvalidCoordinates() {
    return InvalidCoordinates.take();
  }

  /** Prepares for the next camera ray, in the middle of the frame. */
  public void startSample() {
    startSample(.5);
  }

  /**
   * Prepares for the next camera ray.
   *
   * @param newDown the distance of its pixel from the upper edge divided by the height of the full
   *     frame, 0 to 1
   */
  public void startSample(double newDown) {
    down = newDown;
    hitSomething = false;
    passedGlass = false;
    isRejected = false;
    listener = first;
  }

  /** Returns whether the current sample's camera ray hit a surface. */
  public boolean hitSomething() {
    return hitSomething;
  }
}
