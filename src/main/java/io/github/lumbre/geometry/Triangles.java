package io.github.lumbre.geometry;

/**
 * Triangles in the order of a hierarchy's leaves, in flat arrays: the innermost loop of the
 * renderer, made of local variables on purpose. Immutable.
 *
 * <p>The test is watertight: a ray that meets an edge or a vertex of a closed mesh meets at least
 * one of the triangles there. Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection",
 * in double precision: both triangles at an edge compute its edge function from the same sheared
 * vertices, and so with the same size and opposite signs.
 */
final class Triangles {
  /** Nine coordinates a triangle; empty if they are left where they are. */
  private final double[] vertices;

  /** The mesh of each shape that is one. */
  private final TriangleMesh[] meshes;

  /** Which shape, and which element of it, a triangle is. */
  private final int[] shape;

  private final int[] element;

  /**
   * @param meshes by the number of their shape
   * @param shape the triangles' shapes, as element are their numbers in them
   * @param copied whether to keep a copy of the vertices, which is faster to read and takes 72
   *     bytes a triangle
   */
  Triangles(TriangleMesh[] meshes, int[] shape, int[] element, boolean copied) {
    this.meshes = meshes;
    this.shape = shape;
    this.element = element;
    vertices = new double[copied ? Math.multiplyExact(9, shape.length) : 0];
    for (int i = 0; 9 * i < vertices.length; i++) {
      meshes[shape[i]].copyVertices(element[i], vertices, 9 * i);
    }
  }

  /**
   * Looks for hits with the triangles of a leaf, from both sides, borders included, and stores
   * those that are nearest so far, or as near but of a lower shape and element.
   *
   * @param kx the axis that is sheared by sx, as ky by sy
   * @param kz the axis along which the direction is longest
   * @param sx direction along kx over that along kz
   * @param sz reciprocal of the direction along kz
   * @param ox origin along kx, as oy along ky and oz along kz
   */
  boolean intersect(
      int leaf,
      int kx,
      int ky,
      int kz,
      double ox,
      double oy,
      double oz,
      double sx,
      double sy,
      double sz,
      NearestHit nearest) {
    int first = LeafRef.first(leaf);
    int end = first + LeafRef.count(leaf);
    boolean found = false;
    for (int i = first; i < end; i++) {
      found |=
          intersectOne(
              i, vertices, 9 * i, 9 * i + 3, 9 * i + 6, kx, ky, kz, ox, oy, oz, sx, sy, sz,
              nearest);
    }
    return found;
  }

  /**
   * The same for one triangle, given by its place in the order, where its mesh has its vertices.
   */
  boolean intersectInMesh(
      int i,
      int kx,
      int ky,
      int kz,
      double ox,
      double oy,
      double oz,
      double sx,
      double sy,
      double sz,
      NearestHit nearest) {
    TriangleMesh mesh = meshes[shape[i]];
    int a = 3 * mesh.vertex(element[i], 0);
    int b = 3 * mesh.vertex(element[i], 1);
    int c = 3 * mesh.vertex(element[i], 2);
    return intersectOne(i, mesh.positions(), a, b, c, kx, ky, kz, ox, oy, oz, sx, sy, sz, nearest);
  }

  /** The same for vertices that begin at a, b and c of an array. */
  private boolean intersectOne(
      int i,
      double[] p,
      int a,
      int b,
      int c,
      int kx,
      int ky,
      int kz,
      double ox,
      double oy,
      double oz,
      double sx,
      double sy,
      double sz,
      NearestHit nearest) {
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
    // The origin is inside if the edge functions do not differ in sign.
    double u = cx * by - cy * bx;
    double v = ax * cy - ay * cx;
    double w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) {
      return false;
    }
    // Weigh the vertices anew without cancellation: in slivers the signs alone are to be trusted.
    double wa = Math.abs(differenceOfProducts(cx, by, cy, bx));
    double wb = Math.abs(differenceOfProducts(ax, cy, ay, cx));
    double wc = Math.abs(differenceOfProducts(bx, ay, by, ax));
    if (wa + wb + wc == 0) {
      wa = Math.abs(u);
      wb = Math.abs(v);
      wc = Math.abs(w);
    }
    // If all are zero, seen edge on, t is NaN, and no hit.
    double inverse = 1 / (wa + wb + wc);
    double b1 = wb * inverse;
    double b2 = wc * inverse;
    double t = (wa * inverse * az + b1 * bz + b2 * cz) * sz;
    if (!(t > 0 && (t < nearest.t || t == nearest.t && isBefore(i, nearest)))) {
      return false;
    }
    nearest.t = t;
    nearest.shape = shape[i];
    nearest.element = element[i];
    nearest.b1 = b1;
    nearest.b2 = b2;
    return true;
  }

  /** Returns ab − cd to within 1.5 ulp: Jeannerod, Louvet and Muller 2013, Kahan's algorithm. */
  private static double differenceOfProducts(double a, double b, double c, double d) {
    double cd = c * d;
    double error = Math.fma(-c, d, cd);
    return Math.fma(a, b, -cd) + error;
  }

  private boolean isBefore(int i, NearestHit nearest) {
    return shape[i] < nearest.shape || shape[i] == nearest.shape && element[i] < nearest.element;
  }
}
