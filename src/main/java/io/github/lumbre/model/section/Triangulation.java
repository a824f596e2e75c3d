package io.github.lumbre.model.section;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.internal.ModelLimits;
import java.util.Arrays;

/**
 * A triangulation of points on an integer grid, to which points are added one by one: each new one
 * divides the triangle around it, and edges are flipped until circles around triangles hold no
 * other points, as far as doubles can decide it (Lawson 1977). Orientations are exact. Mutable.
 *
 * <p>Edge k of a triangle is opposite to its corner k, and leads from corner k + 1 to corner k + 2.
 * A half-edge is a triangle times 3, plus the edge. An edge with a {@linkplain #delta delta} other
 * than 0 is never flipped by a new point.
 */
final class Triangulation {
  /** The coordinates of points are from 0 to this number. */
  static final int GRID = 1 << 26;

  /** The vertices of the first triangle, which holds all points. */
  static final int OUTER = 3;

  private static final int NONE = -1;

  /** Relative error bound of the circle test with coordinates that are exact in doubles. */
  private static final double CIRCLE_ERROR = 0x1p-48;

  private final Work work;
  private int[] x = new int[64];
  private int[] y = new int[64];

  /** A triangle at each vertex. */
  private int[] at = new int[64];

  private int points;
  private int[] corner = new int[3 * 64];
  private int[] twin = new int[3 * 64];
  private int[] delta = new int[3 * 64];
  private int triangles;
  private int[] stack = new int[64];
  private int stacked;
  private int last;
  private int random = 1;

  /** Counts the steps of an algorithm against a limit, and checks for interrupts. Mutable. */
  static final class Work {
    private long left;

    Work(long limit) {
      left = limit;
    }

    /**
     * Counts a step.
     *
     * @throws TooMuchException if there were too many
     */
    void step() {
      if (--left < 0) {
        throw new TooMuchException();
      }
      if ((left & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
    }
  }

  /** Thrown if an outline takes too many steps. */
  static final class TooMuchException extends RuntimeException {
    private static final long serialVersionUID = 1;

    TooMuchException() {
      super("too many steps", null, false, false);
    }
  }

  Triangulation(Work work) {
    this.work = work;
    addVertex(-4 * GRID, -4 * GRID);
    addVertex(8 * GRID, -4 * GRID);
    addVertex(-4 * GRID, 8 * GRID);
    addTriangle(0, 1, 2);
    Arrays.fill(twin, 0, 3, NONE);
  }

  private int addVertex(int px, int py) {
    if (points == x.length) {
      x = Arrays.copyOf(x, 2 * points);
      y = Arrays.copyOf(y, 2 * points);
      at = Arrays.copyOf(at, 2 * points);
    }
    x[points] = px;
    y[points] = py;
    return points++;
  }

  private int addTriangle(int a, int b, int c) {
    int t = triangles++;
    if (3 * triangles > corner.length) {
      corner = Arrays.copyOf(corner, 2 * corner.length);
      twin = Arrays.copyOf(twin, 2 * twin.length);
      delta = Arrays.copyOf(delta, 2 * delta.length);
    }
    set(t, a, b, c);
    return t;
  }

  void set(int t, int a, int b, int c) {
    corner[3 * t] = a;
    corner[3 * t + 1] = b;
    corner[3 * t + 2] = c;
    at[a] = t;
    at[b] = t;
    at[c] = t;
  }

  int triangles() {
    return triangles;
  }

  int points() {
    return points;
  }

  int x(int vertex) {
    return x[vertex];
  }

  int y(int vertex) {
    return y[vertex];
  }

  /** Returns the triangle at a vertex that was changed last. */
  int triangleAt(int vertex) {
    return at[vertex];
  }

  /** Returns a vertex of a triangle, whose corners are counted modulo 3. */
  int vertex(int triangle, int number) {
    return corner[3 * triangle + number % 3];
  }

  /** Returns the half-edge of the neighboring triangle at the same edge; -1 at the border. */
  int twin(int halfEdge) {
    return twin[halfEdge];
  }

  /** Returns the vertex that a half-edge leads from. */
  int from(int halfEdge) {
    return corner[halfEdge - halfEdge % 3 + (halfEdge + 1) % 3];
  }

  /** Returns the vertex that a half-edge leads to. */
  int to(int halfEdge) {
    return corner[halfEdge - halfEdge % 3 + (halfEdge + 2) % 3];
  }

  /** Returns the vertex opposite to a half-edge. */
  int apex(int halfEdge) {
    return corner[halfEdge];
  }

  /** Returns how often outlines follow a half-edge, minus how often they follow its twin. */
  int delta(int halfEdge) {
    return delta[halfEdge];
  }

  /** Adds to the delta of a half-edge, and subtracts from the delta of its twin. */
  void addDelta(int halfEdge, int more) {
    delta[halfEdge] += more;
    delta[twin[halfEdge]] -= more;
  }

  /**
   * Returns twice the area of a triangle of three vertices, positive if they are counterclockwise.
   */
  long area(int a, int b, int c) {
    return area(a, b, x[c], y[c]);
  }

  private long area(int a, int b, int px, int py) {
    return ((long) x[b] - x[a]) * ((long) py - y[a]) - ((long) y[b] - y[a]) * ((long) px - x[a]);
  }

  /** Returns the vertex at a point, which is added if there is none. */
  int add(int px, int py) {
    int t = locate(px, py);
    int zero = NONE;
    for (int k = 0; k < 3; k++) {
      int v = corner[3 * t + k];
      if (x[v] == px && y[v] == py) {
        return v;
      }
      if (area(from(3 * t + k), to(3 * t + k), px, py) == 0) {
        zero = 3 * t + k;
      }
    }
    int p = addVertex(px, py);
    if (zero == NONE) {
      splitTriangle(t, p);
    } else {
      splitEdge(zero, p);
    }
    legalize(p);
    return p;
  }

  /** Returns the triangle around a point, by a walk. Its random choices rule out cycles. */
  private int locate(int px, int py) {
    int t = last;
    int outside = 0;
    while (outside != NONE) {
      work.step();
      random = random * 1103515245 + 12345;
      int first = (random >>> 16) % 3;
      outside = NONE;
      for (int k = first; k < first + 3 && outside == NONE; k++) {
        int e = 3 * t + k % 3;
        if (area(from(e), to(e), px, py) < 0) {
          outside = e;
        }
      }
      t = outside == NONE ? t : twin[outside] / 3;
    }
    last = t;
    return t;
  }

  private void splitTriangle(int t, int p) {
    int a = corner[3 * t];
    int b = corner[3 * t + 1];
    int c = corner[3 * t + 2];
    int second = addTriangle(p, c, a);
    int third = addTriangle(p, a, b);
    move(3 * t + 1, 3 * second);
    move(3 * t + 2, 3 * third);
    set(t, p, b, c);
    link(3 * t + 1, 3 * second + 2);
    link(3 * second + 1, 3 * third + 2);
    link(3 * third + 1, 3 * t + 2);
    push(3 * t);
    push(3 * second);
    push(3 * third);
  }

  /** Divides the two triangles at an edge; both halves of the edge keep its delta. */
  private void splitEdge(int e, int p) {
    int other = twin[e];
    int d = delta[e];
    int t = e / 3;
    int u = other / 3;
    int a = from(e);
    int b = to(e);
    int c = apex(e);
    int f = apex(other);
    int bc = next(e);
    int af = next(other);
    int second = addTriangle(p, c, a);
    int fourth = addTriangle(p, f, b);
    move(next(bc), 3 * second);
    move(next(af), 3 * fourth);
    int[] twins = {twin[bc], twin[af]};
    int[] deltas = {delta[bc], delta[af]};
    set(t, p, b, c);
    set(u, p, a, f);
    attach(3 * t, twins[0], deltas[0]);
    attach(3 * u, twins[1], deltas[1]);
    link(3 * t + 1, 3 * second + 2);
    link(3 * u + 1, 3 * fourth + 2);
    link(3 * t + 2, 3 * fourth + 1);
    link(3 * u + 2, 3 * second + 1);
    // The edge leads from a to b, so that p b follows it, and a p, too.
    addDelta(3 * t + 2, d);
    addDelta(3 * second + 1, d);
    push(3 * t);
    push(3 * u);
    push(3 * second);
    push(3 * fourth);
  }

  /** Returns the half-edge after another one in its triangle. */
  static int next(int halfEdge) {
    return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
  }

  /** Gives the twin and the delta of a half-edge to another one. */
  private void move(int source, int target) {
    attach(target, twin[source], delta[source]);
  }

  void attach(int halfEdge, int other, int d) {
    twin[halfEdge] = other;
    delta[halfEdge] = d;
    if (other != NONE) {
      twin[other] = halfEdge;
    }
  }

  void link(int one, int other) {
    twin[one] = other;
    twin[other] = one;
    delta[one] = 0;
    delta[other] = 0;
  }

  private void push(int halfEdge) {
    if (stacked == stack.length) {
      stack = Arrays.copyOf(stack, 2 * stacked);
    }
    stack[stacked++] = halfEdge;
  }

  /** Flips the edges opposite to a new vertex, which are on the stack, until all are Delaunay. */
  private void legalize(int p) {
    while (stacked > 0) {
      work.step();
      int e = stack[--stacked];
      int other = twin[e];
      if (other != NONE && delta[e] == 0 && apex(e) == p && inCircle(e, apex(other))) {
        flip(e);
        push(e / 3 * 3);
        push(other / 3 * 3);
      }
    }
  }

  /**
   * Replaces the diagonal of the two triangles at an edge by the other one. Corner 0 of both is
   * then the apex of the half-edge, and edge 0 an outer one.
   */
  void flip(int e) {
    int other = twin[e];
    int t = e / 3;
    int u = other / 3;
    int p = apex(e);
    int a = from(e);
    int b = to(e);
    int q = apex(other);
    int bp = next(e);
    int pa = next(bp);
    int aq = next(other);
    int qb = next(aq);
    int[] outer = {twin[bp], twin[pa], twin[aq], twin[qb]};
    int[] deltas = {delta[bp], delta[pa], delta[aq], delta[qb]};
    set(t, p, a, q);
    set(u, p, q, b);
    attach(3 * t, outer[2], deltas[2]);
    attach(3 * t + 2, outer[1], deltas[1]);
    attach(3 * u, outer[3], deltas[3]);
    attach(3 * u + 1, outer[0], deltas[0]);
    link(3 * t + 1, 3 * u + 2);
  }

  /** Returns whether a vertex is inside the circle around a triangle, beyond rounding errors. */
  private boolean inCircle(int e, int d) {
    int a = apex(e);
    int b = from(e);
    int c = to(e);
    double ax = x[a] - (double) x[d];
    double ay = y[a] - (double) y[d];
    double bx = x[b] - (double) x[d];
    double by = y[b] - (double) y[d];
    double cx = x[c] - (double) x[d];
    double cy = y[c] - (double) y[d];
    double a2 = ax * ax + ay * ay;
    double b2 = bx * bx + by * by;
    double c2 = cx * cx + cy * cy;
    double ofA = a2 * (bx * cy - by * cx);
    double ofB = b2 * (cx * ay - cy * ax);
    double ofC = c2 * (ax * by - ay * bx);
    double size =
        a2 * (Math.abs(bx * cy) + Math.abs(by * cx))
            + b2 * (Math.abs(cx * ay) + Math.abs(cy * ax))
            + c2 * (Math.abs(ax * by) + Math.abs(ay * bx));
    return ofA + ofB + ofC > CIRCLE_ERROR * size;
  }
}
