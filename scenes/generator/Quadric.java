package generator;

/**
 * The sum of squared distances from planes, as a function of position (Garland and Heckbert,
 * "Surface Simplification Using Quadric Error Metrics", 1997). Mutable.
 */
final class Quadric {
  private double xx;
  private double xy;
  private double xz;
  private double yy;
  private double yz;
  private double zz;
  private double x;
  private double y;
  private double z;
  private double c;

  /** Adds the plane through {@code p} with unit normal {@code n}, weighted. */
  void addPlane(Vec n, Vec p, double weight) {
    double d = -n.dot(p);
    xx += weight * n.x() * n.x();
    xy += weight * n.x() * n.y();
    xz += weight * n.x() * n.z();
    yy += weight * n.y() * n.y();
    yz += weight * n.y() * n.z();
    zz += weight * n.z() * n.z();
    x += weight * n.x() * d;
    y += weight * n.y() * d;
    z += weight * n.z() * d;
    c += weight * d * d;
  }

  void add(Quadric o) {
    xx += o.xx;
    xy += o.xy;
    xz += o.xz;
    yy += o.yy;
    yz += o.yz;
    zz += o.zz;
    x += o.x;
    y += o.y;
    z += o.z;
    c += o.c;
  }

  double at(Vec p) {
    double gx = xx * p.x() + xy * p.y() + xz * p.z() + 2 * x;
    double gy = xy * p.x() + yy * p.y() + yz * p.z() + 2 * y;
    double gz = xz * p.x() + yz * p.y() + zz * p.z() + 2 * z;
    return Math.max(0, gx * p.x() + gy * p.y() + gz * p.z() + c);
  }

  /** The position of least error, or {@code fallback} where the planes do not settle it. */
  Vec minimum(Vec fallback) {
    double a = yy * zz - yz * yz;
    double b = xz * yz - xy * zz;
    double d = xy * yz - xz * yy;
    double det = xx * a + xy * b + xz * d;
    double trace = xx + yy + zz;
    if (Math.abs(det) < 1e-5 * trace * trace * trace) {
      return fallback;
    }
    double e = xx * zz - xz * xz;
    double f = xy * xz - xx * yz;
    double g = xx * yy - xy * xy;
    return new Vec(
        -(a * x + b * y + d * z) / det,
        -(b * x + e * y + f * z) / det,
        -(d * x + f * y + g * z) / det);
  }
}
