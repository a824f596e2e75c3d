package io.github.lumbre.geometry.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

/**
 * The edges of one or several meshes, each with the triangles that have it. Vertices at the same
 * position count as one place, because files repeat them for each normal and texture coordinate.
 * Immutable.
 *
 * <p>Triangles are numbered through all meshes, in their order.
 */
public final class MeshEdges {
  /** Normals whose directions differ by less than 1° count as the same. */
  private static final double SAME = .99985;

  private static final int CORNERS_PER_CHECK = 1 << 16;

  private final double[] positions;

  /** The place of each corner: 3 for each triangle. */
  private final int[] corners;

  /** The corners where triangles begin an edge, grouped by the edge. */
  private final int[] sides;

  /** The index of the first side of each edge, and the number of all sides. */
  private final int[] first;

  private final BitSet smooth = new BitSet();

  /** Cells of this part of the longest side: vertices in one cell count as one place. */
  private static final double CELL = 0x1p-20;

  /** Where cells begin: not at round numbers, beside which files round in both directions. */
  private static final double SHIFT = .1371;

  /**
   * @param cell size of the cells whose vertices count as one place; 0 for exact positions
   */
  private MeshEdges(List<TriangleMesh> meshes, double cell) {
    corners = new int[3 * meshes.stream().mapToInt(TriangleMesh::triangleCount).sum()];
    PositionIndex places = new PositionIndex();
    double[] found = new double[3 * 8];
    int count = 0;
    int at = 0;
    for (TriangleMesh mesh : meshes) {
      int[] placeOfVertex = new int[mesh.vertexCount()];
      Arrays.fill(placeOfVertex, -1);
      for (int corner = 0; corner < 3 * mesh.triangleCount(); corner++) {
        if (corner % CORNERS_PER_CHECK == 0) {
          Interrupts.check();
        }
        int vertex = mesh.vertex(corner / 3, corner % 3);
        if (placeOfVertex[vertex] < 0) {
          Vec3 p = mesh.position(vertex);
          int place =
              places.number(rounded(p.x(), cell), rounded(p.y(), cell), rounded(p.z(), cell));
          placeOfVertex[vertex] = place;
          if (place == count) {
            found = 3 * count == found.length ? Arrays.copyOf(found, 6 * count) : found;
            found[3 * count] = p.x();
            found[3 * count + 1] = p.y();
            found[3 * count + 2] = p.z();
            count++;
          }
        }
        corners[at++] = placeOfVertex[vertex];
      }
    }
    positions = Arrays.copyOf(found, 3 * count);
    sides = new int[corners.length];
    first = grouped();
  }

  private static double rounded(double coordinate, double cell) {
    return cell > 0 ? Math.rint(coordinate / cell + SHIFT) : coordinate;
  }

  /** Returns the mesh of a shape in its local space; empty if it is not a mesh. */
  public static Optional<TriangleMesh> meshOf(Shape shape) {
    if (shape instanceof Mesh mesh) {
      return Optional.of(mesh.triangles());
    }
    return shape instanceof MeshInstance instance
        ? Optional.of(instance.shared().mesh())
        : Optional.empty();
  }

  /**
   * Returns the edges of meshes, which share places where they touch. Distances of less than a
   * millionth of the longest side of all meshes are ignored, because many programs write the same
   * point with rounding errors.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static MeshEdges of(List<TriangleMesh> meshes) {
    Bounds3 bounds =
        meshes.stream().map(TriangleMesh::bounds).reduce(Bounds3.EMPTY, Bounds3::union);
    double side = bounds.max().minus(bounds.min()).maxAbs();
    MeshEdges edges = new MeshEdges(meshes, side > 0 && side < 1e300 ? CELL * side : 0);
    edges.findSmooth(meshes);
    return edges;
  }

  /** Returns whether every edge of a mesh belongs to an even number of triangles. */
  public static boolean isClosed(TriangleMesh mesh) {
    // Most edges are even by their vertices: positions are compared for the others alone.
    int[] odd =
        odd(
            mesh.vertexCount(),
            3 * mesh.triangleCount(),
            (side, end) -> mesh.vertex(side / 3, (end == 0 ? side : following(side)) % 3));
    PositionIndex places = new PositionIndex();
    for (int i = 0; i < odd.length; i++) {
      Vec3 p = mesh.position(odd[i]);
      odd[i] = places.number(p.x(), p.y(), p.z());
    }
    return odd(odd.length, odd.length / 2, (side, end) -> odd[2 * side + end]).length == 0;
  }

  /** The ends of sides. */
  @FunctionalInterface
  private interface Sides {
    /**
     * @param end 0 or 1
     */
    int place(int side, int end);
  }

  /** Returns both ends of each pair of places that an odd number of sides connect. */
  private static int[] odd(int placeCount, int count, Sides sides) {
    int[] ends = new int[placeCount];
    int[] others = byPlace(ends, count, sides);
    int[] odd = new int[0];
    int found = 0;
    for (int place = 0, i = 0; place < placeCount; place++) {
      Arrays.sort(others, i, ends[place]);
      while (i < ends[place]) {
        if (i + 1 < ends[place] && others[i] == others[i + 1]) {
          i += 2;
        } else {
          odd = found < odd.length ? odd : Arrays.copyOf(odd, 2 * found + 2);
          odd[found++] = place;
          odd[found++] = others[i++];
        }
      }
    }
    return Arrays.copyOf(odd, found);
  }

  /**
   * Returns the larger places of sides, grouped by the smaller ones.
   *
   * @param ends receives where the group of each place ends
   */
  private static int[] byPlace(int[] ends, int count, Sides sides) {
    for (int side = 0; side < count; side++) {
      if (side % CORNERS_PER_CHECK == 0) {
        Interrupts.check();
      }
      ends[Math.min(sides.place(side, 0), sides.place(side, 1))]++;
    }
    for (int place = 0, sum = 0; place < ends.length; place++) {
      sum += ends[place];
      ends[place] = sum - ends[place];
    }
    int[] others = new int[count];
    for (int side = 0; side < count; side++) {
      int one = sides.place(side, 0);
      int other = sides.place(side, 1);
      others[ends[Math.min(one, other)]++] = Math.max(one, other);
    }
    return others;
  }

  /** Sorts the sides by their edges, and returns where each edge begins. */
  private int[] grouped() {
    int[] next = new int[positions.length / 3 + 1];
    for (int side = 0; side < sides.length; side++) {
      next[low(side) + 1]++;
    }
    for (int place = 1; place < next.length; place++) {
      next[place] += next[place - 1];
    }
    int[] begins = next.clone();
    long[] keys = new long[sides.length];
    for (int side = 0; side < sides.length; side++) {
      keys[next[low(side)]++] = (long) high(side) << 32 | side;
    }
    for (int place = 0; place < begins.length - 1; place++) {
      Arrays.sort(keys, begins[place], begins[place + 1]);
    }
    int[] starts = new int[sides.length + 1];
    int count = 0;
    for (int i = 0; i < keys.length; i++) {
      sides[i] = (int) keys[i];
      boolean isSame =
          i > 0 && low(sides[i]) == low(sides[i - 1]) && high(sides[i]) == high(sides[i - 1]);
      if (!isSame) {
        starts[count++] = i;
      }
    }
    starts[count] = sides.length;
    return Arrays.copyOf(starts, count + 1);
  }

  private int low(int side) {
    return Math.min(corners[side], corners[following(side)]);
  }

  private int high(int side) {
    return Math.max(corners[side], corners[following(side)]);
  }

  /** Returns the next corner of the same triangle. */
  private static int following(int corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  /** Finds the edges whose two triangles have the same vertex normals there. */
  private void findSmooth(List<TriangleMesh> meshes) {
    if (meshes.stream().noneMatch(TriangleMesh::hasNormals)) {
      return;
    }
    int[] meshOf = new int[corners.length / 3];
    int[] begin = new int[meshes.size()];
    int at = 0;
    for (int i = 0; i < meshes.size(); i++) {
      begin[i] = at;
      Arrays.fill(meshOf, at, at + meshes.get(i).triangleCount(), i);
      at += meshes.get(i).triangleCount();
    }
    for (int edge = 0; edge < count(); edge++) {
      if (edge % CORNERS_PER_CHECK == 0) {
        Interrupts.check();
      }
      if (triangles(edge) == 2) {
        Vec3[] one = normals(sides[first[edge]], meshes, meshOf, begin);
        Vec3[] other = normals(sides[first[edge] + 1], meshes, meshOf, begin);
        smooth.set(edge, isSame(one[0], other[0]) && isSame(one[1], other[1]));
      }
    }
  }

  /** Returns the normals at the place of the lower and the higher number of a side. */
  private Vec3[] normals(int side, List<TriangleMesh> meshes, int[] meshOf, int[] begin) {
    TriangleMesh mesh = meshes.get(meshOf[side / 3]);
    if (!mesh.hasNormals()) {
      return new Vec3[] {Vec3.ZERO, Vec3.ZERO};
    }
    int triangle = side / 3 - begin[meshOf[side / 3]];
    Vec3 here = mesh.normal(mesh.vertex(triangle, side % 3));
    Vec3 there = mesh.normal(mesh.vertex(triangle, following(side) % 3));
    return corners[side] == low(side) ? new Vec3[] {here, there} : new Vec3[] {there, here};
  }

  private static boolean isSame(Vec3 one, Vec3 other) {
    double dot = one.dot(other);
    return dot > 0 && dot * dot > SAME * SAME * one.dot(one) * other.dot(other);
  }

  /** Returns three coordinates for each place. */
  public double[] positions() {
    return positions.clone();
  }

  public int count() {
    return first.length - 1;
  }

  /** Returns the place with the lower number of the two ends of an edge. */
  public int from(int edge) {
    return low(sides[first[edge]]);
  }

  /** Returns the place with the higher number of the two ends of an edge. */
  public int to(int edge) {
    return high(sides[first[edge]]);
  }

  /** Returns the number of triangles that have an edge, at least 1. */
  public int triangles(int edge) {
    return first[edge + 1] - first[edge];
  }

  public int triangle(int edge, int index) {
    return sides[first[edge] + index] / 3;
  }

  /** Returns the place of the corner of one of these triangles that is not on the edge. */
  public int opposite(int edge, int index) {
    return corners[following(following(sides[first[edge] + index]))];
  }

  /** Returns whether an edge has two triangles, and their vertex normals are the same along it. */
  public boolean isSmooth(int edge) {
    return smooth.get(edge);
  }
}
