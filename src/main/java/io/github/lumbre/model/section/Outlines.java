package io.github.lumbre.model.section;

import io.github.lumbre.model.section.Triangulation.Work;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/**
 * The region inside directed closed outlines by the nonzero winding rule, as triangles whose
 * corners all meet corners. Outlines may touch, overlap and cross themselves and each other.
 *
 * <p>The outlines become edges of a {@link Triangulation}. Where two segments cross, both get a new
 * point, the nearest one of the grid or an end of a segment beside it, so that they are bent by a
 * few units of the grid and orientations stay exact. Each edge counts how often outlines follow it;
 * from outside, these counts sum up to the winding number of each triangle.
 */
final class Outlines {
  /** Steps of work for each segment, and at least. */
  private static final long STEPS = 100;

  private static final long FEWEST_STEPS = 4_000_000;

  /** A point that was not given. */
  static final int NEW = -1;

  /** The largest distance at which a crossing moves to the end of a segment, along each axis. */
  private static final int NEAR = 2;

  private final Work work;
  private final Triangulation mesh;
  private final Deque<Segment> open = new ArrayDeque<>();

  /** A part of an outline that is not yet an edge, followed some times. */
  private record Segment(int from, int to, int times) {}

  private Outlines(Work work) {
    this.work = work;
    mesh = new Triangulation(work);
  }

  /**
   * The triangles inside outlines.
   *
   * @param given for each point, the number of the given point that it is, or {@link #NEW} for one
   *     where outlines cross
   * @param corners three numbers of points per triangle, counterclockwise
   */
  record Region(Triangulation mesh, int[] given, int[] corners) {
    /** Returns a coordinate of a point on the grid. */
    int x(int point) {
      return mesh.x(point + Triangulation.OUTER);
    }

    /** Returns a coordinate of a point on the grid. */
    int y(int point) {
      return mesh.y(point + Triangulation.OUTER);
    }
  }

  /**
   * Returns the region inside outlines.
   *
   * @param x coordinates of distinct points, from 0 to {@link Triangulation#GRID}
   * @param y as x
   * @param segments numbers of two points each, from and to; they form closed outlines
   * @throws Triangulation.TooMuchException if outlines cross too often
   */
  static Region region(int[] x, int[] y, int... segments) {
    Work work = new Work(Math.max(FEWEST_STEPS, STEPS * segments.length / 2));
    Outlines outlines = new Outlines(work);
    int[] vertices = outlines.add(x, y);
    for (int i = 0; i < segments.length; i += 2) {
      outlines.open.push(new Segment(vertices[segments[i]], vertices[segments[i + 1]], 1));
      while (!outlines.open.isEmpty()) {
        outlines.insert(outlines.open.pop());
      }
    }
    return outlines.inside(vertices);
  }

  /** Adds points along a space-filling curve, so that each is near the one before. */
  private int[] add(int[] x, int[] y) {
    long[] order = new long[x.length];
    Arrays.setAll(order, i -> hilbert(x[i] >> 11, y[i] >> 11) << 32 | i);
    Arrays.sort(order);
    int[] vertices = new int[x.length];
    for (long each : order) {
      int i = (int) each;
      vertices[i] = mesh.add(x[i], y[i]);
    }
    return vertices;
  }

  /** Returns the place of a cell of 2^16 squared ones on Hilbert's curve, in 31 bits. */
  private static long hilbert(int column, int row) {
    int cx = Math.min(column, 0x7fff);
    int cy = Math.min(row, 0x7fff);
    long place = 0;
    for (int s = 1 << 14; s > 0; s >>= 1) {
      int rx = (cx & s) > 0 ? 1 : 0;
      int ry = (cy & s) > 0 ? 1 : 0;
      place += (long) s * s * (3 * rx ^ ry);
      if (ry == 0) {
        int swapped = rx == 1 ? 0x7fff - cx : cx;
        cx = rx == 1 ? 0x7fff - cy : cy;
        cy = swapped;
      }
    }
    return place;
  }

  /** Makes a segment an edge, or a chain of edges and open segments. */
  private void insert(Segment segment) {
    int a = segment.from;
    int b = segment.to;
    if (a == b || segment.times == 0) {
      return;
    }
    int first = leaving(a, b);
    if (mesh.apex(first) == a) {
      cross(segment, first);
      return;
    }
    // The half-edge leads along the segment.
    mesh.addDelta(first, segment.times);
    open.push(new Segment(mesh.to(first), b, segment.times));
  }

  /**
   * Returns the half-edge from a vertex along the way to another one, or else the half-edge
   * opposite to the vertex that the way crosses.
   */
  private int leaving(int a, int b) {
    int t = mesh.triangleAt(a);
    while (true) {
      work.step();
      int k = mesh.vertex(t, 0) == a ? 0 : mesh.vertex(t, 1) == a ? 1 : 2;
      int right = mesh.vertex(t, k + 1);
      int left = mesh.vertex(t, k + 2);
      long ofRight = mesh.area(a, right, b);
      long ofLeft = mesh.area(a, left, b);
      // Edge k + 2 leads from a to the right corner.
      if (ofRight == 0 && isAhead(a, right, b)) {
        return 3 * t + (k + 2) % 3;
      }
      if (ofRight > 0 && ofLeft < 0) {
        return 3 * t + k;
      }
      t = mesh.twin(3 * t + (k + 2) % 3) / 3;
    }
  }

  private boolean isAhead(int a, int v, int b) {
    long dx = (long) mesh.x(v) - mesh.x(a);
    long dy = (long) mesh.y(v) - mesh.y(a);
    return dx * ((long) mesh.x(b) - mesh.x(a)) + dy * ((long) mesh.y(b) - mesh.y(a)) > 0;
  }

  /** Makes a way for a segment that crosses an edge, or divides it at the first outline. */
  private void cross(Segment segment, int first) {
    int a = segment.from;
    int b = segment.to;
    Passage passage = new Passage(mesh, first);
    int e = first;
    while (mesh.delta(e) == 0) {
      work.step();
      int q = mesh.apex(mesh.twin(e));
      long side = mesh.area(a, b, q);
      if (side == 0) {
        mesh.addDelta(passage.end(e), segment.times);
        open.push(new Segment(q, b, segment.times));
        return;
      }
      e = side > 0 ? passage.passLeft(e) : passage.passRight(e);
    }
    divide(segment, e);
  }

  /** Divides a segment and an edge of an outline where they cross. */
  private void divide(Segment segment, int e) {
    int a = segment.from;
    int b = segment.to;
    int l = mesh.from(e);
    int r = mesh.to(e);
    int times = mesh.delta(e);
    double ofL = mesh.area(a, b, l);
    double ofR = mesh.area(a, b, r);
    double s = ofL / (ofL - ofR);
    int px = between(mesh.x(l), mesh.x(r), s);
    int py = between(mesh.y(l), mesh.y(r), s);
    int near = near(px, py, l, r, a, b);
    int p = near == NEW ? mesh.add(px, py) : near;
    int edge = edge(l, r);
    // If the new point is exactly on the edge, it has divided it.
    if (p != l && p != r && edge >= 0) {
      mesh.addDelta(edge, -times);
      open.push(new Segment(l, p, times));
      open.push(new Segment(p, r, times));
    }
    if (p == a || p == b) {
      open.push(segment);
    } else {
      open.push(new Segment(a, p, segment.times));
      open.push(new Segment(p, b, segment.times));
    }
  }

  /**
   * Returns a vertex that is nearly at a point. If it did not end there, a segment would cross the
   * others at the vertex again and again, each time a unit farther.
   */
  private int near(int px, int py, int... vertices) {
    for (int v : vertices) {
      if (Math.abs(mesh.x(v) - px) <= NEAR && Math.abs(mesh.y(v) - py) <= NEAR) {
        return v;
      }
    }
    return NEW;
  }

  private static int between(int from, int to, double s) {
    return (int) Math.rint(from + s * ((double) to - from));
  }

  /** Returns the half-edge between two vertices; -1 if there is none. */
  private int edge(int from, int to) {
    int start = mesh.triangleAt(from);
    int t = start;
    do {
      work.step();
      int k = mesh.vertex(t, 0) == from ? 0 : mesh.vertex(t, 1) == from ? 1 : 2;
      if (mesh.vertex(t, k + 1) == to) {
        return 3 * t + (k + 2) % 3;
      }
      t = mesh.twin(3 * t + (k + 2) % 3) / 3;
    } while (t != start);
    return -1;
  }

  /** Returns the triangles whose winding number is not 0, found from outside. */
  private Region inside(int... vertices) {
    int[] winding = new int[mesh.triangles()];
    boolean[] known = new boolean[mesh.triangles()];
    int[] queue = new int[mesh.triangles()];
    int size = 0;
    int inside = 0;
    queue[size++] = mesh.triangleAt(0);
    known[queue[0]] = true;
    for (int i = 0; i < size; i++) {
      int t = queue[i];
      inside += winding[t] == 0 ? 0 : 1;
      for (int e = 3 * t; e < 3 * t + 3; e++) {
        int other = mesh.twin(e);
        if (other >= 0 && !known[other / 3]) {
          known[other / 3] = true;
          winding[other / 3] = winding[t] - mesh.delta(e);
          queue[size++] = other / 3;
        }
      }
    }
    int[] corners = new int[3 * inside];
    int at = 0;
    for (int t = 0; t < winding.length; t++) {
      for (int k = 0; k < 3 && winding[t] != 0; k++) {
        corners[at++] = mesh.vertex(t, k) - Triangulation.OUTER;
      }
    }
    int[] given = new int[mesh.points() - Triangulation.OUTER];
    Arrays.fill(given, NEW);
    for (int i = 0; i < vertices.length; i++) {
      given[vertices[i] - Triangulation.OUTER] = i;
    }
    return new Region(mesh, given, corners);
  }
}
