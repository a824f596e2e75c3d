package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.BitSet;
import java.util.List;

/** Moves the vertices of a mesh by weighted morph targets (glTF 2.0, section 3.7.2.2). */
record GltfMorph(GltfDocument document, GltfAttributes attributes) {
  /**
   * Returns the moved mesh, without triangles whose vertices are not finite. Its normals and
   * tangents have unit length.
   *
   * @param weights of the targets, some of them not 0
   */
  ModelGeometry applied(GltfJson primitive, ModelGeometry rest, double... weights)
      throws ModelFormatException, IOException {
    double[] positions = document.budget().copy(primitive.location(), rest.positions());
    double[] normals = document.budget().copy(primitive.location(), rest.normals());
    double[] tangents = document.budget().copy(primitive.location(), rest.tangents());
    double[] delta = document.budget().copy(primitive.location(), rest.positions());
    List<GltfJson> targets = primitive.objects("targets");
    for (int i = 0; i < Math.min(targets.size(), weights.length); i++) {
      if (weights[i] != 0) {
        add(targets.get(i), "POSITION", weights[i], delta, positions, 3);
        add(targets.get(i), "NORMAL", weights[i], delta, normals, 3);
        add(targets.get(i), "TANGENT", weights[i], delta, tangents, 4);
      }
    }
    BitSet broken = GltfVectors.removeBroken(positions);
    if (rest.isPoints() && !broken.isEmpty()) {
      throw primitive.malformed("targets", "expected finite positions of points");
    }
    int[] indices = GltfTriangles.whole(document, primitive, broken, rest.indices());
    return GltfVectors.checked(primitive, rest.moved(positions, normals, tangents, indices));
  }

  private void add(
      GltfJson target, String name, double weight, double[] delta, double[] sum, int stride)
      throws ModelFormatException, IOException {
    if (sum.length == 0 || !target.has(name)) {
      return;
    }
    Interrupts.check();
    GltfAccessor accessor = attributes.of(target, name, delta.length / 3).requireComponents(3);
    accessor.read(delta);
    if (!name.equals("POSITION") && GltfAccessors.indexOfInfinite(delta) >= 0) {
      document
          .warnings()
          .add(accessor.location(), "NaN or infinite numbers; " + name + " is ignored");
      return;
    }
    for (int from = 0, to = 0; from < delta.length; from += 3, to += stride) {
      sum[to] += weight * delta[from];
      sum[to + 1] += weight * delta[from + 1];
      sum[to + 2] += weight * delta[from + 2];
    }
  }
}
