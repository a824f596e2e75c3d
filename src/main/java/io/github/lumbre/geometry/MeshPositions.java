package io.github.lumbre.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * The vertices of all meshes of a hierarchy. Their arrays must not be changed.
 *
 * @param all three coordinates per vertex; the mesh's own array if there is one mesh
 * @param start where the coordinates of each mesh begin, by the number of its shape
 */
record MeshPositions(double[] all, int[] start) {
  /**
   * Returns the vertices of meshes.
   *
   * @param meshes indexed by shape number; null for other shapes
   */
  static MeshPositions of(TriangleMesh[] meshes) {
    int[] start = new int[meshes.length];
    int end = 0;
    for (int i = 0; i < meshes.length; i++) {
      start[i] = end;
      end = Math.addExact(end, meshes[i] == null ? 0 : meshes[i].positions().length);
    }
    return new MeshPositions(joined(meshes, end), start);
  }

  private static double[] joined(TriangleMesh[] meshes, int length) {
    List<double[]> parts = new ArrayList<>();
    for (TriangleMesh mesh : meshes) {
      if (mesh != null) {
        parts.add(mesh.positions());
      }
    }
    if (parts.size() == 1) {
      return parts.get(0);
    }
    double[] all = new double[length];
    int end = 0;
    for (double[] part : parts) {
      System.arraycopy(part, 0, all, end, part.length);
      end += part.length;
    }
    return all;
  }
}
