package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The joints that move the vertices of meshes (glTF 2.0, section 3.7.3.3). Mutable. */
final class GltfInfluences {
  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final GltfAttributes attributes;
  private final Map<String, List<Set>> primitives = new HashMap<>();

  /**
   * Four joints of each vertex.
   *
   * @param joints their numbers, which are not checked
   * @param weights how strongly each moves the vertex
   */
  record Set(int[] joints, double[] weights) {}

  GltfInfluences(GltfDocument document, GltfAccessors accessors, GltfAttributes attributes) {
    this.document = document;
    this.accessors = accessors;
    this.attributes = attributes;
  }

  /** Returns the joints of a primitive's vertices: at least one set. */
  List<Set> of(GltfJson primitive, int vertices) throws ModelFormatException, IOException {
    String key = primitive.location();
    List<Set> sets = primitives.get(key);
    if (sets == null) {
      GltfJson json = primitive.requireObject("attributes");
      sets = new ArrayList<>();
      do {
        sets.add(set(json, sets.size(), vertices));
      } while (json.has("JOINTS_" + sets.size()));
      primitives.put(key, sets);
    }
    return sets;
  }

  private Set set(GltfJson json, int number, int vertices)
      throws ModelFormatException, IOException {
    GltfAccessor joints = attributes.of(json, "JOINTS_" + number, vertices).requireComponents(4);
    GltfAccessor weights = attributes.of(json, "WEIGHTS_" + number, vertices).requireComponents(4);
    double[] numbers = accessors.numbers(joints);
    document.budget().allocate(joints.location(), (long) Integer.BYTES * numbers.length);
    int[] indices = new int[numbers.length];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = (int) numbers[i];
    }
    double[] fractions = accessors.fractions(weights);
    if (GltfAccessors.indexOfInfinite(fractions) >= 0) {
      document.warnings().add(weights.location(), "NaN or infinite weights are taken as 0");
      Arrays.setAll(fractions, i -> Double.isFinite(fractions[i]) ? fractions[i] : 0);
    }
    return new Set(indices, fractions);
  }
}
