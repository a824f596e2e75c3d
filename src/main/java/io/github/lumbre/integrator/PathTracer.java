package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.LightSelector;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Mis;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Follows paths from the camera to the lights: an unbiased estimate of all light of at most a given
 * number of scatterings (Kajiya 1986; PBRT 4e, sec. 13.4).
 *
 * <p>At each vertex one emitter, chosen at random, is asked for light; the scattered ray may meet
 * an emitter as well. Multiple importance sampling weighs the two.
 */
public final class PathTracer implements Integrator {
  /** Which of the two ways to find an emitter counts. All have the same mean. */
  enum Strategy {
    /** Both, by multiple importance sampling. */
    BOTH {
      @Override
      double lightWeight(double lightPdf, double bsdfPdf) {
        return Mis.power(lightPdf, bsdfPdf);
      }

      @Override
      double bsdfWeight(double bsdfPdf, double lightPdf) {
        return Mis.power(bsdfPdf, lightPdf);
      }
    },
    /** Light sampling alone, where it is possible. */
    LIGHT {
      @Override
      double lightWeight(double lightPdf, double bsdfPdf) {
        return 1;
      }

      @Override
      double bsdfWeight(double bsdfPdf, double lightPdf) {
        return lightPdf > 0 ? 0 : 1;
      }
    },
    /** Scattered rays that meet an emitter alone; lights of no size are sampled all the same. */
    BSDF {
      @Override
      double lightWeight(double lightPdf, double bsdfPdf) {
        return 0;
      }

      @Override
      double bsdfWeight(double bsdfPdf, double lightPdf) {
        return 1;
      }
    };

    abstract double lightWeight(double lightPdf, double bsdfPdf);

    abstract double bsdfWeight(double bsdfPdf, double lightPdf);
  }

  /** The first vertex at which a path may end at random. */
  private static final int FIRST_ROULETTE = 3;

  private final Scene scene;
  private final int maxDepth;
  private final Light[] emitters;

  /** Which of the emitters are domes: of ten thousand lamps an escaped ray asks none. */
  private final int[] domes;

  private final LightSelector selector;
  private final Strategy strategy;

  /**
   * @param maxDepth how many vertices of a path may scatter, at least 0: with 0 only emitters are
   *     seen, with 1 direct light
   */
  public PathTracer(Scene scene, int maxDepth) {
    this(scene, maxDepth, Strategy.BOTH);
  }

  PathTracer(Scene scene, int maxDepth, Strategy strategy) {
    this(scene, maxDepth, strategy, LightSelector.over(scene.emitters(), scene.radius()));
  }

  PathTracer(Scene scene, int maxDepth, Strategy strategy, LightSelector selector) {
    this.scene = Objects.requireNonNull(scene, "scene");
    this.maxDepth = maxDepth;
    this.strategy = strategy;
    emitters = scene.emitters().toArray(Light[]::new);
    domes =
        IntStream.range(0, emitters.length)
            .filter(i -> emitters[i] instanceof EnvironmentLight)
            .toArray();
    this.selector = selector;
  }

  @Override
  public Rgb radiance(Ray cameraRay, Sampler sampler, Scratch scratch) {
    NearestHit hit = scratch.hit;
    Rgb radiance = Rgb.BLACK;
    Rgb throughput = Rgb.WHITE;
    Ray ray = cameraRay;
    // Density of the ray's direction: infinite if light sampling could not have drawn it.
    double pdf = Double.POSITIVE_INFINITY;
    Vec3 from = cameraRay.origin();
    Vec3 facing = Vec3.ZERO;

    for (int depth = 0; ; depth++) {
      // Find the next vertex, or the world's end.
      scratch.rays++;
      if (!scene.intersect(ray, hit)) {
        return radiance.plus(throughput.times(escaped(ray.direction(), from, facing, pdf)));
      }
      scratch.metSomething = true;
      SurfaceHit surface = scene.surfaceAt(ray, hit);
      Primitive primitive = scene.primitiveAt(hit);

      // Add its light; what glows scatters nothing.
      if (primitive.emission().isPresent()) {
        Rgb emitted = emitted(primitive.emission().get(), surface);
        double weight = emissionWeight(scene.emitterAt(hit), from, facing, surface, pdf);
        return radiance.plus(throughput.times(emitted.times(weight)));
      }
      if (depth == maxDepth) {
        return radiance;
      }

      // Add the light that comes here straight from an emitter.
      Vertex vertex = Vertex.at(surface, primitive.material());
      int dimension = Sampler.vertex(depth);
      radiance = radiance.plus(throughput.times(ambient(vertex)));
      if (!vertex.bsdf().isSpecular() && emitters.length > 0) {
        radiance = radiance.plus(throughput.times(direct(vertex, sampler, dimension, scratch)));
      }

      // Scatter.
      BsdfSample scattered =
          vertex.sample(
              sampler.get1d(dimension + Sampler.LOBE),
              sampler.get2d(dimension + Sampler.DIRECTION));
      if (scattered.weight().isBlack()) {
        return radiance;
      }
      throughput = throughput.times(scattered.weight());
      pdf = scattered.pdf();
      from = surface.position();
      facing = vertex.facing();
      ray = surface.spawn(scattered.wi());

      // End weak paths at random, and strengthen those that survive.
      if (depth >= FIRST_ROULETTE) {
        double survival = Math.min(1, throughput.max());
        if (sampler.get1d(dimension + Sampler.ROULETTE) >= survival) {
          return radiance;
        }
        throughput = throughput.times(1 / survival);
      }
    }
  }

  private Rgb ambient(Vertex vertex) {
    return scene.ambient().isBlack()
        ? Rgb.BLACK
        : scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
  }

  /** Returns the light of one emitter, chosen at random, over the probability of the choice. */
  private Rgb direct(Vertex vertex, Sampler sampler, int dimension, Scratch scratch) {
    Vec3 position = vertex.surface().position();
    LightSelector.Choice choice =
        selector.choose(position, vertex.facing(), sampler.get1d(dimension + Sampler.LIGHT_CHOICE));
    Optional<LightSample> drawn =
        emitters[choice.emitter()].sample(position, sampler.get2d(dimension + Sampler.LIGHT_POINT));
    if (drawn.isEmpty()) {
      return Rgb.BLACK;
    }
    LightSample light = drawn.get();
    Rgb scattered = vertex.eval(light.wi()).times(light.radiance());
    if (scattered.isBlack() || scratch.isOccluded(scene, light.shadowRay(vertex.surface()))) {
      return Rgb.BLACK;
    }
    if (light.isDelta()) {
      return scattered.times(1 / choice.probability());
    }
    double lightPdf = choice.probability() * light.pdf();
    return scattered.times(strategy.lightWeight(lightPdf, vertex.pdf(light.wi())) / lightPdf);
  }

  private static Rgb emitted(Emission emission, SurfaceHit surface) {
    return emission.towards(surface.wo(), surface.geometricNormal(), surface.texture());
  }

  /** Returns the share of a scattered ray, against light sampling, in meeting an emitter. */
  private double emissionWeight(
      int emitter, Vec3 from, Vec3 facing, SurfaceHit surface, double pdf) {
    if (emitter < 0 || pdf == Double.POSITIVE_INFINITY) {
      return 1;
    }
    AreaLight light = (AreaLight) emitters[emitter];
    return strategy.bsdfWeight(
        pdf, selector.probability(from, facing, emitter) * light.shape().pdf(from, surface));
  }

  /** Returns the light from beyond everything, each dome with its own share. */
  private Rgb escaped(Vec3 direction, Vec3 from, Vec3 facing, double pdf) {
    if (pdf == Double.POSITIVE_INFINITY) {
      return scene.background(direction);
    }
    Rgb sum = Rgb.BLACK;
    for (int i : domes) {
      EnvironmentLight dome = (EnvironmentLight) emitters[i];
      double lightPdf = selector.probability(from, facing, i) * dome.pdf(direction);
      sum = sum.plus(dome.from(direction).times(strategy.bsdfWeight(pdf, lightPdf)));
    }
    return sum;
  }
}
