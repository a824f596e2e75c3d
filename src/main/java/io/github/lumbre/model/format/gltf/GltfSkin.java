package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/** Moves the vertices of a mesh with the joints of a skeleton (glTF 2.0, section 3.7.3). */
final class GltfSkin {
  private static final int VERTICES_PER_CHECK = 1 << 16;

  private final GltfDocument document;
  private final GltfInfluences influences;
  private final GltfMatrix[] joints;

  /**
   * Reads a skin.
   *
   * @param nodes already placed
   */
  GltfSkin(
      GltfJson json,
      GltfDocument document,
      GltfAccessors accessors,
      GltfInfluences influences,
      GltfNodes nodes)
      throws ModelFormatException, IOException {
    this.document = document;
    this.influences = influences;
    int[] found = json.indices("joints", nodes.size());
    if (found.length == 0) {
      throw json.malformed("joints", "expected at least one joint, found none");
    }
    joints = new GltfMatrix[found.length];
    for (int i = 0; i < joints.length; i++) {
      joints[i] = nodes.toWorld(found[i]);
    }
    if (json.has("inverseBindMatrices")) {
      GltfAccessor accessor =
          accessors
              .require(json, "inverseBindMatrices")
              .requireComponents(16)
              .requireAtLeast(found.length);
      if (accessor.component() != GltfComponent.FLOAT) {
        throw accessor.error("componentType", "expected 5126 for matrices, found another type");
      }
      double[] matrices = accessors.finiteNumbers(accessor);
      for (int i = 0; i < joints.length; i++) {
        joints[i] = joints[i].times(GltfMatrix.ofColumns(matrices, 16 * i));
      }
    }
  }

  /**
   * Returns the moved mesh, in world space. Its normals and tangents have unit length.
   *
   * @param isMirrored whether the node's transform has a negative determinant, which reverses the
   *     winding of triangles (glTF 2.0, section 3.7.4)
   */
  ModelGeometry applied(GltfJson primitive, ModelGeometry rest, boolean isMirrored)
      throws ModelFormatException, IOException {
    GltfJson json = primitive.requireObject("attributes");
    int vertices = rest.vertexCount();
    List<GltfInfluences.Set> sets = influences.of(primitive, vertices);
    double[] positions = document.budget().copy(primitive.location(), rest.positions());
    double[] normals = document.budget().copy(primitive.location(), rest.normals());
    double[] tangents = document.budget().copy(primitive.location(), rest.tangents());
    double[] sum = new double[12];
    for (int i = 0; i < vertices; i++) {
      if (i % VERTICES_PER_CHECK == 0) {
        Interrupts.check();
      }
      blend(sets, i, sum, json);
      movePoint(positions, 3 * i, sum);
      if (normals.length > 0) {
        moveNormal(normals, 3 * i, sum);
      }
      if (tangents.length > 0) {
        moveVector(tangents, 4 * i, sum);
      }
    }
    int[] indices = rest.indices();
    if (isMirrored) {
      document.budget().addIndices(primitive.location(), indices.length);
      indices = GltfTriangles.reversed(indices);
    }
    return GltfVectors.checked(primitive, rest.moved(positions, normals, tangents, indices));
  }

  /** Computes the weighted mean of the joints' matrices for a vertex. */
  private void blend(List<GltfInfluences.Set> sets, int vertex, double[] sum, GltfJson json)
      throws ModelFormatException {
    Arrays.fill(sum, 0);
    double total = 0;
    for (GltfInfluences.Set set : sets) {
      for (int i = 4 * vertex; i < 4 * vertex + 4; i++) {
        if (set.weights()[i] != 0) {
          joint(set.joints()[i], vertex, json).addTo(sum, set.weights()[i]);
          total += set.weights()[i];
        }
      }
    }
    if (total == 0) {
      joint(sets.get(0).joints()[4 * vertex], vertex, json).addTo(sum, 1);
    } else if (total != 1) {
      for (int i = 0; i < sum.length; i++) {
        sum[i] /= total;
      }
    }
  }

  private GltfMatrix joint(int index, int vertex, GltfJson json) throws ModelFormatException {
    if (index < 0 || index >= joints.length) {
      throw Kind.MALFORMED.at(
          json.location(),
          "expected joints from 0 to %s, found %s at vertex %s"
              .formatted(joints.length - 1, index, vertex));
    }
    return joints[index];
  }

  private static void movePoint(double[] points, int at, double... m) {
    double x = points[at];
    double y = points[at + 1];
    double z = points[at + 2];
    points[at] = m[0] * x + m[1] * y + m[2] * z + m[3];
    points[at + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
    points[at + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
  }

  private static void moveVector(double[] vectors, int at, double... m) {
    double x = vectors[at];
    double y = vectors[at + 1];
    double z = vectors[at + 2];
    vectors[at] = m[0] * x + m[1] * y + m[2] * z;
    vectors[at + 1] = m[4] * x + m[5] * y + m[6] * z;
    vectors[at + 2] = m[8] * x + m[9] * y + m[10] * z;
  }

  /** Moves a normal by the cofactors: the inverse transpose up to a factor, whose sign is kept. */
  private static void moveNormal(double[] normals, int at, double... m) {
    double c00 = m[5] * m[10] - m[6] * m[9];
    double c01 = m[6] * m[8] - m[4] * m[10];
    double c02 = m[4] * m[9] - m[5] * m[8];
    double sign = m[0] * c00 + m[1] * c01 + m[2] * c02 < 0 ? -1 : 1;
    double x = sign * normals[at];
    double y = sign * normals[at + 1];
    double z = sign * normals[at + 2];
    normals[at] = c00 * x + c01 * y + c02 * z;
    normals[at + 1] =
        (m[2] * m[9] - m[1] * m[10]) * x
            + (m[0] * m[10] - m[2] * m[8]) * y
            + (m[1] * m[8] - m[0] * m[9]) * z;
    normals[at + 2] =
        (m[1] * m[6] - m[2] * m[5]) * x
            + (m[2] * m[4] - m[0] * m[6]) * y
            + (m[0] * m[5] - m[1] * m[4]) * z;
  }
}
