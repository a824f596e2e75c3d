package io.github.lumbre.integrator;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightChoice;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.LightSelector;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Shortcut;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * Follows paths from the camera to the lights: an unbiased estimate of all light of at most a given
 * number of scatterings (Kajiya 1986; PBRT 4e, sec. 13.4).
 *
 * <p>At each vertex one emitter, chosen at random, is asked for light; the scattered ray may meet
 * an emitter as well. Multiple importance sampling weighs the two.
 *
 * <p>What a step does is left open for {@link PathRecorder} to listen to; a program that records
 * nothing never loads that class, and the compiler takes the steps for final.
 */
public sealed class PathTracer implements Integrator permits PathRecorder {
  final Scene scene;
  private final int maxDepth;
  final Light[] emitters;

  /** Which of the emitters are domes: of ten thousand lamps an escaped ray asks none. */
  private final int[] domes;

  private final LightSelector selector;
  private final Strategy strategy;
  private final int firstRoulette;
  private final int split;
  private final boolean hasChoice;
  private final boolean hasAmbient;

  /** Whether vertices ask emitters for light. */
  private final boolean asks;

  /**
   * @param maxDepth how many vertices of a path may scatter, at least 0: with 0 only emitters are
   *     seen, with 1 direct light
   */
  public PathTracer(Scene scene, int maxDepth) {
    this(scene, PathOptions.toDepth(maxDepth));
  }

  /** Makes a path tracer that finds the same light in another way. */
  public PathTracer(Scene scene, PathOptions options) {
    this(scene, options, options.selection().over(scene));
  }

  PathTracer(Scene scene, PathOptions options, LightSelector selector) {
    this.scene = Objects.requireNonNull(scene, "scene");
    maxDepth = options.maxDepth();
    strategy = options.strategy();
    firstRoulette = options.firstRoulette();
    split = options.split();
    hasAmbient = !scene.ambient().isBlack();
    hasChoice = !scene.takes(Shortcut.ONE_EMITTER);
    emitters = scene.emitters().toArray(Light[]::new);
    domes =
        IntStream.range(0, emitters.length)
            .filter(i -> emitters[i] instanceof EnvironmentLight)
            .toArray();
    asks = strategy.asks(scene.emitters());
    this.selector = selector;
  }

  @Override
  public Rgb radiance(Ray ray, Sampler sampler, Scratch scratch) {
    scratch.hit.aim(ray);
    return follow(sampler, scratch);
  }

  @Override
  public Rgb radiance(CameraRay ray, Sampler sampler, Scratch scratch) {
    scratch.hit.aim(
        ray.originX(),
        ray.originY(),
        ray.originZ(),
        ray.directionX(),
        ray.directionY(),
        ray.directionZ(),
        Double.POSITIVE_INFINITY);
    return follow(sampler, scratch);
  }

  /** Follows a path along the ray that {@code scratch.hit} was just aimed by. */
  Rgb follow(Sampler sampler, Scratch scratch) {
    Path path = scratch.path;
    path.begin();
    int depth = 0;
    while (extend(depth, sampler, scratch)) {
      depth++;
    }
    if (path.isSplit()) {
      followWays(sampler, scratch);
    }
    return path.radiance();
  }

  /** Follows all ways in which a path goes on from the vertex where it was split. */
  private void followWays(Sampler sampler, Scratch scratch) {
    Vertex vertex = scratch.keepVertex();
    for (int way = 0; way < split; way++) {
      sampler.startPart(way, split);
      int depth = scratch.path.returnToSplit();
      if (asks && way > 0) {
        // What it meets is weighed against light sampling from here, where the last way left.
        vertex.ask(scratch.choice);
      }
      Point2 uDirection = sampler.get2d(Sampler.vertex(depth) + Sampler.DIRECTION);
      boolean goesOn = scatter(vertex, depth, uDirection.x(), uDirection.y(), sampler, scratch);
      while (goesOn) {
        depth++;
        goesOn = extend(depth, sampler, scratch);
      }
    }
  }

  /**
   * Goes to the next vertex and gathers its light; tells whether the path goes on from there. Where
   * it is to be split, it stays, for {@link #followWays}.
   */
  boolean extend(int depth, Sampler sampler, Scratch scratch) {
    NearestHit hit = scratch.hit;
    Path path = scratch.path;

    // Find the next vertex, or the world's end.
    scratch.rays++;
    if (!scene.intersect(hit)) {
      path.gather(escaped(scratch, hit.direction()));
      return false;
    }
    scratch.metSomething = true;
    Primitive primitive = scene.primitiveAt(hit);
    boolean glows = primitive.emission().isPresent();
    if (depth == maxDepth && !glows) {
      return false;
    }
    SurfaceHit surface = scene.surfaceAt(hit);

    // Add its light; what glows scatters nothing.
    if (glows) {
      Rgb emitted = emitted(primitive.emission().get(), surface);
      double weight = emissionWeight(scene.emitterAt(hit), scratch, surface);
      path.gather(emitted.times(weight));
      return false;
    }

    // Add the light that comes here straight from an emitter.
    Vertex vertex = scratch.vertex;
    vertex.moveTo(surface, primitive.material());
    if (hasAmbient) {
      path.gather(ambient(vertex));
    }
    int dimension = Sampler.vertex(depth);
    boolean isSpecular = vertex.bsdf().isSpecular();
    if (split > 1 && !isSpecular && !path.isSplit()) {
      if (asks) {
        direct(vertex, sampler, dimension, scratch);
      }
      path.split(depth, split);
      return false;
    }
    // Drawn before light is asked for: the processor works on both points at once.
    Point2 uDirection = sampler.get2d(dimension + Sampler.DIRECTION);
    if (asks && !isSpecular) {
      direct(vertex, sampler, dimension, scratch);
    }
    return scatter(vertex, depth, uDirection.x(), uDirection.y(), sampler, scratch);
  }

  /**
   * Chooses where the path goes from a vertex; tells whether it goes on.
   *
   * @param u uniform in [0,1), as v is: they choose the direction
   */
  boolean scatter(Vertex vertex, int depth, double u, double v, Sampler sampler, Scratch scratch) {
    Path path = scratch.path;
    int dimension = Sampler.vertex(depth);
    BsdfSample scattered = scratch.scattered;
    double lobe = vertex.bsdf().choosesLobe() ? sampler.get1d(dimension + Sampler.LOBE) : 0;
    vertex.sample(lobe, new Point2(u, v), scattered);
    if (scattered.isAbsorbed()) {
      return false;
    }
    path.weigh(scattered.r(), scattered.g(), scattered.b());
    SurfaceHit surface = vertex.surface();
    path.leave(scattered.pdf());

    // End weak paths at random, and strengthen those that survive.
    if (depth >= firstRoulette) {
      double survival = Math.min(1, path.throughput());
      if (sampler.get1d(dimension + Sampler.ROULETTE) >= survival) {
        return false;
      }
      path.weigh(1 / survival, 1 / survival, 1 / survival);
    }
    surface.spawn(scattered.x(), scattered.y(), scattered.z(), scratch.hit);
    return true;
  }

  Rgb ambient(Vertex vertex) {
    return scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
  }

  /** Adds the light of one emitter, chosen at random, over the probability of the choice. */
  void direct(Vertex vertex, Sampler sampler, int dimension, Scratch scratch) {
    LightChoice choice = scratch.choice;
    LightSample light = scratch.light;
    vertex.ask(choice);
    if (hasChoice) {
      selector.choose(sampler.get1d(dimension + Sampler.LIGHT_CHOICE), choice);
    } else {
      choice.setOnly();
    }
    light.ask(choice, sampler.get2d(dimension + Sampler.LIGHT_POINT));
    emitters[choice.emitter()].sample(light);
    if (light.isEmpty()) {
      return;
    }
    BsdfValue value = scratch.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    if (isBlack || scratch.isOccluded(scene, vertex.surface())) {
      return;
    }
    double weight = 1 / choice.probability();
    if (!light.isDelta()) {
      double lightPdf = choice.probability() * light.pdf();
      weight = strategy.lightWeight(lightPdf, value.pdf()) / lightPdf;
    }
    arrive(scratch.path, r * weight, g * weight, b * weight);
  }

  /** Adds light that arrives at a vertex from an emitter. */
  void arrive(Path path, double r, double g, double b) {
    path.gather(r, g, b);
  }

  static Rgb emitted(Emission emission, SurfaceHit surface) {
    return emission.towards(surface.wo(), surface.geometricNormal(), surface.texture());
  }

  /** Returns the share of a scattered ray, against light sampling, in meeting an emitter. */
  double emissionWeight(int emitter, Scratch scratch, SurfaceHit surface) {
    double pdf = scratch.path.pdf();
    if (emitter < 0 || pdf == Double.POSITIVE_INFINITY || !asks) {
      return 1;
    }
    Shape shape = ((AreaLight) emitters[emitter]).shape();
    double lightPdf = lightPdf(emitter, scratch, shape.pdf(scratch.choice.point(), surface));
    return strategy.bsdfWeight(pdf, lightPdf);
  }

  /**
   * Returns the density with which light sampling would have gone where the path went: from the
   * vertex that asked for light last, since a path can have left any other only by a delta lobe.
   */
  double lightPdf(int emitter, Scratch scratch, double pdfOfEmitter) {
    return hasChoice ? selector.probability(scratch.choice, emitter) * pdfOfEmitter : pdfOfEmitter;
  }

  /** Returns the light from beyond everything, each dome with its own share. */
  Rgb escaped(Scratch scratch, Vec3 direction) {
    double pdf = scratch.path.pdf();
    boolean isWeighed = asks && pdf != Double.POSITIVE_INFINITY;
    double r = 0;
    double g = 0;
    double b = 0;
    for (int emitter : domes) {
      EnvironmentLight dome = (EnvironmentLight) emitters[emitter];
      double weight =
          isWeighed ? strategy.bsdfWeight(pdf, lightPdf(emitter, scratch, dome.pdf(direction))) : 1;
      Rgb light = dome.from(direction);
      r += light.r() * weight;
      g += light.g() * weight;
      b += light.b() * weight;
    }
    return new Rgb(r, g, b);
  }
}
