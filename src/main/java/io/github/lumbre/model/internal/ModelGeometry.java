package io.github.lumbre.model.internal;

/**
 * The triangles of a mesh, in local space. The arrays are not copied and must not be changed. An
 * attribute that the mesh lacks is an empty array.
 *
 * @param positions three finite numbers per vertex
 * @param normals three numbers per vertex; if empty, triangles are flat
 * @param tangents four numbers per vertex, as in glTF 2.0, section 3.7.2.1: a unit vector along
 *     increasing u, and the sign of the bitangent, for v = 0 at the <b>lower</b> edge of a texture
 * @param uv0 two numbers per vertex; v = 0 is the <b>lower</b> edge of a texture (readers of
 *     formats with v = 0 at the upper edge, such as glTF, replace v with 1 - v)
 * @param uv1 a second set of texture coordinates, as uv0
 * @param colors four linear numbers per vertex: red, green, blue and alpha in [0,1]
 * @param indices three vertex numbers per triangle, counted from 0, counterclockwise seen from
 *     outside
 */
public record ModelGeometry(
    double[] positions,
    double[] normals,
    double[] tangents,
    double[] uv0,
    double[] uv1,
    float[] colors,
    int[] indices) {

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positions.length / 3;
  }

  /** Returns whether any triangle has an area. */
  public boolean hasArea() {
    for (int i = 0; i < indices.length; i += 3) {
      if (TriangleList.hasArea(positions, indices[i], indices[i + 1], indices[i + 2])) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of triangles. */
  public int triangleCount() {
    return indices.length / 3;
  }
}
