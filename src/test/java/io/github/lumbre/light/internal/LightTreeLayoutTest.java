package io.github.lumbre.light.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the nodes of light trees. */
class LightTreeLayoutTest {
  private static LightTreeLayout layout(int count) {
    SplittableRandom random = new SplittableRandom(count);
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vec3 place = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
      LightBounds bounds = LightBounds.allAround(Bounds3.of(place), 1 + random.nextInt(3));
      items.add(new LightTreeBuilder.Item(2 * i, bounds));
    }
    return LightTreeLayout.of(LightTreeBuilder.build(items), 2 * count);
  }

  private static IntStream childrenOf(LightTreeLayout layout, int node) {
    return IntStream.range(layout.firstChildren()[node], layout.firstChildren()[node + 1]);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 8, 9, 100, 1000})
  void everyEmitterIsALeafThatLeadsToTheRoot(int count) {
    LightTreeLayout layout = layout(count);
    for (int i = 0; i < count; i++) {
      int child = layout.leaf(2 * i);
      assertThat(layout.children()[child]).isEqualTo(~(2 * i));
      assertThat(layout.sizes()[child]).isEqualTo(1);
      int node = layout.node(child);
      while (layout.parent(node) >= 0) {
        assertThat(childrenOf(layout, node)).contains(child);
        child = layout.parent(node);
        assertThat(layout.children()[child]).isEqualTo(node);
        node = layout.node(child);
      }
      assertThat(node).isZero();
    }
    long leaves =
        IntStream.of(layout.children()).limit(layout.bounds().length).filter(c -> c < 0).count();
    assertThat(leaves).isEqualTo(count);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 8, 9, 100, 1000})
  void nodesHoldTheirChildren(int count) {
    LightTreeLayout layout = layout(count);
    LightBounds[] bounds = layout.bounds();
    for (int node = 0; node < layout.firstChildren().length - 1; node++) {
      assertThat(childrenOf(layout, node).count()).isBetween(1L, (long) LightTreeLayout.WIDTH);
      int size = childrenOf(layout, node).map(child -> layout.sizes()[child]).sum();
      int parent = layout.parent(node);
      assertThat(size).isEqualTo(parent < 0 ? count : layout.sizes()[parent]);
      if (parent >= 0) {
        Bounds3 box = bounds[parent].box();
        assertThat(childrenOf(layout, node))
            .allSatisfy(child -> assertThat(box.union(bounds[child].box())).isEqualTo(box));
      }
    }
  }
}
