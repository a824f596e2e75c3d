package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the choice of nodes with up to eight children. */
class WideCollapseTest {
  private static final int TREES = 300;
  private static final int MAX_LEAVES = 60;

  /** Returns a tree of random shape over leaves with random boxes. */
  private static BvhTree tree(int count, SplittableRandom random) {
    List<Shape> boxes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vec3 center = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
      boxes.add(Box.of(center, new Vec3(side(random), side(random), side(random))));
    }
    int[] children = new int[2 * count];
    int root = divide(0, count, children, random);
    return new BvhTree(new BvhItems(boxes), IntStream.range(0, count).toArray(), children, root);
  }

  private static double side(SplittableRandom random) {
    return random.nextDouble(1e-3, .3);
  }

  private static int divide(int first, int end, int[] children, SplittableRandom random) {
    if (end - first == 1) {
      return BvhTree.LEAF;
    }
    int middle = random.nextInt(first + 1, end);
    children[2 * middle] = divide(first, middle, children, random);
    children[2 * middle + 1] = divide(middle, end, children, random);
    return middle;
  }

  /** Collects the leaves in order; returns the total surface area of the kept nodes. */
  private static double walk(
      WideCollapse collapse, WideCollapse.Kept node, List<WideCollapse.Kept> leaves) {
    double surface = ItemBox.halfArea(node.box());
    WideCollapse.Kept[] children = collapse.children(node);
    assertThat(children).hasSizeBetween(1, WideTree.WIDTH);
    for (WideCollapse.Kept child : children) {
      if (child.isLeaf()) {
        leaves.add(child);
      } else {
        surface += walk(collapse, child, leaves);
      }
    }
    return surface;
  }

  private static double walk(BvhTree tree, List<WideCollapse.Kept> leaves) {
    WideCollapse collapse = new WideCollapse(tree);
    return walk(collapse, collapse.root(), leaves);
  }

  /** Returns the total surface area of the nodes that a random choice keeps. */
  private static double atRandom(TreeNode node, SplittableRandom random) {
    List<TreeNode> lanes = new ArrayList<>(List.of(node));
    int wanted = random.nextInt(2, WideTree.WIDTH + 1);
    do {
      int lane = random.nextInt(lanes.size());
      if (lanes.get(lane) instanceof TreeNode.Inner inner) {
        lanes.set(lane, inner.left());
        lanes.add(inner.right());
      }
    } while (lanes.size() < wanted && lanes.stream().anyMatch(TreeNode.Inner.class::isInstance));
    return ItemBox.halfArea(node.box())
        + lanes.stream()
            .filter(TreeNode.Inner.class::isInstance)
            .mapToDouble(lane -> atRandom(lane, random))
            .sum();
  }

  /**
   * Returns the total surface area of the nodes kept when the largest node is always opened first.
   */
  private static double byOpeningTheLargest(TreeNode node) {
    List<TreeNode> lanes = new ArrayList<>(List.of(node));
    while (lanes.size() < WideTree.WIDTH) {
      TreeNode.Inner largest = null;
      for (TreeNode lane : lanes) {
        if (lane instanceof TreeNode.Inner inner
            && (largest == null
                || ItemBox.halfArea(inner.box()) > ItemBox.halfArea(largest.box()))) {
          largest = inner;
        }
      }
      if (largest == null) {
        break;
      }
      lanes.set(lanes.indexOf(largest), largest.left());
      lanes.add(largest.right());
    }
    return ItemBox.halfArea(node.box())
        + lanes.stream()
            .filter(TreeNode.Inner.class::isInstance)
            .mapToDouble(WideCollapseTest::byOpeningTheLargest)
            .sum();
  }

  @Test
  void halfAreasAreThoseOfBoxes() {
    assertThat(ItemBox.halfArea(new double[] {0, 2, 1, 4, -5, 0})).isEqualTo(2 * 3 + 3 * 5 + 5 * 2);
    assertThat(ItemBox.halfArea(new double[] {1, 1, 0, 2, 0, 3})).isEqualTo(6);
    assertThat(ItemBox.halfArea(ItemBox.empty())).isZero();
  }

  @Test
  void everyLeafIsKeptOnceInItsOrder() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < TREES; i++) {
      int count = random.nextInt(1, MAX_LEAVES);
      BvhTree tree = tree(count, random);
      List<WideCollapse.Kept> leaves = new ArrayList<>();
      walk(tree, leaves);
      assertThat(leaves).hasSize(count);
      for (int leaf = 0; leaf < count; leaf++) {
        assertThat(leaves.get(leaf).first()).isEqualTo(leaf);
        double[] box = new double[6];
        tree.copyBox(leaf, leaf + 1, box);
        assertThat(leaves.get(leaf).box()).isEqualTo(box);
      }
    }
  }

  @Test
  void noOtherChoiceHasLessSurface() {
    SplittableRandom random = new SplittableRandom(2);
    double all = 0;
    double allByLargest = 0;
    for (int i = 0; i < TREES; i++) {
      BvhTree collapsed = tree(random.nextInt(2, MAX_LEAVES), random);
      double least = walk(collapsed, new ArrayList<>());
      TreeNode tree = TreeNode.of(collapsed);
      double byLargest = byOpeningTheLargest(tree);
      assertThat(least).isLessThanOrEqualTo(byLargest * (1 + 1e-12));
      for (int k = 0; k < 20; k++) {
        assertThat(least).isLessThanOrEqualTo(atRandom(tree, random) * (1 + 1e-12));
      }
      all += least;
      allByLargest += byLargest;
    }
    assertThat(all).isLessThan(.95 * allByLargest);
  }
}
