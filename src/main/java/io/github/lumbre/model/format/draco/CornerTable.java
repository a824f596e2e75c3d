package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.Arrays;
import java.util.BitSet;

/**
 * Which corners of triangles meet at a vertex, and which face each other across an edge.
 *
 * <p>The corners of a vertex are a fan: from each, {@link #swingRight} goes to the next, until the
 * boundary or the first again. No two vertices share a corner, so a walk around every vertex visits
 * each corner once.
 *
 * @param vertices of all corners
 * @param opposites the corners across the edges, in both directions; {@link #NONE} at the boundary
 * @param first a corner of each vertex: the one from which nothing lies to the left, if the vertex
 *     is on the boundary; {@link #NONE} for a vertex without corners
 */
record CornerTable(int[] vertices, int[] opposites, int[] first) {
  static final int NONE = -1;

  /** Returns the next corner of a face. */
  static int next(int corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  /** Returns the previous corner of a face. */
  static int previous(int corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }

  /** Returns the number of vertices, including those without corners. */
  int vertexCount() {
    return first.length;
  }

  /** Returns the corner across the edge to the left of a corner, opposite to its previous one. */
  int left(int corner) {
    return opposites[previous(corner)];
  }

  /** Returns the corner across the edge to the right of a corner, opposite to its next one. */
  int right(int corner) {
    return opposites[next(corner)];
  }

  /** Returns the corner of the same vertex in the face to the left. */
  int swingLeft(int corner) {
    int opposite = opposites[next(corner)];
    return opposite == NONE ? NONE : next(opposite);
  }

  /** Returns the corner of the same vertex in the face to the right. */
  int swingRight(int corner) {
    int opposite = opposites[previous(corner)];
    return opposite == NONE ? NONE : previous(opposite);
  }

  /** Returns whether a vertex lies on the boundary, or has no corners. */
  boolean isOnBoundary(int vertex) {
    return first[vertex] == NONE || swingLeft(first[vertex]) == NONE;
  }

  /** Checks that the corners of each vertex are one fan, and that every corner is in one. */
  CornerTable requireFans(DracoInput input) throws ModelFormatException {
    int visited = 0;
    for (int vertex = 0; vertex < first.length; vertex++) {
      int start = first[vertex];
      int corner = start;
      while (corner != NONE) {
        if (vertices[corner] != vertex) {
          throw input.malformed("expected faces that meet at their vertices, found others");
        }
        visited++;
        corner = swingRight(corner);
        if (corner == start) {
          break;
        }
        if (corner == NONE && swingLeft(start) != NONE) {
          throw input.malformed("expected vertices with one fan of faces, found others");
        }
      }
    }
    if (visited != vertices.length) {
      throw input.malformed("expected " + vertices.length + " connected corners, found " + visited);
    }
    return this;
  }

  /**
   * Returns this table, cut along edges: their faces are no neighbors, and a vertex is split into
   * the fans between the cuts. Vertices are numbered anew, from fan to fan.
   *
   * @param seams the corners opposite to the edges, on both sides
   */
  CornerTable cut(BitSet seams, DracoInput input) throws ModelFormatException {
    int[] cut = input.integers(opposites.length);
    for (int i = 0; i < cut.length; i++) {
      cut[i] = seams.get(i) ? NONE : opposites[i];
    }
    int[] labels = input.integers(vertices.length);
    int[] starts = input.integers(vertices.length);
    CornerTable table = new CornerTable(labels, cut, starts);
    int count = 0;
    for (int corner : first) {
      if (corner != NONE) {
        count = label(table, table.leftMost(corner), count);
      }
    }
    input.allocate((long) Integer.BYTES * count);
    return new CornerTable(labels, cut, Arrays.copyOf(starts, count));
  }

  /** Returns the last corner to the left of a corner, or itself if the fan is closed. */
  private int leftMost(int corner) {
    int last = corner;
    for (int c = swingLeft(corner); c != NONE; c = swingLeft(c)) {
      if (c == corner) {
        return corner;
      }
      last = c;
    }
    return last;
  }

  /** Numbers the vertices of a table around one vertex of this table. */
  private int label(CornerTable target, int start, int count) {
    int corner = start;
    do {
      if (corner == start || target.swingLeft(corner) == NONE) {
        target.first[count++] = corner;
      }
      target.vertices[corner] = count - 1;
      corner = swingRight(corner);
    } while (corner != NONE && corner != start);
    return count;
  }
}
