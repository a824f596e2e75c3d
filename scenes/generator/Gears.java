package generator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Flat parts of a machine, lying in planes of constant y: everything has chamfered edges, which
 * catch the light.
 */
final class Gears {
  /** Where the points of a tooth are, as shares of its width, and how high, from its foot. */
  private static final double[][] TOOTH = {
    {0, 0}, {.22, 0}, {.34, .72}, {.44, 1}, {.66, 1}, {.76, .72}, {.88, 0}
  };

  private Gears() {}

  /** A point of an outline, seen from above: x, and z. */
  private record Point(double x, double z) {
    Point minus(Point o) {
      return new Point(x - o.x, z - o.z);
    }

    double length() {
      return StrictMath.hypot(x, z);
    }
  }

  /** Adds a toothed ring from the inner radius to the teeth, its middle at the height {@code y}. */
  static <C> void ring(
      Triangles<C> out, int teeth, double inner, double pitch, double y, double h) {
    int n = teeth * TOOTH.length;
    double tooth = 2 * Math.PI * pitch / teeth;
    List<Point> outer = new ArrayList<>();
    List<Point> bore = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      double[] point = TOOTH[i % TOOTH.length];
      double angle = 2 * Math.PI * (i / TOOTH.length + point[0]) / teeth;
      outer.add(polar(pitch + tooth * (.64 * point[1] - .34), angle));
      bore.add(polar(inner, angle));
    }
    loop(out, outer, bore, y, h, Math.min(.18 * tooth, .25 * h));
  }

  /** Adds a plain ring, smooth all around. */
  static void ring(Triangles<Integer> out, double inner, double radius, double y, double h) {
    double c = .2 * h;
    double top = y + h / 2;
    double foot = y - h / 2;
    new Lathe()
        .curve(1, inner, foot + c, inner + c, foot)
        .curve(1, inner + c, foot, radius - c, foot)
        .curve(1, radius - c, foot, radius, foot + c)
        .curve(1, radius, foot + c, radius, top - c)
        .curve(1, radius, top - c, radius - c, top)
        .curve(1, radius - c, top, inner + c, top)
        .curve(1, inner + c, top, inner, top - c)
        .curve(1, inner, top - c, inner, foot + c)
        .into(out, 64);
  }

  /** Adds spokes from the axis to the radius, wider at the hub. */
  static <C> void spokes(
      Triangles<C> out, int count, double radius, double width, double y, double h) {
    for (int i = 0; i < count; i++) {
      double a = 2 * Math.PI * (i + .25) / count;
      Point along = polar(1, a);
      List<Point> bar =
          List.of(
              at(along, 0, -.7 * width),
              at(along, 0, .7 * width),
              at(along, radius, .4 * width),
              at(along, radius, -.4 * width));
      convex(out, bar, y, h, .2 * h);
    }
  }

  /** Adds a plate that is round at both ends, from (x1, z1) to (x2, z2). */
  static <C> void bridge(
      Triangles<C> out, double[] from, double r1, double[] to, double r2, double y, double h) {
    double heading = StrictMath.atan2(to[1] - from[1], to[0] - from[0]);
    double distance = StrictMath.hypot(to[0] - from[0], to[1] - from[1]);
    double spread = StrictMath.acos((r1 - r2) / distance);
    List<Point> outline = new ArrayList<>();
    for (int i = 0; i <= 24; i++) {
      arc(outline, to, r2, heading + spread - 2 * spread * i / 24);
    }
    double rest = 2 * Math.PI - 2 * spread;
    for (int i = 0; i <= 32; i++) {
      arc(outline, from, r1, heading - spread - rest * i / 32);
    }
    convex(out, outline, y, h, .22 * h);
  }

  private static void arc(List<Point> outline, double[] center, double r, double angle) {
    Point p = polar(r, angle);
    outline.add(new Point(center[0] + p.x, center[1] + p.z));
  }

  /** Adds a slotted head of a screw around the axis, from the height {@code y} upwards. */
  static <C> void screw(Triangles<C> out, double radius, double y, double h, double turn) {
    double half = .13 * radius;
    List<Point> disc = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      disc.add(polar(radius, -2 * Math.PI * i / 40));
    }
    convex(out, disc, y + .22 * h, .44 * h, .02 * h);
    for (int side = 0; side < 2; side++) {
      double from = StrictMath.asin(half / radius);
      List<Point> part = new ArrayList<>();
      for (int i = 0; i <= 20; i++) {
        double angle = (side + 1) * Math.PI - from - (Math.PI - 2 * from) * i / 20;
        part.add(polar(radius, turn + angle));
      }
      convex(out, part, y + .7 * h, .6 * h, .16 * h);
    }
  }

  private static Point polar(double radius, double angle) {
    return new Point(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle));
  }

  private static Point at(Point along, double distance, double aside) {
    return new Point(along.x * distance - along.z * aside, along.z * distance + along.x * aside);
  }

  /** A slab between two outlines of as many points, both counterclockwise in x and z. */
  private static <C> void loop(
      Triangles<C> out, List<Point> outer, List<Point> inner, double y, double h, double chamfer) {
    List<Point> top = inset(outer, chamfer);
    List<Point> bore = inset(inner, -chamfer);
    for (int side = -1; side <= 1; side += 2) {
      double face = y + side * h / 2;
      double edge = face - side * chamfer;
      strip(out, top, face, bore, face, side < 0);
      strip(out, outer, edge, top, face, side < 0);
      strip(out, bore, face, inner, edge, side < 0);
    }
    strip(out, outer, y - h / 2 + chamfer, outer, y + h / 2 - chamfer, false);
    strip(out, inner, y + h / 2 - chamfer, inner, y - h / 2 + chamfer, false);
  }

  /** A slab with a convex outline, which runs clockwise in x and z. */
  private static <C> void convex(
      Triangles<C> out, List<Point> clockwise, double y, double h, double chamfer) {
    List<Point> outline = new ArrayList<>(clockwise);
    Collections.reverse(outline);
    List<Point> top = inset(outline, chamfer);
    for (int side = -1; side <= 1; side += 2) {
      double face = y + side * h / 2;
      strip(out, outline, face - side * chamfer, top, face, side < 0);
      Vec n = new Vec(0, side, 0);
      for (int i = 1; i + 1 < top.size(); i++) {
        C a = corner(out, top.get(0), face, n);
        C b = corner(out, top.get(i), face, n);
        C c = corner(out, top.get(i + 1), face, n);
        out.face(a, side < 0 ? b : c, side < 0 ? c : b);
      }
    }
    strip(out, outline, y - h / 2 + chamfer, outline, y + h / 2 - chamfer, false);
  }

  private static List<Point> inset(List<Point> outline, double distance) {
    int n = outline.size();
    List<Point> result = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      Point p = outline.get(i);
      Point before = p.minus(outline.get((i + n - 1) % n));
      Point after = outline.get((i + 1) % n).minus(p);
      double bx = -before.z / before.length() - after.z / after.length();
      double bz = before.x / before.length() + after.x / after.length();
      double scale = 2 * distance / Math.max(1, bx * bx + bz * bz);
      result.add(new Point(p.x + bx * scale, p.z + bz * scale));
    }
    return result;
  }

  /** Joins two closed outlines by flat faces, which face away from the slab. */
  private static <C> void strip(
      Triangles<C> out, List<Point> low, double y0, List<Point> high, double y1, boolean flipped) {
    for (int i = 0; i < low.size(); i++) {
      int j = (i + 1) % low.size();
      Point p = low.get(i);
      Point q = low.get(j);
      Vec a = new Vec(p.x, y0, p.z);
      Vec b = new Vec(q.x, y0, q.z);
      Vec c = new Vec(high.get(j).x, y1, high.get(j).z);
      Vec d = new Vec(high.get(i).x, y1, high.get(i).z);
      Vec n = d.minus(b).cross(c.minus(a)).times(flipped ? -1 : 1).normalized();
      C ca = corner(out, a, n);
      C cb = corner(out, b, n);
      C cc = corner(out, c, n);
      C cd = corner(out, d, n);
      out.face(ca, flipped ? cb : cc, flipped ? cc : cb);
      out.face(ca, flipped ? cc : cd, flipped ? cd : cc);
    }
  }

  private static <C> C corner(Triangles<C> out, Point p, double y, Vec n) {
    return corner(out, new Vec(p.x, y, p.z), n);
  }

  private static <C> C corner(Triangles<C> out, Vec p, Vec n) {
    return out.corner(p, 0, 0, n);
  }
}
