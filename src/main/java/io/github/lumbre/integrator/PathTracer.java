package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.guiding.Guide;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.Facing;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.path.PathVertex.End;
import io.github.lumbre.path.PathVertex.Source;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Specialization;
import java.util.Objects;
import java.util.Optional;

/**
 * A unidirectional path tracer with next-event estimation and multiple importance sampling (Kajiya
 * 1986; PBRT 4e, sec. 13.4). Its estimate is unbiased for all light that is scattered at most a
 * given number of times.
 *
 * <p>Each step traces a ray to the next vertex. There it adds the emission of the surface, samples
 * one light, samples the BSDF for the next direction, and applies Russian roulette, in this order.
 * With splitting, the rest of the path is repeated from the first non-specular vertex.
 */
public final class PathTracer implements Integrator {
  private final Scene scene;
  private final int maxDepth;
  private final Light[] emitters;

  /** The test for points that an emitter cannot light, by emitter. */
  private final Facing[] facings;

  private final EnvironmentLight[] environments;
  private final LightSampler selector;
  private final MisHeuristic heuristic;
  private final int firstRoulette;

  /** Number of branches of a split path. */
  private final int split;

  /** Whether there is more than one light to select from. */
  private final boolean selects;

  /** Whether the selection of a light needs a random number. */
  private final boolean drawsLight;

  /** Whether vertices sample lights. */
  private final boolean samplesLights;

  /** Whether vertices also sample the reflections of lights in mirrors. */
  private final boolean reflects;

  /** Whether vertices also sample lights through clear glass. */
  private final boolean refracts;

  /** Whether lights are sampled by way of specular surfaces. */
  private final boolean hasLinks;

  private final boolean hasAmbient;

  /** What the camera sees instead of environment lights. */
  private final Optional<Rgb> backplate;

  private final boolean hasBackplate;

  /** Whether rays may pass straight through some surface. */
  private final boolean hasTransparency;

  /** Whether rays may pass straight through some surface or an absorbing medium. */
  private final boolean hasPassing;

  /** The lights that are sampled through the lens, if the scene's own camera is used. */
  private final Optional<LensLights> lensLights;

  private final Optional<MirrorLights> mirrorLights;
  private final Optional<RefractedLights> refractedLights;
  private final Guide guide;

  /** Whether the guide has learned anything. */
  private final boolean isGuided;

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
    heuristic = options.heuristic();
    firstRoulette = options.firstRoulette();
    split = options.split();
    emitters = scene.emitters().stream().map(PathTracer::besideBsdf).toArray(Light[]::new);
    facings = scene.emitters().stream().map(Facing::of).toArray(Facing[]::new);
    environments =
        scene.environments().stream()
            .map(EnvironmentLight::besideBsdf)
            .toArray(EnvironmentLight[]::new);
    this.selector = Objects.requireNonNull(selector, "selector");
    selects = !scene.takes(Specialization.ONE_EMITTER);
    drawsLight = selector.isRandom();
    samplesLights = selector.canChoose() && heuristic.samplesLights(scene.emitters());
    hasAmbient = !scene.ambient().isBlack();
    backplate = options.transparent() ? Optional.of(Rgb.BLACK) : scene.backplate();
    hasBackplate = backplate.isPresent();
    hasTransparency = scene.hasTransparency();
    hasPassing = Passing.isNeeded(scene);
    lensLights =
        samplesLights && !options.transparent()
            ? LensLights.of(scene, emitters, heuristic)
            : Optional.empty();
    mirrorLights =
        samplesLights && options.bySpecular()
            ? MirrorLights.of(scene, emitters, selector, heuristic, guide)
            : Optional.empty();
    reflects = mirrorLights.isPresent();
    refractedLights =
        samplesLights && options.bySpecular()
            ? RefractedLights.of(scene, heuristic, guide)
            : Optional.empty();
    refracts = refractedLights.isPresent();
    hasLinks = reflects || refracts;
    this.guide = Objects.requireNonNull(guide, "guide");
    isGuided = !guide.isEmpty();
  }

  /** Returns a light as it is sampled where BSDF samples can find its light as well. */
  private static Light besideBsdf(Light light) {
    return light instanceof EnvironmentLight environment ? environment.besideBsdf() : light;
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
    return trace(lensLights.isPresent(), sampler, context);
  }

  /**
   * Traces a path that starts with the ray of {@code context.hit}.
   *
   * @param throughLens whether lights are also sampled through the lens
   */
  private Rgb trace(boolean throughLens, Sampler sampler, RenderContext context) {
    Path path = context.path;
    path.begin();
    context.crossing.isUsed = throughLens;
    context.link.begin();
    if (context.isRecorded) {
      context.listener.pathStarted();
    }
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
    context.rays++;
    boolean isHit = scene.intersect(hit);
    if (isHit && hasPassing) {
      isHit = passTransparency(depth, sampler, context);
    }
    if (context.isRecorded) {
      path.reportRay(hit, depth, context.listener);
    }
    if (depth == 0 && context.crossing.isUsed) {
      lensLights.get().addLight(sampler, context);
    }
    if (!isHit) {
      if (depth == 0 && hasBackplate) {
        addBackplate(context);
        return end(End.ESCAPED, context);
      }
      addEnvironment(context, hit.direction());
      return end(End.ESCAPED, context);
    }
    context.hitSomething = true;
    Primitive primitive = scene.primitiveAt(hit);
    boolean emits = primitive.emission().isPresent();
    if (depth == maxDepth && !emits) {
      if (context.isRecorded) {
        context.listener.surfaceHit(hit.shape(), scene.surfaceAt(hit));
      }
      return end(End.DEPTH, context);
    }
    SurfaceHit surface = scene.surfaceAt(hit);

    // Add emission. Most emitters scatter nothing.
    if (emits) {
      if (context.isRecorded) {
        context.listener.surfaceHit(hit.shape(), surface);
      }
      addEmission(primitive.emission().get(), surface, depth, context);
      if (depth == maxDepth || !primitive.scatters()) {
        return end(End.EMITTER, context);
      }
    }

    // Sample one light (next-event estimation), and the BSDF for the next direction.
    Vertex vertex = context.vertex;
    vertex.moveTo(surface, primitive.material());
    context.lift(scene);
    if (context.isRecorded) {
      context.listener.vertexReached(hit.shape(), surface, vertex.bsdf());
    }
    if (hasAmbient) {
      addAmbient(vertex, context);
    }
    boolean isSpecular = vertex.bsdf().isSpecular();
    if (isGuided) {
      vertex.findIn(guide);
    }
    if (split > 1 && !isSpecular && !path.isSplit()) {
      if (samplesLights) {
        direct(vertex, sampler, depth, context);
      }
      path.split(depth, split);
      return end(End.SPLIT, context);
    }
    // Drawn before the light is sampled, so that the processor can compute both points in parallel.
    Point2 uDirection = sampler.get2d(Sampler.vertex(depth) + Sampler.DIRECTION);
    if (samplesLights && !isSpecular) {
      direct(vertex, sampler, depth, context);
    }
    return scatter(vertex, depth, uDirection.x(), uDirection.y(), sampler, context);
  }

  /** Moves the hit beyond transparent surfaces; returns whether a surface stops the ray. */
  private boolean passTransparency(int depth, Sampler sampler, RenderContext context) {
    Passing passing = context.passing;
    boolean stops = passing.stops(scene, depth, sampler, context);
    context.rays += passing.rays();
    context.path.scale(passing.red(), passing.green(), passing.blue());
    return stops;
  }

  /**
   * Samples the BSDF for the path's next direction. Returns whether the path continues.
   *
   * @param u uniform in [0,1), as is v; the two determine the direction
   */
  private boolean scatter(
      Vertex vertex, int depth, double u, double v, Sampler sampler, RenderContext context) {
    Path path = context.path;
    int dimension = Sampler.vertex(depth);
    BsdfSample sample = context.scattered;
    double uLobe = vertex.bsdf().choosesLobe() ? sampler.get1d(dimension + Sampler.LOBE) : 0;
    double throughput = path.throughput();
    double survival = 1;
    if (vertex.isGuided()) {
      survival = path.survival(guide.mean(vertex.cell()));
      context.guiding.sample(guide, vertex, uLobe, u, v, sample);
    } else {
      vertex.sample(uLobe, u, v, sample);
    }
    if (sample.isAbsorbed()) {
      return end(End.ABSORBED, context);
    }
    path.scale(sample.r(), sample.g(), sample.b());
    path.leave(sample.pdf());
    if (hasLinks) {
      context.link.leave(vertex, throughput, context.hit, sample);
    }

    // Russian roulette: end weak paths at random and divide the others by their probability.
    if (depth >= firstRoulette && !vertex.isGuided()) {
      survival = path.survival(depth);
    }
    if (survival < 1) {
      if (sampler.get1d(dimension + Sampler.ROULETTE) >= survival) {
        reportScattered(sample, survival, false, context);
        return false;
      }
      path.scale(1 / survival, 1 / survival, 1 / survival);
    }
    reportScattered(sample, survival, true, context);
    vertex.surface().spawn(sample.x(), sample.y(), sample.z(), context.hit);
    return true;
  }

  /** Traces all branches of a split path, each with an equal share of the throughput. */
  private void traceBranches(Sampler sampler, RenderContext context) {
    Vertex vertex = context.keepVertex();
    for (int branch = 0; branch < split; branch++) {
      sampler.startPart(branch, split);
      int depth = context.path.returnToSplit();
      if (context.isRecorded) {
        context.listener.branchStarted(branch);
      }
      if (samplesLights && branch > 0) {
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

  /** Samples lights, and adds their light that the vertex scatters. */
  private void direct(Vertex vertex, Sampler sampler, int depth, RenderContext context) {
    boolean isClear = sampleLight(vertex, sampler, Sampler.vertex(depth), context);
    if (refracts && depth + 2 <= maxDepth && !isClear && !context.light.isEmpty()) {
      refractedLights.get().addRefracted(vertex, depth, maxDepth, sampler, context);
    }
    if (reflects && depth + 2 <= maxDepth) {
      mirrorLights.get().addReflection(vertex, depth, sampler, context);
    }
  }

  /** Samples one light, selected at random. Returns whether nothing blocks it. */
  private boolean sampleLight(
      Vertex vertex, Sampler sampler, int dimension, RenderContext context) {
    LightChoice choice = context.choice;
    LightSample light = context.light;
    vertex.receiveFrom(choice);
    if (selects) {
      double uChoice = drawsLight ? sampler.get1d(dimension + Sampler.LIGHT_CHOICE) : 0;
      selector.choose(uChoice, choice);
    } else {
      choice.setOnly();
    }
    if (facings[choice.emitter()].isAway(choice) && !context.isRecorded) {
      light.clear();
      return false;
    }
    Point2 uLight = sampler.get2d(dimension + Sampler.LIGHT_POINT);
    Light emitter = emitters[choice.emitter()];
    emitter.sample(choice.x(), choice.y(), choice.z(), uLight.x(), uLight.y(), light);
    if (light.isEmpty()) {
      return false;
    }
    BsdfValue value = context.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    boolean isBlocked = !isBlack && context.isOccluded(scene, vertex.surface());
    if (hasTransparency && !isBlocked) {
      // The shadow ray has dimmed the light.
      r = value.r() * light.r();
      g = value.g() * light.g();
      b = value.b() * light.b();
    }
    if ((isBlack || isBlocked) && !context.isRecorded) {
      return false;
    }
    double lightPdf = choice.probability();
    double misWeight = 1;
    if (!light.isDelta()) {
      lightPdf *= light.pdf();
      if (vertex.isGuided()) {
        value.mix(Guiding.pdf(guide, vertex.cell(), light.wi(), value.pdf()));
      }
      misWeight = heuristic.lightWeight(lightPdf, value.pdf());
    }
    if (context.isRecorded) {
      context.listener.lightSampled(
          Source.LIGHT, choice.emitter(), light, value, lightPdf, misWeight, isBlocked);
    }
    if (!isBlack && !isBlocked) {
      double weight = misWeight / lightPdf;
      context.add(r * weight, g * weight, b * weight);
    }
    return !isBlack && !isBlocked;
  }

  /**
   * Adds the emission of a surface towards the previous vertex, with its MIS weight against light
   * sampling.
   *
   * @param depth number of surfaces that scattered the path so far
   */
  private void addEmission(
      Emission emission, SurfaceHit surface, int depth, RenderContext context) {
    Rgb emitted = emission.towards(surface.wo(), surface.geometricNormal(), surface);
    int emitter = scene.emitterAt(context.hit);
    double bsdfPdf = context.path.pdf();
    double lightPdf = 0;
    double weight = 1;
    if (emitter >= 0 && isWeighted(bsdfPdf)) {
      double pdf = emitters[emitter].pdf(context.choice.point(), surface);
      lightPdf = lightPdf(emitter, pdf, context);
      weight = heuristic.bsdfWeight(bsdfPdf, lightPdf);
    } else if (depth == 0 && emitter >= 0 && context.crossing.isUsed) {
      bsdfPdf = context.crossing.rayPdf();
      lightPdf = lensLights.get().pdf(emitter, surface, context.crossing);
      weight = heuristic.bsdfWeight(bsdfPdf, lightPdf);
    } else if (reflects && emitter >= 0 && mirrorLights.get().isMet(context.link)) {
      bsdfPdf = context.link.pdf();
      lightPdf = mirrorLights.get().pdf(emitter, surface, context.link, context.reflection);
      weight = heuristic.bsdfWeight(bsdfPdf, lightPdf);
    } else if (refracts && emitter >= 0 && context.link.isRefracted()) {
      bsdfPdf = context.link.pdf() * context.link.passProbability();
      double pdf = emitters[emitter].pdf(context.choice.point(), surface);
      double straightPdf = lightPdf(emitter, pdf, context);
      lightPdf = refractedLights.get().pdf(context.link, surface, straightPdf, context);
      weight = heuristic.bsdfWeight(bsdfPdf, lightPdf);
    }
    if (context.isRecorded) {
      context.listener.lightFound(
          Source.EMISSION,
          emitter,
          emitted.r(),
          emitted.g(),
          emitted.b(),
          lightPdf,
          bsdfPdf,
          weight);
    }
    context.add(emitted.r() * weight, emitted.g() * weight, emitted.b() * weight);
  }

  /**
   * Adds the environment lights for a ray that leaves the scene, each with its own MIS weight.
   *
   * @param direction of unit length, in world space
   */
  private void addEnvironment(RenderContext context, Vec3 direction) {
    double bsdfPdf = context.path.pdf();
    double r = 0;
    double g = 0;
    double b = 0;
    for (int i = 0; i < environments.length; i++) {
      double lightPdf = 0;
      double weight = 1;
      if (isWeighted(bsdfPdf)) {
        lightPdf = lightPdf(scene.emitterOfEnvironment(i), environments[i].pdf(direction), context);
        weight = heuristic.bsdfWeight(bsdfPdf, lightPdf);
      }
      Rgb light = environments[i].from(direction);
      r += light.r() * weight;
      g += light.g() * weight;
      b += light.b() * weight;
      if (context.isRecorded) {
        context.listener.lightFound(
            Source.ENVIRONMENT,
            scene.emitterOfEnvironment(i),
            light.r(),
            light.g(),
            light.b(),
            lightPdf,
            bsdfPdf,
            weight);
      }
    }
    context.add(r, g, b);
  }

  /** Adds what the camera sees instead of environment lights. */
  private void addBackplate(RenderContext context) {
    Rgb light = backplate.orElse(Rgb.BLACK);
    if (context.isRecorded) {
      context.listener.lightFound(
          Source.ENVIRONMENT, -1, light.r(), light.g(), light.b(), 0, Double.POSITIVE_INFINITY, 1);
    }
    context.add(light.r(), light.g(), light.b());
  }

  /** Adds the light that ambient irradiance gives the diffuse part of a surface. */
  private void addAmbient(Vertex vertex, RenderContext context) {
    Rgb light = scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
    if (context.isRecorded) {
      context.listener.lightFound(Source.AMBIENT, -1, light.r(), light.g(), light.b(), 0, 0, 1);
    }
    context.add(light.r(), light.g(), light.b());
  }

  /** Returns whether light sampling could also have found light that a ray hits. */
  private boolean isWeighted(double bsdfPdf) {
    return samplesLights && bsdfPdf != Double.POSITIVE_INFINITY;
  }

  /**
   * Returns the density, per solid angle, with which light sampling would have drawn the path's
   * ray. It is the density at the vertex that last sampled a light: the path leaves every later
   * vertex by a delta lobe.
   *
   * @param pdf density with which the emitter itself draws the ray
   */
  private double lightPdf(int emitter, double pdf, RenderContext context) {
    return selects ? selector.probability(context.choice, emitter) * pdf : pdf;
  }

  private static void reportScattered(
      BsdfSample sample, double survival, boolean survives, RenderContext context) {
    if (context.isRecorded) {
      context.listener.scattered(sample, survival, survives);
    }
  }

  /** Reports why the path ends. Always returns false, so that callers can return the result. */
  private static boolean end(End end, RenderContext context) {
    if (context.isRecorded) {
      context.listener.pathEnded(end);
    }
    return false;
  }
}
