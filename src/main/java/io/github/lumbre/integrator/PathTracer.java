package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.Objects;

/**
 * A unidirectional path tracer with next-event estimation and multiple importance sampling (Kajiya
 * 1986; PBRT 4e, sec. 13.4). Its estimate is unbiased for all light that is scattered at most a
 * given number of times.
 *
 * <p>Each step traces a ray to the next vertex. There it adds the emission of the surface, samples
 * light by all {@linkplain LightTechniques techniques}, samples the next direction by the {@link
 * DirectionStrategy}, and applies Russian roulette, in this order. With splitting, the rest of the
 * path is repeated from the first non-specular vertex. The context's listener hears of each event.
 */
public final class PathTracer implements Integrator {
  private final Scene scene;
  private final int maxDepth;

  /** Number of branches of a split path. */
  private final int split;

  /** Whether rays may pass straight through some surface or an absorbing medium. */
  private final boolean hasPassing;

  /** Whether some surface refracts colors to different directions. */
  private final boolean mayDisperse;

  private final LightTechniques techniques;
  private final FoundLights found;
  private final DirectionStrategy directions;

  /**
   * Creates a path tracer with the default options.
   *
   * @param maxDepth the largest number of scattering vertices of a path, at least 0: with 0 only
   *     emitters are visible, with 1 also direct light
   */
  public PathTracer(Scene scene, int maxDepth) {
    this(scene, PathOptions.toDepth(maxDepth));
  }

  /** Creates a path tracer with the given options. */
  public PathTracer(Scene scene, PathOptions options) {
    this(scene, options, Guide.NONE);
  }

  /** Creates a path tracer with the given options and a guide to where light comes from. */
  public PathTracer(Scene scene, PathOptions options, Guide guide) {
    this(scene, options, options.lightSampler().over(scene), guide);
  }

  PathTracer(Scene scene, PathOptions options, LightSampler selector) {
    this(scene, options, selector, Guide.NONE);
  }

  private PathTracer(Scene scene, PathOptions options, LightSampler selector, Guide guide) {
    this.scene = Objects.requireNonNull(scene, "scene");
    maxDepth = options.maxDepth();
    split = options.split();
    hasPassing = Passing.isNeeded(scene);
    mayDisperse = Vertex.mayDisperse(scene);
    directions = DirectionStrategy.of(options, guide);
    techniques = new LightTechniques(new LightSampling(scene, options, selector, directions));
    found = new FoundLights(scene, options, techniques);
  }

  @Override
  public Rgb radiance(Ray ray, Sampler sampler, RenderContext context) {
    context.hit.aim(ray);
    return trace(false, sampler, context);
  }

  @Override
  public Rgb radiance(CameraRay ray, Sampler sampler, RenderContext context) {
    context.hit.aim(
        ray.originX(),
        ray.originY(),
        ray.originZ(),
        ray.directionX(),
        ray.directionY(),
        ray.directionZ(),
        Double.POSITIVE_INFINITY);
    return trace(true, sampler, context);
  }

  /**
   * Traces a path that starts with the ray of {@code context.hit}.
   *
   * @param isOfCamera whether the ray is one of the scene's own camera
   */
  private Rgb trace(boolean isOfCamera, Sampler sampler, RenderContext context) {
    Path path = context.path;
    context.startPath(isOfCamera);
    int depth = 0;
    while (extend(depth, sampler, context)) {
      depth++;
    }
    if (path.isSplit()) {
      traceBranches(sampler, context);
    }
    if (context.isRejected) {
      path.reject();
    }
    return path.radiance();
  }

  /**
   * Traces the ray to the next vertex and adds the light found there. Returns whether the path
   * continues with a new ray. If the path is split at the vertex, the result is false and {@link
   * #traceBranches} continues.
   */
  private boolean extend(int depth, Sampler sampler, RenderContext context) {
    NearestHit hit = context.hit;
    Path path = context.path;

    // Trace the ray. If it leaves the scene, add the environment.
    context.counters.rays++;
    boolean isHit = scene.intersect(hit);
    if (isHit && hasPassing) {
      isHit = passTransparency(depth, sampler, context);
    }
    path.reportRay(hit, depth, context.listener);
    if (depth == 0) {
      for (LightTechnique technique : techniques.ofCamera) {
        technique.add(depth, sampler, context);
      }
    }
    if (!isHit) {
      found.addBackground(depth, sampler, context);
      return end(End.ESCAPED, context);
    }
    context.hitSomething = true;

    // Add emission. Most emitters scatter nothing.
    Primitive primitive = scene.primitiveAt(hit);
    boolean emits = primitive.emission().isPresent();
    if (emits || depth == maxDepth) {
      context.listener.surfaceHit(hit, scene);
    }
    if (depth == maxDepth && !emits) {
      return end(End.DEPTH, context);
    }
    SurfaceHit surface = scene.surfaceAt(hit);
    if (emits) {
      found.addEmission(primitive.emission().get(), surface, depth, context);
      if (depth == maxDepth || !primitive.scatters()) {
        return end(End.EMITTER, context);
      }
    }

    // Sample lights, and the next direction.
    Vertex vertex = context.vertex;
    vertex.moveTo(surface, primitive.material());
    if (mayDisperse) {
      vertex.narrow(path.colors());
    }
    context.lift(scene);
    context.listener.vertexReached(hit.shape(), surface, vertex.bsdf());
    found.addAmbient(vertex, context);
    directions.reach(vertex);
    boolean isSpecular = vertex.bsdf().isSpecular();
    if (split > 1 && !isSpecular && !path.isSplit()) {
      direct(depth, sampler, context);
      path.split(depth, split);
      return end(End.SPLIT, context);
    }
    // Drawn before the light is sampled, so that the processor can compute both points in parallel.
    Point2 uDirection = sampler.get2d(Sampler.vertex(depth) + Sampler.DIRECTION);
    if (!isSpecular) {
      direct(depth, sampler, context);
    }
    return scatter(vertex, depth, uDirection.x(), uDirection.y(), sampler, context);
  }

  /** Moves the hit beyond transparent surfaces; returns whether a surface stops the ray. */
  private boolean passTransparency(int depth, Sampler sampler, RenderContext context) {
    Passing passing = context.scratch.passing;
    boolean stops = passing.stops(scene, depth, sampler, context);
    context.counters.rays += passing.rays();
    context.path.scale(passing.red(), passing.green(), passing.blue());
    return stops;
  }

  /** Samples lights, and adds their light that the vertex scatters. */
  private void direct(int depth, Sampler sampler, RenderContext context) {
    for (LightTechnique technique : techniques.ofVertices) {
      technique.add(depth, sampler, context);
    }
  }

  /**
   * Samples the path's next direction. Returns whether the path continues.
   *
   * @param u uniform in [0,1), as is v; the two determine the direction
   */
  private boolean scatter(
      Vertex vertex, int depth, double u, double v, Sampler sampler, RenderContext context) {
    Path path = context.path;
    int dimension = Sampler.vertex(depth);
    BsdfSample sample = context.scratch.scattered;
    double uLobe = vertex.bsdf().choosesLobe() ? sampler.get1d(dimension + Sampler.LOBE) : 0;
    directions.sample(vertex, uLobe, u, v, context);
    if (sample.isAbsorbed()) {
      return end(End.ABSORBED, context);
    }
    techniques.leave(vertex, context);
    path.scale(sample.r(), sample.g(), sample.b());
    path.leave(sample.pdf());

    // Russian roulette: end weak paths at random and divide the others by their probability.
    double survival = directions.survival(vertex, depth, path);
    if (survival < 1) {
      if (sampler.get1d(dimension + Sampler.ROULETTE) >= survival) {
        context.listener.scattered(sample, survival, false);
        return false;
      }
      path.scale(1 / survival, 1 / survival, 1 / survival);
    }
    context.listener.scattered(sample, survival, true);
    vertex.surface().spawn(sample.x(), sample.y(), sample.z(), context.hit);
    return true;
  }

  /** Traces all branches of a split path, each with an equal share of the throughput. */
  private void traceBranches(Sampler sampler, RenderContext context) {
    Vertex vertex = context.keepVertex();
    for (int branch = 0; branch < split; branch++) {
      sampler.startPart(branch, split);
      int depth = context.path.returnToSplit();
      context.listener.branchStarted(branch);
      if (branch > 0) {
        // Emitters hit by this branch are weighted against light sampling at the split vertex. The
        // previous branch has moved the receiver elsewhere, so move it back.
        vertex.receiveFrom(context.choice);
      }
      Point2 uDirection = sampler.get2d(Sampler.vertex(depth) + Sampler.DIRECTION);
      boolean continues = scatter(vertex, depth, uDirection.x(), uDirection.y(), sampler, context);
      while (continues) {
        depth++;
        continues = extend(depth, sampler, context);
      }
    }
  }

  /** Reports why the path ends. Always returns false, so that callers can return the result. */
  private static boolean end(End end, RenderContext context) {
    context.listener.pathEnded(end);
    return false;
  }
}
