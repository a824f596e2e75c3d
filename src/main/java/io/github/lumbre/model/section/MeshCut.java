package io.github.lumbre.model.section;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.TriangleList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A mesh that planes cut: what is in front of all planes is removed. Triangles across a plane are
 * divided. The point on an edge depends on the positions of its vertices alone, so that all
 * triangles at the edge have the same one, bit for bit. A vertex on a plane counts as in front of
 * it. Mutable.
 */
final class MeshCut {
  private final ModelGeometry mesh;
  private final int[] triangles;
  private final List<Column> columns = new ArrayList<>();
  private final List<Column> sides = new ArrayList<>();
  private final List<Map<Long, Integer>> cuts = new ArrayList<>();
  private int vertices;

  /** Receives the line in which a plane cuts a triangle. */
  interface Lines {
    /**
     * Receives a line between two vertices, with what is removed to its right, seen from the front
     * of the triangle, so that the lines of a closed mesh surround its inside counterclockwise,
     * seen from the removed side.
     *
     * @param corner a vertex of the triangle
     */
    void add(int from, int to, int corner);
  }

  /** Numbers of all vertices, some for each. */
  private static final class Column {
    private final int size;
    private double[] values;

    Column(int size, double... values) {
      this.size = size;
      this.values = values;
    }

    double at(int vertex) {
      return values[vertex];
    }

    /** Sets the numbers of a new vertex between two others. */
    void set(int vertex, int from, int to, double t) {
      if (values.length == 0 && vertex > 0) {
        return;
      }
      if (size * (vertex + 1) > values.length) {
        values = Arrays.copyOf(values, Math.max(size * (vertex + 1), values.length / 2 * 3));
      }
      for (int k = 0; k < size; k++) {
        double a = values[size * from + k] / 2;
        double b = values[size * to + k] / 2;
        // Halves do not overflow, and equal numbers stay as they are.
        values[size * vertex + k] = 2 * (a + t * (b - a));
      }
    }

    double[] of(int count) {
      return Arrays.copyOf(values, values.length == 0 ? 0 : size * count);
    }
  }

  /**
   * @param mesh triangles
   * @param sides for each plane a number per vertex, as {@link CutPlane#side} returns it
   */
  MeshCut(ModelGeometry mesh, double[]... sides) {
    this.mesh = mesh;
    triangles = mesh.indices();
    vertices = mesh.vertexCount();
    columns.add(new Column(3, mesh.positions()));
    columns.add(new Column(3, mesh.normals()));
    columns.add(new Column(4, mesh.tangents()));
    columns.add(new Column(2, mesh.uv0()));
    columns.add(new Column(2, mesh.uv1()));
    double[] colors = new double[mesh.colors().length];
    Arrays.setAll(colors, i -> mesh.colors()[i]);
    columns.add(new Column(4, colors));
    for (double[] each : sides) {
      this.sides.add(new Column(1, each));
      cuts.add(new HashMap<>());
    }
  }

  /** Returns a coordinate, 0 to 2, of a vertex. */
  double position(int vertex, int axis) {
    return columns.get(0).values[3 * vertex + axis];
  }

  /** Calls the visitor with each line in which a plane cuts the mesh. */
  void forLines(int plane, Lines visitor) {
    split(plane, triangles, new TriangleList(0), new TriangleList(0), visitor);
  }

  /** Returns the part that is behind a plane or more, with the vertices that it uses. */
  ModelGeometry kept() {
    TriangleList kept = new TriangleList(0);
    divide(kept);
    return kept.count() == mesh.triangleCount() && vertices == mesh.vertexCount()
        ? mesh
        : part(kept.toArray());
  }

  /** Returns the part that is in front of all planes. */
  ModelGeometry removed() {
    return part(divide(new TriangleList(0)));
  }

  /** Adds what is behind a plane or more to a list, and returns the other triangles. */
  private int[] divide(TriangleList kept) {
    int[] rest = triangles;
    for (int plane = 0; plane < sides.size(); plane++) {
      TriangleList front = new TriangleList(0);
      split(plane, rest, kept, front, (from, to, corner) -> {});
      rest = front.toArray();
    }
    return rest;
  }

  private void split(
      int plane, int[] corners, TriangleList behind, TriangleList front, Lines lines) {
    for (int i = 0; i < corners.length; i += 3) {
      if ((i / 3 & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      int count = 0;
      int odd = 0;
      for (int k = 0; k < 3; k++) {
        count += isBehind(plane, corners[i + k]) ? 1 : 0;
      }
      for (int k = 0; k < 3; k++) {
        odd = isBehind(plane, corners[i + k]) == (count == 1) ? k : odd;
      }
      int a = corners[i + odd];
      int b = corners[i + (odd + 1) % 3];
      int c = corners[i + (odd + 2) % 3];
      switch (count) {
        case 0 -> front.add(a, b, c);
        case 3 -> behind.add(a, b, c);
        default -> {
          boolean isOneBehind = count == 1;
          int p = isOneBehind ? cut(plane, a, b) : cut(plane, b, a);
          int q = isOneBehind ? cut(plane, a, c) : cut(plane, c, a);
          TriangleList alone = isOneBehind ? behind : front;
          TriangleList others = isOneBehind ? front : behind;
          add(alone, a, p, q);
          add(others, p, b, c);
          add(others, p, c, q);
          lines.add(isOneBehind ? q : p, isOneBehind ? p : q, b);
        }
      }
    }
  }

  private static void add(TriangleList list, int a, int b, int c) {
    if (a != b && b != c && c != a) {
      list.add(a, b, c);
    }
  }

  private boolean isBehind(int plane, int vertex) {
    return sides.get(plane).at(vertex) < 0;
  }

  /** Returns the vertex at which a plane cuts the edge from a vertex behind it to another one. */
  private int cut(int plane, int behind, int front) {
    double depth = sides.get(plane).at(behind);
    double height = sides.get(plane).at(front);
    if (height == 0) {
      return front;
    }
    return cuts.get(plane)
        .computeIfAbsent(
            (long) behind << 32 | front,
            key -> add(behind, front, depth / (depth - height), plane));
  }

  private int add(int behind, int front, double t, int plane) {
    int added = vertices++;
    columns.forEach(column -> column.set(added, behind, front, t));
    sides.forEach(column -> column.set(added, behind, front, t));
    sides.get(plane).values[added] = 0;
    Column tangents = columns.get(2);
    if (tangents.values.length > 0) {
      tangents.values[4 * added + 3] = tangents.values[4 * behind + 3];
    }
    return added;
  }

  private ModelGeometry part(int... corners) {
    double[] colors = columns.get(5).of(vertices);
    float[] rounded = new float[colors.length];
    for (int i = 0; i < rounded.length; i++) {
      rounded[i] = (float) colors[i];
    }
    return new ModelGeometry(
            columns.get(0).of(vertices),
            columns.get(1).of(vertices),
            columns.get(2).of(vertices),
            columns.get(3).of(vertices),
            columns.get(4).of(vertices),
            rounded,
            triangles)
        .part(corners);
  }
}
