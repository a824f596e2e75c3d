package io.github.lumbre.model;

import io.github.lumbre.model.ModelFormatException.Kind;

/** Vectors in arrays: three numbers each, which further numbers may follow. */
final class GltfVectors {
  /** The largest absolute value: products of two numbers must not overflow. */
  private static final double MAX_NUMBER = 1e150;

  private GltfVectors() {}

  /**
   * Gives vectors unit length; those of length 0 stay.
   *
   * @param stride numbers from one vector to the next
   */
  static void normalize(double[] vectors, int stride) {
    for (int i = 0; i + 2 < vectors.length; i += stride) {
      double x = vectors[i];
      double y = vectors[i + 1];
      double z = vectors[i + 2];
      double length = Math.sqrt(x * x + y * y + z * z);
      if (length > 0) {
        vectors[i] = x / length;
        vectors[i + 1] = y / length;
        vectors[i + 2] = z / length;
      }
    }
  }

  /**
   * Returns a mesh whose vertices were moved, without directions that are not finite.
   *
   * @throws ModelFormatException if a position is too large
   */
  static ModelGeometry moved(
      GltfJson primitive,
      ModelGeometry rest,
      double[] positions,
      double[] normals,
      double[] tangents,
      int... indices)
      throws ModelFormatException {
    for (double position : positions) {
      if (!(Math.abs(position) <= MAX_NUMBER)) {
        throw new ModelFormatException(
            Kind.MALFORMED,
            primitive.location(),
            "expected moved vertices of at most 1e150, found " + position);
      }
    }
    normalize(normals, 3);
    normalize(tangents, 4);
    boolean hasNormals = GltfAccessors.indexOfInfinite(normals) < 0;
    boolean hasTangents = hasNormals && GltfAccessors.indexOfInfinite(tangents) < 0;
    return new ModelGeometry(
        positions,
        hasNormals ? normals : new double[0],
        hasTangents ? tangents : new double[0],
        rest.uv0(),
        rest.uv1(),
        rest.colors(),
        indices);
  }
}
