package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.List;

/**
 * The connected pieces of meshes: triangles are connected if they have a vertex at exactly the same
 * position. Pieces are numbered from 0 by their first triangles. Immutable.
 */
public final class Pieces {
  /** All pieces of a model from this number on are one part. */
  public static final int LAST = ModelLimits.MAX_PARTS - 1;

  /** The piece of each triangle, through all meshes. */
  private final int[] ofTriangles;

  /** The number of the first triangle of each mesh. */
  private final int[] starts;

  private final int count;

  public interface Source {
    int triangles();

    int vertices();

    /** Returns the vertex of a triangle and one of its corners, 0 to 2. */
    int vertex(int triangle, int corner);

    /** Returns the finite position of a vertex. */
    Vec3 position(int vertex);
  }

  private Pieces(int[] ofTriangles, int[] starts, int count) {
    this.ofTriangles = ofTriangles;
    this.starts = starts;
    this.count = count;
  }

  /** Returns the label of a piece of a model, whose pieces are numbered from 0. */
  public static String label(int piece) {
    return piece < LAST ? "piece " + (piece + 1) : "other pieces";
  }

  /**
   * Finds the pieces of meshes in one space.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Pieces of(List<? extends Source> meshes) {
    int[] starts = new int[meshes.size() + 1];
    int vertices = 0;
    for (int i = 0; i < meshes.size(); i++) {
      starts[i + 1] = Math.addExact(starts[i], meshes.get(i).triangles());
      vertices = Math.addExact(vertices, meshes.get(i).vertices());
    }
    int[] roots = new int[vertices];
    Arrays.setAll(roots, i -> i);
    int[] places = new int[starts[meshes.size()]];
    PositionIndex index = new PositionIndex();
    for (int i = 0; i < meshes.size(); i++) {
      connect(meshes.get(i), index, roots, starts[i], places);
    }
    int[] numbers = new int[vertices];
    int count = 0;
    for (int triangle = 0; triangle < places.length; triangle++) {
      check(triangle);
      int root = root(roots, places[triangle]);
      if (numbers[root] == 0) {
        numbers[root] = ++count;
      }
      places[triangle] = numbers[root] - 1;
    }
    return new Pieces(places, starts, count);
  }

  /** Connects the places of a mesh's triangles, and stores one of each triangle. */
  private static void connect(
      Source mesh, PositionIndex index, int[] roots, int start, int... places) {
    int[] ofVertices = new int[mesh.vertices()];
    for (int vertex = 0; vertex < ofVertices.length; vertex++) {
      check(vertex);
      Vec3 at = mesh.position(vertex);
      ofVertices[vertex] = index.number(at.x(), at.y(), at.z());
    }
    for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
      check(triangle);
      int first = root(roots, ofVertices[mesh.vertex(triangle, 0)]);
      places[start + triangle] = first;
      for (int corner = 1; corner < 3; corner++) {
        int other = root(roots, ofVertices[mesh.vertex(triangle, corner)]);
        // The smaller number stays, so that the depth of trees is that of path halving alone.
        roots[Math.max(first, other)] = Math.min(first, other);
        first = Math.min(first, other);
      }
    }
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

  public int count() {
    return count;
  }

  public int of(int mesh, int triangle) {
    return ofTriangles[starts[mesh] + triangle];
  }
}
