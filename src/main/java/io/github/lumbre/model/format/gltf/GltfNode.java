package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A node of a glTF file (glTF 2.0, section 3.5.2).
 *
 * @param matrix the local transform, if the file gives it as a matrix
 * @param translation used if there is no matrix
 * @param rotation a unit quaternion: x, y, z, w
 * @param weights of morph targets; empty if the mesh has them
 * @param light of KHR_lights_punctual
 */
record GltfNode(
    String name,
    String location,
    int[] children,
    Optional<GltfMatrix> matrix,
    double[] translation,
    double[] rotation,
    double[] scale,
    double[] weights,
    OptionalInt mesh,
    OptionalInt skin,
    OptionalInt camera,
    OptionalInt light) {
  private static final double[] ZERO = {0, 0, 0};
  private static final double[] ONE = {1, 1, 1};
  private static final double[] NO_ROTATION = {0, 0, 0, 1};

  /** Returns the node that a JSON object describes. */
  static GltfNode of(GltfJson json, GltfDocument document, int lights) throws ModelFormatException {
    double[] rotation = json.numbers("rotation", NO_ROTATION);
    Optional<double[]> unit = normalized(rotation);
    if (unit.isEmpty()) {
      throw json.malformed("rotation", "expected a unit quaternion, found zeros");
    }
    Optional<GltfJson> light = json.extension("KHR_lights_punctual");
    return new GltfNode(
        json.text("name", ""),
        json.location(),
        json.indices("children", document.size("nodes")),
        matrix(json),
        json.numbers("translation", ZERO),
        unit.get(),
        json.numbers("scale", ONE),
        json.numbers("weights"),
        json.index("mesh", document.size("meshes")),
        json.index("skin", document.size("skins")),
        json.index("camera", document.size("cameras")),
        light.isPresent()
            ? OptionalInt.of(light.get().requireIndex("light", lights))
            : OptionalInt.empty());
  }

  /**
   * Returns this node without its mesh and light. Its camera stays, as KHR_node_visibility asks.
   */
  GltfNode hidden() {
    return new GltfNode(
        name,
        location,
        children,
        matrix,
        translation,
        rotation,
        scale,
        weights,
        OptionalInt.empty(),
        skin,
        camera,
        OptionalInt.empty());
  }

  private static Optional<GltfMatrix> matrix(GltfJson json) throws ModelFormatException {
    if (!json.has("matrix")) {
      return Optional.empty();
    }
    double[] columns = json.numbers("matrix", new double[16]);
    if (!GltfMatrix.isAffine(columns)) {
      throw json.malformed("matrix", "expected the last row 0, 0, 0, 1, found another one");
    }
    return Optional.of(GltfMatrix.ofColumns(columns, 0));
  }

  /** Returns a quaternion of length 1; empty if its length is 0. */
  static Optional<double[]> normalized(double... q) {
    double largest = 0;
    for (double component : q) {
      largest = Math.max(largest, Math.abs(component));
    }
    if (largest == 0) {
      return Optional.empty();
    }
    double square = 0;
    for (double component : q) {
      square += component / largest * (component / largest);
    }
    double length = Math.sqrt(square);
    double[] unit = new double[q.length];
    for (int i = 0; i < q.length; i++) {
      unit[i] = q[i] / largest / length;
    }
    return Optional.of(unit);
  }
}
