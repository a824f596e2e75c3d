package io.github.lumbre.model;

import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;

/** The nodes of a glTF file: trees, and their transforms to world space. Mutable. */
final class GltfNodes {
  private static final int NONE = -1;

  private final GltfDocument document;
  private final List<GltfNode> nodes = new ArrayList<>();
  private final int[] parents;
  private final List<GltfMatrix> toWorld;

  /**
   * Reads the nodes.
   *
   * @param lights number of punctual lights in the file
   * @throws ModelFormatException if a node has two parents, or is its own ancestor
   */
  GltfNodes(GltfDocument document, int lights) throws ModelFormatException {
    this.document = document;
    List<GltfJson> section = document.section("nodes");
    document.budget().addNodes(section.size());
    for (GltfJson json : section) {
      nodes.add(GltfNode.of(json, document, lights));
    }
    parents = parents();
    toWorld = new ArrayList<>(nodes.size());
  }

  /** Returns a node. */
  GltfNode get(int index) {
    return nodes.get(index);
  }

  /** Returns the number of nodes. */
  int size() {
    return nodes.size();
  }

  private int[] parents() throws ModelFormatException {
    int[] found = new int[nodes.size()];
    Arrays.fill(found, NONE);
    for (int i = 0; i < found.length; i++) {
      int[] children = nodes.get(i).children();
      for (int k = 0; k < children.length; k++) {
        int child = children[k];
        if (found[child] != NONE) {
          throw new ModelFormatException(
              Kind.MALFORMED,
              nodes.get(i).location() + ".children[" + k + "]",
              "expected a node without a parent, found "
                  + child
                  + ", a child of node "
                  + found[child]);
        }
        found[child] = i;
      }
    }
    return found;
  }

  /**
   * Computes all transforms to world space.
   *
   * @param pose replaces the local transforms of some nodes
   * @throws ModelFormatException if a node is its own ancestor, or a tree is too deep
   */
  void place(GltfPose pose) throws ModelFormatException {
    GltfMatrix[] placed = new GltfMatrix[nodes.size()];
    int[] depths = new int[nodes.size()];
    int[] queue = new int[nodes.size()];
    int end = 0;
    for (int i = 0; i < queue.length; i++) {
      if (parents[i] == NONE) {
        queue[end++] = i;
      }
    }
    for (int begin = 0; begin < end; begin++) {
      int node = queue[begin];
      int parent = parents[node];
      GltfMatrix local = pose.local(node, nodes.get(node));
      placed[node] = parent == NONE ? local : placed[parent].times(local);
      depths[node] = parent == NONE ? 1 : depths[parent] + 1;
      GltfBudget.require(nodes.get(node).location(), "levels", GltfBudget.MAX_DEPTH, depths[node]);
      for (int child : nodes.get(node).children()) {
        queue[end++] = child;
      }
    }
    for (int i = 0; i < placed.length; i++) {
      if (placed[i] == null) {
        throw new ModelFormatException(
            Kind.MALFORMED,
            nodes.get(i).location(),
            "expected a node that is not below itself, found a cycle");
      }
    }
    toWorld.clear();
    toWorld.addAll(Arrays.asList(placed));
  }

  /** Returns the transform of a node to world space. */
  GltfMatrix toWorld(int node) {
    return toWorld.get(node);
  }

  /** Returns the nodes of the default scene, else of the first one, else all, by their indices. */
  int[] visible() throws ModelFormatException {
    int[] roots = roots();
    int[] queue = Arrays.copyOf(roots, nodes.size());
    int end = roots.length;
    for (int begin = 0; begin < end; begin++) {
      for (int child : nodes.get(queue[begin]).children()) {
        queue[end++] = child;
      }
    }
    int[] visible = Arrays.copyOf(queue, end);
    Arrays.sort(visible);
    return visible;
  }

  private int[] roots() throws ModelFormatException {
    List<GltfJson> scenes = document.section("scenes");
    OptionalInt number = document.root().index("scene", scenes.size());
    if (scenes.isEmpty()) {
      return allRoots();
    }
    GltfJson scene = scenes.get(number.orElse(0));
    int[] roots = scene.indices("nodes", nodes.size());
    boolean[] seen = new boolean[nodes.size()];
    for (int i = 0; i < roots.length; i++) {
      int node = roots[i];
      if (parents[node] != NONE || seen[node]) {
        throw scene.malformed(
            "nodes[" + i + "]",
            seen[node]
                ? "expected each node once, found " + node + " again"
                : "expected a root node, found " + node + ", a child of node " + parents[node]);
      }
      seen[node] = true;
    }
    return roots;
  }

  private int[] allRoots() {
    int[] roots = new int[nodes.size()];
    int count = 0;
    for (int i = 0; i < roots.length; i++) {
      if (parents[i] == NONE) {
        roots[count++] = i;
      }
    }
    return Arrays.copyOf(roots, count);
  }
}
