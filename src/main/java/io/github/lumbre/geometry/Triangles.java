package io.github.lumbre.geometry;

import io.github.lumbre.math.internal.FusedMultiplyAdd;

/**
 * Triangles in the order of a hierarchy's leaves, in flat arrays. Their test is the renderer's
 * innermost loop, so it works on local variables. Immutable.
 *
 * <p>The test is watertight: a ray through an edge or a vertex of a closed mesh hits at least one
 * of the triangles there. It is the test of Woop, Benthin and Wald 2013, "Watertight Ray/Triangle
 * Intersection", in double precision. Both triangles at an edge compute the edge function from the
 * same sheared vertices, and both get its exact sign.
 */
final class Triangles {
  /** The maximum number of triangles that one task prepares. */
  private static final int MAX_PART = 1 << 14;

  /** The vertex coordinates of all meshes. */
  private final double[] positions;

  /** The offsets of each triangle's three vertices in {@code positions}. */
  private final int[] corners;

  /** The shape number of each triangle, and its element number in that shape. */
  private final int[] shape;

  private final int[] element;

  /**
   * Creates triangles that share the vertices of their meshes.
   *
   * @param meshes indexed by shape number; null for other shapes
   * @param joined their vertices
   * @param shape the shape number of each triangle
   * @param element the number of each triangle in its mesh
   */
  Triangles(TriangleMesh[] meshes, MeshPositions joined, int[] shape, int[] element) {
    positions = joined.all();
    corners = new int[Math.multiplyExact(3, shape.length)];
    this.shape = shape;
    this.element = element;
    new Corners(meshes, joined.start()).runAll(shape.length, MAX_PART);
  }

  private Triangles(double[] positions, int[] corners, int[] shape, int[] element) {
    this.positions = positions;
    this.corners = corners;
    this.shape = shape;
    this.element = element;
  }

  /** Returns the corners: the offsets of each triangle's three vertices, in leaf order. */
  int[] corners() {
    return corners;
  }

  /** Returns the same triangles for {@link #intersectOne} alone, without the corners. */
  Triangles withoutCorners() {
    return new Triangles(positions, new int[0], shape, element);
  }

  /** Sets the corners of triangles. */
  private final class Corners implements RangeWork {
    private final TriangleMesh[] meshes;
    private final int[] start;

    Corners(TriangleMesh[] meshes, int[] start) {
      this.meshes = meshes;
      this.start = start;
    }

    @Override
    public void run(int first, int end) {
      for (int i = first; i < end; i++) {
        set(i);
      }
    }

    private void set(int i) {
      TriangleMesh mesh = meshes[shape[i]];
      for (int corner = 0; corner < 3; corner++) {
        corners[3 * i + corner] = start[shape[i]] + 3 * mesh.vertex(element[i], corner);
      }
    }
  }

  /**
   * Tests the triangles of a leaf from both sides, borders included. Stores a hit beyond what the
   * ray has passed if it is the nearest so far, or equally near with a lower shape and element.
   *
   * @return whether a hit was stored
   */
  boolean intersect(int leaf, ShearedRay ray, NearestHit nearest) {
    int first = LeafRef.first(leaf);
    int end = first + LeafRef.count(leaf);
    boolean found = false;
    for (int i = first; i < end; i++) {
      found |=
          intersectOne(i, corners[3 * i], corners[3 * i + 1], corners[3 * i + 2], ray, nearest);
    }
    return found;
  }

  /**
   * Tests one triangle, as {@link #intersect} does.
   *
   * @param i the position of the triangle in leaf order
   * @param a its first corner; b and c are the others
   */
  boolean intersectOne(int i, int a, int b, int c, ShearedRay ray, NearestHit nearest) {
    int kx = ray.kx;
    int ky = ray.ky;
    int kz = ray.kz;
    double ox = ray.ox;
    double oy = ray.oy;
    double oz = ray.oz;
    double sx = ray.sx;
    double sy = ray.sy;
    double sz = ray.sz;
    double[] p = positions;
    // Move the origin to zero and shear the ray onto the axis kz.
    double az = p[a + kz] - oz;
    double bz = p[b + kz] - oz;
    double cz = p[c + kz] - oz;
    double ax = p[a + kx] - ox - sx * az;
    double ay = p[a + ky] - oy - sy * az;
    double bx = p[b + kx] - ox - sx * bz;
    double by = p[b + ky] - oy - sy * bz;
    double cx = p[c + kx] - ox - sx * cz;
    double cy = p[c + ky] - oy - sy * cz;
    // The origin is inside unless one edge function is negative and another positive. Sign bits
    // decide this without unpredictable branches.
    double u = differenceOfProducts(cx, by, cy, bx);
    double v = differenceOfProducts(ax, cy, ay, cx);
    double w = differenceOfProducts(bx, ay, by, ax);
    long signU = Double.doubleToRawLongBits(u);
    long signV = Double.doubleToRawLongBits(v);
    long signW = Double.doubleToRawLongBits(w);
    if (((signU | signV | signW) & (-signU | -signV | -signW)) < 0) {
      return false;
    }
    // If all are zero, the triangle is exactly edge-on: t is NaN, and there is no hit.
    double inverse = 1 / (u + v + w);
    double b1 = v * inverse;
    double b2 = w * inverse;
    double t = (u * inverse * az + b1 * bz + b2 * cz) * sz;
    if (!(t < nearest.t || t == nearest.t && isBefore(i, nearest))
        || !nearest.isAfterPassed(t, shape[i], element[i])) {
      return false;
    }
    if (nearest.passed.isCollecting) {
      nearest.collect(shape[i], element[i], b1, b2);
      return false;
    }
    nearest.t = t;
    nearest.shape = shape[i];
    nearest.element = element[i];
    nearest.b1 = b1;
    nearest.b2 = b2;
    return true;
  }

  /**
   * Returns ab − cd to within 1.5 ulp, and therefore with the exact sign, unless a product
   * underflows. An exact zero is 0, not -0. Source: Jeannerod, Louvet and Muller 2013, "Further
   * Analysis of Kahan's Algorithm for the Accurate Computation of 2 × 2 Determinants".
   */
  private static double differenceOfProducts(double a, double b, double c, double d) {
    double cd = c * d;
    double error = FusedMultiplyAdd.of(-c, d, cd);
    return FusedMultiplyAdd.of(a, b, -cd) + error;
  }

  private boolean isBefore(int i, NearestHit nearest) {
    return shape[i] < nearest.shape || shape[i] == nearest.shape && element[i] < nearest.element;
  }
}
