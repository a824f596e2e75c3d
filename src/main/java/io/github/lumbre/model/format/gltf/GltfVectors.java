package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelGeometry;
import java.util.Arrays;
import java.util.BitSet;

/** Vectors in arrays: three numbers each, which further numbers may follow. */
final class GltfVectors {
  /** The largest absolute value: products of two numbers must not overflow. */
  private static final double MAX_NUMBER = 1e150;

  private GltfVectors() {}

  /**
   * Gives vectors unit length; vectors of length 0 stay.
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

  /** Sets positions that are not finite to 0, and returns the numbers of their vertices. */
  static BitSet removeBroken(double[] positions) {
    BitSet broken = new BitSet();
    for (int i = 0; i < positions.length; i += 3) {
      if (!Double.isFinite(positions[i] + positions[i + 1] + positions[i + 2])) {
        broken.set(i / 3);
        Arrays.fill(positions, i, i + 3, 0);
      }
    }
    return broken;
  }

  /**
   * Returns a mesh whose vertices were moved, without directions that are not finite. The others
   * get unit length, in place.
   *
   * @throws ModelFormatException if a position is too large
   */
  static ModelGeometry checked(GltfJson primitive, ModelGeometry moved)
      throws ModelFormatException {
    for (double position : moved.positions()) {
      if (!(Math.abs(position) <= MAX_NUMBER)) {
        throw Kind.MALFORMED.at(
            primitive.location(), "expected moved vertices of at most 1e150, found " + position);
      }
    }
    normalize(moved.normals(), 3);
    normalize(moved.tangents(), 4);
    boolean hasNormals = GltfAccessors.indexOfInfinite(moved.normals()) < 0;
    boolean hasTangents = hasNormals && GltfAccessors.indexOfInfinite(moved.tangents()) < 0;
    return moved.moved(
        moved.positions(),
        hasNormals ? moved.normals() : new double[0],
        hasTangents ? moved.tangents() : new double[0],
        moved.indices());
  }
}
