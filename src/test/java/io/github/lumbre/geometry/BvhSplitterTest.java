package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests splits against the definition of the surface area heuristic. */
class BvhSplitterTest {
  /** Items before and after the split range, which a split must not change. */
  private static final int BEFORE = 2;

  private static final int AFTER = 3;

  private static final List<LeafCost> COSTS =
      List.of(
          BinaryTraversal.COSTS,
          WideTree.COSTS,
          new LeafCost(1, 16, 3, false),
          new LeafCost(4, 2, .5, true));

  private static final int SIZE = BuildItems.SIZE;

  /**
   * Returns boxes of random sizes whose centers are different multiples of four, in random order.
   */
  private static int[] boxes(Random random, int range) {
    int[] boxes = new int[6 * (BEFORE + range + AFTER)];
    for (int axis = 0; axis < 3; axis++) {
      List<Integer> places = new ArrayList<>(IntStream.range(0, range).boxed().toList());
      Collections.shuffle(places, random);
      int stretch = 4 * (1 + random.nextInt(4));
      for (int i = 0; i < boxes.length / 6; i++) {
        boolean isInside = i >= BEFORE && i < BEFORE + range;
        int center = isInside ? stretch * places.get(i - BEFORE) + 16 : 4000;
        int half = random.nextInt(8);
        boxes[6 * i + 2 * axis] = center - half;
        boxes[6 * i + 2 * axis + 1] = center + half;
      }
    }
    return boxes;
  }

  /** A splitter of a copy of some boxes. */
  private static final class Subject {
    final int[] boxes;
    final int[] array;
    final int triangles;
    final LeafCost costs;
    final BvhSplitter splitter;

    Subject(int[] boxes, int triangles, LeafCost costs) {
      this.boxes = boxes;
      this.triangles = triangles;
      this.costs = costs;
      array = new int[SIZE * (boxes.length / 6)];
      for (int i = 0; i < boxes.length / 6; i++) {
        System.arraycopy(boxes, 6 * i, array, SIZE * i, 6);
        array[SIZE * i + BuildItems.NUMBER] = i;
        array[SIZE * i + BuildItems.WEIGHT] = costs.weight(i < triangles);
      }
      splitter = new BvhSplitter(array, costs);
    }

    int[] around(List<Integer> items) {
      int[] box = {9999, -9999, 9999, -9999, 9999, -9999};
      for (int item : items) {
        for (int k = 0; k < 6; k += 2) {
          box[k] = Math.min(box[k], boxes[6 * item + k]);
          box[k + 1] = Math.max(box[k + 1], boxes[6 * item + k + 1]);
        }
      }
      return box;
    }

    int units(List<Integer> items) {
      return costs.units(items.stream().mapToInt(i -> costs.weight(i < triangles)).sum());
    }

    /** The expected cost of a leaf, up to the probability that a ray meets the whole. */
    double cost(List<Integer> items) {
      int[] box = around(items);
      double x = box[1] - box[0];
      double y = box[3] - box[2];
      double z = box[5] - box[4];
      return units(items) * (x * y + y * z + z * x);
    }

    int number(int place) {
      return array[SIZE * place + BuildItems.NUMBER];
    }

    List<Integer> range(int first, int end) {
      return IntStream.range(first, end).map(this::number).boxed().toList();
    }

    /** Checks that each box has moved with its item, and that other ranges are as they were. */
    void assertReorderedWithin(int first, int end) {
      for (int i = 0; i < boxes.length / 6; i++) {
        int[] expected = Arrays.copyOfRange(boxes, 6 * number(i), 6 * number(i) + 6);
        assertThat(Arrays.copyOfRange(array, SIZE * i, SIZE * i + 6)).isEqualTo(expected);
        assertThat(array[SIZE * i + BuildItems.WEIGHT])
            .isEqualTo(costs.weight(number(i) < triangles));
        if (i < first || i >= end) {
          assertThat(number(i)).isEqualTo(i);
        }
      }
      assertThat(range(first, end))
          .containsExactlyInAnyOrderElementsOf(IntStream.range(first, end).boxed().toList());
    }
  }

  /** With each center in a bin of its own, the split is the best of all along all axes. */
  @Test
  void splitsHaveTheLeastExpectedCost() {
    Random random = new Random(1);
    int leaves = 0;
    for (int round = 0; round < 400; round++) {
      int range = 2 + random.nextInt(15);
      int end = BEFORE + range;
      LeafCost costs = COSTS.get(round % COSTS.size());
      Subject subject = new Subject(boxes(random, range), random.nextInt(end + 1), costs);
      List<Integer> all = subject.range(BEFORE, end);
      double best = Double.POSITIVE_INFINITY;
      for (int axis = 0; axis < 3; axis++) {
        int at = 2 * axis;
        List<Integer> sorted = new ArrayList<>(all);
        sorted.sort(
            Comparator.comparingDouble(
                i -> subject.boxes[6 * i + at] + subject.boxes[6 * i + at + 1]));
        for (int k = 1; k < range; k++) {
          best =
              Math.min(
                  best,
                  subject.cost(sorted.subList(0, k)) + subject.cost(sorted.subList(k, range)));
        }
      }
      subject.splitter.measure(BEFORE, end);
      int[] box = subject.around(all);
      assertThat(subject.splitter.extent())
          .isEqualTo(Math.max(box[1] - box[0], Math.max(box[3] - box[2], box[5] - box[4])));
      boolean mayBeLeaf = subject.units(all) <= costs.maxUnits();
      assertThat(subject.splitter.fitsLeaf()).isEqualTo(mayBeLeaf);
      int middle = subject.splitter.split(BEFORE, end);
      subject.assertReorderedWithin(BEFORE, end);
      double nodeCost = costs.nodeCost() * subject.cost(all) / subject.units(all);
      if (middle == BEFORE) {
        leaves++;
        assertThat(mayBeLeaf).isTrue();
        assertThat(subject.cost(all)).isLessThanOrEqualTo(best + nodeCost + 1e-9);
      } else {
        double found =
            subject.cost(subject.range(BEFORE, middle)) + subject.cost(subject.range(middle, end));
        assertThat(found).isCloseTo(best, within(1e-9));
        if (mayBeLeaf) {
          assertThat(found + nodeCost).isLessThan(subject.cost(all) + 1e-9);
        }
      }
    }
    assertThat(leaves).isBetween(20, 380);
  }

  /** Boxes around one center cannot be separated by it. */
  @Test
  void concentricBoxesAreNotSplit() {
    int[] boxes = new int[6 * 20];
    for (int k = 0; k < boxes.length; k++) {
      boxes[k] = 50 + (k % 2 == 0 ? -1 : 1) * (1 + k / 6);
    }
    Subject subject = new Subject(boxes, 0, BinaryTraversal.COSTS);
    subject.splitter.measure(0, 20);
    assertThat(subject.splitter.fitsLeaf()).isFalse();
    assertThat(subject.splitter.split(0, 20)).isZero();
    subject.assertReorderedWithin(0, 20);
  }

  /** Items that differ along one axis alone are split along it. */
  @Test
  void rowsOfBoxesAreSplitInTheMiddle() {
    for (int axis = 0; axis < 3; axis++) {
      int[] boxes = new int[6 * 64];
      for (int k = 0; k < boxes.length; k++) {
        boxes[k] = k % 2 + (k % 6 / 2 == axis ? 7 * (k / 6) : 0);
      }
      Subject subject = new Subject(boxes, 0, BinaryTraversal.COSTS);
      subject.splitter.measure(0, 64);
      assertThat(subject.splitter.split(0, 64)).isEqualTo(32);
      subject.assertReorderedWithin(0, 64);
      assertThat(subject.range(0, 32)).allMatch(item -> item < 32);
    }
  }
}
