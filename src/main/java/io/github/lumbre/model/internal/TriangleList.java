package io.github.lumbre.model.internal;

import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.Supplier;

/** A growing list of triangles: three vertex numbers each. Mutable. */
public final class TriangleList {
  private int[] indices;
  private int size;

  /**
   * @param triangles the expected number of triangles
   */
  public TriangleList(int triangles) {
    indices = new int[Math.multiplyExact(3, triangles)];
  }

  /** Returns the triangles of some lists in turn; of a single one itself. */
  public static TriangleList joined(List<TriangleList> lists) {
    if (lists.size() == 1) {
      return lists.get(0);
    }
    TriangleList all = new TriangleList(lists.stream().mapToInt(TriangleList::count).sum());
    for (TriangleList list : lists) {
      System.arraycopy(list.indices, 0, all.indices, all.size, list.size);
      all.size += list.size;
    }
    return all;
  }

  public void add(int a, int b, int c) {
    if (size + 3 > indices.length) {
      int larger = (int) Math.min(2L * indices.length + 12, 3L * ModelLimits.MAX_COUNT);
      indices = Arrays.copyOf(indices, Math.max(larger, Math.addExact(size, 3)));
    }
    indices[size] = a;
    indices[size + 1] = b;
    indices[size + 2] = c;
    size += 3;
  }

  /**
   * Adds a triangle, unless it has no area or a vertex that is not finite.
   *
   * @param positions three coordinates per vertex
   * @param tally counts triangles that are left out
   * @param place of the triangle in the file
   * @return whether it is added
   */
  public boolean addSound(
      double[] positions, int a, int b, int c, Tally tally, Supplier<String> place) {
    if (!Double.isFinite(sum(positions, a) + sum(positions, b) + sum(positions, c))) {
      tally.add(Tally.BROKEN, place.get());
      return false;
    }
    if (!hasArea(positions, a, b, c)) {
      tally.add(Tally.FLAT, place.get());
      return false;
    }
    add(a, b, c);
    return true;
  }

  private static double sum(double[] positions, int vertex) {
    return positions[3 * vertex] + positions[3 * vertex + 1] + positions[3 * vertex + 2];
  }

  /** Replaces coordinates that are not finite by 0; no triangle may use them. */
  public static void clearBroken(double[] positions) {
    for (int i = 0; i < positions.length; i++) {
      positions[i] = Double.isFinite(positions[i]) ? positions[i] : 0;
    }
  }

  /** Returns a vertex number of the list of all corners. */
  public int vertex(int corner) {
    return indices[corner];
  }

  public int count() {
    return size / 3;
  }

  /**
   * Removes triangles with a vertex that is not finite.
   *
   * @param positions three coordinates per vertex
   * @return the number of removed triangles
   */
  public int removeBroken(double[] positions) {
    return removeUnless(
        i -> {
          double ofTwo = sum(positions, indices[i]) + sum(positions, indices[i + 1]);
          return Double.isFinite(ofTwo + sum(positions, indices[i + 2]));
        });
  }

  private int removeUnless(IntPredicate isKept) {
    int kept = 0;
    for (int i = 0; i < size; i += 3) {
      if (isKept.test(i)) {
        System.arraycopy(indices, i, indices, kept, 3);
        kept += 3;
      }
    }
    int removed = (size - kept) / 3;
    size = kept;
    return removed;
  }

  /**
   * Removes triangles of zero area.
   *
   * @param positions three coordinates per vertex
   * @return the number of removed triangles
   */
  public int removeFlat(double[] positions) {
    return removeUnless(i -> hasArea(positions, indices[i], indices[i + 1], indices[i + 2]));
  }

  /** Returns whether a triangle between three vertices has an area. */
  static boolean hasArea(double[] positions, int a, int b, int c) {
    if (a == b || b == c || c == a) {
      return false;
    }
    Vec3 e1 = edge(positions, a, b);
    Vec3 e2 = edge(positions, a, c);
    if (e1.cross(e2).maxAbs() > 0x1p-500) {
      return true;
    }
    // Squares of tiny numbers would underflow.
    return e1.maxAbs() > 0
        && e2.maxAbs() > 0
        && e1.normalized().cross(e2.normalized()).maxAbs() > 0;
  }

  private static Vec3 edge(double[] positions, int from, int to) {
    return new Vec3(
        positions[3 * to] - positions[3 * from],
        positions[3 * to + 1] - positions[3 * from + 1],
        positions[3 * to + 2] - positions[3 * from + 2]);
  }

  /** Returns the vertex numbers; the list must not be used afterwards. */
  public int[] toArray() {
    return size == indices.length ? indices : Arrays.copyOf(indices, size);
  }
}
