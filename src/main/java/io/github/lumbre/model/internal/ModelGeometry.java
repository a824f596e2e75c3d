package io.github.lumbre.model.internal;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * The triangles of a mesh, or points, in local space. The arrays are not copied and must not be
 * changed. An attribute that the mesh lacks is an empty array.
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
 * @param isPoints whether each vertex is a point, which is shown as a sphere; there are no
 *     triangles then
 */
public record ModelGeometry(
    double[] positions,
    double[] normals,
    double[] tangents,
    double[] uv0,
    double[] uv1,
    float[] colors,
    int[] indices,
    boolean isPoints) {
  /** Creates triangles. */
  public ModelGeometry(
      double[] positions,
      double[] normals,
      double[] tangents,
      double[] uv0,
      double[] uv1,
      float[] colors,
      int[] indices) {
    this(positions, normals, tangents, uv0, uv1, colors, indices, false);
  }

  public static ModelGeometry ofPoints(
      double[] positions, double[] uv0, double[] uv1, float[] colors) {
    double[] none = {};
    return new ModelGeometry(positions, none, none, uv0, uv1, colors, new int[0], true);
  }

  /** Returns the same triangles or points, moved, or fewer triangles. */
  public ModelGeometry moved(
      double[] newPositions, double[] newNormals, double[] newTangents, int... newIndices) {
    return new ModelGeometry(
        newPositions, newNormals, newTangents, uv0, uv1, colors, newIndices, isPoints);
  }

  /** Returns the same triangles or points without colors of vertices. */
  ModelGeometry withoutColors() {
    return new ModelGeometry(
        positions, normals, tangents, uv0, uv1, new float[0], indices, isPoints);
  }

  /**
   * Returns some of the triangles, with their vertices alone.
   *
   * @param corners three vertex numbers per triangle
   */
  public ModelGeometry part(int... corners) {
    int[] used = IntStream.of(corners).sorted().distinct().toArray();
    int[] moved = IntStream.of(corners).map(v -> Arrays.binarySearch(used, v)).toArray();
    return new ModelGeometry(
        selected(positions, 3, used),
        selected(normals, 3, used),
        selected(tangents, 4, used),
        selected(uv0, 2, used),
        selected(uv1, 2, used),
        selectedColors(used),
        moved);
  }

  /** Returns the vertices that are points or belong to a triangle. */
  public BitSet used() {
    BitSet used = new BitSet(vertexCount());
    for (int vertex : indices) {
      used.set(vertex);
    }
    if (isPoints) {
      used.set(0, vertexCount());
    }
    return used;
  }

  /** Returns the box around all vertices, in local space; empty without any. */
  public Bounds3 bounds() {
    double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int i = 0; i < positions.length; i++) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
    return new Bounds3(new Vec3(low[0], low[1], low[2]), new Vec3(high[0], high[1], high[2]));
  }

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positions.length / 3;
  }

  /** Returns what is shown, for messages. */
  public String items() {
    return isPoints ? "points" : "triangles";
  }

  /** Returns the number of triangles or of points. */
  public int itemCount() {
    return isPoints ? vertexCount() : triangleCount();
  }

  /** Returns whether there is a point, or a triangle that has an area. */
  public boolean isVisible() {
    if (isPoints) {
      return positions.length > 0;
    }
    for (int i = 0; i < indices.length; i += 3) {
      if (TriangleList.hasArea(positions, indices[i], indices[i + 1], indices[i + 2])) {
        return true;
      }
    }
    return false;
  }

  public int triangleCount() {
    return indices.length / 3;
  }

  /** Returns some of the vertices as points, without normals and tangents, in their order. */
  public ModelGeometry points(IntPredicate isShown) {
    int[] shown = IntStream.range(0, vertexCount()).filter(isShown).toArray();
    return ofPoints(
        selected(positions, 3, shown),
        selected(uv0, 2, shown),
        selected(uv1, 2, shown),
        selectedColors(shown));
  }

  /** Returns the vertices with finite positions as points; see {@link #points(IntPredicate)}. */
  public ModelGeometry points() {
    return points(
        v -> Double.isFinite(positions[3 * v] + positions[3 * v + 1] + positions[3 * v + 2]));
  }

  private static double[] selected(double[] values, int size, int... vertices) {
    if (values.length == 0 || values.length == size * vertices.length) {
      return values;
    }
    double[] some = new double[size * vertices.length];
    for (int i = 0; i < some.length; i += size) {
      System.arraycopy(values, size * vertices[i / size], some, i, size);
    }
    return some;
  }

  private float[] selectedColors(int... vertices) {
    if (colors.length == 0 || colors.length == 4 * vertices.length) {
      return colors;
    }
    float[] some = new float[4 * vertices.length];
    for (int i = 0; i < some.length; i += 4) {
      System.arraycopy(colors, 4 * vertices[i / 4], some, i, 4);
    }
    return some;
  }
}
