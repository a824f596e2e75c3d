package io.github.lumbre.model.format.gltf;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The values that an animation gives to nodes at one time. Mutable. */
final class GltfPose {
  private final Map<Integer, double[]> translations = new HashMap<>();
  private final Map<Integer, double[]> rotations = new HashMap<>();
  private final Map<Integer, double[]> scales = new HashMap<>();
  private final Map<Integer, double[]> weights = new HashMap<>();
  private double end = Double.NEGATIVE_INFINITY;

  /** Notes the time of a last keyframe, in seconds. */
  void extendTo(double seconds) {
    end = Math.max(end, seconds);
  }

  /** Returns the latest time noted; infinite if there is none. */
  double end() {
    return end < 0 ? Double.POSITIVE_INFINITY : end;
  }

  /** Sets the translation of a node. */
  void translate(int node, double... value) {
    translations.put(node, value);
  }

  /** Sets the rotation of a node: a unit quaternion. */
  void rotate(int node, double... value) {
    rotations.put(node, value);
  }

  void scale(int node, double... value) {
    scales.put(node, value);
  }

  /** Sets the weights of the morph targets of a node's mesh. */
  void weigh(int node, double... value) {
    weights.put(node, value);
  }

  /** Returns the local transform of a node. */
  GltfMatrix local(int index, GltfNode node) {
    return node.matrix()
        .orElseGet(
            () ->
                GltfMatrix.of(
                    translations.getOrDefault(index, node.translation()),
                    rotations.getOrDefault(index, node.rotation()),
                    scales.getOrDefault(index, node.scale())));
  }

  /** Returns the orientation of a node: its local transform without translation and scale. */
  GltfMatrix orientation(int index, GltfNode node) {
    return node.matrix()
        .map(GltfMatrix::orientation)
        .orElseGet(
            () ->
                GltfMatrix.of(
                    new double[3],
                    rotations.getOrDefault(index, node.rotation()),
                    new double[] {1, 1, 1}));
  }

  /** Returns whether a node neither mirrors nor flattens what it places. */
  boolean isPositive(int index, GltfNode node) {
    return node.matrix().isPresent()
        ? node.matrix().get().isPositive()
        : Arrays.stream(scales.getOrDefault(index, node.scale())).allMatch(scale -> scale > 0);
  }

  /** Returns the weights of a node; empty if the animation does not set them. */
  Optional<double[]> weights(int node) {
    return Optional.ofNullable(weights.get(node));
  }
}
