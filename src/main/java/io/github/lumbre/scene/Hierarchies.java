package io.github.lumbre.scene;

import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.KernelChange;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Function;

/**
 * The hierarchies of a scene. Both find the same blockers of a ray to a light at a finite distance.
 *
 * @param all the hierarchy over all shapes
 * @param blockers the hierarchy without the walls that face all lights at finite distances, and
 *     that rays from behind pass through; the same as {@code all} if there are none, or too many
 *     other shapes for a second hierarchy
 * @param change the change of kernel of both
 */
record Hierarchies(Bvh all, Bvh blockers, KernelChange change) {
  /** The largest number of triangles and other shapes in a second hierarchy. */
  private static final int MOST_ITEMS = 1000;

  /** Returns the hierarchies of a scene's shapes and lights for a traversal kernel. */
  static Hierarchies over(List<Shape> shapes, Kernel kernel, List<Light> lights) {
    Bvh all = Bvh.over(shapes, kernel);
    return of(all, shapes, lights, all::part);
  }

  /** Returns hierarchies that count visited nodes; see {@link Bvh#counting}. */
  static Hierarchies counting(List<Shape> shapes, LongAdder visits, List<Light> lights) {
    return of(Bvh.counting(shapes, visits), shapes, lights, some -> Bvh.counting(some, visits));
  }

  /**
   * Returns hierarchies.
   *
   * @param shapes the scene's shapes, over which {@code all} was built
   * @param lights the scene's lights
   * @param build builds a hierarchy over some of the shapes
   */
  static Hierarchies of(
      Bvh all, List<Shape> shapes, List<Light> lights, Function<List<Shape>, Bvh> build) {
    List<Bounds3> near =
        lights.stream().map(Light::bounds).flatMap(Optional::stream).map(LightBounds::box).toList();
    List<Shape> some =
        shapes.stream().filter(shape -> !near.stream().allMatch(shape::isBehind)).toList();
    boolean isLean =
        !near.isEmpty() && some.size() < shapes.size() && Bvh.items(some) <= MOST_ITEMS;
    Bvh blockers = isLean ? build.apply(some) : all;
    List<Bvh> both = isLean ? List.of(all, blockers) : List.of(all);
    return new Hierarchies(all, blockers, KernelChange.of(both, shapes));
  }

  /**
   * Returns the hierarchies of another scene with the same shapes. Both scenes change kernels
   * together, so that there is no second hierarchy for other lights.
   */
  Hierarchies of(boolean isOfSameLights) {
    return isOfSameLights ? this : new Hierarchies(all, all, change);
  }
}
