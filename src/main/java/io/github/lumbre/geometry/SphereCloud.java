package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.texture.TexturePoint;
import java.util.AbstractList;

/**
 * Spheres of one local radius as one shape. Rays hit each of them from both sides. All places of a
 * cloud share its points and a hierarchy over them in local space: about 200 bytes per point.
 *
 * <p>The element of a hit is twice the number of the sphere, plus 1 if the ray leaves it.
 */
final class SphereCloud implements Shape {
  private final Points points;
  private final Bvh bvh;
  private final Transform toWorld;

  /**
   * The spheres in local space.
   *
   * @param mesh see {@link TriangleMesh#ofPoints}
   */
  private record Points(TriangleMesh mesh, double radius) {
    int count() {
      return mesh.vertexCount();
    }

    Sphere sphere(int index, Transform toWorld) {
      return new Sphere(placed(index, toWorld), radius);
    }

    /** Returns the map from a sphere's own space, around its center, to world space. */
    Transform placed(int index, Transform toWorld) {
      return toWorld.times(Transform.translation(mesh.position(index)));
    }

    TexturePoint texture(int index) {
      return mesh.hasUvs() ? mesh.uv(index) : new TexturePoint(0, 0);
    }
  }

  private SphereCloud(Points points, Bvh bvh, Transform toWorld) {
    this.points = points;
    this.bvh = bvh;
    this.toWorld = toWorld;
  }

  /**
   * Returns a cloud.
   *
   * @param mesh the centers; see {@link TriangleMesh#ofPoints}
   * @param radius in (0, 1e150]
   */
  static SphereCloud of(TriangleMesh mesh, double radius, Kernel kernel) {
    if (mesh.vertexCount() == 0) {
      throw new IllegalArgumentException("centers: expected at least one, found none");
    }
    Points points = new Points(mesh, radius);
    AbstractList<Item> items =
        new AbstractList<>() {
          @Override
          public Item get(int index) {
            return new Item(points, index);
          }

          @Override
          public int size() {
            return points.count();
          }
        };
    return new SphereCloud(points, Bvh.over(items, kernel), Transform.IDENTITY);
  }

  /** Returns the hierarchy over the spheres, which all places share. */
  Bvh bvh() {
    return bvh;
  }

  @Override
  public SphereCloud transformed(Transform outer) {
    return new SphereCloud(points, bvh, Placement.invertible(outer.times(toWorld)));
  }

  @Override
  public Bounds3 bounds() {
    Bounds3 centers = points.mesh.bounds();
    Vec3 reach = new Vec3(points.radius, points.radius, points.radius);
    return Placement.outward(
        toWorld, new Bounds3(centers.min().minus(reach), centers.max().plus(reach)));
  }

  /**
   * {@inheritDoc}
   *
   * <p>The items of the hierarchy are shapes, which find the ray and the passed hit in {@code
   * nearest}. So both are replaced by local ones during the search.
   */
  @Override
  public boolean intersect(NearestHit nearest) {
    double ox = nearest.originX;
    double oy = nearest.originY;
    double oz = nearest.originZ;
    double dx = nearest.directionX;
    double dy = nearest.directionY;
    double dz = nearest.directionZ;
    PassedHit passed = nearest.passed;
    int passedShape = passed.shape;
    int passedElement = passed.element;
    boolean isCollecting = passed.isCollecting;
    nearest.originX = toWorld.inversePointX(ox, oy, oz);
    nearest.originY = toWorld.inversePointY(ox, oy, oz);
    nearest.originZ = toWorld.inversePointZ(ox, oy, oz);
    nearest.directionX = toWorld.inverseVectorX(dx, dy, dz);
    nearest.directionY = toWorld.inverseVectorY(dx, dy, dz);
    nearest.directionZ = toWorld.inverseVectorZ(dx, dy, dz);
    if (passedShape == 0) {
      passed.shape = passedElement >> 1;
      passed.element = passedElement & 1;
    }
    // The caller collects the hits of this shape.
    passed.isCollecting = false;
    boolean found =
        bvh.intersectPart(
            nearest.originX,
            nearest.originY,
            nearest.originZ,
            nearest.directionX,
            nearest.directionY,
            nearest.directionZ,
            nearest);
    passed.isCollecting = isCollecting;
    passed.shape = passedShape;
    passed.element = passedElement;
    nearest.originX = ox;
    nearest.originY = oy;
    nearest.originZ = oz;
    nearest.directionX = dx;
    nearest.directionY = dy;
    nearest.directionZ = dz;
    return found;
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    int index = hit.element >> 1;
    SurfaceHit surface = points.sphere(index, toWorld).surfaceAt(hit);
    surface.textureAt(points.texture(index)).addAttributes(points.mesh, index, 0, 0);
    return surface;
  }

  @Override
  public NormalGradient normalGradientAt(NearestHit hit) {
    return points.sphere(hit.element >> 1, toWorld).normalGradientAt(hit);
  }

  @Override
  public boolean isClosed() {
    return true;
  }

  @Override
  public double area() {
    return points.count() * points.sphere(0, toWorld).area();
  }

  /**
   * {@inheritDoc} Points are uniform by the area in local space, including points that the spheres
   * themselves occlude.
   */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    int count = points.count();
    int index = Math.min((int) (u * count), count - 1);
    Vec3 n = Warp.uniformSphere(new Point2(Math.min(u * count - index, 1), v));
    Vec3 local = n.times(points.radius);
    Transform place = points.placed(index, toWorld);
    Vec3 position = place.point(local);
    Vec3 normal = place.normal(n);
    Vec3 reference = new Vec3(x, y, z);
    double pdf = pdf(reference.minus(position), normal);
    if (!(pdf > 0)) {
      result.clear();
      return;
    }
    double error = place.pointError(local, normal);
    if (place.isSkewed()) {
      error += place.mappingError(reference, normal);
    }
    result.set(position, normal, points.texture(index), error, pdf);
    result.addAttributes(points.mesh, index, 0, 0);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    return pdf(reference.minus(onShape.position()), onShape.geometricNormal());
  }

  /**
   * Returns the density per solid angle. For a unit world-space normal n, areas grow by |det M| /
   * |Mᵀn|.
   */
  private double pdf(Vec3 toReference, Vec3 normal) {
    double x = toWorld.vector(Vec3.X).dot(normal);
    double y = toWorld.vector(Vec3.Y).dot(normal);
    double z = toWorld.vector(Vec3.Z).dot(normal);
    double growth = Math.abs(toWorld.determinant()) / new Vec3(x, y, z).length();
    double local = 4 * Math.PI * points.radius * points.radius * points.count();
    return Placement.solidAnglePdf(toReference, normal, growth * local);
  }

  /** A sphere as an item of the hierarchy, in local space: two words, since there are many. */
  static final class Item implements Shape {
    private final Points points;
    private final int index;

    private Item(Points points, int index) {
      this.points = points;
      this.index = index;
    }

    private Sphere sphere() {
      return points.sphere(index, Transform.IDENTITY);
    }

    @Override
    public Bounds3 bounds() {
      return sphere().bounds();
    }

    @Override
    public boolean intersect(NearestHit nearest) {
      double[] centers = points.mesh.positions();
      boolean found =
          Sphere.intersect(
              points.radius,
              nearest.originX - centers[3 * index],
              nearest.originY - centers[3 * index + 1],
              nearest.originZ - centers[3 * index + 2],
              nearest.directionX,
              nearest.directionY,
              nearest.directionZ,
              nearest);
      if (found) {
        nearest.element += 2 * index;
      }
      return found;
    }

    @Override
    public SurfaceHit surfaceAt(NearestHit hit) {
      return sphere().surfaceAt(hit);
    }

    @Override
    public Shape transformed(Transform outer) {
      return sphere().transformed(outer);
    }

    @Override
    public double area() {
      return sphere().area();
    }

    @Override
    public boolean isClosed() {
      return true;
    }

    @Override
    public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
      sphere().sample(x, y, z, u, v, result);
    }

    @Override
    public double pdf(Vec3 reference, SurfaceHit onShape) {
      return sphere().pdf(reference, onShape);
    }
  }
}
