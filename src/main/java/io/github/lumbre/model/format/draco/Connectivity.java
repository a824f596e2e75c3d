package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;

import io.github.lumbre.model.ModelFormatException;
import java.util.List;
import java.util.Optional;

/**
 * The triangles of a mesh, without the values of its attributes.
 *
 * @param pointCount number of points
 * @param points the points of the corners of all faces
 * @param table how the faces are connected; empty for sequential connectivity
 * @param seams how they are connected for attributes with seams of their own
 */
record Connectivity(
    int pointCount, int[] points, Optional<CornerTable> table, List<CornerTable> seams) {
  /** Returns a mesh without seams: each vertex is a point. */
  static Connectivity of(CornerTable table) {
    return new Connectivity(table.vertexCount(), table.vertices(), Optional.of(table), List.of());
  }

  /**
   * Returns a mesh with seams: between seams of attributes, a vertex has several points.
   *
   * @param seams the table, cut along the seams of each attribute
   */
  static Connectivity of(CornerTable table, List<CornerTable> seams, DracoInput input)
      throws ModelFormatException {
    int[] points = input.integers(table.vertices().length);
    int[][] labels = seams.stream().map(CornerTable::vertices).toArray(int[][]::new);
    int count = 0;
    for (int vertex = 0; vertex < table.vertexCount(); vertex++) {
      int start = table.first()[vertex];
      if (start == NONE) {
        continue;
      }
      if (!table.isOnBoundary(vertex)) {
        start = afterSeam(table, labels, start);
      }
      points[start] = count;
      int before = start;
      int corner = table.swingRight(start);
      while (corner != NONE && corner != start) {
        points[corner] = differ(labels, before, corner) ? ++count : count;
        before = corner;
        corner = table.swingRight(corner);
      }
      count++;
    }
    return new Connectivity(count, points, Optional.of(table), seams);
  }

  /**
   * Returns the first corner around an inner vertex that follows a seam; the start if none does.
   */
  private static int afterSeam(CornerTable table, int[][] labels, int start) {
    for (int[] label : labels) {
      int corner = table.swingRight(start);
      while (corner != start) {
        if (label[corner] != label[start]) {
          return corner;
        }
        corner = table.swingRight(corner);
      }
    }
    return start;
  }

  private static boolean differ(int[][] labels, int a, int b) {
    for (int[] label : labels) {
      if (label[a] != label[b]) {
        return true;
      }
    }
    return false;
  }
}
