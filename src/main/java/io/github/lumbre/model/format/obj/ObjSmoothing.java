package io.github.lumbre.model.format.obj;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.Corners;
import java.util.Arrays;

/**
 * Smooth normals: a vertex in a smoothing group has the average normal of the group's triangles
 * around it, weighted by area. Mutable.
 */
final class ObjSmoothing {
  /** Pairs of vertex and group. */
  private final Corners pairs = new Corners();

  private int group;
  private int count;

  /** For each pair, the sum of cross products. */
  private double[] sums = new double[3 * 16];

  /** For each pair, the number of its normal. */
  private int[] normals = new int[16];

  /** Sets the current group; 0 for flat faces. */
  void use(int newGroup) {
    group = newGroup;
  }

  boolean isFlat() {
    return group == 0;
  }

  /** Returns whether the current group has no normal of a vertex; then {@link #add} must follow. */
  boolean isNew(int vertex) {
    return pairs.number(vertex, group, 0) == count;
  }

  /** Sets the number of the normal of a vertex in the current group. */
  void add(int vertex, int normal) {
    if (count == normals.length) {
      normals = Arrays.copyOf(normals, Math.multiplyExact(2, count));
      sums = Arrays.copyOf(sums, Math.multiplyExact(6, count));
    }
    normals[count++] = normal;
  }

  /**
   * Adds a triangle to the normal of a vertex in the current group.
   *
   * @param cross cross product of two of its edges
   * @return the number of the normal
   */
  int sum(int vertex, Vec3 cross) {
    int pair = pairs.number(vertex, group, 0);
    sums[3 * pair] += cross.x();
    sums[3 * pair + 1] += cross.y();
    sums[3 * pair + 2] += cross.z();
    return normals[pair];
  }

  /** Stores all unit normals; normals of zero length stay as they are. */
  void store(double[] target) {
    for (int i = 0; i < count; i++) {
      Vec3 normal = new Vec3(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]).normalized();
      if (normal.isFinite()) {
        target[3 * normals[i]] = normal.x();
        target[3 * normals[i] + 1] = normal.y();
        target[3 * normals[i] + 2] = normal.z();
      }
    }
  }
}
