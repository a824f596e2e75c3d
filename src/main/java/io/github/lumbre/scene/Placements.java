package io.github.lumbre.scene;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.math.Transform;
import io.github.lumbre.scene.internal.SceneNode;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * The parts of a scene at their places, so that a scene that continues another moves only what it
 * has to. Mutable until the scene is built.
 */
final class Placements {
  static final Placements NONE = new Placements();

  private final Map<SceneNode, Placed> placed = new IdentityHashMap<>();
  private final Map<SceneNode, Placed> earlier;

  /** A shape or content, and the transform of its group that placed it. */
  private record Placed(double[] outer, Object thing) {}

  private Placements() {
    earlier = Map.of();
  }

  /**
   * @param earlier the placements of another scene with some of the same nodes
   */
  Placements(Placements earlier) {
    this.earlier = earlier.placed;
  }

  /**
   * Returns the shape of a surface in world space.
   *
   * @param outer transform of the group
   * @param isOutermost whether the surface is in no group
   */
  Shape shape(SceneNode.Surface node, Transform outer, boolean isOutermost) {
    return isOutermost
        ? node.shape()
        : (Shape) of(node, outer, () -> node.shape().transformed(outer));
  }

  /**
   * Returns content in world space.
   *
   * @param toWorld from the content's space to world space
   */
  SceneContent.Placed content(SceneNode.Part node, Transform toWorld) {
    return (SceneContent.Placed) of(node, toWorld, () -> node.content().placed(toWorld));
  }

  private Object of(SceneNode node, Transform outer, java.util.function.Supplier<Object> maker) {
    double[] values = outer.toArray();
    Placed known = earlier.get(node);
    Placed used =
        known != null && Arrays.equals(known.outer(), values)
            ? known
            : new Placed(values, maker.get());
    placed.put(node, used);
    return used.thing();
  }
}
