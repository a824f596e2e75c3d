package io.github.lumbre.model.internal;

import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The texture coordinates of a normal map. Tangents point along increasing u of the picture, so
 * that a transform that rotates or mirrors the picture does so with the bumps.
 *
 * @param uvSet 0 or 1
 * @param transform of the coordinates; the identity if it neither rotates nor mirrors
 */
record MapCoordinates(int uvSet, UvTransform transform) {
  private static final MapCoordinates FIRST = new MapCoordinates(0, UvTransform.IDENTITY);

  // Java would make the code of the next two at the first call, which delays each start.

  @Override
  public boolean equals(Object other) {
    return other instanceof MapCoordinates map
        && uvSet == map.uvSet
        && transform.equals(map.transform);
  }

  @Override
  public int hashCode() {
    return 31 * transform.hashCode() + uvSet;
  }

  /**
   * Returns the coordinates whose tangents a mesh needs and lacks: the coordinates of the normal
   * map, or else of a layer's normal map. It is empty if the material has no normal map, if the
   * mesh has tangents or no texture coordinates, and if each triangle of a flat mesh has the
   * tangents of its first texture coordinates.
   */
  static Optional<MapCoordinates> missing(ModelMaterial material, ModelGeometry geometry) {
    Optional<ModelTexture> map =
        Stream.concat(material.normalMap().stream(), layers(material))
            .flatMap(input -> input.texture().stream())
            .findFirst();
    if (map.isEmpty() || geometry.tangents().length > 0) {
      return Optional.empty();
    }
    MapCoordinates used = of(map.get(), geometry);
    boolean hasOwn = geometry.normals().length == 0 && used.equals(FIRST);
    return hasOwn || used.of(geometry).length == 0 ? Optional.empty() : Optional.of(used);
  }

  private static Stream<MaterialInput> layers(ModelMaterial material) {
    return MaterialParameter.all().stream()
        .filter(p -> p.kind() == MaterialParameter.Kind.NORMALS)
        .map(material::input);
  }

  private static MapCoordinates of(ModelTexture texture, ModelGeometry geometry) {
    UvTransform t = texture.uvTransform();
    boolean isUpright = t.uu() > 0 && t.vv() > 0 && t.uv() == 0 && t.vu() == 0;
    return new MapCoordinates(
        geometry.uv1().length == 0 ? 0 : texture.uvSet(), isUpright ? UvTransform.IDENTITY : t);
  }

  /** Returns two numbers per vertex, or an empty array if the mesh has no texture coordinates. */
  private double[] of(ModelGeometry geometry) {
    double[] plain = uvSet == 1 ? geometry.uv1() : geometry.uv0();
    if (transform.isIdentity()) {
      return plain;
    }
    double[] mapped = new double[plain.length];
    for (int i = 0; i < mapped.length; i += 2) {
      mapped[i] = transform.u(plain[i], plain[i + 1]);
      mapped[i + 1] = transform.v(plain[i], plain[i + 1]);
    }
    return mapped;
  }

  /** Returns a mesh with tangents. Triangles of a flat one share no vertices afterwards. */
  ModelGeometry withTangents(ModelGeometry geometry) {
    if (geometry.normals().length > 0) {
      return with(geometry, MikkTangents.of(geometry, of(geometry)));
    }
    ModelGeometry separate = separated(geometry);
    return with(separate, flatTangents(separate, of(separate)));
  }

  private static ModelGeometry with(ModelGeometry mesh, double[] tangents) {
    return new ModelGeometry(
        mesh.positions(),
        mesh.normals(),
        tangents,
        mesh.uv0(),
        mesh.uv1(),
        mesh.colors(),
        mesh.indices());
  }

  private static ModelGeometry separated(ModelGeometry mesh) {
    int[] corners = mesh.indices();
    float[] colors = new float[mesh.colors().length == 0 ? 0 : 4 * corners.length];
    for (int i = 0; i < colors.length; i++) {
      colors[i] = mesh.colors()[4 * corners[i / 4] + i % 4];
    }
    int[] indices = new int[corners.length];
    Arrays.setAll(indices, i -> i);
    return new ModelGeometry(
        separated(mesh.positions(), 3, corners),
        mesh.normals(),
        mesh.tangents(),
        separated(mesh.uv0(), 2, corners),
        separated(mesh.uv1(), 2, corners),
        colors,
        indices);
  }

  private static double[] separated(double[] values, int size, int... corners) {
    double[] result = new double[values.length == 0 ? 0 : size * corners.length];
    for (int i = 0; i < result.length; i++) {
      result[i] = values[size * corners[i / size] + i % size];
    }
    return result;
  }

  /** Returns the tangents of triangles that share no vertices; zero where there is none. */
  private static double[] flatTangents(ModelGeometry mesh, double... uv) {
    double[] tangents = new double[4 * mesh.vertexCount()];
    for (int i = 0; i < mesh.vertexCount(); i += 3) {
      Vec3 a = position(mesh, i);
      Vec3 e1 = position(mesh, i + 1).minus(a);
      Vec3 e2 = position(mesh, i + 2).minus(a);
      double dv1 = uv[2 * i + 3] - uv[2 * i + 1];
      double dv2 = uv[2 * i + 5] - uv[2 * i + 1];
      double area = (uv[2 * i + 2] - uv[2 * i]) * dv2 - (uv[2 * i + 4] - uv[2 * i]) * dv1;
      Vec3 sum = e1.times(dv2).plus(-dv1, e2).times(Math.signum(area));
      Vec3 tangent = sum.maxAbs() > 0 ? sum.normalized() : sum;
      for (int corner = i; corner < i + 3; corner++) {
        tangents[4 * corner] = tangent.x();
        tangents[4 * corner + 1] = tangent.y();
        tangents[4 * corner + 2] = tangent.z();
        tangents[4 * corner + 3] = area < 0 ? -1 : 1;
      }
    }
    return tangents;
  }

  private static Vec3 position(ModelGeometry mesh, int vertex) {
    double[] p = mesh.positions();
    return new Vec3(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
  }
}
