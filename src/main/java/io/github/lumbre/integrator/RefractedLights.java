package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.guiding.Guide;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Dielectric;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.path.PathVertex.Source;
import io.github.lumbre.sampling.Sampler;
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
final class RefractedLights {
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

  private final Scene scene;
  private final MisHeuristic heuristic;
  private final Guide guide;

  /** The clear glass of each primitive that refracts; null for all others. */
  private final Dielectric[] glass;

  /** The bounds of all clear glass. */
  private final Bounds3 bounds;

  private RefractedLights(
      Scene scene, MisHeuristic heuristic, Guide guide, Dielectric[] glass, Bounds3 bounds) {
    this.scene = scene;
    this.heuristic = heuristic;
    this.guide = guide;
    this.glass = glass;
    this.bounds = bounds;
  }

  /**
   * Returns the lamps that are seen through a scene's clear glass; empty if there is none, or rays
   * pass straight through other surfaces.
   *
   * @param heuristic weights scattered rays and samples of refracted light
   * @param guide the one that scattered rays follow
   */
  static Optional<RefractedLights> of(Scene scene, MisHeuristic heuristic, Guide guide) {
    List<Primitive> primitives = scene.primitives();
    Dielectric[] glass = new Dielectric[primitives.size()];
    Bounds3 bounds = Bounds3.EMPTY;
    for (int i = 0; i < glass.length; i++) {
      Primitive primitive = primitives.get(i);
      Optional<Dielectric> clear = primitive.material().clearGlass();
      if (clear.isPresent() && primitive.emission().isEmpty()) {
        glass[i] = clear.get();
        bounds = bounds.union(primitive.shape().bounds());
      }
    }
    return bounds.isEmpty() || Passing.isNeeded(scene)
        ? Optional.empty()
        : Optional.of(new RefractedLights(scene, heuristic, guide, glass, bounds));
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
   * Adds the refracted light of the lamp that was sampled last at a vertex, but not at each vertex.
   *
   * @param depth number of the vertex
   * @param maxDepth the largest number of scattering vertices of a path
   */
  void addRefracted(
      Vertex vertex, int depth, int maxDepth, Sampler sampler, RenderContext context) {
    LightSample light = context.light;
    if (light.target() != LightSample.Target.SURFACE) {
      return;
    }
    double probability = probability(context.path.throughput());
    if (bounds.meets(vertex.surface().origin(), light.surface().position())
        && sampler.get1d(Sampler.glass(depth)) < probability) {
      search(vertex, depth, maxDepth, probability, context);
    }
  }

  /** Searches for the path to the lamp, and adds its light if there is one. */
  private void search(
      Vertex vertex, int depth, int maxDepth, double probability, RenderContext context) {
    LightSample light = context.light;
    SurfaceSample onLight = light.surface();
    Vec3 to = onLight.position();
    GlassPath found = context.glassPath;
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
    BsdfValue value = context.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    boolean isBlocked = !isBlack && context.isOccluded(scene, found.lastSurface());
    if (vertex.isGuided()) {
      value.mix(Guiding.pdf(guide, vertex.cell(), light.wi(), value.pdf()));
    }
    value.scalePdf(found.passProbability());
    double misWeight = heuristic.lightWeight(refractedPdf, value.pdf());
    if (context.isRecorded) {
      context.listener.lightSampled(
          Source.REFRACTION,
          context.choice.emitter(),
          light,
          value,
          refractedPdf,
          misWeight,
          isBlocked);
    }
    if (!isBlack && !isBlocked) {
      double weight = misWeight / refractedPdf;
      context.add(r * weight, g * weight, b * weight);
    }
  }

  /**
   * Returns the density per solid angle, at the vertex that the path left, with which {@link
   * #addRefracted} draws the path to a light.
   *
   * @param link a path that {@linkplain SpecularLink#isRefracted is refracted}
   * @param hit where the path meets the light
   * @param pdf density, at the vertex, of the straight direction there
   */
  double pdf(SpecularLink link, SurfaceHit hit, double pdf, RenderContext context) {
    GlassPath found = context.glassPath;
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
      if (!found.trace(scene, glass, origin, direction, to, axis)) {
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
   * that a beam covers on the lamp, relative to that of straight rays. 0 if the lamp shows both
   * another side.
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
