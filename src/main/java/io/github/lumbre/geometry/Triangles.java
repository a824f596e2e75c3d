package io.github.lumbre.geometry;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Triangles in the order of a hierarchy's leaves, in flat arrays: the innermost loop of the
 * renderer, made of local variables on purpose. Immutable.
 *
 * <p>The test is watertight: a ray that meets an edge or a vertex of a closed mesh meets at least
 * one of the triangles there. Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection",
 * in double precision: both triangles at an edge compute its edge function from the same sheared
 * vertices, and both with exactly the sign that those give it.
 */
final class Triangles {
  /** Coordinates of the vertices of all meshes. */
  private final double[] positions;

  /** Where each triangle's three vertices are among the positions. */
  private final int[] corners;

  /** Which shape, and which element of it, a triangle is. */
  private final int[] shape;

  private final int[] element;

  /**
   * Takes triangles, which share the vertices of their meshes.
   *
   * @param meshes by the number of their shape
   * @param shape the triangles' shapes, as element are their numbers in them
   */
  Triangles(TriangleMesh[] meshes, int[] shape, int[] element) {
    int[] start = new int[meshes.length];
    int end = 0;
    for (int i = 0; i < meshes.length; i++) {
      start[i] = end;
      end = Math.addExact(end, meshes[i] == null ? 0 : meshes[i].positions().length);
    }
    positions = joined(meshes, end);
    corners = new int[Math.multiplyExact(3, shape.length)];
    for (int k = 0; k < corners.length; k++) {
      int i = k / 3;
      corners[k] = start[shape[i]] + 3 * meshes[shape[i]].vertex(element[i], k % 3);
    }
    this.shape = shape;
    this.element = element;
  }

  /** Returns the positions of all meshes, which are so many; of a single one, its own array. */
  private static double[] joined(TriangleMesh[] meshes, int length) {
    List<double[]> parts =
        Arrays.stream(meshes).filter(Objects::nonNull).map(TriangleMesh::positions).toList();
    if (parts.size() == 1) {
      return parts.get(0);
    }
    double[] all = new double[length];
    int end = 0;
    for (double[] part : parts) {
      System.arraycopy(part, 0, all, end, part.length);
      end += part.length;
    }
    return all;
  }

  /**
   * Looks for hits with the triangles of a leaf, from both sides, borders included, and stores
   * those that are nearest so far, or as near but of a lower shape and element.
   */
  boolean intersect(int leaf, ShearedRay ray, NearestHit nearest) {
    int first = LeafRef.first(leaf);
    int end = first + LeafRef.count(leaf);
    boolean found = false;
    for (int i = first; i < end; i++) {
      found |= intersectOne(i, ray, nearest);
    }
    return found;
  }

  /** The same for one triangle, given by its place in the order. */
  boolean intersectOne(int i, ShearedRay ray, NearestHit nearest) {
    int a = corners[3 * i];
    int b = corners[3 * i + 1];
    int c = corners[3 * i + 2];
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
    // The origin is inside if the edge functions do not differ in sign: if not one is negative and
    // another positive. Their bits tell; a branch for each would go either way as often.
    double u = differenceOfProducts(cx, by, cy, bx);
    double v = differenceOfProducts(ax, cy, ay, cx);
    double w = differenceOfProducts(bx, ay, by, ax);
    long signU = Double.doubleToRawLongBits(u);
    long signV = Double.doubleToRawLongBits(v);
    long signW = Double.doubleToRawLongBits(w);
    if (((signU | signV | signW) & (-signU | -signV | -signW)) < 0) {
      return false;
    }
    // If all are zero, exactly edge on, t is NaN, and no hit.
    double inverse = 1 / (u + v + w);
    double b1 = v * inverse;
    double b2 = w * inverse;
    double t = (u * inverse * az + b1 * bz + b2 * cz) * sz;
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

  /**
   * Returns ab − cd to within 1.5 ulp, and so with its sign, and 0, not -0, if it is 0, unless a
   * product is below the range of doubles: Jeannerod, Louvet and Muller 2013, "Further Analysis of
   * Kahan's Algorithm for the Accurate Computation of 2 × 2 Determinants".
   */
  private static double differenceOfProducts(double a, double b, double c, double d) {
    double cd = c * d;
    double error = Math.fma(-c, d, cd);
    return Math.fma(a, b, -cd) + error;
  }

  private boolean isBefore(int i, NearestHit nearest) {
    return shape[i] < nearest.shape || shape[i] == nearest.shape && element[i] < nearest.element;
  }
}
