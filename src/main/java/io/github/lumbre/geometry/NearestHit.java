package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/**
 * A ray in world space, the nearest hit found so far along it, and the workspace of the traversal.
 * Mutable; each thread reuses one instance for all its rays. It stores plain numbers, so that
 * tracing a ray allocates nothing.
 */
public final class NearestHit {
  /** The maximum stack depth of one traversal: seven entries for each level of eight-wide nodes. */
  private static final int STACK = 7 * BvhBuilder.MAX_DEPTH + 2;

  /**
   * The ray's origin, which is excluded, and its direction. The direction is not zero, and its
   * length is the unit of t.
   */
  double originX;

  double originY;
  double originZ;
  double directionX;
  double directionY;
  double directionZ;

  /** The ray parameter of the hit; before any hit, the ray's end. */
  double t;

  /** The number of the hit shape, or -1. */
  int shape;

  /**
   * The part of the shape, in the order in which a ray meets parts at the same t: the triangle of a
   * mesh, the face of a box, or whether the ray leaves a sphere.
   */
  int element;

  /** The ray's end, excluded. */
  private double end;

  /** The hit that the ray has passed; searches find the first one after it. */
  final PassedHit passed = new PassedHit();

  /** The barycentric weights of a triangle's second and third vertex. */
  double b1;

  double b2;

  /** Whether the traversal may stop at the first hit, as for shadow rays. */
  boolean any;

  /**
   * The nodes still to visit; nested traversals (of instances) use the entries from stackTop on.
   */
  final int[] stack = new int[2 * STACK];

  /** Where the ray enters the nodes still to visit, as integers that sort as t does. */
  final int[] stackNear = new int[2 * STACK];

  /**
   * The stack of the vector kernel's search for the nearest hit, instead of the other two: where
   * the ray enters a node in the upper half, as an integer that sorts as t does, and the node.
   */
  final long[] entries = new long[2 * STACK];

  int stackTop;

  /** The surface at the hit, filled by {@link Shape#surfaceAt}. */
  final SurfaceHit surface = new SurfaceHit();

  /** Whether the traversal is inside a hierarchy that is a shape of another hierarchy. */
  boolean inPart;

  /** The ray for the vector kernel: in the outer hierarchy, and in one that is a shape of it. */
  private final WideRay wideRay = new WideRay();

  private final WideRay widePartRay = new WideRay();

  /** Where the ray enters the children of one node, in the same encoding. */
  final int[] lanes = new int[WideTree.WIDTH];

  /** Creates a workspace without a ray and without a hit. */
  public NearestHit() {}

  /** Sets the ray and discards the previous hit. */
  public void aim(Ray ray) {
    Vec3 o = ray.origin();
    Vec3 d = ray.direction();
    aim(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.tMax());
  }

  /**
   * Sets the {@linkplain Ray ray}, given by its coordinates, and discards the previous hit.
   *
   * @param tMax the ray's end, excluded; may be infinite
   */
  public void aim(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
    originX = ox;
    originY = oy;
    originZ = oz;
    directionX = dx;
    directionY = dy;
    directionZ = dz;
    t = tMax;
    end = tMax;
    passed.clear();
    shape = -1;
    stackTop = 0;
    any = false;
    inPart = false;
  }

  /**
   * Passes the surface that was hit: the next search along the same ray finds the first hit after
   * it, in the order of t, shape and part of the shape. Repeated until nothing is hit, this meets
   * each surface once, also where several surfaces coincide.
   */
  public void pass() {
    passed.moveTo(t, shape, element);
    t = end;
    shape = -1;
  }

  /** Moves to the next hit at the passed t, if there are many; returns whether there is one. */
  boolean moveToCoinciding(Bvh search) {
    return passed.isOneOfMany() && passed.moveToCollected(search, this, end);
  }

  /** Collects a hit of a shape, or of a part of the shape under test. */
  void collect(int hitShape, int hitElement, double hitB1, double hitB2) {
    passed.collect(inPart ? passed.testedShape : hitShape, hitElement, hitB1, hitB2);
  }

  /** Returns whether a hit comes after the one that the ray has passed. */
  boolean isAfterPassed(double newT, int newShape, int newElement) {
    return passed.isBefore(newT, newShape, newElement);
  }

  /** Returns whether a hit of a shape under test comes after the one that the ray has passed. */
  boolean isAfterPassed(double newT, int newElement) {
    return passed.isBefore(newT, 0, newElement);
  }

  /** Returns the ray of the current traversal; the scalar kernel uses only its inherited fields. */
  WideRay wideRay() {
    return inPart ? widePartRay : wideRay;
  }

  /** Returns the ray's origin in world space. */
  public Vec3 origin() {
    return new Vec3(originX, originY, originZ);
  }

  /** Returns the ray's direction in world space; it need not have unit length. */
  public Vec3 direction() {
    return new Vec3(directionX, directionY, directionZ);
  }

  /** Returns the unit direction opposite to the ray's direction. */
  Vec3 backwards() {
    return direction().negated().normalized();
  }

  /** Returns the part of the hit shape, such as the triangle of a mesh. */
  public int element() {
    return element;
  }

  /** Returns whether a hit was found since the ray was set. */
  public boolean isHit() {
    return shape >= 0;
  }

  /**
   * Returns the ray parameter of the hit, in units of the direction's length; before any hit, the
   * ray's end.
   */
  public double t() {
    return t;
  }

  /**
   * Returns the number of the hit shape, which is its index in the list that the {@link Bvh} was
   * built over; -1 without a hit.
   */
  public int shape() {
    return shape;
  }

  /** Returns the x of the ray's origin in the local space of a transform. */
  double localOriginX(Transform toWorld) {
    return toWorld.inversePointX(originX, originY, originZ);
  }

  /** Returns the y of the ray's origin in the local space of a transform. */
  double localOriginY(Transform toWorld) {
    return toWorld.inversePointY(originX, originY, originZ);
  }

  /** Returns the z of the ray's origin in the local space of a transform. */
  double localOriginZ(Transform toWorld) {
    return toWorld.inversePointZ(originX, originY, originZ);
  }

  /** Returns the x of the ray's direction in the local space of a transform, not normalized. */
  double localDirectionX(Transform toWorld) {
    return toWorld.inverseVectorX(directionX, directionY, directionZ);
  }

  /** Returns the y of the ray's direction in the local space of a transform, not normalized. */
  double localDirectionY(Transform toWorld) {
    return toWorld.inverseVectorY(directionX, directionY, directionZ);
  }

  /** Returns the z of the ray's direction in the local space of a transform, not normalized. */
  double localDirectionZ(Transform toWorld) {
    return toWorld.inverseVectorZ(directionX, directionY, directionZ);
  }
}
