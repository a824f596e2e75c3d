package generator;

/**
 * A solid given by the signed distance to its surface: negative inside, positive outside.
 *
 * <p>The distances of stretched, blended and cut solids are bounds, not exact: never much greater
 * than the truth, which is what {@link Mesher} relies on. The formulas of the basic solids are
 * those collected by I. Quilez, "Distance functions".
 */
@FunctionalInterface
interface Sdf {
  double at(double x, double y, double z);

  default double at(Vec p) {
    return at(p.x(), p.y(), p.z());
  }

  /** The unit direction in which the distance grows, by central differences of {@code step}. */
  default Vec normal(Vec p, double step) {
    return gradient(p, step).normalized();
  }

  /** The gradient of the distance, by central differences of {@code step}. */
  default Vec gradient(Vec p, double step) {
    double x = p.x();
    double y = p.y();
    double z = p.z();
    return new Vec(
            at(x + step, y, z) - at(x - step, y, z),
            at(x, y + step, z) - at(x, y - step, z),
            at(x, y, z + step) - at(x, y, z - step))
        .times(.5 / step);
  }

  static Sdf sphere(Vec c, double radius) {
    return (x, y, z) -> length(x - c.x(), y - c.y(), z - c.z()) - radius;
  }

  /** An ellipsoid with its axes along x, y and z. */
  static Sdf ellipsoid(Vec c, Vec r) {
    double smallest = Math.min(r.x(), Math.min(r.y(), r.z()));
    return (x, y, z) -> {
      double px = (x - c.x()) / r.x();
      double py = (y - c.y()) / r.y();
      double pz = (z - c.z()) / r.z();
      double k0 = length(px, py, pz);
      double k1 = length(px / r.x(), py / r.y(), pz / r.z());
      return k1 < 1e-9 ? -smallest : k0 * (k0 - 1) / k1;
    };
  }

  /** A cone between two spheres, together with them. */
  static Sdf limb(Vec a, Vec b, double radiusA, double radiusB) {
    Vec ba = b.minus(a);
    double l2 = ba.dot(ba);
    double rr = radiusA - radiusB;
    double a2 = l2 - rr * rr;
    double il2 = 1 / l2;
    return (px, py, pz) -> {
      double dx = px - a.x();
      double dy = py - a.y();
      double dz = pz - a.z();
      double y = dx * ba.x() + dy * ba.y() + dz * ba.z();
      double z = y - l2;
      double x2 =
          square(dx * l2 - ba.x() * y)
              + square(dy * l2 - ba.y() * y)
              + square(dz * l2 - ba.z() * y);
      double y2 = y * y * l2;
      double z2 = z * z * l2;
      double k = Math.signum(rr) * rr * rr * x2;
      if (Math.signum(z) * a2 * z2 > k) {
        return Math.sqrt(x2 + z2) * il2 - radiusB;
      }
      if (Math.signum(y) * a2 * y2 < k) {
        return Math.sqrt(x2 + y2) * il2 - radiusA;
      }
      return (Math.sqrt(x2 * a2 * il2) + y * rr) * il2 - radiusA;
    };
  }

  /** A truncated cone with flat ends at {@code a} and {@code b}, its edges rounded. */
  static Sdf cone(Vec a, Vec b, double radiusA, double radiusB, double rounding) {
    double length = b.minus(a).length();
    Vec axis = b.minus(a).normalized();
    Vec from = a.plus(axis.times(rounding));
    double h = length - 2 * rounding;
    double ra = radiusA - rounding;
    double rb = radiusB - rounding;
    double slope = rb - ra;
    double k = slope * slope + h * h;
    return (px, py, pz) -> {
      double dx = px - from.x();
      double dy = py - from.y();
      double dz = pz - from.z();
      double along = dx * axis.x() + dy * axis.y() + dz * axis.z();
      double radial = Math.sqrt(Math.max(0, dx * dx + dy * dy + dz * dz - along * along));
      double t = along / h;
      double capX = Math.max(0, radial - (t < .5 ? ra : rb));
      double capY = Math.abs(t - .5) - .5;
      double f = Math.max(0, Math.min(1, (slope * (radial - ra) + t * h * h) / k));
      double sideX = radial - ra - f * slope;
      double sideY = t - f;
      double sign = sideX < 0 && capY < 0 ? -1 : 1;
      double square =
          Math.min(capX * capX + capY * capY * h * h, sideX * sideX + sideY * sideY * h * h);
      return sign * Math.sqrt(square) - rounding;
    };
  }

  /** A box with its edges along x, y and z, rounded. */
  static Sdf box(Vec c, Vec half, double rounding) {
    return (x, y, z) -> {
      double qx = Math.abs(x - c.x()) - half.x() + rounding;
      double qy = Math.abs(y - c.y()) - half.y() + rounding;
      double qz = Math.abs(z - c.z()) - half.z() + rounding;
      double outside = length(Math.max(0, qx), Math.max(0, qy), Math.max(0, qz));
      return outside + Math.min(0, Math.max(qx, Math.max(qy, qz))) - rounding;
    };
  }

  /** A ring around the axis through {@code c} along the unit vector {@code axis}. */
  static Sdf torus(Vec c, Vec axis, double radius, double thickness) {
    return (px, py, pz) -> {
      Vec d = new Vec(px, py, pz).minus(c);
      double along = d.dot(axis);
      double radial = Math.sqrt(Math.max(0, d.dot(d) - along * along)) - radius;
      return Math.sqrt(radial * radial + along * along) - thickness;
    };
  }

  /** The half space behind the plane through {@code point} whose outward normal is given. */
  static Sdf behind(Vec point, Vec normal) {
    Vec n = normal.normalized();
    double d = point.dot(n);
    return (x, y, z) -> x * n.x() + y * n.y() + z * n.z() - d;
  }

  /** The union of solids, blended over the width {@code k}. */
  static Sdf union(double k, Sdf... parts) {
    return (x, y, z) -> {
      double d = parts[0].at(x, y, z);
      for (int i = 1; i < parts.length; i++) {
        d = smoothMin(d, parts[i].at(x, y, z), k);
      }
      return d;
    };
  }

  default Sdf or(double k, Sdf other) {
    return (x, y, z) -> smoothMin(at(x, y, z), other.at(x, y, z), k);
  }

  default Sdf and(double k, Sdf other) {
    return (x, y, z) -> -smoothMin(-at(x, y, z), -other.at(x, y, z), k);
  }

  default Sdf without(double k, Sdf other) {
    return (x, y, z) -> -smoothMin(-at(x, y, z), other.at(x, y, z), k);
  }

  /** This solid, thicker by {@code distance} all around. */
  default Sdf grown(double distance) {
    return (x, y, z) -> at(x, y, z) - distance;
  }

  /** This solid stretched about {@code c}. */
  default Sdf stretched(Vec c, double sx, double sy, double sz) {
    double smallest = Math.min(sx, Math.min(sy, sz));
    return (x, y, z) ->
        smallest * at(c.x() + (x - c.x()) / sx, c.y() + (y - c.y()) / sy, c.z() + (z - c.z()) / sz);
  }

  /** This solid turned about the axis through {@code c} along x (0), y (1) or z (2). */
  default Sdf turned(Vec c, int axis, double degrees) {
    double cos = StrictMath.cos(StrictMath.toRadians(degrees));
    double sin = StrictMath.sin(StrictMath.toRadians(degrees));
    return (x, y, z) -> {
      double dx = x - c.x();
      double dy = y - c.y();
      double dz = z - c.z();
      return switch (axis) {
        case 0 -> at(x, c.y() + cos * dy + sin * dz, c.z() - sin * dy + cos * dz);
        case 1 -> at(c.x() + cos * dx - sin * dz, y, c.z() + sin * dx + cos * dz);
        default -> at(c.x() + cos * dx + sin * dy, c.y() - sin * dx + cos * dy, z);
      };
    };
  }

  /** The mirror image in the plane x = 0. */
  default Sdf mirrored() {
    return (x, y, z) -> at(-x, y, z);
  }

  /** The half with x > 0 together with its mirror image. */
  default Sdf onBothSides() {
    return (x, y, z) -> at(Math.abs(x), y, z);
  }

  /** The smaller of two distances, with the corner between them rounded (Quilez, "Smooth min"). */
  static double smoothMin(double a, double b, double k) {
    if (k <= 0) {
      return Math.min(a, b);
    }
    double h = Math.max(0, k - Math.abs(a - b)) / k;
    return Math.min(a, b) - h * h * k / 4;
  }

  private static double square(double a) {
    return a * a;
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }
}
