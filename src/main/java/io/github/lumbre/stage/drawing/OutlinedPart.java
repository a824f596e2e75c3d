package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * The edges of the meshes of one object at one place.
 *
 * @param edges in the local space of the meshes
 * @param primitives the index of the primitive of each mesh, in the order of the meshes
 * @param begins the number of the first triangle of each mesh in {@code edges}
 */
record OutlinedPart(MeshEdges edges, Transform toWorld, int[] primitives, int[] begins) {
  /** Returns the map from the local space of a shape's mesh to world space. */
  static Transform toWorldOf(Shape shape) {
    return shape instanceof MeshInstance instance ? instance.toWorld() : Transform.IDENTITY;
  }

  static OutlinedPart of(
      MeshEdges edges, Transform toWorld, List<Integer> primitives, List<TriangleMesh> meshes) {
    int[] begins = new int[meshes.size()];
    for (int i = 1; i < begins.length; i++) {
      begins[i] = begins[i - 1] + meshes.get(i - 1).triangleCount();
    }
    return new OutlinedPart(edges, toWorld, primitives.stream().mapToInt(i -> i).toArray(), begins);
  }

  /** Returns three world-space coordinates for each place of the edges. */
  double[] worldPositions() {
    double[] positions = edges.positions();
    for (int i = 0; i < positions.length && !toWorld.equals(Transform.IDENTITY); i += 3) {
      Vec3 world = toWorld.point(new Vec3(positions[i], positions[i + 1], positions[i + 2]));
      positions[i] = world.x();
      positions[i + 1] = world.y();
      positions[i + 2] = world.z();
    }
    return positions;
  }

  /** Returns the part of the model to which an edge belongs: that of its first triangle. */
  int partOf(int edge, PartOf parts) {
    int triangle = edges.triangle(edge, 0);
    int mesh = begins.length - 1;
    while (begins[mesh] > triangle) {
      mesh--;
    }
    return parts.number(primitives[mesh], triangle - begins[mesh]);
  }

  /** Returns whether a hit is on one of the meshes. */
  boolean has(NearestHit hit) {
    for (int primitive : primitives) {
      if (primitive == hit.shape()) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a hit is on one of the triangles that have an edge. */
  boolean isOnEdge(NearestHit hit, int edge) {
    for (int mesh = 0; mesh < primitives.length; mesh++) {
      if (primitives[mesh] == hit.shape()) {
        int triangle = begins[mesh] + hit.element();
        for (int i = 0; i < edges.triangles(edge); i++) {
          if (edges.triangle(edge, i) == triangle) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
