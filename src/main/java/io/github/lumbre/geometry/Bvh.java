package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.HierarchyLimitException;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * A bounding volume hierarchy over shapes in world space. All threads share it; a {@link
 * KernelChange} may replace its traversal by one that finds the same hits.
 *
 * <p>The triangles of each {@link Mesh} are items of the hierarchy. Every other bounded shape is
 * one item; unbounded shapes are tested for every ray. Of hits at the same t, the lower shape
 * number wins, then the lower element number, so results do not depend on the traversal order.
 *
 * <p>No hit is lost to rounding. Each box is wider than its contents by {@link BvhItems#MARGIN}
 * times their largest coordinate. Every traversal widens the boxes by the same fraction of its
 * ray's origin. This exceeds the error of any item's intersection test.
 */
public final class Bvh {
  private static final LeafShapes NO_SHAPES = new LeafShapes(new Shape[0], new int[0]);

  /** Not volatile: a thread may use the former traversal for a while. */
  private Traversal bounded;

  private final LeafShapes unbounded;

  /** The shapes, if a change to the vector kernel is possible. */
  private final List<Shape> changeable;

  private Bvh(Traversal bounded, LeafShapes unbounded, List<Shape> changeable) {
    this.bounded = bounded;
    this.unbounded = unbounded;
    this.changeable = changeable;
  }

  /**
   * Builds the hierarchy over shapes for the kernel {@link Kernel#AUTO}. A shape's number is its
   * index in the list.
   *
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted while a
   *     large hierarchy is built
   */
  public static Bvh over(List<? extends Shape> shapes) {
    return over(shapes, Kernel.AUTO);
  }

  /**
   * Builds the hierarchy over shapes. A shape's number is its index in the list.
   *
   * @throws IllegalStateException if the kernel is not available
   * @throws HierarchyLimitException if there are too many items for it
   * @throws java.util.concurrent.CancellationException if the calling thread is interrupted while a
   *     large hierarchy is built
   */
  public static Bvh over(List<? extends Shape> shapes, Kernel kernel) {
    List<Shape> all = List.copyOf(shapes);
    BvhItems items = new BvhItems(all);
    return new Bvh(
        kernel.over(items), items.unbounded(), kernel.mayChange(items) ? all : List.of());
  }

  /**
   * Returns a hierarchy over shapes that is built when the first ray is traced, for scenes that are
   * read and perhaps not rendered. Of many triangles, it is built where rays pass. It never changes
   * to the vector kernel.
   *
   * @throws HierarchyLimitException if there are too many items for a hierarchy
   */
  public static Bvh later(List<? extends Shape> shapes, Kernel kernel) {
    BvhItems items = new BvhItems(List.copyOf(shapes));
    BvhBuilder.requirePlaces(items);
    Kernel used = kernel == Kernel.AUTO ? Kernel.SCALAR : kernel;
    boolean hasCells =
        used == Kernel.SCALAR && items.triangleCount() >= CellTraversal.LEAST_TRIANGLES;
    return new Bvh(
        new LateTraversal(() -> hasCells ? new CellTraversal(items) : used.over(items)),
        items.unbounded(),
        List.of());
  }

  /**
   * Builds the hierarchy over some shapes of a list, which keep their numbers in it.
   *
   * @param isIncluded returns whether the shape of a number is included
   */
  public static Bvh over(List<? extends Shape> shapes, Kernel kernel, IntPredicate isIncluded) {
    double[] nothing = {};
    TriangleMesh empty = TriangleMesh.of(nothing, nothing, nothing, new int[0]);
    Shape none = Mesh.baked(empty, Transform.IDENTITY);
    return over(
        IntStream.range(0, shapes.size())
            .mapToObj(i -> isIncluded.test(i) ? shapes.get(i) : none)
            .toList(),
        kernel);
  }

  /**
   * Returns a hierarchy over the shapes of two hierarchies, which search and change kernels on
   * their own. No two shapes may have the same number.
   */
  public static Bvh both(Bvh first, Bvh second) {
    Traversal both =
        (ox, oy, oz, dx, dy, dz, nearest) -> {
          boolean found = first.search(nearest);
          return found && nearest.any || second.search(nearest) | found;
        };
    return new Bvh(both, NO_SHAPES, List.of());
  }

  /**
   * Builds a hierarchy over some of the shapes of this one, for the same kernel. It may change to
   * the vector kernel exactly if this one may; see {@link KernelChange}.
   */
  public Bvh part(List<? extends Shape> some) {
    List<Shape> shapes = List.copyOf(some);
    BvhItems items = new BvhItems(shapes);
    boolean isPlain = bounded instanceof BinaryTraversal || bounded instanceof LateTraversal;
    Kernel kernel = isPlain ? Kernel.SCALAR : Kernel.VECTOR;
    return new Bvh(kernel.over(items), items.unbounded(), isChangeable() ? shapes : List.of());
  }

  /**
   * Builds a slow hierarchy that finds the same hits and counts the nodes that {@link
   * Kernel#SCALAR} visits. It does not count nodes inside a {@link MeshInstance}.
   *
   * @param visits incremented for each visited node, leaves included
   */
  public static Bvh counting(List<? extends Shape> shapes, LongAdder visits) {
    BvhItems items = new BvhItems(List.copyOf(shapes));
    return new Bvh(Kernel.counting(items, visits), items.unbounded(), List.of());
  }

  /**
   * Finds the nearest hit along a ray and stores it.
   *
   * @return whether there is a hit
   */
  public boolean intersect(Ray ray, NearestHit nearest) {
    nearest.aim(ray);
    return intersect(nearest);
  }

  /**
   * Finds the nearest hit along the ray that {@code nearest} was last aimed along, and stores it.
   *
   * @return whether there is a hit
   */
  public boolean intersect(NearestHit nearest) {
    return nearest.moveToCoinciding(this) || search(nearest);
  }

  /**
   * Returns whether any shape blocks a ray, that is, whether {@link #intersect} would find a hit.
   */
  public boolean isOccluded(Ray ray, NearestHit scratch) {
    scratch.aim(ray);
    return isOccluded(scratch);
  }

  /** Returns whether any shape blocks the ray that {@code scratch} was last aimed along. */
  public boolean isOccluded(NearestHit scratch) {
    scratch.any = true;
    return search(scratch);
  }

  /** Finds a hit, as {@link Traversal#traverse} does. */
  boolean search(NearestHit nearest) {
    // Tested here, so that the JIT removes the call in scenes without unbounded shapes.
    boolean found = !unbounded.isEmpty() && unbounded.intersect(nearest);
    if (found && nearest.any) {
      return true;
    }
    return traverse(nearest) | found;
  }

  private boolean traverse(NearestHit nearest) {
    return bounded.traverse(
        nearest.originX,
        nearest.originY,
        nearest.originZ,
        nearest.directionX,
        nearest.directionY,
        nearest.directionZ,
        nearest);
  }

  /**
   * Continues a traversal in the hierarchy of a mesh that is itself a shape of another hierarchy.
   * Finds a hit before {@code nearest.t} along a ray in local coordinates. The caller stores the
   * shape number.
   *
   * @return whether a hit was found and stored
   */
  boolean intersectPart(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    int outer = nearest.shape;
    nearest.shape = -1;
    nearest.inPart = true;
    boolean found = bounded.traverse(ox, oy, oz, dx, dy, dz, nearest);
    nearest.inPart = false;
    nearest.shape = outer;
    return found;
  }

  /** Returns whether this hierarchy may change to the vector kernel. */
  boolean isChangeable() {
    return !changeable.isEmpty();
  }

  /** Returns the traversal of all shapes but the unbounded ones. */
  Traversal bounded() {
    return bounded;
  }

  /**
   * Builds the traversal that this hierarchy may change to.
   *
   * @param lastPlace see {@link Kernel#over(BvhItems, int)}
   * @throws HierarchyLimitException if it has too many triangles for that
   */
  Traversal vectorTraversal(int lastPlace) {
    return Kernel.VECTOR.over(new BvhItems(changeable), lastPlace);
  }

  /** Replaces the traversal by one that finds the same hits. */
  void changeTo(Traversal same) {
    bounded = same;
  }

  /** Returns the bounds of the shapes that this hierarchy may search with the vector kernel. */
  Bounds3 changeableBounds() {
    return changeable.stream()
        .map(Shape::bounds)
        .filter(Bounds3::isFinite)
        .reduce(Bounds3.EMPTY, Bounds3::union);
  }

  /** Returns the approximate number of items of a hierarchy over shapes. */
  public static long items(List<? extends Shape> shapes) {
    return shapes.stream()
        .mapToLong(s -> s instanceof Mesh mesh ? mesh.triangles().triangleCount() : 1)
        .sum();
  }

  /** Returns the approximate number of items that it may search with the vector kernel. */
  long changeableItems() {
    return items(changeable);
  }
}
