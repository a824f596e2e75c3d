package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.texture.TexturePoint;

/**
 * A sphere around the local origin, or an ellipsoid if its transform scales non-uniformly. Rays hit
 * it from both sides.
 *
 * <p>Texture coordinates of the local unit normal n: u = ½ + atan2(n.z, n.x) / 2π, v = ½ −
 * asin(n.y) / π.
 */
public final class Sphere implements Shape {
  /** 1 − cos of the half angle of the cone that contains all directions. */
  private static final double ALL_DIRECTIONS = 2;

  private final Transform toWorld;
  private final double radius;
  private final boolean isSkewed;

  /**
   * Creates a sphere.
   *
   * @param toWorld invertible
   * @param radius in local space, in (0, 1e150]
   * @throws IllegalArgumentException if the transform is singular or the radius is out of range
   */
  public Sphere(Transform toWorld, double radius) {
    this.toWorld = Placement.invertible(toWorld);
    this.radius = Range.SIZE.require("radius", radius);
    isSkewed = toWorld.isSkewed();
  }

  /**
   * Returns a sphere around a point.
   *
   * @param radius in world units, in (0, 1e150]
   */
  public static Sphere of(Vec3 center, double radius) {
    return new Sphere(Placement.at(center), radius);
  }

  /**
   * Returns spheres of one radius as one shape, such as a cloud of points. It takes much less
   * memory than a shape for each.
   *
   * @param centers three coordinates per sphere, all finite
   * @param radius in (0, 1e150]
   * @param uvs two texture coordinates per sphere, all finite, which hold for all of its surface;
   *     or empty, for (0,0)
   * @param attributes further data of the spheres; tangents are not used
   * @param kernel searches the spheres
   * @throws IllegalArgumentException if there is no sphere, an array has a wrong length, a number
   *     is not finite or the radius is out of range
   * @throws IllegalStateException if the kernel is not available
   */
  public static Shape cloud(
      double[] centers, double radius, double[] uvs, MeshAttributes attributes, Kernel kernel) {
    TriangleMesh points = TriangleMesh.ofPoints(centers, uvs, attributes);
    return SphereCloud.of(points, Range.SIZE.require("radius", radius), kernel);
  }

  /** Returns the map from local to world space. */
  public Transform toWorld() {
    return toWorld;
  }

  /** Returns the radius in local space. */
  public double radius() {
    return radius;
  }

  @Override
  public Sphere transformed(Transform outer) {
    return new Sphere(outer.times(toWorld), radius);
  }

  @Override
  public Bounds3 bounds() {
    Vec3 x = toWorld.vector(Vec3.X);
    Vec3 y = toWorld.vector(Vec3.Y);
    Vec3 z = toWorld.vector(Vec3.Z);
    Vec3 half =
        new Vec3(
                new Vec3(x.x(), y.x(), z.x()).length(),
                new Vec3(x.y(), y.y(), z.y()).length(),
                new Vec3(x.z(), y.z(), z.z()).length())
            .times(radius);
    Vec3 center = toWorld.point(Vec3.ZERO);
    Bounds3 box = new Bounds3(center.minus(half), center.plus(half));
    return Placement.widened(box, toWorld, new Vec3(radius, radius, radius));
  }

  /**
   * {@inheritDoc}
   *
   * <p>The quadratic is solved relative to the ray's point closest to the center, where its
   * coefficients keep full precision for ray origins at any distance: Haines et al. 2019,
   * "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7.
   */
  @Override
  public boolean intersect(NearestHit nearest) {
    double ox = nearest.localOriginX(toWorld);
    double oy = nearest.localOriginY(toWorld);
    double oz = nearest.localOriginZ(toWorld);
    double dx = nearest.localDirectionX(toWorld);
    double dy = nearest.localDirectionY(toWorld);
    double dz = nearest.localDirectionZ(toWorld);
    return intersect(radius, ox, oy, oz, dx, dy, dz, nearest);
  }

  /**
   * Finds the first hit of a sphere around the origin, as {@link Shape#intersect} does, along a ray
   * that is given in the sphere's space. The stored element is 0 where the ray enters the sphere,
   * and 1 where it leaves it.
   */
  static boolean intersect(
      double radius,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz,
      NearestHit nearest) {
    double dd = dx * dx + dy * dy + dz * dz;
    double middle = -(ox * dx + oy * dy + oz * dz) / dd;
    double cx = ox + middle * dx;
    double cy = oy + middle * dy;
    double cz = oz + middle * dz;
    double off = Math.sqrt(cx * cx + cy * cy + cz * cz);
    double discriminant = (radius - off) * (radius + off);
    if (!(discriminant >= 0)) {
      return false;
    }
    double half = Math.sqrt(discriminant / dd);
    double t = middle - half;
    int root = 0;
    if (!nearest.isAfterPassed(t, root)) {
      t = middle + half;
      root = 1;
      if (!nearest.isAfterPassed(t, root)) {
        return false;
      }
    }
    if (!(t < nearest.t)) {
      return false;
    }
    nearest.t = t;
    nearest.element = root;
    return true;
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    Vec3 origin = toWorld.inversePoint(hit.origin());
    Vec3 direction = toWorld.inverseVector(hit.direction());
    Vec3 n = origin.plus(hit.t, direction).normalized();
    Vec3 local = n.times(radius);
    Vec3 normal = toWorld.normal(n);
    double sinSquared = n.x() * n.x() + n.z() * n.z();
    Vec3 alongU = toWorld.vector(new Vec3(-n.z(), 0, n.x()));
    Vec3 alongV = toWorld.vector(new Vec3(n.x() * n.y(), -sinSquared, n.z() * n.y()));
    return hit.surface.set(
        toWorld.point(local),
        normal,
        Frame.around(normal, alongU, alongV),
        texture(n),
        hit.backwards(),
        toWorld.pointError(local, normal));
  }

  @Override
  public NormalGradient normalGradientAt(NearestHit hit) {
    Vec3 n = toWorld.inversePoint(hit.origin().plus(hit.t, hit.direction())).normalized();
    Frame frame = Frame.around(toWorld.normal(n));
    return new NormalGradient(
        toWorld.covector(n),
        frame.tangent(),
        changeAlong(frame.tangent()),
        frame.bitangent(),
        changeAlong(frame.bitangent()));
  }

  private Vec3 changeAlong(Vec3 step) {
    return toWorld.covector(toWorld.inverseVector(step)).times(1 / radius);
  }

  private static TexturePoint texture(Vec3 n) {
    return new TexturePoint(
        .5 + Elementary.atan2(n.z(), n.x()) / Elementary.TWO_PI,
        .5 - Elementary.asin(n.y()) * Elementary.INV_PI);
  }

  @Override
  public boolean isClosed() {
    return true;
  }

  @Override
  public double area() {
    return EllipsoidArea.ofUnitSphere(toWorld) * radius * radius;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Samples a direction uniformly, in local space, from the directions that hit the sphere: a
   * cone from outside, all directions from inside. Source: PBRT 4e, sec. 6.2.4. Under a non-uniform
   * scale, the density includes the Jacobian of the map of directions.
   */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    Vec3 reference = new Vec3(x, y, z);
    Vec3 from = toWorld.inversePoint(reference).times(1 / radius);
    double distance = from.length();
    double oneMinusCosMax = oneMinusCosMax(distance);
    Frame frame = distance > 0 ? Frame.around(from.times(1 / distance)) : Frame.WORLD;
    Vec3 n =
        distance > 1
            ? frame.toWorld(nearPoint(distance, oneMinusCosMax, new Point2(u, v)))
            : exit(from, Warp.uniformSphere(new Point2(u, v)));
    n = n.normalized();
    Vec3 local = n.times(radius);
    Vec3 position = toWorld.point(local);
    double pdf = pdf(oneMinusCosMax, position.minus(reference));
    if (!(pdf > 0)) {
      result.clear();
      return;
    }
    Vec3 normal = toWorld.normal(n);
    double error = toWorld.pointError(local, normal);
    if (isSkewed) {
      error += toWorld.mappingError(reference, normal);
    }
    result.set(position, normal, texture(n), error, pdf);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    double distance = toWorld.inversePoint(reference).length() / radius;
    Vec3 way = onShape.position().minus(reference);
    if (distance > 1 && way.dot(onShape.geometricNormal()) > 0) {
      return 0;
    }
    return pdf(oneMinusCosMax(distance), way);
  }

  /**
   * Returns the nearest point of the unit sphere in a uniform direction of the cone that an outside
   * reference point sees. The z axis points to the reference point.
   */
  private static Vec3 nearPoint(double distance, double oneMinusCosMax, Point2 u) {
    Vec3 w = Warp.uniformCone(u, oneMinusCosMax);
    double sinTheta = Math.sqrt(w.x() * w.x() + w.y() * w.y());
    if (sinTheta == 0) {
      return Vec3.Z;
    }
    // By the law of sines; beta is the angle between the direction and the normal at the hit.
    double sinBeta = Math.min(1, distance * sinTheta);
    double cosBeta = Math.sqrt((1 - sinBeta) * (1 + sinBeta));
    double sinAlpha = sinBeta * w.z() - cosBeta * sinTheta;
    double cosAlpha = cosBeta * w.z() + sinBeta * sinTheta;
    return new Vec3(w.x() * (sinAlpha / sinTheta), w.y() * (sinAlpha / sinTheta), cosAlpha);
  }

  /** Returns the point at which a ray from inside the unit sphere leaves it. */
  private static Vec3 exit(Vec3 from, Vec3 direction) {
    double b = from.dot(direction);
    double c = Math.max(0, 1 - from.dot(from));
    return from.plus(Math.sqrt(b * b + c) - b, direction);
  }

  /**
   * Returns 1 − cos of the half angle that the unit sphere subtends at a distance from its center.
   */
  private static double oneMinusCosMax(double distance) {
    if (!(distance > 1)) {
      return ALL_DIRECTIONS;
    }
    double sin = 1 / distance;
    double cos = Math.sqrt((distance - 1) * (distance + 1)) * sin;
    return sin * sin / (1 + cos);
  }

  /**
   * Returns the world-space density of a uniform direction in a local cone. For a unit local
   * direction w, dω = |det M| / |M w|³ dω'.
   */
  private double pdf(double oneMinusCosMax, Vec3 way) {
    double stretch = way.length() / toWorld.inverseVector(way).length();
    double spread = Math.abs(toWorld.determinant()) / (stretch * stretch * stretch);
    double pdf = Warp.uniformConePdf(oneMinusCosMax) / spread;
    return pdf < Double.POSITIVE_INFINITY ? pdf : 0;
  }

  /** Returns where it is, for people. */
  @Override
  public String toString() {
    return "Sphere around " + toWorld.point(Vec3.ZERO);
  }
}
