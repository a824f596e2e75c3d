package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.geometry.internal.HierarchyLimitException;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * Changes the hierarchies of a scene from plain Java to vectors once these are faster. Until the
 * JIT has compiled the vector kernel, it is about 100 times slower, so that hierarchies for {@link
 * Kernel#AUTO} begin with plain Java. Hits are bit-identical, so that renders may go on meanwhile.
 *
 * <p>Mutable and thread-safe.
 */
public final class KernelChange {
  private static final int RAYS = 500;

  /** Vectors must win this many batches of rays in a row. */
  private static final int WINS = 3;

  /** After this time, vectors will not become faster. */
  private static final long LONGEST_NANOS = 40_000_000_000L;

  private final List<Bvh> hierarchies;

  /** See {@link Kernel#over(BvhItems, int)}. */
  private final int lastPlace;

  private boolean isTried;

  private KernelChange(List<Bvh> hierarchies, int lastPlace) {
    this.hierarchies = hierarchies;
    this.lastPlace = lastPlace;
  }

  /** Returns the change of a hierarchy and of the hierarchies of its {@link MeshInstance}s. */
  public static KernelChange of(Bvh bvh, List<? extends Shape> shapes) {
    return of(List.of(bvh), shapes);
  }

  /** Returns the change of hierarchies over shapes, and of their {@link MeshInstance}s. */
  public static KernelChange of(List<Bvh> hierarchies, List<? extends Shape> shapes) {
    return of(hierarchies, shapes, BvhBuilder.MAX_ITEMS);
  }

  /** Returns the change to a vector kernel with fewer places for triangles, for tests. */
  static KernelChange of(List<Bvh> hierarchies, List<? extends Shape> shapes, int lastPlace) {
    Set<Bvh> all = new LinkedHashSet<>(hierarchies);
    for (Shape shape : shapes) {
      if (shape instanceof MeshInstance instance) {
        all.add(instance.shared().bvh());
      } else if (shape instanceof SphereCloud cloud) {
        all.add(cloud.bvh());
      }
    }
    return new KernelChange(all.stream().filter(Bvh::isChangeable).toList(), lastPlace);
  }

  /**
   * Returns whether {@link #run} has something to do, if vectors are available; it tries it once.
   */
  public synchronized boolean isPossible() {
    return !isTried && !hierarchies.isEmpty();
  }

  /**
   * Builds vector hierarchies and searches the largest one until the JIT has compiled the search
   * and it is faster than plain Java; then changes all hierarchies. If it does not become faster,
   * nothing changes, as where vectors are not available or have no place for the triangles. Takes
   * one thread a few seconds.
   *
   * @param isWanted whether to continue; the search stops soon after it returns false. Another run
   *     may then try again.
   * @return whether the hierarchies have changed
   * @throws InterruptedException if the thread is interrupted; nothing has changed then
   */
  public boolean run(BooleanSupplier isWanted) throws InterruptedException {
    synchronized (this) {
      if (!isPossible()) {
        return false;
      }
      isTried = true;
    }
    if (Kernel.vectorObstacle().isPresent()) {
      return false;
    }
    List<Traversal> vectors = new ArrayList<>();
    try {
      for (Bvh bvh : hierarchies) {
        vectors.add(bvh.vectorTraversal(lastPlace));
      }
    } catch (HierarchyLimitException e) {
      return false;
    }
    int largest = indexOfLargest();
    if (!becomesFaster(hierarchies.get(largest), vectors.get(largest), isWanted)) {
      return false;
    }
    CompiledKernel.setCompiled(true);
    for (int i = 0; i < vectors.size(); i++) {
      hierarchies.get(i).changeTo(vectors.get(i));
    }
    return true;
  }

  private synchronized void tryAgain() {
    isTried = false;
  }

  private int indexOfLargest() {
    Bvh largest =
        hierarchies.stream().max(Comparator.comparingLong(Bvh::changeableItems)).orElseThrow();
    return hierarchies.indexOf(largest);
  }

  private boolean becomesFaster(Bvh bvh, Traversal vectors, BooleanSupplier isWanted)
      throws InterruptedException {
    SearchTime plainTime = new SearchTime(bvh, bvh.bounded());
    SearchTime vectorTime = new SearchTime(bvh, vectors);
    long start = System.nanoTime();
    for (int wins = 0; wins < WINS; ) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      if (System.nanoTime() - start > LONGEST_NANOS) {
        return false;
      }
      if (!isWanted.getAsBoolean()) {
        tryAgain();
        return false;
      }
      wins = vectorTime.next() < plainTime.next() ? wins + 1 : 0;
    }
    return true;
  }

  /** Measures the time of searches along paths that bounce between the items. */
  private static final class SearchTime {
    private final Traversal traversal;
    private final Bounds3 bounds;
    private final NearestHit nearest = new NearestHit();
    private int points;
    private Vec3 origin;

    SearchTime(Bvh bvh, Traversal traversal) {
      this.traversal = traversal;
      bounds = bvh.changeableBounds();
      origin = somewhere();
    }

    /** Returns the nanoseconds of the next searches; all instances share one sequence. */
    long next() {
      long start = System.nanoTime();
      for (int i = 0; i < RAYS; i++) {
        Vec3 direction = somewhere().minus(origin);
        if (search(direction, i % 2 == 1) && !nearest.any) {
          // The next path vertex lies just before the surface.
          origin = origin.plus(direction.times(.999 * nearest.t));
        } else if (!nearest.any) {
          origin = somewhere();
        }
      }
      return System.nanoTime() - start;
    }

    private boolean search(Vec3 direction, boolean any) {
      nearest.aim(
          origin.x(),
          origin.y(),
          origin.z(),
          direction.x(),
          direction.y(),
          direction.z(),
          any ? 1 : Double.POSITIVE_INFINITY);
      nearest.any = any;
      return traversal.traverse(
          origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z(), nearest);
    }

    /**
     * Returns the next point of a uniform sequence (Roberts 2018, "The Unreasonable Effectiveness
     * of Quasirandom Sequences": powers of the root of x⁴ = x + 1).
     */
    private Vec3 somewhere() {
      points++;
      return new Vec3(
          between(bounds.min().x(), bounds.max().x(), .8191725133961645 * points),
          between(bounds.min().y(), bounds.max().y(), .6710436067037893 * points),
          between(bounds.min().z(), bounds.max().z(), .5497004779019703 * points));
    }

    private static double between(double low, double high, double position) {
      return low + (position - Math.floor(position)) * (high - low);
    }
  }
}
