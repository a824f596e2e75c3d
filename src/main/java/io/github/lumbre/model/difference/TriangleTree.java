package io.github.lumbre.model.difference;

import io.github.lumbre.math.Vec3;

/** A hierarchy of boxes around triangles, in which the nearest triangle is found. Immutable. */
final class TriangleTree {
  private static final int LEAF = 4;

  /** Nine coordinates for each triangle, in the order of the tree. */
  private final double[] corners;

  /** Six coordinates for each node, which is a range of triangles: its box. */
  private final double[] boxes;

  /** The found triangle. Mutable. */
  static final class Nearest {
    private int triangle;
    private double squared;

    /** Returns the number of the triangle in the tree; -1 if none is within the limit. */
    int triangle() {
      return triangle;
    }

    double distance() {
      return Math.sqrt(squared);
    }
  }

  /**
   * @param triangles nine coordinates each; they are sorted
   */
  TriangleTree(double... triangles) {
    corners = triangles;
    boxes = new double[6 * (2 * count() + 8)];
    build(0, 0, count());
  }

  int count() {
    return corners.length / 9;
  }

  Vec3 corner(int triangle, int k) {
    int i = 9 * triangle + 3 * k;
    return new Vec3(corners[i], corners[i + 1], corners[i + 2]);
  }

  private void build(int node, int from, int to) {
    double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int i = 9 * from; i < 9 * to; i++) {
      low[i % 3] = Math.min(low[i % 3], corners[i]);
      high[i % 3] = Math.max(high[i % 3], corners[i]);
    }
    int axis = 0;
    for (int k = 0; k < 3; k++) {
      boxes[6 * node + k] = low[k];
      boxes[6 * node + 3 + k] = high[k];
      axis = high[k] - low[k] > high[axis] - low[axis] ? k : axis;
    }
    if (to - from > LEAF) {
      int middle = (from + to) >>> 1;
      select(from, to, middle, axis);
      build(2 * node + 1, from, middle);
      build(2 * node + 2, middle, to);
    }
  }

  /** Sorts triangles so far that those before the middle one are not beyond it (Hoare 1961). */
  private void select(int from, int to, int middle, int axis) {
    int low = from;
    int high = to - 1;
    while (low < high) {
      double pivot = place((low + high) >>> 1, axis);
      int i = low;
      int j = high;
      while (i <= j) {
        while (place(i, axis) < pivot) {
          i++;
        }
        while (place(j, axis) > pivot) {
          j--;
        }
        if (i <= j) {
          swap(i++, j--);
        }
      }
      if (middle <= j) {
        high = j;
      } else if (middle >= i) {
        low = i;
      } else {
        return;
      }
    }
  }

  private double place(int triangle, int axis) {
    int i = 9 * triangle + axis;
    return corners[i] + corners[i + 3] + corners[i + 6];
  }

  private void swap(int i, int j) {
    for (int k = 0; k < 9; k++) {
      double kept = corners[9 * i + k];
      corners[9 * i + k] = corners[9 * j + k];
      corners[9 * j + k] = kept;
    }
  }

  /** Finds the triangle nearest to a point, within a distance. */
  void find(Vec3 p, double limit, Nearest nearest) {
    nearest.triangle = -1;
    nearest.squared = limit * limit;
    if (count() > 0) {
      find(0, 0, count(), p, nearest);
    }
  }

  private void find(int node, int from, int to, Vec3 p, Nearest nearest) {
    if (to - from <= LEAF) {
      for (int t = from; t < to; t++) {
        double squared = squaredDistance(t, p);
        if (squared <= nearest.squared) {
          nearest.squared = squared;
          nearest.triangle = t;
        }
      }
      return;
    }
    int middle = (from + to) >>> 1;
    double left = squaredToBox(2 * node + 1, p);
    double right = squaredToBox(2 * node + 2, p);
    boolean isLeftFirst = left <= right;
    for (int k = 0; k < 2; k++) {
      boolean isLeft = isLeftFirst == (k == 0);
      if ((isLeft ? left : right) <= nearest.squared) {
        find(2 * node + (isLeft ? 1 : 2), isLeft ? from : middle, isLeft ? middle : to, p, nearest);
      }
    }
  }

  private double squaredToBox(int node, Vec3 p) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
      double x = p.get(k);
      double d = Math.max(0, Math.max(boxes[6 * node + k] - x, x - boxes[6 * node + 3 + k]));
      sum += d * d;
    }
    return sum;
  }

  /** Returns the squared distance of a point from a triangle. */
  double squaredDistance(int triangle, Vec3 p) {
    Vec3 apart = p.minus(nearestPoint(triangle, p));
    return apart.dot(apart);
  }

  /** Returns the point of a triangle that is nearest to a point (Ericson 2005, sec. 5.1.5). */
  Vec3 nearestPoint(int triangle, Vec3 p) {
    Vec3 a = corner(triangle, 0);
    Vec3 b = corner(triangle, 1);
    Vec3 c = corner(triangle, 2);
    Vec3 ab = b.minus(a);
    Vec3 ac = c.minus(a);
    Vec3 ap = p.minus(a);
    double d1 = ab.dot(ap);
    double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) {
      return a;
    }
    Vec3 bp = p.minus(b);
    double d3 = ab.dot(bp);
    double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) {
      return b;
    }
    double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
      return a.plus(d1 == d3 ? 0 : d1 / (d1 - d3), ab);
    }
    Vec3 cp = p.minus(c);
    double d5 = ab.dot(cp);
    double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) {
      return c;
    }
    double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
      return a.plus(d2 == d6 ? 0 : d2 / (d2 - d6), ac);
    }
    double va = d3 * d6 - d5 * d4;
    double along = d4 - d3 + (d5 - d6);
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
      return b.plus(along == 0 ? 0 : (d4 - d3) / along, c.minus(b));
    }
    double sum = va + vb + vc;
    return sum == 0 ? a : a.plus(vb / sum, ab).plus(vc / sum, ac);
  }
}
