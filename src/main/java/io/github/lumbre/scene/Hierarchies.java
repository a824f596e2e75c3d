package io.github.lumbre.scene;

import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.KernelChange;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The hierarchies of a scene. Both find the same blockers of a ray to a light at a finite distance.
 *
 * @param all the hierarchy over all shapes
 * @param blockers the hierarchy without the walls that face all lights at finite distances, and
 *     that rays from behind pass through; the same as {@code all} if there are none, or too many
 *     other shapes for a second hierarchy
 */
record Hierarchies(Bvh all, Bvh blockers) {
  /** The largest number of triangles and other shapes in a second hierarchy. */
  private static final int MOST_ITEMS = 1000;

  /**
   * Returns the hierarchies of a scene.
   *
   * @param shapes the scene's shapes, over which {@code all} was built
   * @param lights the scene's lights
   * @param build builds a hierarchy over some of the shapes
   */
  static Hierarchies of(
      Bvh all, List<Shape> shapes, List<Light> lights, Function<List<Shape>, Bvh> build) {
    List<Bounds3> near =
        lights.stream().map(Light::bounds).flatMap(Optional::stream).map(LightBounds::box).toList();
    if (near.isEmpty()) {
      return new Hierarchies(all, all);
    }
    List<Shape> blockers =
        shapes.stream().filter(shape -> !near.stream().allMatch(shape::isBehind)).toList();
    boolean isLean = blockers.size() < shapes.size() && Bvh.items(blockers) <= MOST_ITEMS;
    return new Hierarchies(all, isLean ? build.apply(blockers) : all);
  }

  /** Returns the change of kernel of both hierarchies. */
  KernelChange kernelChange(List<Shape> shapes) {
    return KernelChange.of(blockers == all ? List.of(all) : List.of(all, blockers), shapes);
  }
}
