package io.github.lumbre.light.internal;

import io.github.lumbre.light.LightBounds;
import java.util.Arrays;

/**
 * The nodes of a {@link LightTree}, made from a binary tree by replacing nodes by their children
 * until a node has {@link #WIDTH} of them. The children of a node have consecutive numbers.
 * Immutable; its arrays are shared and never change.
 */
final class LightTreeLayout {
  /** The largest number of children. */
  static final int WIDTH = LightChoice.WEIGHTS;

  private final LightTreeBuilder.Node[] binary;

  /** The number of each node's first child; one entry more marks the end. */
  private int[] firstChildren;

  /** The node of each child; for a leaf, ~emitter. */
  private final int[] children;

  /** The node that each child belongs to. */
  private final int[] nodes;

  /** The child that each node is; -1 for the root. */
  private int[] parents;

  /** The number of emitters in each child. */
  private final int[] sizes;

  private final LightBounds[] bounds;

  /** The child that each emitter of the scene is, if it is in the tree. */
  private final int[] leaves;

  private LightTreeLayout(LightTreeBuilder.Node[] binary, int emitters) {
    this.binary = binary;
    // All nodes of the binary tree but the root may be children; the root is one if it is a leaf.
    int most = Math.max(1, binary.length - 1);
    firstChildren = new int[most + 1];
    children = new int[most];
    nodes = new int[most];
    parents = new int[most];
    sizes = new int[most];
    bounds = new LightBounds[most];
    leaves = new int[emitters];
  }

  /**
   * Returns the layout of a binary tree.
   *
   * @param emitters number of emitters of the scene
   */
  static LightTreeLayout of(LightTreeBuilder.Node[] binary, int emitters) {
    LightTreeLayout layout = new LightTreeLayout(binary, emitters);
    layout.fill();
    return layout;
  }

  /** Stores the nodes breadth first. */
  private void fill() {
    int[] origins = new int[parents.length];
    int[] group = new int[WIDTH];
    int end = 0;
    int nodeCount = 1;
    parents[0] = -1;
    for (int node = 0; node < nodeCount; node++) {
      int size = group(origins[node], group);
      for (int i = 0; i < size; i++) {
        LightTreeBuilder.Node child = binary[group[i]];
        nodes[end] = node;
        sizes[end] = child.size();
        bounds[end] = child.bounds();
        if (child.child() < 0) {
          children[end] = child.child();
          leaves[~child.child()] = end;
        } else {
          origins[nodeCount] = group[i];
          parents[nodeCount] = end;
          children[end] = nodeCount++;
        }
        end++;
      }
      firstChildren[node + 1] = end;
    }
    firstChildren = Arrays.copyOf(firstChildren, nodeCount + 1);
    parents = Arrays.copyOf(parents, nodeCount);
  }

  /**
   * Replaces a node of the binary tree by its children, and again the largest of them, until there
   * are {@link #WIDTH} or only leaves. Returns their number.
   *
   * @param group receives the nodes
   */
  private int group(int node, int[] group) {
    group[0] = node;
    int size = 1;
    while (size < WIDTH) {
      int largest = 0;
      for (int i = 1; i < size; i++) {
        largest = binary[group[i]].size() > binary[group[largest]].size() ? i : largest;
      }
      int left = binary[group[largest]].child();
      if (left < 0) {
        return size;
      }
      System.arraycopy(group, largest + 1, group, largest + 2, size - largest - 1);
      group[largest] = left;
      group[largest + 1] = left + 1;
      size++;
    }
    return size;
  }

  /** Returns the number of each node's first child, and the number of children. */
  int[] firstChildren() {
    return firstChildren;
  }

  /** Returns the node of each child; for a leaf, ~emitter. */
  int[] children() {
    return children;
  }

  /** Returns the number of emitters in each child. */
  int[] sizes() {
    return sizes;
  }

  /** Returns the bounds of all children. */
  LightBounds[] bounds() {
    return Arrays.copyOf(bounds, firstChildren[firstChildren.length - 1]);
  }

  /** Returns the child that an emitter of the tree is. */
  int leaf(int emitter) {
    return leaves[emitter];
  }

  /** Returns the node that a child belongs to. */
  int node(int child) {
    return nodes[child];
  }

  /** Returns the child that a node is; -1 for the root. */
  int parent(int node) {
    return parents[node];
  }
}
