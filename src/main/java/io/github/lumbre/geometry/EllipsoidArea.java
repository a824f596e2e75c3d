package io.github.lumbre.geometry;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;

/** Computes the surface area of ellipsoids with Carlson's symmetric elliptic integrals. */
final class EllipsoidArea {
  private static final int SWEEPS = 12;
  private static final double PRECISION = 1e-3;

  private EllipsoidArea() {}

  /** Returns the world-space area of the image of the unit sphere. */
  static double ofUnitSphere(Transform toWorld) {
    double[] squares = axesSquared(toWorld);
    double largest = Math.max(squares[0], Math.max(squares[1], squares[2]));
    double a = squares[0] / largest;
    double b = squares[1] / largest;
    double c = squares[2] / largest;
    return 4 * Math.PI * largest * integralG(a * b, a * c, b * c);
  }

  /** Returns the squared semi-axes: the eigenvalues of MᵀM, computed with Jacobi rotations. */
  private static double[] axesSquared(Transform m) {
    Vec3[] column = {m.vector(Vec3.X), m.vector(Vec3.Y), m.vector(Vec3.Z)};
    // One-sided Jacobi method: rotate pairs of columns until they are orthogonal.
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int i = 0; i < 3; i++) {
        makeOrthogonal(column, i, (i + 1) % 3);
      }
    }
    return new double[] {
      column[0].lengthSquared(), column[1].lengthSquared(), column[2].lengthSquared()
    };
  }

  private static void makeOrthogonal(Vec3[] column, int i, int j) {
    Vec3 p = column[i];
    Vec3 q = column[j];
    double between = p.dot(q);
    if (between == 0) {
      return;
    }
    double zeta = (q.lengthSquared() - p.lengthSquared()) / (2 * between);
    double tan = Math.copySign(1, zeta) / (Math.abs(zeta) + Math.sqrt(1 + zeta * zeta));
    double cos = 1 / Math.sqrt(1 + tan * tan);
    column[i] = p.times(cos).plus(-cos * tan, q);
    column[j] = q.times(cos).plus(cos * tan, p);
  }

  /** Returns R_G by DLMF 19.21.10, with the middle argument last to avoid cancellation. */
  private static double integralG(double x, double y, double z) {
    double low = Math.min(x, Math.min(y, z));
    double high = Math.max(x, Math.max(y, z));
    double middle = Math.max(Math.min(x, y), Math.min(Math.max(x, y), z));
    return .5
        * (middle * integralF(low, high, middle)
            - (low - middle) * (high - middle) * integralD(low, high, middle) / 3
            + Math.sqrt(low * high / middle));
  }

  /** Returns R_F (Carlson 1995, "Numerical Computation of Real or Complex Elliptic Integrals"). */
  private static double integralF(double x0, double y0, double z0) {
    double x = x0;
    double y = y0;
    double z = z0;
    double mean = (x + y + z) / 3;
    while (spread(x, y, z, mean) > PRECISION) {
      double lambda = Math.sqrt(x * y) + Math.sqrt(x * z) + Math.sqrt(y * z);
      x = .25 * (x + lambda);
      y = .25 * (y + lambda);
      z = .25 * (z + lambda);
      mean = (x + y + z) / 3;
    }
    double dx = 1 - x / mean;
    double dy = 1 - y / mean;
    double dz = -dx - dy;
    double e2 = dx * dy - dz * dz;
    double e3 = dx * dy * dz;
    return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / Math.sqrt(mean);
  }

  /** Returns R_D (Carlson 1995, as in {@link #integralF}). */
  private static double integralD(double x0, double y0, double z0) {
    double x = x0;
    double y = y0;
    double z = z0;
    double sum = 0;
    double factor = 1;
    double mean = (x + y + 3 * z) / 5;
    while (spread(x, y, z, mean) > PRECISION) {
      double lambda = Math.sqrt(x * y) + Math.sqrt(x * z) + Math.sqrt(y * z);
      sum += factor / (Math.sqrt(z) * (z + lambda));
      factor *= .25;
      x = .25 * (x + lambda);
      y = .25 * (y + lambda);
      z = .25 * (z + lambda);
      mean = (x + y + 3 * z) / 5;
    }
    double dx = 1 - x / mean;
    double dy = 1 - y / mean;
    double dz = -(dx + dy) / 3;
    double xy = dx * dy;
    double e2 = xy - 6 * dz * dz;
    double e3 = (3 * xy - 8 * dz * dz) * dz;
    double e4 = 3 * (xy - dz * dz) * dz * dz;
    double e5 = xy * dz * dz * dz;
    double series =
        1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
    return 3 * sum + factor * series / (mean * Math.sqrt(mean));
  }

  private static double spread(double x, double y, double z, double mean) {
    return Math.max(Math.abs(x - mean), Math.max(Math.abs(y - mean), Math.abs(z - mean))) / mean;
  }
}
