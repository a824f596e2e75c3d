package io.github.lumbre.scene;

import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.KernelChange;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightBounds;
import io.github.lumbre.math.Bounds3;
import java.util.ArrayList;
import java.util.BitSet;
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

  /** Returns hierarchies that are built when the first ray is traced; see {@link Bvh#later}. */
  static Hierarchies later(List<Shape> shapes, Kernel kernel) {
    Bvh all = Bvh.later(shapes, kernel);
    return new Hierarchies(all, all, KernelChange.of(List.of(), List.of()));
  }

  /**
   * Returns the hierarchies of the poses of a scene in motion. They share one of the shapes that
   * are the same in all poses, if all poses have equally many shapes, and change kernels together.
   */
  static List<Hierarchies> inMotion(List<SceneAssembly> poses) {
    Kernel kernel = poses.get(0).kernel;
    List<List<Shape>> shapes = poses.stream().map(SceneAssembly::shapes).toList();
    BitSet still = still(shapes);
    if (shapes.stream().allMatch(pose -> pose.size() == still.cardinality())) {
      Hierarchies first = over(shapes.get(0), kernel, poses.get(0).allLights());
      return poses.stream()
          .map(pose -> first.of(pose.allLights().equals(poses.get(0).allLights())))
          .toList();
    }
    Bvh shared = Bvh.over(shapes.get(0), kernel, still::get);
    List<Bvh> moving =
        shapes.stream().map(some -> Bvh.over(some, kernel, i -> !still.get(i))).toList();
    List<Bvh> parts = new ArrayList<>(moving);
    parts.add(shared);
    KernelChange change =
        KernelChange.of(parts, shapes.stream().flatMap(List::stream).distinct().toList());
    return moving.stream()
        .map(own -> Bvh.both(shared, own))
        .map(both -> new Hierarchies(both, both, change))
        .toList();
  }

  /** Returns the numbers of the shapes that are the same in all poses. */
  private static BitSet still(List<List<Shape>> poses) {
    List<Shape> first = poses.get(0);
    BitSet still = new BitSet();
    if (poses.stream().allMatch(pose -> pose.size() == first.size())) {
      for (int i = 0; i < first.size(); i++) {
        int shape = i;
        still.set(i, poses.stream().allMatch(pose -> pose.get(shape) == first.get(shape)));
      }
    }
    return still;
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
