package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Copies of a node's mesh (EXT_mesh_gpu_instancing), which share its arrays. */
record GltfInstances(GltfDocument document, GltfAccessors accessors) {
  static final String EXTENSION = "EXT_mesh_gpu_instancing";

  /** Heap bytes of a copy: its transform, and the numbers that the transform is made from. */
  private static final long BYTES_PER_COPY = 300;

  /**
   * Returns the transforms of all copies, from the mesh to the node; the identity if the node does
   * not have the extension.
   *
   * @param node its index
   * @throws ModelFormatException if the accessors differ in the number of elements
   */
  List<GltfMatrix> ofNode(int node) throws ModelFormatException, IOException {
    Optional<GltfJson> extension = document.section("nodes").get(node).extension(EXTENSION);
    if (extension.isEmpty()) {
      return List.of(GltfMatrix.IDENTITY);
    }
    GltfJson attributes = extension.get().requireObject("attributes");
    int count = count(attributes);
    document.budget().allocate(attributes.location(), BYTES_PER_COPY * count);
    double[] translations = numbers(attributes, "TRANSLATION", count, 0, 0, 0);
    double[] rotations = numbers(attributes, "ROTATION", count, 0, 0, 0, 1);
    double[] scales = numbers(attributes, "SCALE", count, 1, 1, 1);
    List<GltfMatrix> copies = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Optional<double[]> rotation = GltfNode.normalized(element(rotations, 4, i));
      if (rotation.isEmpty()) {
        throw attributes.malformed(
            "ROTATION", "expected unit quaternions, found zeros in element " + i);
      }
      copies.add(GltfMatrix.of(element(translations, 3, i), rotation.get(), element(scales, 3, i)));
    }
    return copies;
  }

  /** Returns the number of elements that the first attribute has. */
  private int count(GltfJson attributes) throws ModelFormatException, IOException {
    List<String> names = attributes.keys();
    String first = names.isEmpty() ? "TRANSLATION" : names.get(0);
    return accessors.require(attributes, first).count();
  }

  /** Returns the numbers of an attribute; without it, one element for all copies. */
  private double[] numbers(GltfJson attributes, String name, int count, double... fallback)
      throws ModelFormatException, IOException {
    if (!attributes.has(name)) {
      return fallback;
    }
    GltfAccessor accessor = accessors.require(attributes, name).requireComponents(fallback.length);
    if (accessor.count() != count) {
      throw attributes.malformed(
          name, "expected " + count + " elements, found " + accessor.count());
    }
    return accessors.finiteNumbers(accessor);
  }

  private static double[] element(double[] numbers, int components, int index) {
    int from = numbers.length == components ? 0 : components * index;
    return Arrays.copyOfRange(numbers, from, from + components);
  }
}
