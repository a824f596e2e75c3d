package generator;

/**
 * A tube around the trefoil knot (2 + cos 3t)·(cos 2t, 0, sin 2t) + sin 3t · (0, 1, 0), with
 * normals and with uv that grow along the knot and around the tube.
 */
final class TorusKnot {
  private static final int ALONG = 325;
  private static final int AROUND = 40;
  private static final double RADIUS = .58;

  static String obj() {
    StringBuilder out = new StringBuilder("# trefoil, " + 2 * ALONG * AROUND + " triangles\n");
    for (int i = 0; i <= ALONG; i++) {
      for (int j = 0; j <= AROUND; j++) {
        vertex(out, (double) i / ALONG, (double) j / AROUND);
      }
    }
    for (int i = 0; i < ALONG; i++) {
      for (int j = 0; j < AROUND; j++) {
        int a = i * (AROUND + 1) + j + 1;
        int b = a + AROUND + 1;
        face(out, a, b, b + 1);
        face(out, a, b + 1, a + 1);
      }
    }
    return out.toString();
  }

  /** One vertex; u along the knot and v around the tube, both in [0,1]. */
  private static void vertex(StringBuilder out, double u, double v) {
    double t = 2 * Math.PI * u;
    double angle = 2 * Math.PI * v;
    double[] here = knot(t);
    double[] tangent = unit(sum(knot(t + 1e-4), 1, knot(t - 1e-4), -1));
    // The knot lies on a torus, whose normal turns with it more evenly than the curve's own.
    double[] outward = torusNormal(t);
    double[] sideways = unit(cross(tangent, outward));
    double[] normal = sum(outward, StrictMath.cos(angle), sideways, StrictMath.sin(angle));
    line(out, "v", sum(here, 1, normal, RADIUS));
    line(out, "vt", new double[] {u, v});
    line(out, "vn", normal);
  }

  private static double[] knot(double t) {
    double ring = 2 + StrictMath.cos(3 * t);
    return new double[] {
      ring * StrictMath.cos(2 * t), StrictMath.sin(3 * t), ring * StrictMath.sin(2 * t)
    };
  }

  private static double[] torusNormal(double t) {
    double c = StrictMath.cos(3 * t);
    return new double[] {
      c * StrictMath.cos(2 * t), StrictMath.sin(3 * t), c * StrictMath.sin(2 * t)
    };
  }

  private static void line(StringBuilder out, String key, double[] numbers) {
    out.append(key);
    for (double number : numbers) {
      out.append(' ').append(Json.scalar(number));
    }
    out.append('\n');
  }

  private static void face(StringBuilder out, int... vertices) {
    out.append('f');
    for (int v : vertices) {
      out.append(' ').append(v).append('/').append(v).append('/').append(v);
    }
    out.append('\n');
  }

  private static double[] sum(double[] a, double s, double[] b, double t) {
    return new double[] {a[0] * s + b[0] * t, a[1] * s + b[1] * t, a[2] * s + b[2] * t};
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }

  private static double[] unit(double[] a) {
    double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return new double[] {a[0] / length, a[1] / length, a[2] / length};
  }
}
