package generator;

/** A round wire along a curve in a plane of constant z, closed at both ends by flat caps. */
final class Tube {
  private static final int AROUND = 12;

  private Tube() {}

  /** Adds a wire through points (x, y), which are joined by straight pieces with smooth normals. */
  static <C> void into(Triangles<C> out, double radius, double[][] points) {
    for (int i = 0; i + 1 < points.length; i++) {
      for (int j = 0; j < AROUND; j++) {
        C a = corner(out, radius, points, i, j);
        C b = corner(out, radius, points, i, j + 1);
        C c = corner(out, radius, points, i + 1, j + 1);
        C d = corner(out, radius, points, i + 1, j);
        out.face(a, b, c);
        out.face(a, c, d);
      }
    }
    cap(out, radius, points, 0, -1);
    cap(out, radius, points, points.length - 1, 1);
  }

  private static <C> C corner(Triangles<C> out, double radius, double[][] points, int i, int j) {
    Vec n = around(direction(points, i), j);
    Vec p = new Vec(points[i][0], points[i][1], 0).plus(n.times(radius));
    return out.corner(p, (double) j / AROUND, (double) i / (points.length - 1), n);
  }

  private static Vec around(Vec along, int j) {
    double angle = 2 * Math.PI * (j % AROUND) / AROUND;
    Vec side = new Vec(along.y(), -along.x(), 0);
    return side.times(StrictMath.cos(angle)).plus(new Vec(0, 0, -StrictMath.sin(angle)));
  }

  private static Vec direction(double[][] points, int i) {
    double[] a = points[Math.max(0, i - 1)];
    double[] b = points[Math.min(points.length - 1, i + 1)];
    return new Vec(b[0] - a[0], b[1] - a[1], 0).normalized();
  }

  private static <C> void cap(Triangles<C> out, double radius, double[][] points, int i, int side) {
    Vec along = direction(points, i);
    Vec n = along.times(side);
    Vec center = new Vec(points[i][0], points[i][1], 0);
    C middle = out.corner(center, 0, 0, n);
    for (int j = 0; j < AROUND; j++) {
      C a = out.corner(center.plus(around(along, j).times(radius)), 0, 0, n);
      C b = out.corner(center.plus(around(along, j + 1).times(radius)), 0, 0, n);
      out.face(middle, side > 0 ? a : b, side > 0 ? b : a);
    }
  }
}
