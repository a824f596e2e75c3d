package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** The nodes of a glTF file: trees, and their transforms to world space. Mutable. */
final class GltfNodes {
  /** The extension that hides nodes. */
  static final String VISIBILITY = "KHR_node_visibility";

  private static final int NONE = -1;

  private final GltfDocument document;
  private final List<GltfNode> nodes = new ArrayList<>();
  private final int[] parents;
  private final List<GltfMatrix> toWorld;

  /** Nodes above others, as parts. */
  private final Map<Integer, ModelNode> groups = new HashMap<>();

  /**
   * Reads the nodes.
   *
   * @param lights number of punctual lights in the file
   * @throws ModelFormatException if a node is damaged
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
    for (int hidden : withDescendants(hidden(section))) {
      nodes.set(hidden, nodes.get(hidden).hidden());
    }
  }

  /** Returns the nodes that hide themselves and all below them. */
  private static int[] hidden(List<GltfJson> section) throws ModelFormatException {
    int[] hidden = new int[section.size()];
    int count = 0;
    for (int i = 0; i < hidden.length; i++) {
      Optional<GltfJson> extension = section.get(i).extension(VISIBILITY);
      if (extension.isPresent() && !extension.get().flag("visible", true)) {
        hidden[count++] = i;
      }
    }
    return Arrays.copyOf(hidden, count);
  }

  GltfNode get(int index) {
    return nodes.get(index);
  }

  /** Returns the number of nodes. */
  int size() {
    return nodes.size();
  }

  /**
   * Returns a node as a part of the model, with the nodes above it.
   *
   * @param otherwise the name of a node that has none; may be empty
   */
  ModelNode part(int node, String otherwise) {
    IntStream above = IntStream.iterate(parents[node], n -> n != NONE, n -> parents[n]);
    Optional<ModelNode> parent = Optional.empty();
    int[] ancestors = above.toArray();
    for (int i = ancestors.length - 1; i >= 0; i--) {
      Optional<ModelNode> outer = parent;
      parent = Optional.of(groups.computeIfAbsent(ancestors[i], n -> part(n, "", outer)));
    }
    return part(node, otherwise, parent);
  }

  private ModelNode part(int node, String otherwise, Optional<ModelNode> parent) {
    String name = nodes.get(node).name();
    return ModelNode.of(name.isEmpty() ? otherwise : name, "node " + node, parent);
  }

  private int[] parents() {
    int[] found = new int[nodes.size()];
    Arrays.fill(found, NONE);
    for (int i = 0; i < found.length; i++) {
      int[] children = nodes.get(i).children();
      for (int k = 0; k < children.length; k++) {
        int child = children[k];
        if (found[child] == NONE) {
          found[child] = i;
        } else {
          document
              .warnings()
              .add(
                  "a node is listed as a child again",
                  nodes.get(i).location() + ".children[" + k + "]",
                  "expected a node without a parent, found "
                      + child
                      + ", a child of node "
                      + found[child]
                      + "; it is shown there");
        }
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
    boolean[] seen = new boolean[nodes.size()];
    int end = 0;
    for (int i = 0; i < queue.length; i++) {
      if (parents[i] == NONE) {
        end = append(i, queue, end, seen);
      }
    }
    for (int begin = 0; begin < end; begin++) {
      int node = queue[begin];
      int parent = parents[node];
      GltfMatrix local = pose.local(node, nodes.get(node));
      placed[node] = parent == NONE ? local : placed[parent].times(local);
      depths[node] = parent == NONE ? 1 : depths[parent] + 1;
      ModelLimits.require(nodes.get(node).location(), "levels", GltfBudget.MAX_DEPTH, depths[node]);
      end = appendChildren(node, queue, end, seen);
    }
    for (int i = 0; i < placed.length; i++) {
      if (placed[i] == null) {
        throw Kind.MALFORMED.at(
            nodes.get(i).location(), "expected a node that is not below itself, found a cycle");
      }
    }
    toWorld.clear();
    toWorld.addAll(Arrays.asList(placed));
  }

  /** Returns the transform of a node to world space. */
  GltfMatrix toWorld(int node) {
    return toWorld.get(node);
  }

  /**
   * Returns where a camera or a light is that a node places. A scale of the node itself has no
   * effect, not even one that mirrors or flattens (glTF 2.0, section 3.10.2; KHR_lights_punctual).
   * What mirrors the nodes around it turns it, too, so that it still faces them.
   *
   * @param pose in which the nodes were {@linkplain #place placed}
   */
  GltfMatrix unscaled(int node, GltfPose pose) {
    GltfMatrix placed = toWorld.get(node);
    if (pose.isPositive(node, nodes.get(node)) && placed.toTransform().isInvertible()) {
      return placed;
    }
    GltfMatrix own = pose.orientation(node, nodes.get(node));
    int parent = parents[node];
    boolean isSolid = parent != NONE && toWorld.get(parent).toTransform().isInvertible();
    GltfMatrix around = isSolid ? toWorld.get(parent) : orientation(parent, pose);
    return placed.withAxesOf(around.times(own));
  }

  /** Returns the orientation of a node by those of all nodes above it, whatever their scales. */
  private GltfMatrix orientation(int node, GltfPose pose) {
    GltfMatrix axes = GltfMatrix.IDENTITY;
    for (int n = node; n != NONE; n = parents[n]) {
      axes = pose.orientation(n, nodes.get(n)).times(axes);
    }
    return axes;
  }

  /** Returns the nodes of the default scene, else of the first one, else all, by their indices. */
  int[] shown() throws ModelFormatException {
    int[] shown = withDescendants(roots());
    Arrays.sort(shown);
    return shown;
  }

  /** Returns nodes and all below them, each once. */
  private int[] withDescendants(int[] ancestors) {
    int[] queue = new int[nodes.size()];
    boolean[] seen = new boolean[nodes.size()];
    int end = 0;
    for (int ancestor : ancestors) {
      end = append(ancestor, queue, end, seen);
    }
    for (int begin = 0; begin < end; begin++) {
      end = appendChildren(queue[begin], queue, end, seen);
    }
    return Arrays.copyOf(queue, end);
  }

  /** Adds a node to a queue unless it was there, and returns the new end of the queue. */
  private static int append(int node, int[] queue, int end, boolean[] seen) {
    if (seen[node]) {
      return end;
    }
    seen[node] = true;
    queue[end] = node;
    return end + 1;
  }

  private int appendChildren(int node, int[] queue, int end, boolean[] seen) {
    int newEnd = end;
    for (int child : nodes.get(node).children()) {
      // A node is shown below its first parent alone.
      newEnd = parents[child] == node ? append(child, queue, newEnd, seen) : newEnd;
    }
    return newEnd;
  }

  /**
   * Returns the nodes that the scene lists. Some exporters list all nodes, also those that are
   * shown below others; only a child without its parent is worth a warning.
   */
  private int[] roots() throws ModelFormatException {
    List<GltfJson> scenes = document.section("scenes");
    OptionalInt number = document.root().index("scene", scenes.size());
    if (scenes.isEmpty()) {
      return allRoots();
    }
    GltfJson scene = scenes.get(number.orElse(0));
    int[] roots = scene.indices("nodes", nodes.size());
    int[] outermost = Arrays.stream(roots).filter(node -> parents[node] == NONE).toArray();
    BitSet shown = new BitSet();
    for (int node : withDescendants(outermost)) {
      shown.set(node);
    }
    for (int i = 0; i < roots.length; i++) {
      int node = roots[i];
      if (!shown.get(node)) {
        document
            .warnings()
            .add(
                "a node is listed without its parent",
                scene.location("nodes[" + i + "]"),
                "expected a root node, found %d, a child of node %d; it is shown in its place there"
                    .formatted(node, parents[node]));
      }
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
