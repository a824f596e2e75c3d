package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.function.IntBinaryOperator;
import java.util.function.IntFunction;

/**
 * The connected pieces of a mesh: triangles are connected if they have a vertex at exactly the same
 * position. Pieces are numbered from 0 by their first triangles. Immutable.
 */
public final class Pieces {
  /** All pieces of a model from this number on are one part. */
  public static final int LAST = ModelLimits.MAX_PARTS - 1;

  private final int[] ofTriangles;
  private final int count;

  private Pieces(int[] ofTriangles, int count) {
    this.ofTriangles = ofTriangles;
    this.count = count;
  }

  /** Returns the label of a piece of a model, whose pieces are numbered from 0. */
  public static String label(int piece) {
    return piece < LAST ? "piece " + (piece + 1) : "other pieces";
  }

  /**
   * Finds the pieces.
   *
   * @param vertex returns the vertex of a triangle and one of its corners, 0 to 2
   * @param position returns the finite position of a vertex
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Pieces of(
      int triangles, int vertices, IntBinaryOperator vertex, IntFunction<Vec3> position) {
    int[] places = places(vertices, position);
    int[] roots = new int[vertices];
    Arrays.setAll(roots, i -> i);
    for (int triangle = 0; triangle < triangles; triangle++) {
      check(triangle);
      int first = root(roots, places[vertex.applyAsInt(triangle, 0)]);
      for (int corner = 1; corner < 3; corner++) {
        int other = root(roots, places[vertex.applyAsInt(triangle, corner)]);
        // The smaller number stays, so that the depth of trees is that of path halving alone.
        roots[Math.max(first, other)] = Math.min(first, other);
        first = Math.min(first, other);
      }
    }
    int[] numbers = new int[vertices];
    int[] ofTriangles = new int[triangles];
    int count = 0;
    for (int triangle = 0; triangle < triangles; triangle++) {
      check(triangle);
      int root = root(roots, places[vertex.applyAsInt(triangle, 0)]);
      if (numbers[root] == 0) {
        numbers[root] = ++count;
      }
      ofTriangles[triangle] = numbers[root] - 1;
    }
    return new Pieces(ofTriangles, count);
  }

  private static int[] places(int vertices, IntFunction<Vec3> position) {
    PositionIndex index = new PositionIndex();
    int[] places = new int[vertices];
    for (int i = 0; i < vertices; i++) {
      check(i);
      Vec3 at = position.apply(i);
      places[i] = index.number(at.x(), at.y(), at.z());
    }
    return places;
  }

  private static void check(int item) {
    if ((item & ModelLimits.INTERRUPT_MASK) == 0) {
      Interrupts.check();
    }
  }

  /** Returns the root of a tree; halves the path to it. */
  private static int root(int[] roots, int place) {
    int at = place;
    while (roots[at] != at) {
      roots[at] = roots[roots[at]];
      at = roots[at];
    }
    return at;
  }

  /** Returns the number of pieces. */
  public int count() {
    return count;
  }

  /** Returns the piece of a triangle. */
  public int of(int triangle) {
    return ofTriangles[triangle];
  }
}
