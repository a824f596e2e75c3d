package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/**
 * A ray, the nearest hit found so far along it, and the scratch memory of the search. Mutable, one
 * for each thread, aimed anew for every ray: plain numbers, so that following a ray makes no
 * object.
 */
public final class NearestHit {
  /** The most nodes that one search puts aside: seven for each level of nodes of eight. */
  private static final int STACK = 7 * BvhBuilder.MAX_DEPTH + 2;

  /** Where the ray begins, excluded, and its direction: not zero, and t is in units of it. */
  double originX;

  double originY;
  double originZ;
  double directionX;
  double directionY;
  double directionZ;

  /** Ray parameter of the hit; before any hit, the ray's end. */
  double t;

  /** Number of the shape that was hit, or -1. */
  int shape;

  /** Part of the shape: a mesh's triangle, a box's face. */
  int element;

  /** Barycentric weights of a triangle's second and third vertex. */
  double b1;

  double b2;

  /** Whether any hit will do, so that the search may stop at the first. */
  boolean any;

  /** Nodes still to visit; nested searches (instances) use the part from stackTop on. */
  final int[] stack = new int[2 * STACK];

  /** Where the ray enters the nodes still to visit, as integers in the order of t. */
  final int[] stackNear = new int[2 * STACK];

  int stackTop;

  /** What the shape says of its surface at the hit, once it is asked. */
  final SurfaceHit surface = new SurfaceHit();

  /** Whether the search is in a hierarchy that is a shape of another. */
  boolean inPart;

  /** The ray in a hierarchy of floats, and in one that is a shape of another. */
  private final WideRay wideRay = new WideRay();

  private final WideRay widePartRay = new WideRay();

  /** Where the ray enters the children of one node. */
  final int[] lanes = new int[WideTree.WIDTH];

  /** Makes the memory of a search; there is no ray and no hit yet. */
  public NearestHit() {}

  /** Takes another ray and forgets the last. */
  public void aim(Ray ray) {
    Vec3 o = ray.origin();
    Vec3 d = ray.direction();
    aim(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.tMax());
  }

  /** Takes another {@linkplain Ray ray}, given by its coordinates, and forgets the last. */
  public void aim(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
    originX = ox;
    originY = oy;
    originZ = oz;
    directionX = dx;
    directionY = dy;
    directionZ = dz;
    t = tMax;
    shape = -1;
    stackTop = 0;
    any = false;
    inPart = false;
  }

  /** Returns the memory for the ray of this search; one in doubles uses what it inherits alone. */
  WideRay wideRay() {
    return inPart ? widePartRay : wideRay;
  }

  /** Returns where the ray begins. */
  public Vec3 origin() {
    return new Vec3(originX, originY, originZ);
  }

  /** Returns the ray's direction. */
  public Vec3 direction() {
    return new Vec3(directionX, directionY, directionZ);
  }

  /** Returns the unit direction back to where the ray comes from. */
  Vec3 backwards() {
    return direction().negated().normalized();
  }

  public boolean isHit() {
    return shape >= 0;
  }

  /** Returns the ray parameter of the hit. */
  public double t() {
    return t;
  }

  /** Returns the number of the shape that was hit: its index in the list the Bvh was built from. */
  public int shape() {
    return shape;
  }

  /** Returns the x of the ray's origin in the space that a transform maps to the world. */
  double localOriginX(Transform toWorld) {
    return toWorld.inversePointX(originX, originY, originZ);
  }

  /** Returns the y of the ray's origin in the space that a transform maps to the world. */
  double localOriginY(Transform toWorld) {
    return toWorld.inversePointY(originX, originY, originZ);
  }

  /** Returns the z of the ray's origin in the space that a transform maps to the world. */
  double localOriginZ(Transform toWorld) {
    return toWorld.inversePointZ(originX, originY, originZ);
  }

  /** Returns the x of the ray's direction in that space; its length is not kept at 1. */
  double localDirectionX(Transform toWorld) {
    return toWorld.inverseVectorX(directionX, directionY, directionZ);
  }

  /** Returns the y of the ray's direction in that space; its length is not kept at 1. */
  double localDirectionY(Transform toWorld) {
    return toWorld.inverseVectorY(directionX, directionY, directionZ);
  }

  /** Returns the z of the ray's direction in that space; its length is not kept at 1. */
  double localDirectionZ(Transform toWorld) {
    return toWorld.inverseVectorZ(directionX, directionY, directionZ);
  }
}
