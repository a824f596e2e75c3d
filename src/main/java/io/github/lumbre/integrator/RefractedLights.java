package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.List;
import java.util.Optional;

/**
 * The lamps that surfaces see through clear glass, such as a window, the surface of water or a wine
 * glass. A shadow ray to a lamp ends at the glass. A search varies its direction until the
 * refracted ray meets the same point of the lamp. Multiple importance sampling weights this way
 * with scattered rays, which also find the light that the search misses. It is manifold next-event
 * estimation (Hanika, Droske and Fascione 2015) for refraction. Immutable.
 */
final class RefractedLights implements LightTechnique {
  /**
   * The largest probability of a search. Measured: it takes less time to an error than 1/2 or 1.
   */
  private static final double MOST_SEARCHES = .25;

  /** The largest number of rays through the glass that one search traces. */
  private static final int MOST_RAYS = 8;

  /** Distance from the lamp's point, relative to that of the vertex, that ends the search. */
  private static final double CONVERGED = 1e-7;

  /** Difference of two directions that count as the same. */
  private static final double SAME = 1e-5;

  private final LightSampling shared;
  private final int maxDepth;

  /** The clear glass of each primitive that refracts; null for all others. */
  private final Dielectric[] glass;

  /** The bounds of all clear glass. */
  private final Bounds3 bounds;

  private RefractedLights(LightSampling shared, Dielectric[] glass, Bounds3 bounds) {
    this.shared = shared;
    maxDepth = shared.options.maxDepth();
    this.glass = glass;
    this.bounds = bounds;
  }

  /**
   * Returns the lamps that are seen through a scene's clear glass; empty if there is none, or rays
   * pass straight through other surfaces.
   */
  static Optional<RefractedLights> of(LightSampling shared) {
    if (!shared.options.bySpecular()) {
      return Optional.empty();
    }
    Scene scene = shared.scene;
    List<Primitive> primitives = scene.primitives();
    Dielectric[] glass = new Dielectric[primitives.size()];
    Bounds3 bounds = Bounds3.EMPTY;
    for (int i = 0; i < glass.length; i++) {
      Primitive primitive = primitives.get(i);
      Optional<Dielectric> clear = Dielectric.of(primitive.material());
      if (clear.isPresent() && primitive.emission().isEmpty()) {
        glass[i] = clear.get();
        bounds = bounds.union(primitive.shape().bounds());
      }
    }
    return bounds.isEmpty() || Passing.isNeeded(scene)
        ? Optional.empty()
        : Optional.of(new RefractedLights(shared, glass, bounds));
  }

  /**
   * Returns the probability with which a vertex samples light through glass. A search takes as long
   * as many rays, so that the vertices of weak paths search more rarely.
   *
   * @param throughput the path's at the vertex, its largest component
   */
  static double probability(double throughput) {
    return MOST_SEARCHES * Math.min(1, throughput);
  }

  /**
   * Adds the refracted light of the lamp that {@link DirectLights} sampled and something blocks,
   * but not at each vertex.
   */
  @Override
  public void add(int depth, Sampler sampler, RenderContext context) {
    LightSample light = context.scratch.light;
    if (depth + 2 > maxDepth
        || !context.scratch.isLightMissed
        || light.target() != LightSample.Target.SURFACE) {
      return;
    }
    Vertex vertex = context.vertex;
    double probability = probability(context.path.throughput());
    if (bounds.meets(vertex.surface().origin(), light.surface().position())
        && sampler.get1d(Sampler.glass(depth)) < probability) {
      search(vertex, depth, probability, context);
    }
  }

  /** Searches for the path to the lamp, and adds its light if there is one. */
  private void search(Vertex vertex, int depth, double probability, RenderContext context) {
    LightSample light = context.scratch.light;
    SurfaceSample onLight = light.surface();
    Vec3 to = onLight.position();
    GlassPath found = context.scratch.glassPath;
    Vec3 origin = vertex.surface().spawn(light.wi()).origin();
    boolean isFound = find(origin, vertex.facing(), to, found);
    context.countSearch();
    if (!isFound || depth + 1 + found.surfaces() > maxDepth) {
      return;
    }
    double pdf = probability * context.choice.probability() * light.pdf();
    double refractedPdf = pdf * widening(origin, to, onLight.normal(), found);
    if (!(refractedPdf > 0 && refractedPdf < Double.POSITIVE_INFINITY)) {
      return;
    }
    light.redirect(found.first(), found.passed(), refractedPdf);
    BsdfValue value = context.scratch.value;
    vertex.evaluate(light, value);
    boolean isBlocked =
        !LightSampling.isBlack(context) && context.isOccluded(shared.scene, found.lastSurface());
    shared.directions.weigh(vertex, light, value);
    value.scalePdf(found.passProbability());
    double misWeight = shared.heuristic.lightWeight(refractedPdf, value.pdf());
    int emitter = context.choice.emitter();
    LightSampling.add(Source.REFRACTION, emitter, refractedPdf, misWeight, isBlocked, context);
  }

  @Override
  public boolean mightFind(int depth, RenderContext context) {
    return context.link.isRefracted();
  }

  @Override
  public double rayPdf(RenderContext context) {
    return context.link.pdf() * context.link.passProbability();
  }

  @Override
  public double pdf(int emitter, SurfaceHit hit, RenderContext context) {
    SpecularLink link = context.link;
    // The density, at the vertex, of the straight direction to the light.
    double pdf =
        shared.probability(context.choice, emitter)
            * shared.emitters[emitter].pdf(context.choice.point(), hit);
    GlassPath found = context.scratch.glassPath;
    Vec3 to = hit.position();
    boolean isSame =
        pdf > 0
            && link.surfaces() <= GlassPath.MOST_SURFACES
            && find(link.origin(), link.facing(), to, found)
            && found.first().minus(link.direction()).length() <= SAME;
    context.countSearch();
    if (!isSame) {
      return 0;
    }
    double result =
        probability(link.throughput())
            * pdf
            * widening(link.origin(), to, hit.geometricNormal(), found);
    return result < Double.POSITIVE_INFINITY ? result : 0;
  }

  /**
   * Searches for a direction in which glass refracts light from one point to another, from the
   * straight direction on, by Newton's method.
   *
   * @param origin where rays from the vertex start
   * @param facing the side of the vertex that receives light
   * @param to the point on a light
   */
  private boolean find(Vec3 origin, Vec3 facing, Vec3 to, GlassPath found) {
    Vec3 straight = to.minus(origin);
    double distance = straight.length();
    Vec3 axis = straight.times(1 / distance);
    if (facing.dot(axis) < 0) {
      return false;
    }
    Vec3 direction = axis;
    for (int ray = 0; ray < MOST_RAYS; ray++) {
      if (!found.trace(shared.scene, glass, origin, direction, to, axis)) {
        return false;
      }
      Vec3 miss = to.minus(found.end());
      if (miss.length() <= CONVERGED * distance) {
        return true;
      }
      direction = found.turned(miss, axis);
    }
    return false;
  }

  /**
   * Returns the density of the direction that was found, per density of the straight one: the area
   * that a beam covers on the light, relative to the area that straight rays cover. 0 if refracted
   * and straight rays meet different sides of the light.
   */
  private static double widening(Vec3 origin, Vec3 to, Vec3 lightNormal, GlassPath found) {
    Vec3 straight = to.minus(origin);
    double distance = straight.length();
    Vec3 axis = straight.times(1 / distance);
    double slant = lightNormal.dot(axis);
    double refractedSlant = lightNormal.dot(found.last());
    if (!(slant * refractedSlant > 0)) {
      return 0;
    }
    double area = found.spread(axis) * found.last().dot(axis) / refractedSlant;
    return area * slant / (distance * distance);
  }
}
