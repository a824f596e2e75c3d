package io.github.lumbre.model.section;

import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelGeometry;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The surface in which a plane cuts a body: the inside of outlines. Mutable. */
final class Cap {
  private static final double[] NONE = {};
  private static final float[] NO_COLORS = {};

  /** Areas below this part of the square of the length of outlines may be none. */
  private static final double BALANCED = 1e-6;

  /** Common areas below this part of the whole one are rounding errors. */
  private static final double COMMON = 1e-6;

  private final CutPlane plane;
  private final PositionIndex index = new PositionIndex();
  private int[] segments = new int[64];
  private int size;
  private boolean open;

  Cap(CutPlane plane) {
    this.plane = plane;
  }

  /** Adds a line between points in world space; see {@link MeshCut.Lines}. */
  void add(Vec3 from, Vec3 to) {
    int a = index.number(from.x(), from.y(), from.z());
    int b = index.number(to.x(), to.y(), to.z());
    if (a == b) {
      return;
    }
    if (size == segments.length) {
      segments = Arrays.copyOf(segments, 2 * size);
    }
    segments[size++] = a;
    segments[size++] = b;
  }

  /** Adds the outlines of another cap. */
  void add(Cap other) {
    double[] points = other.index.positions();
    for (int i = 0; i < other.size; i += 2) {
      add(point(points, other.segments[i]), point(points, other.segments[i + 1]));
    }
  }

  /** Returns the area inside the outlines, negative if they are clockwise: around a cavity. */
  double area() {
    double[] points = index.positions();
    Vec3 origin = point(points, 0);
    Vec3 sum = Vec3.ZERO;
    for (int i = 0; i < size; i += 2) {
      Vec3 from = point(points, segments[i]).minus(origin);
      sum = sum.plus(from.cross(point(points, segments[i + 1]).minus(origin)));
    }
    return sum.dot(plane.normal()) / 2;
  }

  /** Returns whether the boxes around the outlines of two caps have a common area. */
  boolean isNear(Cap other) {
    double[] box = box();
    double[] there = other.box();
    return box[0] < there[2] && there[0] < box[2] && box[1] < there[3] && there[1] < box[3];
  }

  /** Returns the least and the largest coordinates in the plane. */
  private double[] box() {
    double[] points = index.positions();
    double[] box = {
      Double.POSITIVE_INFINITY,
      Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY,
      Double.NEGATIVE_INFINITY
    };
    for (int i = 0; i < points.length / 3; i++) {
      Vec3 p = point(points, i);
      box[0] = Math.min(box[0], plane.u(p));
      box[1] = Math.min(box[1], plane.v(p));
      box[2] = Math.max(box[2], plane.u(p));
      box[3] = Math.max(box[3], plane.v(p));
    }
    return box;
  }

  /** Returns both caps as one; empty if they have no common area. */
  Optional<Cap> union(Cap other) {
    Cap both = new Cap(plane);
    both.add(this);
    both.add(other);
    try {
      double apart = filledArea() + other.filledArea();
      return both.filledArea() < apart * (1 - COMMON) ? Optional.of(both) : Optional.empty();
    } catch (Triangulation.TooMuchException e) {
      return Optional.empty();
    }
  }

  private double filledArea() {
    return surface().map(Cap::area).orElse(0.);
  }

  private static double area(ModelGeometry surface) {
    double sum = 0;
    int[] corners = surface.indices();
    for (int i = 0; i < corners.length; i += 3) {
      Vec3 a = point(surface.positions(), corners[i]);
      Vec3 b = point(surface.positions(), corners[i + 1]).minus(a);
      sum += b.cross(point(surface.positions(), corners[i + 2]).minus(a)).length() / 2;
    }
    return sum;
  }

  /** Returns whether outlines surround as much clockwise as counterclockwise, or nothing. */
  boolean isBalanced() {
    double[] points = index.positions();
    double length = 0;
    for (int i = 0; i < size; i += 2) {
      length += point(points, segments[i]).minus(point(points, segments[i + 1])).length();
    }
    return length > 0 && Math.abs(area()) <= BALANCED * length * length;
  }

  /** Returns whether the first point of another cap's outlines is inside of these. */
  boolean surrounds(Cap other) {
    Vec3 inside = point(other.index.positions(), 0);
    double[] points = index.positions();
    int winding = 0;
    for (int i = 0; i < size; i += 2) {
      Vec3 from = point(points, segments[i]).minus(inside);
      Vec3 to = point(points, segments[i + 1]).minus(inside);
      boolean isUp = plane.v(from) <= 0 && plane.v(to) > 0;
      boolean isDown = plane.v(to) <= 0 && plane.v(from) > 0;
      double side = plane.u(from) * plane.v(to) - plane.v(from) * plane.u(to);
      winding += isUp && side > 0 ? 1 : isDown && side < 0 ? -1 : 0;
    }
    return winding != 0;
  }

  /**
   * Returns the surface in world space, whose texture coordinates are those of the plane; empty if
   * it has no area.
   *
   * @throws Triangulation.TooMuchException if outlines cross too often
   */
  Optional<ModelGeometry> surface() {
    double[] points = index.positions();
    int count = points.length / 3;
    double[] u = new double[count];
    double[] v = new double[count];
    Arrays.setAll(u, i -> plane.u(point(points, i)));
    Arrays.setAll(v, i -> plane.v(point(points, i)));
    double left = Arrays.stream(u).min().orElse(0);
    double low = Arrays.stream(v).min().orElse(0);
    double extent =
        Math.max(Arrays.stream(u).max().orElse(0) - left, Arrays.stream(v).max().orElse(0) - low);
    double unit = extent / Triangulation.GRID;
    if (!(unit > 0) || !Double.isFinite(unit)) {
      return Optional.empty();
    }
    int[] x = new int[count];
    int[] y = new int[count];
    Arrays.setAll(x, i -> (int) Math.rint((u[i] - left) / unit));
    Arrays.setAll(y, i -> (int) Math.rint((v[i] - low) / unit));
    open = !isClosed(x, y);
    if (open) {
      return Optional.empty();
    }
    Outlines.Region region = Outlines.region(x, y, Arrays.copyOf(segments, size));
    int[] given = region.given();
    double[] positions = new double[3 * given.length];
    double[] uv = new double[2 * given.length];
    for (int i = 0; i < given.length; i++) {
      Vec3 p =
          given[i] >= 0
              ? point(points, given[i])
              : plane.at(left + unit * region.x(i), low + unit * region.y(i));
      positions[3 * i] = p.x();
      positions[3 * i + 1] = p.y();
      positions[3 * i + 2] = p.z();
      uv[2 * i] = plane.u(p);
      uv[2 * i + 1] = plane.v(p);
    }
    return region.corners().length == 0
        ? Optional.empty()
        : Optional.of(
            new ModelGeometry(positions, NONE, NONE, uv, NONE, NO_COLORS, region.corners()));
  }

  private static Vec3 point(double[] points, int i) {
    return new Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  }

  /** Returns whether as many lines begin as end at each point of the grid. */
  private boolean isClosed(int[] x, int[] y) {
    Map<Long, Integer> balance = new HashMap<>();
    for (int i = 0; i < size; i++) {
      long place = (long) x[segments[i]] << 32 | y[segments[i]];
      balance.merge(place, i % 2 == 0 ? 1 : -1, Integer::sum);
    }
    return balance.values().stream().allMatch(b -> b == 0);
  }

  /** Returns whether {@link #surface} found an outline with a gap. */
  boolean isOpen() {
    return open;
  }
}
