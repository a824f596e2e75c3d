package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.geometry.internal.HierarchyLimitException;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;

/**
 * The traversal kernel of a hierarchy: vectors of eight floats, or plain Java. The hits of both are
 * bit-identical; only the speed differs.
 *
 * <p>The vector kernel needs a processor with 256-bit vectors and the module jdk.incubator.vector,
 * which Java loads with {@code --add-modules jdk.incubator.vector}. The command-line jar, run with
 * {@code -jar}, loads it by itself.
 */
public enum Kernel {
  /**
   * Vectors where they are available and faster: in hierarchies of six items or more, but not in
   * those whose items are mostly too small, relative to its extent, for floats to separate, nor in
   * those of more than about 63 million triangles. Until the JIT has compiled the vector kernel,
   * plain Java; see {@link KernelChange}.
   */
  AUTO,

  /** Vectors always; an error where they are not available. */
  VECTOR,

  /** Plain Java always. */
  SCALAR;

  /** With fewer items, vectors are no faster. */
  private static final int MIN_ITEMS = 6;

  /** Returns the reason why vectors are not available in this JVM; empty if they are available. */
  public static Optional<String> vectorObstacle() {
    return Vectors.obstacle();
  }

  /**
   * Returns the reason why vectors would not be available in this JVM even with the module
   * jdk.incubator.vector; empty if they would be. Needs the package jdk.internal.vm.vector of
   * java.base, which the manifest of the command-line jar exports.
   *
   * @throws IllegalStateException if that package is not exported
   */
  public static Optional<String> processorObstacle() {
    return VectorLanes.obstacle(VectorLanes.withoutModule());
  }

  /**
   * Returns the reason why vectors are not available although the processor may support them: Java
   * has no module jdk.incubator.vector, or runs without it. Empty if vectors are available, or if
   * the processor is known not to support them.
   */
  public static Optional<String> moduleObstacle() {
    if (Vectors.isLoaded()) {
      return Optional.empty();
    }
    boolean isSupported;
    try {
      isSupported = processorObstacle().isEmpty();
    } catch (IllegalStateException e) {
      // The size of the processor's vectors is unknown: it may suffice.
      isSupported = VectorLanes.obstacle(WideTree.WIDTH).isEmpty();
    }
    return isSupported ? vectorObstacle() : Optional.empty();
  }

  /**
   * Returns the traversal over items.
   *
   * @throws IllegalStateException if this is {@link #VECTOR} and vectors are not available
   * @throws HierarchyLimitException if there are too many items
   */
  Traversal over(BvhItems items) {
    return over(items, BvhBuilder.MAX_ITEMS);
  }

  /**
   * Returns the traversal over items.
   *
   * @param lastPlace the largest number of a triangle's place in the vector kernel, less than the
   *     default for tests
   */
  Traversal over(BvhItems items, int lastPlace) {
    if (items.isEmpty()) {
      return Traversal.NONE;
    }
    if (usesVectors(items)) {
      try {
        return vectorsOver(items, lastPlace);
      } catch (HierarchyLimitException e) {
        if (this == VECTOR) {
          throw e;
        }
      }
    }
    return new BinaryTraversal(new BvhBuilder(items, BinaryTraversal.COSTS).build(), items);
  }

  private static Traversal vectorsOver(BvhItems items, int lastPlace) {
    BvhTree tree = new BvhBuilder(items, WideTree.COSTS).build();
    return Vectors.over(new WideTree(tree, items, lastPlace));
  }

  /** Returns a traversal over items that counts the nodes that {@link #SCALAR} visits. */
  static Traversal counting(BvhItems items, LongAdder visits) {
    if (items.isEmpty()) {
      return Traversal.NONE;
    }
    BvhTree tree = new BvhBuilder(items, BinaryTraversal.COSTS).build();
    return new CountingTraversal(tree, items, visits);
  }

  private boolean usesVectors(BvhItems items) {
    if (this == SCALAR) {
      return false;
    }
    if (this == AUTO) {
      return CompiledKernel.isCompiled() && vectorObstacle().isEmpty() && suitVectors(items);
    }
    if (vectorObstacle().isPresent()) {
      throw new IllegalStateException(
          "the vector kernel is not available: " + vectorObstacle().get());
    }
    return items.hasFiniteExtent();
  }

  /**
   * Returns whether a hierarchy starts with plain Java but may change to vectors, if they are
   * available: {@link KernelChange#run} asks that, which takes a while at the start of Java.
   */
  boolean mayChange(BvhItems items) {
    return this == AUTO && !CompiledKernel.isCompiled() && suitVectors(items);
  }

  private static boolean suitVectors(BvhItems items) {
    return items.count() >= MIN_ITEMS && items.hasFiniteExtent() && items.suitFloats();
  }
}
