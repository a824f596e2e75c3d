package io.github.lumbre.model.difference;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.Comparator;

/**
 * The second moments of a surface about the origin, along perpendicular axes.
 *
 * @param moments in increasing order
 * @param vectors unit vectors of the axes
 */
record Inertia(double[] moments, Vec3[] vectors) {
  private static final int SWEEPS = 30;

  static Inertia of(TriangleTree surface) {
    double[][] m = new double[3][3];
    for (int t = 0; t < surface.count(); t++) {
      Vec3[] p = {surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
      Vec3 sum = p[0].plus(p[1]).plus(p[2]);
      double weight = p[1].minus(p[0]).cross(p[2].minus(p[0])).length() / 24;
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
          double products = sum.get(i) * sum.get(j);
          for (Vec3 corner : p) {
            products += corner.get(i) * corner.get(j);
          }
          m[i][j] += weight * products;
        }
      }
    }
    return of(m);
  }

  /** Finds the axes by rotations (Jacobi 1846). */
  private static Inertia of(double[]... m) {
    double[][] v = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int i = 0; i < 2; i++) {
        for (int j = i + 1; j < 3; j++) {
          if (m[i][j] != 0) {
            rotate(i, j, m, v);
          }
        }
      }
    }
    Integer[] order = {0, 1, 2};
    Arrays.sort(order, Comparator.comparingDouble(i -> m[i][i]));
    double[] moments = new double[3];
    Vec3[] vectors = new Vec3[3];
    for (int i = 0; i < 3; i++) {
      int from = order[i];
      moments[i] = m[from][from];
      vectors[i] = new Vec3(v[0][from], v[1][from], v[2][from]).normalized();
    }
    return new Inertia(moments, vectors);
  }

  private static void rotate(int i, int j, double[][] m, double[][] v) {
    double theta = (m[j][j] - m[i][i]) / (2 * m[i][j]);
    double t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
    double c = 1 / Math.sqrt(t * t + 1);
    double s = t * c;
    for (int k = 0; k < 3; k++) {
      double a = m[k][i];
      double b = m[k][j];
      m[k][i] = c * a - s * b;
      m[k][j] = s * a + c * b;
    }
    for (int k = 0; k < 3; k++) {
      double a = m[i][k];
      double b = m[j][k];
      m[i][k] = c * a - s * b;
      m[j][k] = s * a + c * b;
      double x = v[k][i];
      double y = v[k][j];
      v[k][i] = c * x - s * y;
      v[k][j] = s * x + c * y;
    }
  }

  /** Returns right-handed axes. The moment of the last differs most from the others. */
  Frame axes() {
    int special = isFirst() ? 0 : 2;
    Vec3 z = vectors[special];
    Vec3 x = vectors[1];
    return new Frame(x, z.cross(x), z);
  }

  private boolean isFirst() {
    return moments[1] - moments[0] > moments[2] - moments[1];
  }

  /** Returns whether the two other moments differ by less than a part of them. */
  boolean isRound(double part) {
    double other = isFirst() ? moments[2] - moments[1] : moments[1] - moments[0];
    return other <= part * moments[2];
  }
}
