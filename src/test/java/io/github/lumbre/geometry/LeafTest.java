package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.geometry.internal.HierarchyLimitException;
import org.junit.jupiter.api.Test;

/** Tests the encoding, the weights and the numbering of leaves. */
class LeafTest {
  @Test
  void referencesKeepWhatTheyAreMadeOf() {
    for (int first : new int[] {0, 1, 15, 16, 1 << 20, BvhBuilder.MAX_ITEMS}) {
      for (int count = 1; count <= 15; count++) {
        for (boolean ofShapes : new boolean[] {true, false}) {
          int leaf = LeafRef.of(ofShapes, first, count);
          assertThat(leaf).isNegative();
          assertThat(LeafRef.isOfShapes(leaf)).isEqualTo(ofShapes);
          assertThat(LeafRef.first(leaf)).isEqualTo(first);
          assertThat(LeafRef.count(leaf)).isEqualTo(count);
        }
      }
    }
  }

  /**
   * Triangles are tested in blocks, and the last block may be partial; shapes are tested singly.
   */
  @Test
  void blocksOfTrianglesAndShapesAreUnits() {
    for (int block : new int[] {1, 2, 4, 8}) {
      LeafCost costs = new LeafCost(block, 4, 1, false);
      for (int triangles = 0; triangles <= 20; triangles++) {
        for (int shapes = 0; shapes <= 5; shapes++) {
          int weight = triangles * costs.weight(true) + shapes * costs.weight(false);
          int blocks = (int) Math.ceil((double) triangles / block);
          assertThat(costs.units(weight)).isEqualTo(blocks + shapes);
        }
      }
    }
  }

  /** Parts of ranges of more than 64 units cost their root in wide trees. */
  @Test
  void partsOfLargeRangesCostLessInWideTrees() {
    int block = WideTree.WIDTH;
    assertThat(WideTree.COSTS.partCost(25 * block, 64 * block)).isEqualTo(25);
    assertThat(WideTree.COSTS.partCost(25 * block, 64 * block + 1)).isEqualTo(5);
    assertThat(WideTree.COSTS.partCost(24 * block + 1, 1000 * block)).isEqualTo(5);
    assertThat(BinaryTraversal.COSTS.partCost(25, 1000)).isEqualTo(25);
  }

  @Test
  void itemsOfEachKindAreNumberedAsTheirLeavesAreMet() {
    LeafOrder leaves = new LeafOrder(new int[] {5, 2, 0, 4, 3, 1}, 3);
    int shape = leaves.add(0, 1);
    int triangles = leaves.add(1, 3);
    int shapes = leaves.add(3, 5);
    int triangle = leaves.add(5, 6);
    assertThat(leaves.shapes()).containsExactly(5, 4, 3);
    assertThat(leaves.triangles()).containsExactly(2, 0, 1);
    assertThat(shape).isEqualTo(LeafRef.of(true, 0, 1));
    assertThat(shapes).isEqualTo(LeafRef.of(true, 1, 2));
    assertThat(triangles).isEqualTo(LeafRef.of(false, 0, 2));
    assertThat(triangle).isEqualTo(LeafRef.of(false, 2, 1));
  }

  /** A leaf takes the fullest block that has room for it. */
  @Test
  void noLeafIsInTwoBlocks() {
    LeafOrder leaves = new LeafOrder(new int[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0}, 11, 4, 8);
    assertThat(leaves.add(0, 3)).isEqualTo(LeafRef.of(false, 0, 3));
    assertThat(leaves.add(3, 5)).isEqualTo(LeafRef.of(false, 4, 2));
    assertThat(leaves.add(5, 8)).isEqualTo(LeafRef.of(false, 8, 3));
    assertThat(leaves.add(8, 9)).isEqualTo(LeafRef.of(false, 11, 1));
    assertThat(leaves.add(9, 11)).isEqualTo(LeafRef.of(false, 6, 2));
    assertThat(leaves.triangles()).containsExactly(1, 2, 3, 0, 4, 5, 10, 0, 6, 7, 8, 9);
  }

  @Test
  void triangleWithoutPlaceIsRefused() {
    LeafOrder leaves = new LeafOrder(new int[] {1, 2, 3, 4, 5, 6, 7, 8, 0}, 9, 4, 4);
    leaves.add(0, 4);
    leaves.add(4, 8);
    assertThatThrownBy(() -> leaves.add(8, 9))
        .isInstanceOf(HierarchyLimitException.class)
        .hasMessage(
            "the vector kernel has no place for so many triangles; expected at most about"
                + " 63 million, or the scalar kernel");
  }
}
