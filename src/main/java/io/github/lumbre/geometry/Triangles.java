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
  /** Nine coordinates a triangle. */
  private final double[] vertices;

  /** Which shape, and which element of it, a triangle is. */
  private final int[] shape;

  private final int[] element;

  Triangles(double[] vertices, int[] shape, int[] element) {
    this.vertices = vertices;
    this.shape = shape;
    this.element = element;
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
      found |= intersectOne(i, kx, ky, kz, ox, oy, oz, sx, sy, sz, nearest);
    }
    return found;
  }

  /** The same for one triangle, given by its place in the order. */
  boolean intersectOne(
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
    double[] p = vertices;
    int base = 9 * i;
    // Move the origin to zero and shear the ray onto the axis kz.
    double az = p[base + kz] - oz;
    double bz = p[base + 3 + kz] - oz;
    double cz = p[base + 6 + kz] - oz;
    double ax = p[base + kx] - ox - sx * az;
    double ay = p[base + ky] - oy - sy * az;
    double bx = p[base + 3 + kx] - ox - sx * bz;
    double by = p[base + 3 + ky] - oy - sy * bz;
    double cx = p[base + 6 + kx] - ox - sx * cz;
    double cy = p[base + 6 + ky] - oy - sy * cz;
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
