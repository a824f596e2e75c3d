package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.Arrays;
import java.util.Optional;

/**
 * The order of an attribute's values in the stream: the order in which a traversal reaches the
 * vertices, or the order of the points. Mutable while the traversal goes on.
 */
final class Entries {
  private static final int NOT_REACHED = -1;

  private final Optional<CornerTable> table;
  private final int[] corners;
  private final int[] ofVertices;
  private int count;

  private Entries(Optional<CornerTable> table, int[] corners, int[] ofVertices, int count) {
    this.table = table;
    this.corners = corners;
    this.ofVertices = ofVertices;
    this.count = count;
  }

  /** Returns an order to which vertices are added. */
  static Entries over(CornerTable table, DracoInput input) throws ModelFormatException {
    int[] corners = input.integers(table.vertexCount());
    int[] ofVertices = input.integers(table.vertexCount());
    Arrays.fill(ofVertices, NOT_REACHED);
    return new Entries(Optional.of(table), corners, ofVertices, 0);
  }

  /** Returns the order of the points of a mesh without a table. */
  static Entries ofPoints(int count) {
    return new Entries(Optional.empty(), new int[0], new int[0], count);
  }

  /** Adds the entry of a vertex, which has none yet, reached at a corner. */
  void add(int vertex, int corner) {
    ofVertices[vertex] = count;
    corners[count++] = corner;
  }

  boolean has(int vertex) {
    return ofVertices[vertex] != NOT_REACHED;
  }

  int count() {
    return count;
  }

  /** Returns the connectivity of the vertices; empty if there is an entry for each point. */
  Optional<CornerTable> table() {
    return table;
  }

  /** Returns the corner at which the traversal reached the vertex of an entry. */
  int corner(int entry) {
    return corners[entry];
  }

  /** Returns the entry of a vertex that the traversal has reached. */
  int of(int vertex) {
    return ofVertices[vertex];
  }

  /** Returns the entries of all points; 0 for points without corners. */
  int[] toPoints(Connectivity mesh, DracoInput input) throws ModelFormatException {
    int[] ofPoints = input.integers(mesh.pointCount());
    if (table.isEmpty()) {
      Arrays.setAll(ofPoints, i -> i);
      return ofPoints;
    }
    int[] vertices = table.get().vertices();
    for (int corner = 0; corner < vertices.length; corner++) {
      ofPoints[mesh.points()[corner]] = ofVertices[vertices[corner]];
    }
    return ofPoints;
  }
}
