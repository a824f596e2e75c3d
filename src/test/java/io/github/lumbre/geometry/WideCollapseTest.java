package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the choice of nodes with up to eight children. */
class WideCollapseTest {
  private static final int TREES = 300;
  private static final int MAX_LEAVES = 60;

  /** Returns a tree of random shape over leaves with random boxes. */
  private static BvhNode tree(int first, int end, SplittableRandom random) {
    if (end - first == 1) {
      double[] box = new double[6];
      for (int axis = 0; axis < 6; axis += 2) {
        box[axis] = random.nextDouble();
        box[axis + 1] = box[axis] + random.nextDouble(.3);
      }
      return new BvhNode.Leaf(box, first, end);
    }
    int middle = random.nextInt(first + 1, end);
    BvhNode left = tree(first, middle, random);
    BvhNode right = tree(middle, end, random);
    double[] box = new double[6];
    for (int axis = 0; axis < 6; axis += 2) {
      box[axis] = Math.min(left.box()[axis], right.box()[axis]);
      box[axis + 1] = Math.max(left.box()[axis + 1], right.box()[axis + 1]);
    }
    return new BvhNode.Inner(box, left, right);
  }

  /** Collects the leaves in order; returns the total surface area of the kept nodes. */
  private static double walk(WideCollapse collapse, WideCollapse.Kept node, List<BvhNode> leaves) {
    double surface = BvhNode.halfArea(node.node().box());
    WideCollapse.Kept[] children = collapse.children(node);
    assertThat(children).hasSizeBetween(1, WideTree.WIDTH);
    for (WideCollapse.Kept child : children) {
      if (child.node() instanceof BvhNode.Leaf) {
        leaves.add(child.node());
      } else {
        surface += walk(collapse, child, leaves);
      }
    }
    return surface;
  }

  /** Returns the total surface area of the nodes that a random choice keeps. */
  private static double atRandom(BvhNode node, SplittableRandom random) {
    List<BvhNode> lanes = new ArrayList<>(List.of(node));
    int wanted = random.nextInt(2, WideTree.WIDTH + 1);
    do {
      int lane = random.nextInt(lanes.size());
      if (lanes.get(lane) instanceof BvhNode.Inner inner) {
        lanes.set(lane, inner.left());
        lanes.add(inner.right());
      }
    } while (lanes.size() < wanted && lanes.stream().anyMatch(BvhNode.Inner.class::isInstance));
    return BvhNode.halfArea(node.box())
        + lanes.stream()
            .filter(BvhNode.Inner.class::isInstance)
            .mapToDouble(lane -> atRandom(lane, random))
            .sum();
  }

  /**
   * Returns the total surface area of the nodes kept when the largest node is always opened first.
   */
  private static double byOpeningTheLargest(BvhNode node) {
    List<BvhNode> lanes = new ArrayList<>(List.of(node));
    while (lanes.size() < WideTree.WIDTH) {
      BvhNode.Inner largest = null;
      for (BvhNode lane : lanes) {
        if (lane instanceof BvhNode.Inner inner
            && (largest == null
                || BvhNode.halfArea(inner.box()) > BvhNode.halfArea(largest.box()))) {
          largest = inner;
        }
      }
      if (largest == null) {
        break;
      }
      lanes.set(lanes.indexOf(largest), largest.left());
      lanes.add(largest.right());
    }
    return BvhNode.halfArea(node.box())
        + lanes.stream()
            .filter(BvhNode.Inner.class::isInstance)
            .mapToDouble(WideCollapseTest::byOpeningTheLargest)
            .sum();
  }

  @Test
  void halfAreasAreThoseOfBoxes() {
    assertThat(BvhNode.halfArea(new double[] {0, 2, 1, 4, -5, 0})).isEqualTo(2 * 3 + 3 * 5 + 5 * 2);
    assertThat(BvhNode.halfArea(new double[] {1, 1, 0, 2, 0, 3})).isEqualTo(6);
    assertThat(BvhNode.halfArea(BvhNode.EMPTY)).isZero();
  }

  @Test
  void everyLeafIsKeptOnceInItsOrder() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < TREES; i++) {
      int count = random.nextInt(1, MAX_LEAVES);
      BvhNode tree = tree(0, count, random);
      List<BvhNode> leaves = new ArrayList<>();
      walk(new WideCollapse(tree), WideCollapse.root(tree), leaves);
      assertThat(leaves).hasSize(count);
      for (int leaf = 0; leaf < count; leaf++) {
        assertThat(((BvhNode.Leaf) leaves.get(leaf)).first()).isEqualTo(leaf);
      }
    }
  }

  @Test
  void noOtherChoiceHasLessSurface() {
    SplittableRandom random = new SplittableRandom(2);
    double all = 0;
    double allByLargest = 0;
    for (int i = 0; i < TREES; i++) {
      BvhNode tree = tree(0, random.nextInt(2, MAX_LEAVES), random);
      double least = walk(new WideCollapse(tree), WideCollapse.root(tree), new ArrayList<>());
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
