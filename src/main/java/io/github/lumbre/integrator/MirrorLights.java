package io.github.lumbre.integrator;

import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.geometry.internal.SphereMirror;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The lamps that surfaces see in mirrors that are spheres. The reflection of a lamp in a sphere is
 * small, so that few scattered rays meet it. Surfaces therefore also sample it: a point of the
 * lamp, sampled from the sphere's center, has at most one reflection. Multiple importance sampling
 * weights both ways, with densities per solid angle at the surface (Veach 1997, ch. 9). It is
 * manifold next-event estimation (Hanika et al. 2015) where the only solution is known. Immutable.
 */
final class MirrorLights implements LightTechnique {
  /** The largest number of mirrors; smaller spheres are left to scattered rays. */
  private static final int MOST_MIRRORS = 16;

  /** Rounding of a point of a sphere, relative to the largest coordinate. */
  private static final double ROUNDING = 64 * 0x1p-52;

  /**
   * How often a reflection is sampled, relative to the sine of the angle from a mirror's center to
   * its border. Measured: it takes less time to an error than 1 or 1/4.
   */
  private static final double SHARE = .5;

  private static final TexturePoint NO_TEXTURE = new TexturePoint(0, 0);
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  private final LightSampling shared;
  private final SphereMirror[] mirrors;
  private final Rgb[] reflectances;

  /** The index among the mirrors of each primitive; -1 if it is none. */
  private final int[] mirrorOfPrimitive;

  private MirrorLights(LightSampling shared, List<Mirror> found) {
    this.shared = shared;
    mirrors = found.stream().map(Mirror::sphere).toArray(SphereMirror[]::new);
    reflectances = found.stream().map(Mirror::reflectance).toArray(Rgb[]::new);
    mirrorOfPrimitive = new int[shared.scene.primitives().size()];
    Arrays.fill(mirrorOfPrimitive, -1);
    for (int i = 0; i < found.size(); i++) {
      mirrorOfPrimitive[found.get(i).primitive] = i;
    }
  }

  private record Mirror(int primitive, SphereMirror sphere, Rgb reflectance) {
    static Optional<Mirror> of(int number, Primitive primitive) {
      if (primitive.emission().isPresent() || !(primitive.shape() instanceof Sphere sphere)) {
        return Optional.empty();
      }
      return primitive
          .material()
          .mirrorReflectance()
          .filter(reflectance -> !reflectance.isBlack())
          .flatMap(r -> SphereMirror.of(sphere).map(mirror -> new Mirror(number, mirror, r)));
    }
  }

  /**
   * Returns the lamps that are sampled in a scene's mirrors; empty if there are no lamps or no
   * mirrors, or rays pass through surfaces.
   */
  static Optional<MirrorLights> of(LightSampling shared) {
    Scene scene = shared.scene;
    if (!shared.options.bySpecular()
        || Arrays.stream(shared.emitters).noneMatch(AreaLight.class::isInstance)
        || Passing.isNeeded(scene)) {
      return Optional.empty();
    }
    List<Mirror> found = new ArrayList<>();
    for (int i = 0; i < scene.primitives().size(); i++) {
      Mirror.of(i, scene.primitives().get(i)).ifPresent(found::add);
    }
    if (found.isEmpty()) {
      return Optional.empty();
    }
    found.sort(Comparator.comparingDouble((Mirror mirror) -> mirror.sphere.radius()).reversed());
    List<Mirror> largest = found.subList(0, Math.min(MOST_MIRRORS, found.size()));
    return Optional.of(new MirrorLights(shared, largest));
  }

  /** A reflection that is sampled. Mutable; each thread reuses one instance. */
  static final class Reflection {
    private final double[] weights = new double[MOST_MIRRORS];
    private final LightChoice choice = new LightChoice();

    /** The reflection, and where a ray from it to the light starts. */
    private final SurfaceSample point = new SurfaceSample();

    private Vec3 above = Vec3.ZERO;
  }

  /**
   * Samples the reflection of one light in one mirror, and adds its light that a vertex scatters.
   */
  @Override
  public void add(int depth, Sampler sampler, RenderContext context) {
    Vertex vertex = context.vertex;
    Reflection reflection = context.scratch.reflection;
    LightSample light = context.scratch.light;
    if (depth + 2 > shared.options.maxDepth()
        || !sample(sampler, Sampler.mirror(depth), vertex, reflection, light)) {
      return;
    }
    BsdfValue value = context.scratch.value;
    vertex.evaluate(light, value);
    boolean isBlocked =
        !LightSampling.isBlack(context)
            && (context.isOccluded(shared.scene, vertex.surface(), reflection.point)
                || context.isOccluded(shared.scene, reflection.above));
    shared.directions.weigh(vertex, light, value);
    double misWeight = shared.heuristic.lightWeight(light.pdf(), value.pdf());
    int emitter = reflection.choice.emitter();
    LightSampling.add(Source.MIRROR, emitter, light.pdf(), misWeight, isBlocked, context);
  }

  /**
   * Samples the reflection of a light.
   *
   * @param dimension that of the number which selects the mirror and the light
   * @param light receives the reflected light, as it arrives at the vertex
   * @return whether there is a reflection
   */
  private boolean sample(
      Sampler sampler, int dimension, Vertex vertex, Reflection reflection, LightSample light) {
    Vec3 from = vertex.surface().origin();
    double[] weights = reflection.weights;
    double most = Math.max(1, weigh(from, vertex.facing(), weights));
    double rest = sampler.get1d(dimension) * most;
    int chosen = 0;
    while (chosen < mirrors.length && rest >= weights[chosen]) {
      rest -= weights[chosen];
      chosen++;
    }
    if (chosen == mirrors.length) {
      return false;
    }
    LightChoice choice = reflection.choice;
    choice.moveTo(mirrors[chosen].center(), Vec3.ZERO);
    shared.select(Math.min(rest / weights[chosen], BELOW_ONE), choice);
    if (!(shared.emitters[choice.emitter()] instanceof AreaLight lamp)) {
      return false;
    }
    Point2 onLight = sampler.get2d(dimension + 1);
    lamp.sample(choice.x(), choice.y(), choice.z(), onLight.x(), onLight.y(), light);
    double probability = weights[chosen] / most * choice.probability();
    return !light.isEmpty() && reflect(from, chosen, probability, reflection, light);
  }

  /** Replaces light that arrives at the center of a mirror by its reflection seen from a point. */
  private boolean reflect(
      Vec3 from, int chosen, double probability, Reflection reflection, LightSample light) {
    SphereMirror mirror = mirrors[chosen];
    SurfaceSample onLight = light.surface();
    Vec3 to = onLight.position();
    Vec3 normal = mirror.normalBetween(from, to);
    if (normal.equals(Vec3.ZERO)) {
      return false;
    }
    Vec3 at = mirror.center().plus(mirror.radius(), normal);
    double pdf = probability * light.pdf() * density(mirror, from, at, to, onLight.normal());
    if (!(pdf > 0)) {
      return false;
    }
    double error = ROUNDING * (mirror.center().maxAbs() + mirror.radius());
    reflection.point.set(at, normal, NO_TEXTURE, error, pdf);
    reflection.above = at.plus(error, normal);
    light.redirect(at.minus(from).normalized(), reflectances[chosen], pdf);
    return true;
  }

  /**
   * Returns the density, per solid angle at a point, of the reflection of a light's point, for a
   * density of 1 at the mirror's center; 0 if the center and the reflection see different sides of
   * the light, or if a beam only touches a surface.
   */
  private static double density(SphereMirror mirror, Vec3 from, Vec3 at, Vec3 to, Vec3 normal) {
    double sides = normal.dot(mirror.center().minus(to)) * normal.dot(at.minus(to));
    double density = sides > 0 ? 1 / mirror.narrowing(from, at, to, normal) : 0;
    return density < Double.POSITIVE_INFINITY ? density : 0;
  }

  /** The path's only specular surface since its last vertex is the outside of a mirror. */
  @Override
  public boolean mightFind(int depth, RenderContext context) {
    SpecularLink link = context.link;
    return link.isSingle() && link.isFrontal() && mirrorOfPrimitive[link.primitive()] >= 0;
  }

  @Override
  public double rayPdf(RenderContext context) {
    return context.link.pdf();
  }

  @Override
  public double pdf(int emitter, SurfaceHit hit, RenderContext context) {
    SpecularLink link = context.link;
    Reflection reflection = context.scratch.reflection;
    int met = mirrorOfPrimitive[link.primitive()];
    SphereMirror mirror = mirrors[met];
    double most = Math.max(1, weigh(link.vertex(), link.facing(), reflection.weights));
    double weight = reflection.weights[met];
    if (weight == 0 || !(shared.emitters[emitter] instanceof AreaLight lamp)) {
      return 0;
    }
    double density =
        density(mirror, link.vertex(), link.point(), hit.position(), hit.geometricNormal());
    LightChoice choice = reflection.choice;
    choice.moveTo(mirror.center(), Vec3.ZERO);
    double probability = shared.probability(choice, emitter);
    return weight / most * probability * lamp.pdf(mirror.center(), hit) * density;
  }

  /**
   * Computes the weight of each mirror at a point: half the sine of the angle from its center to
   * its border, or 0 if the point faces away from it. Returns the sum. If it is below 1, it is the
   * probability with which a reflection is sampled at all, because small reflections are worth
   * fewer shadow rays.
   *
   * @param facing unit normal of the side that receives light, in world space; zero for both
   */
  private double weigh(Vec3 from, Vec3 facing, double[] weights) {
    double sum = 0;
    for (int i = 0; i < mirrors.length; i++) {
      Vec3 way = mirrors[i].center().minus(from);
      double radius = mirrors[i].radius();
      boolean isBelow = facing.dot(way) <= -radius;
      double distance = way.length();
      weights[i] = isBelow || distance <= radius ? 0 : SHARE * radius / distance;
      sum += weights[i];
    }
    return sum;
  }
}
