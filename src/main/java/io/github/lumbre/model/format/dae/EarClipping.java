package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.format.dae.PolygonDivision.Projection;
import java.util.Arrays;

/**
 * Cuts triangles off a polygon, whose holes are joined with it by edges first (Eberly 2008,
 * "Triangulation by Ear Clipping"). The work on all polygons together is limited. Mutable.
 */
final class EarClipping {
  /** The most comparisons of corners, for all polygons. */
  private static final long MAX_STEPS = 100_000_000;

  private static final int STEPS_PER_CHECK = 1 << 16;

  private long steps;
  private Projection in;

  /** The corner of each node of the ring. */
  private int[] corner;

  private int[] next;
  private int[] previous;
  private int nodes;
  private int lostHoles;
  private int[] triangles = {};
  private int used;

  /**
   * Divides a polygon.
   *
   * @param ends of its loops, the outer one first
   * @return false if that takes too many steps
   */
  boolean divide(Projection polygon, int... ends) {
    in = polygon;
    int count = ends[ends.length - 1];
    int most = count + 2 * ends.length;
    corner = new int[most];
    next = new int[most];
    previous = new int[most];
    nodes = 0;
    lostHoles = 0;
    triangles = new int[3 * most];
    used = 0;
    addRing(0, ends[0], false);
    for (int hole = 1; hole < ends.length && steps < MAX_STEPS; hole++) {
      boolean turnsLeft = area(ends[hole - 1], ends[hole]) > 0;
      join(addRing(ends[hole - 1], ends[hole], turnsLeft), ends);
    }
    clip();
    return steps < MAX_STEPS;
  }

  /** Returns the number of holes that could not be joined. */
  int lostHoles() {
    return lostHoles;
  }

  /** Returns the triangles: three numbers of corners each. */
  int[] triangles() {
    return Arrays.copyOf(triangles, used);
  }

  private double area(int from, int to) {
    double area = 0;
    for (int i = from; i < to; i++) {
      int j = i + 1 == to ? from : i + 1;
      area += in.x[i] * in.y[j] - in.x[j] * in.y[i];
    }
    return area;
  }

  /** Adds a ring of nodes, and returns its first one. */
  private int addRing(int from, int to, boolean isTurned) {
    int first = nodes;
    int count = to - from;
    for (int k = 0; k < count; k++) {
      corner[nodes] = isTurned ? to - 1 - k : from + k;
      next[nodes] = first + (k + 1) % count;
      previous[nodes] = first + (k + count - 1) % count;
      nodes++;
    }
    return first;
  }

  private int addNode(int ofCorner) {
    corner[nodes] = ofCorner;
    return nodes++;
  }

  /** Joins the ring of a hole with the outer one, by the shortest edge that crosses no other. */
  private void join(int hole, int... ends) {
    int from = rightmost(hole);
    boolean[] isTried = new boolean[nodes];
    for (int to = nearest(from, isTried); to >= 0; to = nearest(from, isTried)) {
      if (steps >= MAX_STEPS) {
        return;
      }
      isTried[to] = true;
      if (isInside(to, corner[from]) && isFree(corner[from], corner[to], ends)) {
        link(from, to);
        return;
      }
    }
    lostHoles++;
  }

  private int rightmost(int hole) {
    int best = hole;
    for (int node = next[hole]; node != hole; node = next[node]) {
      best = in.x[corner[node]] > in.x[corner[best]] ? node : best;
    }
    return best;
  }

  /** Returns the nearest node of the outer ring that is not tried; -1 if there is none. */
  private int nearest(int from, boolean... isTried) {
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    int node = 0;
    do {
      step();
      double dx = in.x[corner[node]] - in.x[corner[from]];
      double dy = in.y[corner[node]] - in.y[corner[from]];
      if (!isTried[node] && dx * dx + dy * dy < least) {
        least = dx * dx + dy * dy;
        best = node;
      }
      node = next[node];
    } while (node != 0);
    return best;
  }

  /** Returns whether a corner lies in the angle inside a node. */
  private boolean isInside(int node, int point) {
    int a = corner[previous[node]];
    int b = corner[node];
    int c = corner[next[node]];
    boolean isLeftOfBoth = in.turn(a, b, point) >= 0 && in.turn(b, c, point) >= 0;
    boolean isLeftOfOne = in.turn(a, b, point) >= 0 || in.turn(b, c, point) >= 0;
    return in.turn(a, b, c) >= 0 ? isLeftOfBoth : isLeftOfOne;
  }

  /** Returns whether the way between two corners crosses no edge of the polygon. */
  private boolean isFree(int from, int to, int... ends) {
    int start = 0;
    for (int end : ends) {
      for (int i = start; i < end; i++) {
        step();
        if (cross(from, to, i, i + 1 == end ? start : i + 1)) {
          return false;
        }
      }
      start = end;
    }
    return true;
  }

  private boolean cross(int a, int b, int c, int d) {
    boolean touches = in.isSame(a, c) || in.isSame(a, d) || in.isSame(b, c) || in.isSame(b, d);
    return !touches
        && in.turn(a, b, c) * in.turn(a, b, d) <= 0
        && in.turn(c, d, a) * in.turn(c, d, b) <= 0;
  }

  /** Leads the outer ring from one of its nodes around a hole and back. */
  private void link(int hole, int outer) {
    int holeEnd = addNode(corner[hole]);
    int outerEnd = addNode(corner[outer]);
    chain(previous[hole], holeEnd);
    chain(outerEnd, next[outer]);
    chain(holeEnd, outerEnd);
    chain(outer, hole);
  }

  private void chain(int before, int after) {
    next[before] = after;
    previous[after] = before;
  }

  /** Cuts off ears of the ring with the node 0, until a triangle is left. */
  private void clip() {
    int size = 1;
    for (int node = next[0]; node != 0; node = next[node]) {
      size++;
    }
    int node = 0;
    int misses = 0;
    int strictness = 2;
    while (size > 3 && steps < MAX_STEPS) {
      if (isEar(node, strictness)) {
        emit(node);
        chain(previous[node], next[node]);
        size--;
        misses = 0;
        node = next[next[node]];
      } else if (++misses > size) {
        // The polygon crosses itself.
        strictness = Math.max(0, strictness - 1);
        misses = 0;
      } else {
        node = next[node];
      }
    }
    emit(node);
  }

  private void emit(int node) {
    triangles[used] = corner[previous[node]];
    triangles[used + 1] = corner[node];
    triangles[used + 2] = corner[next[node]];
    used += 3;
  }

  /**
   * Returns whether a node can be cut off.
   *
   * @param strictness 2 if no corner may be in or at its triangle, 1 if corners may be at its
   *     edges, 0 for all nodes
   */
  private boolean isEar(int node, int strictness) {
    int a = corner[previous[node]];
    int b = corner[node];
    int c = corner[next[node]];
    if (strictness == 0) {
      return true;
    }
    if (!(in.turn(a, b, c) > 0)) {
      return false;
    }
    double least = strictness == 2 ? 0 : Double.MIN_VALUE;
    for (int other = next[next[node]]; other != previous[node]; other = next[other]) {
      step();
      int p = corner[other];
      boolean isIn =
          in.turn(a, b, p) >= least && in.turn(b, c, p) >= least && in.turn(c, a, p) >= least;
      if (isIn && !in.isSame(p, a) && !in.isSame(p, b) && !in.isSame(p, c)) {
        return false;
      }
    }
    return true;
  }

  private void step() {
    if ((++steps & STEPS_PER_CHECK - 1) == 0) {
      Interrupts.check();
    }
  }
}
