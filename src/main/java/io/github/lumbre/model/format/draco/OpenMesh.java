package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;

import io.github.lumbre.model.ModelFormatException;
import java.util.Arrays;

/**
 * A mesh to which faces are added, and whose vertices are merged. Mutable.
 *
 * <p>A corner has at most one opposite, which has it as its opposite. So a walk around a vertex
 * ends at a boundary or where it began, even in a damaged stream.
 */
final class OpenMesh {
  private final DracoInput input;
  private final int[] vertices;
  private final int[] opposites;
  private final int[] first;

  /** The vertex into which each was merged, or itself. */
  private final int[] merged;

  /** The vertices that were merged into others, in this order. */
  private final int[] lost;

  private int vertexCount;
  private int lostCount;

  /**
   * @param maxVertices including those that are merged
   * @param maxMerged the largest number of vertices that are merged
   */
  OpenMesh(DracoInput input, int faces, int maxVertices, int maxMerged)
      throws ModelFormatException {
    this.input = input;
    vertices = input.integers(3L * faces);
    opposites = input.integers(3L * faces);
    first = input.integers(maxVertices);
    merged = input.integers(maxVertices);
    lost = input.integers(maxMerged);
    Arrays.fill(opposites, NONE);
  }

  /** Returns the number of faces when it is complete. */
  int faceCount() {
    return vertices.length / 3;
  }

  int vertex(int corner) {
    int vertex = vertices[corner];
    while (merged[vertex] != vertex) {
      merged[vertex] = merged[merged[vertex]];
      vertex = merged[vertex];
    }
    return vertex;
  }

  void addVertex(int corner) throws ModelFormatException {
    if (vertexCount == first.length) {
      throw input.malformed("expected at most " + first.length + " vertices, found more");
    }
    merged[vertexCount] = vertexCount;
    first[vertexCount] = corner;
    vertices[corner] = vertexCount++;
  }

  void add(int corner, int vertex) {
    vertices[corner] = vertex;
  }

  /** Adds a corner to a vertex, with no other to its left. */
  void addFirst(int corner, int vertex) {
    vertices[corner] = vertex;
    first[vertex] = corner;
  }

  /** Returns the corner across the open edge whose end is a vertex of another open edge. */
  int acrossNext(int vertex) throws ModelFormatException {
    if (first[vertex] == NONE) {
      throw input.malformed("expected a vertex with faces, found one without");
    }
    return CornerTable.next(first[vertex]);
  }

  /** Joins the open edges opposite to two corners. */
  void join(int a, int b) throws ModelFormatException {
    if (a == b || opposites[a] != NONE || opposites[b] != NONE) {
      throw input.malformed("expected edges of at most two faces, found one of more");
    }
    opposites[a] = b;
    opposites[b] = a;
  }

  /** Merges a vertex into another. */
  void merge(int from, int to) throws ModelFormatException {
    if (from == to || lostCount == lost.length) {
      throw input.malformed(
          "expected " + lost.length + " splits of different vertices, found others");
    }
    merged[from] = to;
    first[to] = first[from];
    first[from] = NONE;
    lost[lostCount++] = from;
  }

  /**
   * Returns the connectivity.
   *
   * @param isCompact whether numbers of merged vertices are used again, for the last vertices
   */
  CornerTable table(boolean isCompact) throws ModelFormatException {
    int[] numbers = input.integers(vertexCount);
    int[] occupants = input.integers(vertexCount);
    Arrays.setAll(occupants, i -> i);
    int count = isCompact ? compact(occupants) : vertexCount;
    for (int i = 0; i < count; i++) {
      numbers[occupants[i]] = i;
    }
    for (int corner = 0; corner < vertices.length; corner++) {
      vertices[corner] = numbers[vertex(corner)];
    }
    input.allocate((long) Integer.BYTES * count);
    return new CornerTable(vertices, opposites, Arrays.copyOf(first, count)).requireFans(input);
  }

  /**
   * Moves the last vertices to the numbers of merged ones.
   *
   * @param occupants receives the vertices that have each number
   * @return the number of vertices
   */
  private int compact(int[] occupants) {
    int count = vertexCount;
    for (int i = 0; i < lostCount; i++) {
      while (count > 0 && first[count - 1] == NONE) {
        count--;
      }
      int free = lost[i];
      if (count - 1 > free) {
        count--;
        first[free] = first[count];
        first[count] = NONE;
        occupants[free] = occupants[count];
      }
    }
    return count;
  }
}
