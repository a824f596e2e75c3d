package io.github.lumbre.geometry;

import io.github.lumbre.math.Vec3;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Finds open borders of meshes. */
final class MeshBorder {
  private MeshBorder() {}

  /** An undirected edge between two distinct positions. */
  private record Edge(int from, int to) {
    static Edge between(int a, int b) {
      return new Edge(Math.min(a, b), Math.max(a, b));
    }
  }

  /**
   * Returns whether every edge belongs to an even number of triangles. Vertices at exactly the same
   * position count as one, because files repeat them for each normal and texture coordinate.
   */
  static boolean isClosed(TriangleMesh mesh) {
    int[] places = places(mesh);
    Set<Edge> odd = new HashSet<>();
    for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
      for (int corner = 0; corner < 3; corner++) {
        Edge edge =
            Edge.between(
                places[mesh.vertex(triangle, corner)],
                places[mesh.vertex(triangle, (corner + 1) % 3)]);
        if (!odd.remove(edge)) {
          odd.add(edge);
        }
      }
    }
    return odd.isEmpty();
  }

  private static int[] places(TriangleMesh mesh) {
    Map<Vec3, Integer> numbers = new HashMap<>();
    int[] places = new int[mesh.vertexCount()];
    for (int vertex = 0; vertex < places.length; vertex++) {
      // Adding 0 turns -0 into 0, so that both are the same position.
      Vec3 position = mesh.position(vertex).plus(Vec3.ZERO);
      Integer known = numbers.putIfAbsent(position, numbers.size());
      places[vertex] = known == null ? numbers.size() - 1 : known;
    }
    return places;
  }
}
