package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfacePatch;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.guiding.Guide;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Dielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.path.PathVertex.Source;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.util.List;
import java.util.Optional;

/**
 * The lamps that surfaces see through a single refracting surface, such as that of water. A shadow
 * ray to a lamp ends there. From the hit, a search along the surface finds a point that refracts
 * the same point of the lamp to the vertex. Multiple importance sampling weights this way with
 * scattered rays, which also find the light that the search misses. It is manifold next-event
 * estimation (Hanika, Droske and Fascione 2015) through one surface. Immutable.
 *
 * <p>Surfaces that enclose a volume, such as those of a wine glass, are left out: light passes two
 * of them.
 */
final class RefractedLights {
  /** The largest number of patches of a surface that one search visits. */
  private static final int MOST_PATCHES = 8;

  /** Distance of points, relative to the path's length, that count as the same. */
  private static final double SAME = 1e-6;

  private final Scene scene;
  private final MisHeuristic heuristic;
  private final Guide guide;

  /** The clear glass of each primitive that refracts; null for all others. */
  private final Dielectric[] glass;

  private RefractedLights(
      Scene scene, MisHeuristic heuristic, Guide guide, Dielectric[] glass) {
    this.scene = scene;
    this.heuristic = heuristic;
    this.guide = guide;
    this.glass = glass;
  }

  /**
   * Returns the lamps that are seen through a scene's refracting surfaces; empty if there are no
   * such surfaces, or rays pass straight through others.
   *
   * @param heuristic weights scattered rays and samples of refracted light
   * @param guide the one that scattered rays follow
   */
  static Optional<RefractedLights> of(Scene scene, MisHeuristic heuristic, Guide guide) {
    List<Primitive> primitives = scene.primitives();
    Dielectric[] glass = new Dielectric[primitives.size()];
    boolean isFound = false;
    for (int i = 0; i < glass.length; i++) {
      Primitive primitive = primitives.get(i);
      Optional<Dielectric> clear = primitive.material().clearGlass();
      if (clear.isPresent() && primitive.emission().isEmpty() && !primitive.shape().isClosed()) {
        glass[i] = clear.get();
        isFound = true;
      }
    }
    return isFound && !Passing.isNeeded(scene)
        ? Optional.of(new RefractedLights(scene, heuristic, guide, glass))
        : Optional.empty();
  }

  /** A refraction that was found. Mutable; each thread reuses one instance. */
  static final class Refraction {
    private final NearestHit probe = new NearestHit();
    private Vec3 point = Vec3.ZERO;
    private Vec3 direction = Vec3.ZERO;

    /** Local direction from the surface to the vertex; only its z is used. */
    private Vec3 wo = Vec3.Z;

    private Dielectric glass = new Dielectric(Rgb.WHITE, Rgb.WHITE, 1);

    /** The beam's solid angle at the vertex per solid angle of the straight direction. */
    private double narrowing;
  }

  /**
   * Adds the refracted light of the lamp that was sampled last at a vertex.
   *
   * @param pdf density, per solid angle, of the straight direction to the lamp's point
   * @param emitter index of the lamp
   */
  void addRefracted(Vertex vertex, double pdf, int emitter, RenderContext context) {
    LightSample light = context.light;
    if (light.target() != LightSample.Target.SURFACE) {
      return;
    }
    SurfaceSample onLight = light.surface();
    Refraction found = context.refraction;
    vertex.surface().spawnTowards(onLight.position(), found.probe);
    Vec3 origin = found.probe.origin();
    if (!find(origin, vertex.facing(), onLight.position(), onLight.normal(), found)) {
      return;
    }
    double refractedPdf = pdf / found.narrowing;
    if (!(refractedPdf > 0 && refractedPdf < Double.POSITIVE_INFINITY)) {
      return;
    }
    light.redirect(found.direction, found.glass.passed(found.wo), refractedPdf);
    BsdfValue value = context.value;
    vertex.evaluate(light, value);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    SurfaceHit surface = scene.surfaceAt(found.probe);
    boolean isBlocked = !isBlack && context.isOccluded(scene, surface);
    double bsdfPdf = value.pdf();
    if (vertex.isGuided()) {
      bsdfPdf = Guiding.pdf(guide, vertex.cell(), light.wi(), bsdfPdf);
    }
    value.setPdf(bsdfPdf * found.glass.passProbability(found.wo));
    double misWeight = heuristic.lightWeight(refractedPdf, value.pdf());
    if (context.isRecorded) {
      context.listener.lightSampled(
          Source.REFRACTION, emitter, light, value, refractedPdf, misWeight, isBlocked);
    }
    if (!isBlack && !isBlocked) {
      double weight = misWeight / refractedPdf;
      context.add(r * weight, g * weight, b * weight);
    }
  }

  /** Returns whether the path's only specular surface is one that lamps are sampled through. */
  boolean isMet(SpecularLink link) {
    return link.isSingle() && link.isRefracted() && glass[link.primitive()] != null;
  }

  /** Returns the density with which scattered rays draw a path by way of such a surface. */
  double scatteredPdf(SpecularLink link) {
    Vec3 wo = new Vec3(0, 0, link.cosine());
    return link.pdf() * glass[link.primitive()].passProbability(wo);
  }

  /**
   * Returns the density per solid angle, at the vertex that the path left, with which {@link
   * #addRefracted} draws the path to a light.
   *
   * @param hit where the path meets the light
   * @param pdf density, at the vertex, of the straight direction there
   */
  double pdf(SpecularLink link, SurfaceHit hit, double pdf, Refraction found) {
    boolean isFound =
        pdf > 0
            && find(link.origin(), link.facing(), hit.position(), hit.geometricNormal(), found)
            && found.probe.shape() == link.primitive();
    if (!isFound) {
      return 0;
    }
    double length = hit.position().minus(link.origin()).length();
    boolean isSame = found.point.minus(link.point()).length() <= SAME * length;
    double result = pdf / found.narrowing;
    return isSame && result < Double.POSITIVE_INFINITY ? result : 0;
  }

  /**
   * Searches for a point of a refracting surface that lets light pass from one point to another,
   * from the place on where the straight line between them meets the surface.
   *
   * @param origin where rays from the vertex start
   * @param facing the side of the vertex that receives light
   * @param to the point on a light
   * @param lightNormal unit normal of the light there
   */
  private boolean find(Vec3 origin, Vec3 facing, Vec3 to, Vec3 lightNormal, Refraction found) {
    NearestHit probe = found.probe;
    Vec3 straight = to.minus(origin);
    if (facing.dot(straight) < 0) {
      return false;
    }
    aim(origin, straight, 1, probe);
    if (!scene.intersect(probe) || glass[probe.shape()] == null) {
      return false;
    }
    int primitive = probe.shape();
    for (int visited = 0; visited < MOST_PATCHES; visited++) {
      int element = probe.element();
      Optional<SurfacePatch> patch = scene.primitiveAt(probe).shape().patchAt(probe);
      if (patch.isEmpty()) {
        return false;
      }
      Vec3 normal = patch.get().normal();
      double side = normal.dot(origin.minus(patch.get().origin()));
      double eta = glass[primitive].eta(new Vec3(0, 0, side));
      Optional<Point2> solution = patch.get().refraction(origin, to, eta);
      if (solution.isEmpty()) {
        return false;
      }
      Vec3 point = patch.get().at(solution.get());
      aim(origin, point.minus(origin).normalized(), Double.POSITIVE_INFINITY, probe);
      if (!scene.intersect(probe) || probe.shape() != primitive) {
        return false;
      }
      if (probe.element() == element) {
        return set(patch.get(), solution.get(), origin, to, eta, lightNormal, found);
      }
    }
    return false;
  }

  private static void aim(Vec3 origin, Vec3 direction, double end, NearestHit probe) {
    probe.aim(
        origin.x(),
        origin.y(),
        origin.z(),
        direction.x(),
        direction.y(),
        direction.z(),
        end);
  }

  private boolean set(
      SurfacePatch patch,
      Point2 solution,
      Vec3 origin,
      Vec3 to,
      double eta,
      Vec3 lightNormal,
      Refraction found) {
    Vec3 point = patch.at(solution);
    Vec3 straight = to.minus(origin);
    Vec3 way = point.minus(origin);
    // The lamp must show both its points of view the same side.
    if (!(lightNormal.dot(straight) * lightNormal.dot(to.minus(point)) > 0)) {
      return false;
    }
    double distance = straight.length();
    double slant = Math.abs(lightNormal.dot(straight)) / distance;
    found.point = point;
    found.direction = way.normalized();
    found.wo = new Vec3(0, 0, -found.direction.dot(patch.normalAt(solution)));
    found.glass = glass[found.probe.shape()];
    found.narrowing =
        patch.solidAngle(origin, to, eta, solution, lightNormal) * distance * distance / slant;
    return found.narrowing > 0;
  }
}
