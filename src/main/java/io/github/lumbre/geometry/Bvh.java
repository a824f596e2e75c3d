package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;

/**
 * A bounding volume hierarchy over shapes. Immutable, shared by all threads.
 *
 * <p>The triangles of each {@link Mesh} are items of the hierarchy themselves; other shapes are
 * items as a whole, and unbounded ones are asked every time. Of hits at the same t the one of the
 * lower shape, and in it of the lower element, wins, so that no order of the search shows.
 *
 * <p>No hit is lost to rounding: the boxes are wider than their contents by {@link BvhItems#MARGIN}
 * of the largest coordinate that entered, and every search widens them by as much of its ray's
 * origin. That is more than the test of any item can be wrong by.
 */
public final class Bvh {
  private final Traversal bounded;
  private final LeafShapes unbounded;

  private Bvh(Traversal bounded, LeafShapes unbounded) {
    this.bounded = bounded;
    this.unbounded = unbounded;
  }

  /**
   * Builds the hierarchy over shapes, which are numbered by their place in the list, for the kernel
   * {@link Kernel#AUTO}.
   */
  public static Bvh over(List<? extends Shape> shapes) {
    return over(shapes, Kernel.AUTO);
  }

  /**
   * Builds the hierarchy over shapes, which are numbered by their place in the list.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public static Bvh over(List<? extends Shape> shapes, Kernel kernel) {
    BvhItems items = new BvhItems(List.copyOf(shapes));
    return new Bvh(kernel.over(items), items.unbounded());
  }

  /**
   * Builds a slow hierarchy over shapes that finds the same hits, and counts the nodes that plain
   * Java visits; of shapes that are meshes placed often, not those inside.
   *
   * @param visits what hears of each node
   */
  public static Bvh counting(List<? extends Shape> shapes, LongAdder visits) {
    BvhItems items = new BvhItems(List.copyOf(shapes));
    return new Bvh(Kernel.counting(items, visits), items.unbounded());
  }

  /** Finds the nearest hit along a ray; tells whether there is one. */
  public boolean intersect(Ray ray, NearestHit nearest) {
    nearest.aim(ray);
    return intersect(nearest);
  }

  /** Finds the nearest hit along the ray that {@code nearest} was just aimed by. */
  public boolean intersect(NearestHit nearest) {
    return search(nearest);
  }

  /** Tells whether anything lies on a ray: whether {@link #intersect} would find a hit. */
  public boolean isOccluded(Ray ray, NearestHit scratch) {
    scratch.aim(ray);
    return isOccluded(scratch);
  }

  /** Tells whether anything lies on the ray that {@code scratch} was just aimed by. */
  public boolean isOccluded(NearestHit scratch) {
    scratch.any = true;
    return search(scratch);
  }

  private boolean search(NearestHit nearest) {
    // Asked here, so that the compiler leaves out what scenes without such shapes never do.
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
   * Continues a search in a hierarchy of triangles that is itself a shape of another: looks for a
   * hit before {@code nearest.t} along a ray given by its local coordinates. The shape's number is
   * the caller's to store.
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
}
