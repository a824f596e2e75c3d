package io.github.lumbre.light.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the construction of light trees. */
class LightTreeBuilderTest {
  private static LightTreeBuilder.Item item(int emitter, Vec3 position, double size) {
    Vec3 half = new Vec3(size, size, size);
    Bounds3 box = Bounds3.of(position.minus(half), position.plus(half));
    return new LightTreeBuilder.Item(emitter, LightBounds.allAround(box, 1));
  }

  private static Vec3 along(int axis, double distance) {
    return (axis == 0 ? Vec3.X : axis == 1 ? Vec3.Y : Vec3.Z).times(distance);
  }

  /** Returns the emitters below a node, in ascending order. */
  private static List<Integer> emitters(LightTreeBuilder.Node[] nodes, int node) {
    List<Integer> found = new ArrayList<>();
    collect(nodes, node, found);
    Collections.sort(found);
    return found;
  }

  private static void collect(LightTreeBuilder.Node[] nodes, int node, List<Integer> found) {
    int child = nodes[node].child();
    if (child < 0) {
      found.add(~child);
    } else {
      collect(nodes, child, found);
      collect(nodes, child + 1, found);
    }
  }

  private static int depth(LightTreeBuilder.Node[] nodes, int node) {
    int child = nodes[node].child();
    return child < 0 ? 0 : 1 + Math.max(depth(nodes, child), depth(nodes, child + 1));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void groupsFarApartAreDividedFirst(int axis) {
    SplittableRandom random = new SplittableRandom(83);
    for (int few = 1; few < 10; few++) {
      List<LightTreeBuilder.Item> items = new ArrayList<>();
      for (int i = 0; i < 10; i++) {
        // Multiples of 7 modulo 10, so that neighbors in the list are often from both groups.
        boolean isFar = i * 7 % 10 < few;
        Vec3 near =
            new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        items.add(item(i, near.plus(along(axis, isFar ? -100 : 100)), .1));
      }
      LightTreeBuilder.Node[] nodes = LightTreeBuilder.build(items);
      int limit = few;
      assertThat(emitters(nodes, nodes[0].child()))
          .containsExactlyElementsOf(
              IntStream.range(0, 10).filter(i -> i * 7 % 10 < limit).boxed().toList());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 9, 64, 100})
  void lightsInOnePlaceAreDividedInHalves(int count) {
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      items.add(item(i, Vec3.X, 0));
    }
    LightTreeBuilder.Node[] nodes = LightTreeBuilder.build(items);
    for (LightTreeBuilder.Node node : nodes) {
      if (node.child() >= 0) {
        assertThat(nodes[node.child()].size()).isEqualTo(node.size() / 2);
      }
    }
  }

  /** The cheapest splits would remove the farthest light, one by one. */
  @ParameterizedTest
  @ValueSource(doubles = {-1, 1})
  void noPathIsLong(double side) {
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < 120; i++) {
      items.add(item(i, along(0, side * Math.pow(16, i)), 0));
    }
    LightTreeBuilder.Node[] nodes = LightTreeBuilder.build(items);
    assertThat(depth(nodes, 0)).isBetween(20, 60);
    assertThat(emitters(nodes, 0)).hasSize(120);
  }

  @Test
  void lightsTooFarApartForACostAreDividedInHalves() {
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < 16; i++) {
      items.add(item(i, along(1, (i % 2 == 0 ? 1e200 : -1e200) * (i + 1)), 0));
    }
    LightTreeBuilder.Node[] nodes = LightTreeBuilder.build(items);
    assertThat(emitters(nodes, 0)).hasSize(16);
    assertThat(nodes[nodes[0].child()].size()).isEqualTo(8);
  }

  @Test
  void orderOfTheListDoesNotMatter() {
    SplittableRandom random = new SplittableRandom(84);
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Vec3 place = new Vec3(random.nextInt(3), random.nextInt(3), random.nextInt(3));
      items.add(item(i, place, .1 * random.nextInt(3)));
    }
    List<LightTreeBuilder.Item> shuffled = new ArrayList<>(items);
    Collections.shuffle(shuffled, new Random(85));
    assertThat(LightTreeBuilder.build(shuffled)).isEqualTo(LightTreeBuilder.build(items));
  }

  @Test
  void nodesHoldTheirChildren() {
    SplittableRandom random = new SplittableRandom(86);
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      items.add(item(i, new Vec3(random.nextDouble(), random.nextDouble(), i), .1));
    }
    LightTreeBuilder.Node[] nodes = LightTreeBuilder.build(items);
    for (int node = 0; node < nodes.length; node++) {
      assertThat(nodes[node].size()).isEqualTo(emitters(nodes, node).size());
      if (node > 0) {
        LightTreeBuilder.Node parent = nodes[nodes[node].parent()];
        assertThat(node - parent.child()).isBetween(0, 1);
        assertThat(parent.bounds().box().union(nodes[node].bounds().box()))
            .isEqualTo(parent.bounds().box());
      }
    }
  }
}
