package io.github.lumbre.geometry;

/**
 * The nearest hit found so far along one ray, and the scratch memory of the search. Mutable, one
 * for each thread, reused ray after ray.
 */
public final class NearestHit {
  /** The most nodes that one search puts aside: seven for each level of nodes of eight. */
  private static final int STACK = 7 * BvhBuilder.MAX_DEPTH + 1;

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

  /** Coordinates of a ray, to be chosen from by an axis' number without a branch. */
  final double[] axes = new double[9];

  /** The same for the children of one node. */
  final int[] lanes = new int[WideTree.WIDTH];

  /** Makes the memory of a search; there is no hit yet. */
  public NearestHit() {}

  /** Forgets the last ray. */
  void start(double tMax) {
    t = tMax;
    shape = -1;
    stackTop = 0;
    any = false;
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
}
