package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A ray tracer after Whitted (1980): direct light from every light, mirrors and glass, but no light
 * between diffuse or glossy surfaces. It samples each area light and environment light once per
 * vertex.
 */
public final class RayTracer implements Integrator {
  /**
   * The number of glass surfaces at which a path is split into reflection and refraction. After
   * that it follows one of the two at random, so that deep glass does not cost 2^depth rays.
   */
  private static final int MAX_SPLITS = 4;

  private final Scene scene;
  private final List<Light> lights;
  private final int maxReflections;
  private final int maxRefractions;

  /** What the camera sees instead of environment lights. */
  private final Optional<SeenBackplate> backplate;

  /** Whether samples that see the backplate through clear glass cover their pixel. */
  private final boolean isGlassSeen;

  /** Whether rays may pass straight through some surface or an absorbing medium. */
  private final boolean hasPassing;

  /** Whether some surface refracts colors to different directions. */
  private final boolean mayDisperse;

  /**
   * Creates a ray tracer.
   *
   * @param maxReflections the largest number of mirror reflections along a path, at least 0
   * @param maxRefractions the largest number of glass surfaces along a path, at least 0
   */
  public RayTracer(Scene scene, int maxReflections, int maxRefractions) {
    this(scene, maxReflections, maxRefractions, PathOptions.toDepth(0));
  }

  /**
   * Creates a ray tracer.
   *
   * @param background whose background camera rays find
   */
  RayTracer(Scene scene, int maxReflections, int maxRefractions, PathOptions background) {
    this.scene = Objects.requireNonNull(scene, "scene");
    this.lights = scene.lights();
    this.maxReflections = maxReflections;
    this.maxRefractions = maxRefractions;
    backplate = background.backplateOf(scene).map(seen -> new SeenBackplate(scene, seen));
    isGlassSeen = background.backplate().isPresent();
    hasPassing = Passing.isNeeded(scene);
    mayDisperse = Vertex.mayDisperse(scene);
  }

  /** A ray still to be traced, its throughput, and how many surfaces it has left. */
  record Branch(Ray ray, Rgb throughput, int reflections, int refractions) {
    /** Returns this branch with its throughput multiplied. */
    Branch scaled(Rgb factor) {
      return new Branch(ray, throughput.times(factor), reflections, refractions);
    }
  }

  @Override
  public Rgb radiance(Ray cameraRay, Sampler sampler, RenderContext context) {
    Deque<Branch> pending = context.scratch.branches;
    pending.clear();
    pending.push(new Branch(cameraRay, Rgb.WHITE, 0, 0));
    context.listener.pathStarted();
    double r = 0;
    double g = 0;
    double b = 0;
    for (int number = 0; !pending.isEmpty(); number++) {
      Rgb light = trace(pending.pop(), number, sampler, context);
      r += light.r();
      g += light.g();
      b += light.b();
    }
    if (context.isRejected) {
      r = Double.NaN;
    }
    return new Rgb(r, g, b);
  }

  /**
   * Traces a branch, returns the light found at its end times its throughput, and pushes the
   * branches that start there.
   *
   * @param number of the branch within the sample, from 0; selects its random numbers
   */
  private Rgb trace(Branch branch, int number, Sampler sampler, RenderContext context) {
    NearestHit hit = context.hit;
    context.counters.rays++;
    boolean isHit = scene.intersect(branch.ray(), hit);
    Branch seen = branch;
    if (isHit && hasPassing) {
      isHit = context.scratch.passing.stops(scene, number, sampler, context);
      context.counters.rays += context.scratch.passing.rays();
      seen = branch.scaled(context.scratch.passing.factor());
    }
    return seen.throughput().times(shadeHit(seen, number, isHit, sampler, context));
  }

  private Rgb shadeHit(
      Branch branch, int number, boolean isHit, Sampler sampler, RenderContext context) {
    NearestHit hit = context.hit;
    Rgb throughput = branch.throughput();
    int depth = branch.reflections() + branch.refractions();
    context.listener.rayTraced(hit, depth, throughput.r(), throughput.g(), throughput.b());
    if (!isHit) {
      return depth == 0 && backplate.isPresent()
          ? backplate(backplate.get().light(context), context)
          : environment(hit.direction(), context);
    }
    context.hitSomething = true;
    SurfaceHit surface = scene.surfaceAt(hit);
    Primitive primitive = scene.primitiveAt(hit);
    Rgb emitted = Rgb.BLACK;
    if (primitive.emission().isPresent()) {
      emitted = emission(primitive.emission().get(), surface, primitive.scatters(), context);
      if (!primitive.scatters()) {
        return emitted;
      }
    }
    context.vertex.moveTo(surface, primitive.material());
    if (mayDisperse) {
      context.vertex.narrow(throughput);
    }
    context.lift(scene);
    context.listener.vertexReached(hit.shape(), surface, context.vertex.bsdf());
    return shade(branch, number, emitted, sampler, context);
  }

  /**
   * Returns the emitted light and the direct light that a vertex scatters, and pushes the branches
   * that start there.
   */
  private Rgb shade(
      Branch branch, int number, Rgb emitted, Sampler sampler, RenderContext context) {
    Deque<Branch> pending = context.scratch.branches;
    Vertex vertex = context.vertex;
    boolean isSpecular = vertex.bsdf().isSpecular();
    Rgb light =
        isSpecular
            ? emittedBySpecular(emitted, context)
            : direct(vertex, number, emitted, sampler, context);
    int waiting = pending.size();
    int dimension = Sampler.vertex(number);
    if (vertex.bsdf() instanceof Dielectric glass) {
      splitAtGlass(branch, glass, sampler.get1d(dimension + Sampler.LOBE), context, pending);
    } else if (isFollowedAtRandom(vertex.bsdf())) {
      scatterInGlass(branch, sampler, dimension, context, pending);
    } else if (isSpecular) {
      reflect(branch, context, pending);
    }
    if (pending.size() == waiting) {
      context.listener.pathEnded(isSpecular ? End.DEPTH : End.ABSORBED);
    }
    return light;
  }

  /**
   * Returns whether a BSDF is glass that is rough or disperses light, or smooth glass that reflects
   * and refracts only a part of the light.
   */
  private static boolean isFollowedAtRandom(Bsdf bsdf) {
    return bsdf.isBareGlass() || bsdf.isSpecular() && bsdf.choosesLobe();
  }

  private static Rgb emittedBySpecular(Rgb emitted, RenderContext context) {
    if (!emitted.isBlack()) {
      context.listener.lightAdded(emitted.r(), emitted.g(), emitted.b());
    }
    return emitted;
  }

  private Rgb backplate(Rgb light, RenderContext context) {
    context.hitSomething |= isGlassSeen && context.passedGlass;
    reportFound(Source.ENVIRONMENT, -1, light, context);
    context.listener.lightAdded(light.r(), light.g(), light.b());
    context.listener.pathEnded(End.ESCAPED);
    return light;
  }

  private Rgb environment(Vec3 direction, RenderContext context) {
    Rgb light = scene.background(direction);
    if (context.isRecorded()) {
      for (int i = 0; i < scene.environments().size(); i++) {
        Rgb one = scene.environments().get(i).from(direction);
        reportFound(Source.ENVIRONMENT, scene.emitterOfEnvironment(i), one, context);
      }
    }
    context.listener.lightAdded(light.r(), light.g(), light.b());
    context.listener.pathEnded(End.ESCAPED);
    return light;
  }

  private Rgb emission(
      Emission emission, SurfaceHit surface, boolean continues, RenderContext context) {
    Rgb light = emission.towards(surface.wo(), surface.geometricNormal(), surface);
    context.listener.surfaceHit(context.hit, scene);
    reportFound(Source.EMISSION, scene.emitterAt(context.hit), light, context);
    if (!continues) {
      context.listener.lightAdded(light.r(), light.g(), light.b());
      context.listener.pathEnded(End.EMITTER);
    }
    return light;
  }

  private static void reportFound(Source source, int emitter, Rgb light, RenderContext context) {
    double bsdfPdf = source == Source.AMBIENT ? 0 : Double.POSITIVE_INFINITY;
    context.listener.lightFound(source, emitter, light.r(), light.g(), light.b(), 0, bsdfPdf, 1);
  }

  /**
   * Returns the emitted light, and the ambient light and one sample of each light, scattered at the
   * vertex.
   */
  private Rgb direct(
      Vertex vertex, int number, Rgb emitted, Sampler sampler, RenderContext context) {
    Rgb ambient = scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
    if (!ambient.isBlack()) {
      reportFound(Source.AMBIENT, -1, ambient, context);
    }
    double r = emitted.r() + ambient.r();
    double g = emitted.g() + ambient.g();
    double b = emitted.b() + ambient.b();
    for (int i = 0; i < lights.size(); i++) {
      int dimension = Sampler.vertex(number * lights.size() + i) + Sampler.LIGHT_POINT;
      LightSample light = context.scratch.light;
      Vec3 position = vertex.surface().origin();
      Point2 u = sampler.get2d(dimension);
      lights.get(i).sample(position.x(), position.y(), position.z(), u.x(), u.y(), light);
      if (!light.isEmpty()) {
        Rgb arriving = arriving(i, light, vertex, context);
        r += arriving.r();
        g += arriving.g();
        b += arriving.b();
      }
    }
    context.listener.lightAdded(r, g, b);
    return new Rgb(r, g, b);
  }

  /**
   * Returns the light of one light sample that the vertex scatters back along the ray; black if it
   * is blocked.
   *
   * @param number of the light in the scene's list of lights
   */
  private Rgb arriving(int number, LightSample light, Vertex vertex, RenderContext context) {
    BsdfValue value = context.scratch.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    boolean isBlocked = !isBlack && context.isOccluded(scene, vertex.surface());
    if (scene.hasTransparency() && !isBlocked) {
      // The shadow ray has dimmed the light.
      r = value.r() * light.r();
      g = value.g() * light.g();
      b = value.b() * light.b();
    }
    double pdf = light.isDelta() ? 1 : light.pdf();
    int emitter = scene.emitterOfLight(number);
    context.listener.lightSampled(Source.LIGHT, emitter, light, value, pdf, 1, isBlocked);
    boolean arrives = !isBlack && !isBlocked;
    // Single allocation site, so that escape analysis can remove it.
    double weight = light.isDelta() ? 1 : 1 / pdf;
    return new Rgb(arrives ? r * weight : 0, arrives ? g * weight : 0, arrives ? b * weight : 0);
  }

  private void reflect(Branch branch, RenderContext context, Deque<Branch> pending) {
    BsdfSample mirrored = context.scratch.scattered;
    context.vertex.sample(0, .5, .5, mirrored);
    if (branch.reflections() < maxReflections && !mirrored.isAbsorbed()) {
      pending.push(
          new Branch(
              context.vertex.surface().spawn(mirrored.wi()),
              branch.throughput().times(mirrored.weight()),
              branch.reflections() + 1,
              branch.refractions()));
    }
  }

  /**
   * Continues in one random direction: rough glass scatters into a continuum and cannot be split in
   * two.
   */
  private void scatterInGlass(
      Branch branch, Sampler sampler, int dimension, RenderContext context, Deque<Branch> pending) {
    if (branch.refractions() < maxRefractions) {
      BsdfSample either = context.scratch.scattered;
      double uLobe = sampler.get1d(dimension + Sampler.LOBE);
      Point2 u = sampler.get2d(dimension + Sampler.DIRECTION);
      context.vertex.sample(uLobe, u.x(), u.y(), either);
      pushGlass(branch, context.vertex, either.wi(), either.weight(), pending);
    }
  }

  private void splitAtGlass(
      Branch branch, Dielectric glass, double lobe, RenderContext context, Deque<Branch> pending) {
    Vertex vertex = context.vertex;
    if (branch.refractions() >= maxRefractions) {
      return;
    }
    if (branch.refractions() >= MAX_SPLITS) {
      BsdfSample either = context.scratch.scattered;
      vertex.sample(lobe, .5, .5, either);
      pushGlass(branch, vertex, either.wi(), either.weight(), pending);
      return;
    }
    double reflected = glass.reflected(vertex.wo());
    Vec3 mirror = new Vec3(-vertex.wo().x(), -vertex.wo().y(), vertex.wo().z());
    pushGlass(
        branch, vertex, vertex.toWorld(mirror), glass.reflectance().times(reflected), pending);
    if (reflected < 1) {
      pushGlass(
          branch,
          vertex,
          vertex.toWorld(glass.refract(vertex.wo())),
          glass.transmittance().times(1 - reflected),
          pending);
    }
  }

  private void pushGlass(
      Branch branch, Vertex vertex, Vec3 direction, Rgb weight, Deque<Branch> pending) {
    if (!weight.isBlack()) {
      pending.push(
          new Branch(
              vertex.surface().spawn(direction),
              branch.throughput().times(weight),
              branch.reflections(),
              branch.refractions() + 1));
    }
  }
}
