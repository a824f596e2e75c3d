package io.github.lumbre.geometry;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Distribution1d;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.texture.TexturePoint;

/** The world-space surface of a placed mesh, evaluated at hits or sampled. */
final class MeshSurface {
  /**
   * The error of a sheared vertex relative to the edges: about six roundings, with a safety margin.
   */
  private static final double SHEARING = 16 * 0x1p-52;

  /** The least distance of the smooth surface from the triangle, relative to the error bound. */
  private static final double LEAST_LIFT = 8;

  private final TriangleMesh mesh;
  private final Transform toWorld;
  private final boolean isInWorld;
  private final boolean hasAttributes;
  private final boolean hasTangents;
  private final boolean isSmooth;
  private final boolean isWound;

  /** The triangles' areas in world space; computed on first use, because few meshes are lights. */
  private volatile Distribution1d areas;

  MeshSurface(TriangleMesh mesh, Transform toWorld) {
    this.mesh = mesh;
    this.toWorld = toWorld;
    isInWorld = toWorld == Transform.IDENTITY;
    hasAttributes = mesh.attributes() != MeshAttributes.NONE;
    hasTangents = mesh.attributes().tangents().length > 0;
    isSmooth = mesh.hasNormals();
    isWound = mesh.fronts().rule() == TriangleMesh.Front.WINDING;
  }

  /**
   * Returns the surface at a hit, whose point has the barycentric weights (1 − b1 − b2, b1, b2).
   */
  SurfaceHit at(NearestHit hit) {
    int triangle = hit.element;
    Vec3 a = position(triangle, 0);
    Vec3 e1 = position(triangle, 1).minus(a);
    Vec3 e2 = position(triangle, 2).minus(a);
    Vec3 normal = geometricNormal(triangle, e1, e2);
    SurfaceHit surface =
        hit.surface.set(
            a.plus(hit.b1, e1).plus(hit.b2, e2),
            normal,
            texture(triangle, hit.b1, hit.b2),
            hit.backwards(),
            error(triangle, e1, e2, normal));
    if (isSmooth) {
      shadeSmoothly(surface, hit, e1, e2, normal);
    } else {
      shade(surface, hit, e1, e2, normal);
    }
    if (hasAttributes) {
      surface.addAttributes(mesh, triangle, hit.b1, hit.b2);
    }
    return surface;
  }

  /** Sets the shading frame around the interpolated normal, and where the smooth surface is. */
  private void shadeSmoothly(SurfaceHit surface, NearestHit hit, Vec3 e1, Vec3 e2, Vec3 normal) {
    Vec3 n0 = normal(hit.element, 0, normal);
    Vec3 n1 = normal(hit.element, 1, normal);
    Vec3 n2 = normal(hit.element, 2, normal);
    Vec3 sum = n0.times(1 - hit.b1 - hit.b2).plus(hit.b1, n1).plus(hit.b2, n2);
    shade(surface, hit, e1, e2, shadingNormal(sum, normal));
    Vec3 lift = lift(surface, hit, e1, e2, n0, n1, n2);
    if (side(surface) * lift.dot(normal) > LEAST_LIFT * surface.error()) {
      surface.liftBy(lift);
    }
  }

  /**
   * Returns the way to the smooth surface at a hit: the mean, by barycentric weights, of the ways
   * up to the tangent planes of the three vertices (Hanika 2021, "Hacking the Shadow Terminator",
   * Ray Tracing Gems II, ch. 4). A plane that lies below the hit counts as a way of 0.
   */
  private static Vec3 lift(
      SurfaceHit surface, NearestHit hit, Vec3 e1, Vec3 e2, Vec3 n0, Vec3 n1, Vec3 n2) {
    double side = side(surface);
    Vec3 from = e1.times(hit.b1).plus(hit.b2, e2);
    return n0.times((1 - hit.b1 - hit.b2) * height(from, n0, side))
        .plus(hit.b1 * height(from.minus(e1), n1, side), n1)
        .plus(hit.b2 * height(from.minus(e2), n2, side), n2);
  }

  private static double side(SurfaceHit surface) {
    return surface.isFrontal() ? 1 : -1;
  }

  /** Returns the height, in units of a vertex normal, of its tangent plane above a point. */
  private static double height(Vec3 fromVertex, Vec3 vertexNormal, double side) {
    double below = -side * fromVertex.dot(vertexNormal);
    return below > 0 ? side * below / vertexNormal.dot(vertexNormal) : 0;
  }

  /** Returns how the shading normal changes along the triangle of a hit. */
  NormalGradient normalGradientAt(NearestHit hit) {
    if (!mesh.hasNormals()) {
      return NormalGradient.FLAT;
    }
    int triangle = hit.element;
    Vec3 a = position(triangle, 0);
    Vec3 e1 = position(triangle, 1).minus(a);
    Vec3 e2 = position(triangle, 2).minus(a);
    Vec3 normal = geometricNormal(triangle, e1, e2);
    Vec3 n = normal(triangle, 0, normal);
    Vec3 n1 = normal(triangle, 1, normal).minus(n);
    Vec3 n2 = normal(triangle, 2, normal).minus(n);
    Vec3 sum = n.plus(hit.b1, n1).plus(hit.b2, n2);
    if (!isShading(sum, normal)) {
      return NormalGradient.FLAT;
    }
    // The gradients of the barycentric weights.
    Vec3 cross = e1.cross(e2);
    double square = cross.dot(cross);
    return new NormalGradient(
        sum, e2.cross(cross).times(1 / square), n1, cross.cross(e1).times(1 / square), n2);
  }

  // Escape analysis cannot remove an object that comes from two branches, so that the methods of a
  // hit choose between numbers, and not between vectors.

  private Vec3 position(int triangle, int corner) {
    Vec3 local = mesh.position(mesh.vertex(triangle, corner));
    double x = local.x();
    double y = local.y();
    double z = local.z();
    if (!isInWorld) {
      Vec3 world = toWorld.point(local);
      x = world.x();
      y = world.y();
      z = world.z();
    }
    return new Vec3(x, y, z);
  }

  /**
   * Returns the vertex normal at a corner in world space, for shading. It does what {@link
   * TriangleMesh#mappedNormal} does, without allocating a vector.
   */
  private Vec3 normal(int triangle, int corner, Vec3 geometricNormal) {
    Vec3 local = mesh.normal(mesh.vertex(triangle, corner));
    double x = local.x();
    double y = local.y();
    double z = local.z();
    if (!isInWorld && local.maxAbs() > 0) {
      Vec3 world = toWorld.normal(local);
      x = world.x();
      y = world.y();
      z = world.z();
    }
    if (mesh.fronts().hasNormalsBehind(triangle)) {
      Vec3 raised = raised(triangle, new Vec3(x, y, z), geometricNormal);
      x = raised.x();
      y = raised.y();
      z = raised.z();
    }
    return new Vec3(x, y, z);
  }

  /** Returns a vertex normal moved to the front, as {@link TriangleMesh.Front#WINDING} says. */
  private Vec3 raised(int triangle, Vec3 normal, Vec3 geometricNormal) {
    Vec3 n = mesh.fronts().hasReversedNormals(triangle) ? normal.negated() : normal;
    return n.plus(-2 * Math.min(0, n.dot(geometricNormal)), geometricNormal);
  }

  /** Returns whether a sum of vertex normals is on the front, or at its edge if none is behind. */
  private boolean isShading(Vec3 sum, Vec3 geometricNormal) {
    return sum.dot(geometricNormal) > 0 || isWound && sum.maxAbs() > 0;
  }

  private Vec3 geometricNormal(int triangle, Vec3 e1, Vec3 e2) {
    Vec3 cross = TriangleMesh.cross(e1, e2);
    if (!(cross.maxAbs() > 0)) {
      // A transform can flatten a sliver to a line; any direction perpendicular to it is valid.
      return e1.maxAbs() > 0 ? Frame.around(e1.normalized()).tangent() : Vec3.Y;
    }
    boolean isTurned = mesh.fronts().isTurned(triangle) ^ toWorld.isMirroring();
    return cross.normalized().times(isTurned ? -1 : 1);
  }

  private Vec3 shadingNormal(Vec3 sum, Vec3 geometricNormal) {
    double x = geometricNormal.x();
    double y = geometricNormal.y();
    double z = geometricNormal.z();
    if (isShading(sum, geometricNormal)) {
      Vec3 smooth = sum.normalized();
      x = smooth.x();
      y = smooth.y();
      z = smooth.z();
    }
    return new Vec3(x, y, z);
  }

  private void shade(SurfaceHit surface, NearestHit hit, Vec3 e1, Vec3 e2, Vec3 normal) {
    if (hasTangents) {
      shadeByTangents(surface, hit, normal);
    } else {
      shadeByTexture(surface, hit.element, e1, e2, normal);
    }
  }

  /**
   * Sets the shading frame around a normal; its tangents solve E1 = ΔU1 T + ΔV1 B and E2 = ΔU2 T +
   * ΔV2 B. If these have no solution, the tangents are arbitrary.
   */
  private void shadeByTexture(SurfaceHit surface, int triangle, Vec3 e1, Vec3 e2, Vec3 normal) {
    TexturePoint a = mesh.uv(triangle, 0);
    TexturePoint b = mesh.uv(triangle, 1);
    TexturePoint c = mesh.uv(triangle, 2);
    double du1 = b.u() - a.u();
    double dv1 = b.v() - a.v();
    double du2 = c.u() - a.u();
    double dv2 = c.v() - a.v();
    double determinant = du1 * dv2 - du2 * dv1;
    boolean isSolvable =
        Math.abs(determinant) > 1e-12 * (Math.abs(du1 * dv2) + Math.abs(du2 * dv1));
    double sign = isSolvable ? Math.copySign(1, determinant) : 0;
    Vec3 tangent = e1.times(sign * dv2).plus(-sign * dv1, e2);
    Vec3 bitangent = e2.times(sign * du1).plus(-sign * du2, e1);
    surface.shadeAround(normal, tangent, bitangent);
  }

  /** Sets the shading frame of the interpolated vertex tangents around a normal. */
  private void shadeByTangents(SurfaceHit surface, NearestHit hit, Vec3 normal) {
    Vec3 local =
        mesh.tangent(hit.element, 0)
            .times(1 - hit.b1 - hit.b2)
            .plus(hit.b1, mesh.tangent(hit.element, 1))
            .plus(hit.b2, mesh.tangent(hit.element, 2));
    Vec3 tangent = isInWorld ? local : toWorld.vector(local);
    double sign = mesh.bitangentSign(hit.element) * (toWorld.isMirroring() ? -1 : 1);
    surface.shadeAround(normal, tangent, normal.cross(tangent).times(sign));
  }

  private TexturePoint texture(int triangle, double b1, double b2) {
    TexturePoint a = mesh.uv(triangle, 0);
    TexturePoint b = mesh.uv(triangle, 1);
    TexturePoint c = mesh.uv(triangle, 2);
    return new TexturePoint(
        a.u() + b1 * (b.u() - a.u()) + b2 * (c.u() - a.u()),
        a.v() + b1 * (b.v() - a.v()) + b2 * (c.v() - a.v()));
  }

  /**
   * Returns a bound, along the normal, of the rounding error of a point on a triangle. It depends
   * on the coordinates of all three vertices. It also depends on the edge lengths in every
   * direction, because the intersection test shears one axis into another.
   */
  private double error(int triangle, Vec3 e1, Vec3 e2, Vec3 normal) {
    Vec3 a = mesh.position(mesh.vertex(triangle, 0));
    Vec3 b = mesh.position(mesh.vertex(triangle, 1));
    Vec3 c = mesh.position(mesh.vertex(triangle, 2));
    Vec3 farthest =
        new Vec3(
            largest(a.x(), b.x(), c.x()),
            largest(a.y(), b.y(), c.y()),
            largest(a.z(), b.z(), c.z()));
    return toWorld.pointError(farthest, normal) + SHEARING * Math.max(e1.maxAbs(), e2.maxAbs());
  }

  private static double largest(double a, double b, double c) {
    return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
  }

  double area() {
    return mesh.triangleCount() == 0 ? 0 : areas().mean() * mesh.triangleCount();
  }

  private Distribution1d areas() {
    Distribution1d known = areas;
    if (known == null) {
      double[] weights = new double[mesh.triangleCount()];
      for (int i = 0; i < weights.length; i++) {
        Vec3 a = position(i, 0);
        weights[i] = .5 * position(i, 1).minus(a).cross(position(i, 2).minus(a)).length();
      }
      // Two threads may compute this at once; their results are equal.
      known = new Distribution1d(weights);
      areas = known;
    }
    return known;
  }

  void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    Vec3 reference = new Vec3(x, y, z);
    result.clear();
    if (!(area() > 0)) {
      return;
    }
    int triangle = areas().choose(u);
    Point2 b = Warp.uniformTriangle(new Point2(areas().remainder(triangle, u), v));
    Vec3 a = position(triangle, 0);
    Vec3 e1 = position(triangle, 1).minus(a);
    Vec3 e2 = position(triangle, 2).minus(a);
    Vec3 position = a.plus(b.x(), e1).plus(b.y(), e2);
    Vec3 normal = geometricNormal(triangle, e1, e2);
    double pdf = Placement.solidAnglePdf(reference.minus(position), normal, area());
    if (!(pdf > 0)) {
      return;
    }
    double error = error(triangle, e1, e2, normal) + mappingError(reference, normal);
    result.set(position, normal, texture(triangle, b.x(), b.y()), error, pdf);
    if (hasAttributes) {
      result.addAttributes(mesh, triangle, b.x(), b.y());
    }
  }

  /**
   * Returns a bound of the rounding error of mapping a ray to local space. It is large for
   * transforms that are strongly non-uniform.
   */
  private double mappingError(Vec3 origin, Vec3 normal) {
    double r = toWorld.inversePoint(origin).maxAbs();
    return isInWorld ? 0 : toWorld.pointError(new Vec3(r, r, r), normal);
  }

  double pdf(Vec3 reference, SurfaceHit onShape) {
    Vec3 toReference = reference.minus(onShape.position());
    return Placement.solidAnglePdf(toReference, onShape.geometricNormal(), area());
  }
}
