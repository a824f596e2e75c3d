package io.github.lumbre.model.internal;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * Computes the vertex tangents of a mesh for normal maps, as MikkTSpace does (Mikkelsen 2008,
 * "Simulation of Wrinkled Surfaces Revisited", and the reference code of the same author), which
 * glTF 2.0 requires. A vertex's tangent is the mean of its triangles' directions of increasing u,
 * each projected into the vertex's plane and weighted by the angle at the vertex. Triangles whose
 * texture is mirrored count separately.
 */
final class MikkTangents {
  private final ModelGeometry mesh;
  private final double[] uvs;
  private final int[] group;
  private final double[] sums;

  private MikkTangents(ModelGeometry mesh, double[] uvs) {
    this.mesh = mesh;
    this.uvs = uvs;
    group = groups(mesh, uvs);
    // Two sums per vertex: for each orientation of the texture.
    sums = new double[6 * mesh.vertexCount()];
  }

  /**
   * Returns four numbers per vertex; see {@link ModelGeometry#tangents}.
   *
   * @param mesh with normals
   * @param uvs the texture coordinates of the normal map, two numbers per vertex
   */
  static double[] of(ModelGeometry mesh, double[] uvs) {
    MikkTangents tangents = new MikkTangents(mesh, uvs);
    for (int i = 0; i < mesh.indices().length; i += 3) {
      tangents.addTriangle(i);
    }
    return tangents.result();
  }

  /** Returns for each vertex the first one with the same position, normal and coordinates. */
  private static int[] groups(ModelGeometry mesh, double[] uvs) {
    Map<Key, Integer> first = new HashMap<>();
    int[] groups = new int[mesh.vertexCount()];
    for (int i = 0; i < groups.length; i++) {
      Integer known = first.putIfAbsent(Key.of(mesh, uvs, i), i);
      groups[i] = known == null ? i : known;
    }
    return groups;
  }

  /** The attributes that make two vertices one: position, normal and coordinates. */
  private record Key(double[] numbers) {
    static Key of(ModelGeometry mesh, double[] uvs, int i) {
      double[] numbers = new double[8];
      System.arraycopy(mesh.positions(), 3 * i, numbers, 0, 3);
      System.arraycopy(mesh.normals(), 3 * i, numbers, 3, 3);
      System.arraycopy(uvs, 2 * i, numbers, 6, 2);
      return new Key(numbers);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Key key && Arrays.equals(numbers, key.numbers);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(numbers);
    }
  }

  private static Vec3 vector(double[] array, int i) {
    return new Vec3(array[3 * i], array[3 * i + 1], array[3 * i + 2]);
  }

  private void addTriangle(int first) {
    int[] corners = Arrays.copyOfRange(mesh.indices(), first, first + 3);
    Vec3 a = vector(mesh.positions(), corners[0]);
    Vec3 e1 = vector(mesh.positions(), corners[1]).minus(a);
    Vec3 e2 = vector(mesh.positions(), corners[2]).minus(a);
    double[] uv = uvs;
    double du1 = uv[2 * corners[1]] - uv[2 * corners[0]];
    double dv1 = uv[2 * corners[1] + 1] - uv[2 * corners[0] + 1];
    double du2 = uv[2 * corners[2]] - uv[2 * corners[0]];
    double dv2 = uv[2 * corners[2] + 1] - uv[2 * corners[0] + 1];
    double area = du1 * dv2 - du2 * dv1;
    Vec3 tangent = e1.times(dv2).plus(-dv1, e2).times(Math.signum(area));
    if (area == 0 || !(tangent.maxAbs() > 0)) {
      return;
    }
    for (int corner = 0; corner < 3; corner++) {
      int vertex = group[corners[corner]];
      Vec3 normal = vector(mesh.normals(), vertex);
      Vec3 position = vector(mesh.positions(), vertex);
      Vec3 next = vector(mesh.positions(), corners[(corner + 1) % 3]).minus(position);
      Vec3 previous = vector(mesh.positions(), corners[(corner + 2) % 3]).minus(position);
      double angle = angle(inPlane(next, normal), inPlane(previous, normal));
      Vec3 projected = inPlane(tangent, normal);
      if (projected.maxAbs() > 0) {
        add(vertex, area > 0, projected.normalized().times(angle));
      }
    }
  }

  private static Vec3 inPlane(Vec3 v, Vec3 normal) {
    return v.plus(-v.dot(normal), normal);
  }

  private static double angle(Vec3 a, Vec3 b) {
    return Elementary.atan2(a.cross(b).length(), a.dot(b));
  }

  private void add(int vertex, boolean isUpright, Vec3 tangent) {
    int i = 6 * vertex + (isUpright ? 0 : 3);
    sums[i] += tangent.x();
    sums[i + 1] += tangent.y();
    sums[i + 2] += tangent.z();
  }

  private double[] result() {
    double[] tangents = new double[4 * mesh.vertexCount()];
    for (int i = 0; i < mesh.vertexCount(); i++) {
      Vec3 upright = vector(sums, 2 * group[i]);
      Vec3 mirrored = vector(sums, 2 * group[i] + 1);
      // A vertex whose triangles have both orientations keeps the one with the larger angle.
      boolean isUpright = upright.length() >= mirrored.length();
      Vec3 sum = isUpright ? upright : mirrored;
      Vec3 tangent = sum.maxAbs() > 0 ? sum.normalized() : Vec3.X;
      tangents[4 * i] = tangent.x();
      tangents[4 * i + 1] = tangent.y();
      tangents[4 * i + 2] = tangent.z();
      tangents[4 * i + 3] = isUpright ? 1 : -1;
    }
    return tangents;
  }
}
