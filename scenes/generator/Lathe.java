package generator;

import java.util.ArrayList;
import java.util.List;

/**
 * A closed surface of revolution around the y axis, outlined from its lowest point on the axis
 * outwards and back to the axis. Mutable while the outline is drawn.
 */
final class Lathe {
  private final List<double[]> points = new ArrayList<>();
  private final List<double[]> normals = new ArrayList<>();

  /** Adds a smooth curve through points (radius, height); it starts with a crease. */
  Lathe curve(int stepsPerPiece, double... radiusHeight) {
    int n = radiusHeight.length / 2;
    for (int i = 0; i + 1 < n; i++) {
      for (int s = 0; s <= stepsPerPiece; s++) {
        if (s < stepsPerPiece || i + 2 == n) {
          double t = (double) s / stepsPerPiece;
          add(hermite(radiusHeight, i, t, 0), hermite(radiusHeight, i, t, 1));
        }
      }
    }
    return this;
  }

  /** The Catmull-Rom curve in the piece from point i, and its derivative. */
  private static double[] hermite(double[] p, int i, double t, int derivative) {
    double[] result = new double[2];
    int last = p.length / 2 - 1;
    for (int k = 0; k < 2; k++) {
      double a = p[2 * i + k];
      double b = p[2 * i + 2 + k];
      double da = (b - p[2 * Math.max(0, i - 1) + k]) / (i > 0 ? 2 : 1);
      double db = (p[2 * Math.min(last, i + 2) + k] - a) / (i + 1 < last ? 2 : 1);
      double c2 = 3 * (b - a) - 2 * da - db;
      double c3 = 2 * (a - b) + da + db;
      result[k] =
          derivative == 0 ? a + t * (da + t * (c2 + t * c3)) : da + t * (2 * c2 + 3 * t * c3);
    }
    return result;
  }

  /** Adds an arc around (radius, height), from one angle to another in degrees; 0 is outwards. */
  Lathe arc(int steps, double radius, double height, double r, double from, double to) {
    for (int s = 0; s <= steps; s++) {
      double a = StrictMath.toRadians(from + (to - from) * s / steps);
      double c = StrictMath.cos(a);
      double d = StrictMath.sin(a);
      double turn = to > from ? 1 : -1;
      add(new double[] {radius + r * c, height + r * d}, new double[] {-d * turn, c * turn});
    }
    return this;
  }

  private void add(double[] point, double[] direction) {
    double length = Math.sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
    double[] normal = {direction[1] / length, -direction[0] / length};
    point[0] = Math.max(0, point[0]);
    if (!points.isEmpty()) {
      double[] p = points.get(points.size() - 1);
      double[] n = normals.get(normals.size() - 1);
      boolean same = StrictMath.hypot(p[0] - point[0], p[1] - point[1]) < 1e-6;
      if (same && n[0] * normal[0] + n[1] * normal[1] > .9) {
        return;
      }
    }
    points.add(point);
    normals.add(point[0] < 1e-9 ? new double[] {0, Math.signum(normal[1])} : normal);
  }

  /** Adds the surface in so many segments; u runs around, v along the outline. */
  <C, T extends Triangles<C>> T into(T out, int segments) {
    double[] lengths = new double[points.size()];
    for (int i = 1; i < lengths.length; i++) {
      double[] a = points.get(i - 1);
      double[] b = points.get(i);
      lengths[i] = lengths[i - 1] + StrictMath.hypot(b[0] - a[0], b[1] - a[1]);
    }
    double total = lengths[lengths.length - 1];
    for (int i = 0; i + 1 < points.size(); i++) {
      for (int s = 0; s < segments; s++) {
        C a = corner(out, i, s, segments, lengths[i] / total);
        C b = corner(out, i, s + 1, segments, lengths[i] / total);
        C c = corner(out, i + 1, s + 1, segments, lengths[i + 1] / total);
        C d = corner(out, i + 1, s, segments, lengths[i + 1] / total);
        out.face(a, d, b);
        out.face(d, c, b);
      }
    }
    return out;
  }

  private <C> C corner(Triangles<C> out, int i, int segment, int segments, double v) {
    double a = 2 * Math.PI * (segment % segments) / segments;
    double c = StrictMath.cos(a);
    double s = StrictMath.sin(a);
    double[] p = points.get(i);
    double[] n = normals.get(i);
    Vec position = new Vec(p[0] * c, p[1], p[0] * s);
    return out.corner(position, (double) segment / segments, v, new Vec(n[0] * c, n[1], n[0] * s));
  }
}
