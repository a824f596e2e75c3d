package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.TexturePoint;
import java.util.Optional;

/**
 * A rectangle around the local origin in the xz plane, with normal +y and its border included. Rays
 * from behind pass through it unless it is two-sided. Texture coordinates: u = (w/2 − x)/w, v =
 * (h/2 − z)/h for width w and height h.
 */
public final class Rectangle implements Shape {
  /**
   * Above this cosine between the sides, the transformed shape is a parallelogram and not a
   * rectangle.
   */
  private static final double RIGHT_ANGLE = 1e-12;

  /**
   * Up to this distance, in half diagonals, points are sampled by solid angle. Farther away,
   * sampling by area is nearly as good and costs less.
   */
  private static final double NEAR = 2;

  private final Transform toWorld;
  private final double width;
  private final double height;
  private final boolean twoSided;
  private final double halfWidth;
  private final double halfHeight;
  private final Vec3 normal;
  private final Frame shading;
  private final double area;
  private final Vec3 center;

  /** The world-space frame along local x, local z and the normal. */
  private final Frame axes;

  private final double scaleX;
  private final double scaleZ;

  /** The error bound of a point at the center, and its growth per unit along local x and z. */
  private final double errorAtCenter;

  private final double errorPerX;
  private final double errorPerZ;

  /** The square of the distance up to which points are sampled by solid angle. */
  private final double nearSquared;

  /**
   * Creates a rectangle.
   *
   * @param toWorld invertible
   * @param width along local x, in (0, 1e150]
   * @param height along local z, in (0, 1e150]
   * @param twoSided whether rays from behind hit the rectangle
   * @throws IllegalArgumentException if the transform is singular or a size is out of range
   */
  public Rectangle(Transform toWorld, double width, double height, boolean twoSided) {
    this.toWorld = Placement.invertible(toWorld);
    this.width = Range.SIZE.require("width", width);
    this.height = Range.SIZE.require("height", height);
    this.twoSided = twoSided;
    halfWidth = .5 * width;
    halfHeight = .5 * height;
    normal = toWorld.normal(Vec3.Y);
    Vec3 x = toWorld.vector(Vec3.X);
    Vec3 z = toWorld.vector(Vec3.Z);
    shading = Frame.around(normal, x.negated(), z.negated());
    area = x.cross(z).length() * width * height;
    center = toWorld.point(Vec3.ZERO);
    axes = Frame.around(normal, x, z);
    scaleX = x.length();
    scaleZ = z.length();
    errorAtCenter = toWorld.pointError(Vec3.ZERO, normal);
    errorPerX = toWorld.pointError(Vec3.X, normal) - errorAtCenter;
    errorPerZ = toWorld.pointError(Vec3.Z, normal) - errorAtCenter;
    boolean isRectangular = Math.abs(x.dot(z)) <= RIGHT_ANGLE * scaleX * scaleZ;
    double diagonal = new Vec3(halfWidth * scaleX, 0, halfHeight * scaleZ).length();
    nearSquared = isRectangular ? NEAR * diagonal * (NEAR * diagonal) : 0;
  }

  /**
   * Returns a one-sided rectangle around a point.
   *
   * @param normal direction that its front faces, of any length; the width lies along x for a
   *     vertical one, and is horizontal otherwise
   * @param width in world units, in (0, 1e150]
   * @param height in world units, in (0, 1e150]
   * @throws IllegalArgumentException if the normal is zero, or a number is out of range
   */
  public static Rectangle facing(Vec3 center, Vec3 normal, double width, double height) {
    if (!(normal.maxAbs() > 0) || !normal.isFinite()) {
      throw new IllegalArgumentException(
          "normal: expected a finite vector other than 0, found " + normal);
    }
    Vec3 y = normal.normalized();
    Vec3 x = Frame.isAlong(y, Vec3.Y) ? Vec3.X : Vec3.Y.cross(y).normalized();
    Transform toWorld = Transform.ofAxes(x, y, x.cross(y), Placement.finite("center", center));
    return new Rectangle(toWorld, width, height, false);
  }

  /** Returns the map from local to world space. */
  public Transform toWorld() {
    return toWorld;
  }

  /** Returns the length along local x. */
  public double width() {
    return width;
  }

  /** Returns the length along local z. */
  public double height() {
    return height;
  }

  /** Returns whether rays from behind hit the rectangle. */
  public boolean isTwoSided() {
    return twoSided;
  }

  /** Returns the same rectangle, which rays from behind hit, too. */
  public Rectangle twoSided() {
    return new Rectangle(toWorld, width, height, true);
  }

  @Override
  public Rectangle transformed(Transform outer) {
    return new Rectangle(outer.times(toWorld), width, height, twoSided);
  }

  @Override
  public Bounds3 bounds() {
    Vec3 corner = new Vec3(halfWidth, 0, halfHeight);
    return Placement.outward(toWorld, new Bounds3(corner.negated(), corner));
  }

  @Override
  public boolean intersect(NearestHit nearest) {
    double dy = nearest.localDirectionY(toWorld);
    if (dy >= 0 && !twoSided) {
      return false;
    }
    double t = -nearest.localOriginY(toWorld) / dy;
    if (!(t < nearest.t && nearest.isAfterPassed(t, 0))) {
      return false;
    }
    double x = nearest.localOriginX(toWorld);
    x += t * nearest.localDirectionX(toWorld);
    double z = nearest.localOriginZ(toWorld);
    z += t * nearest.localDirectionZ(toWorld);
    if (!(Math.abs(x) <= halfWidth && Math.abs(z) <= halfHeight)) {
      return false;
    }
    nearest.t = t;
    nearest.element = 0;
    return true;
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    Vec3 origin = toWorld.inversePoint(hit.origin());
    Vec3 direction = toWorld.inverseVector(hit.direction());
    Vec3 p = origin.plus(hit.t, direction);
    Vec3 local = new Vec3(p.x(), 0, p.z());
    return hit.surface.set(
        position(local), normal, shading, texture(local), hit.backwards(), error(local));
  }

  private Vec3 position(Vec3 local) {
    return toWorld.pointInPlane(local.x(), local.z());
  }

  /** Returns {@link Transform#pointError} of a local point, with fewer operations. */
  private double error(Vec3 local) {
    return errorAtCenter + Math.abs(local.x()) * errorPerX + Math.abs(local.z()) * errorPerZ;
  }

  private TexturePoint texture(Vec3 local) {
    return new TexturePoint((halfWidth - local.x()) / width, (halfHeight - local.z()) / height);
  }

  @Override
  public Optional<Vec3> onlyNormal() {
    return Optional.of(normal);
  }

  @Override
  public boolean isBehind(Bounds3 box) {
    return !twoSided && Placement.isInFront(box, toWorld);
  }

  @Override
  public boolean isClosed() {
    return false;
  }

  @Override
  public double area() {
    return area;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Points are uniform by solid angle for near reference points, otherwise by area. For
   * reference points behind a one-sided rectangle, there is no sample.
   */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    Vec3 reference = new Vec3(x, y, z);
    Vec3 from = axes.toLocal(reference.minus(center));
    if (isNear(from.x(), from.y(), from.z())) {
      SphericalRectangle seen = seenFrom(from.x(), from.y(), from.z());
      if (seen.isUsable()) {
        Point2 way = seen.at(new Point2(u, v));
        double localX = within(halfWidth, (from.x() + way.x()) / scaleX);
        double localZ = within(halfHeight, (from.y() + way.y()) / scaleZ);
        Vec3 local = new Vec3(localX, 0, localZ);
        set(result, local, position(local), 1 / seen.solidAngle());
        return;
      }
    }
    Vec3 local = new Vec3((u - .5) * width, 0, (v - .5) * height);
    Vec3 position = position(local);
    double pdf = areaPdf(reference.minus(position));
    if (pdf > 0) {
      set(result, local, position, pdf);
    } else {
      result.clear();
    }
  }

  private void set(SurfaceSample result, Vec3 local, Vec3 position, double pdf) {
    result.set(position, normal, texture(local), error(local), pdf);
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    Vec3 from = axes.toLocal(reference.minus(center));
    if (isNear(from.x(), from.y(), from.z())) {
      SphericalRectangle seen = seenFrom(from.x(), from.y(), from.z());
      if (seen.isUsable()) {
        return 1 / seen.solidAngle();
      }
    }
    return areaPdf(reference.minus(onShape.position()));
  }

  /**
   * Returns whether a reference point, given in the frame {@link #axes}, is near and on a visible
   * side.
   */
  private boolean isNear(double x, double y, double z) {
    return (twoSided || z > 0) && x * x + y * y + z * z <= nearSquared;
  }

  private SphericalRectangle seenFrom(double x, double y, double z) {
    double endX = halfWidth * scaleX;
    double endY = halfHeight * scaleZ;
    return new SphericalRectangle(-endX - x, endX - x, -endY - y, endY - y, Math.abs(z));
  }

  private static double within(double half, double x) {
    return Math.max(-half, Math.min(x, half));
  }

  private double areaPdf(Vec3 toReference) {
    boolean isVisible = twoSided || toReference.dot(normal) > 0;
    return isVisible ? Placement.solidAnglePdf(toReference, normal, area) : 0;
  }

  /** Returns where it is, for people. */
  @Override
  public String toString() {
    return "Rectangle in " + bounds();
  }
}
