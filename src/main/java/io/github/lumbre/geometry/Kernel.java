package io.github.lumbre.geometry;

import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;

/**
 * How hierarchies are searched: by vectors of eight floats, or by nothing but plain Java. Both find
 * the same hits, bit for bit; they differ in speed. Chosen when a hierarchy is built.
 *
 * <p>Vectors need the module jdk.incubator.vector, which a virtual machine has only if it was
 * started with {@code --add-modules jdk.incubator.vector}, and a processor with vectors of 256
 * bits.
 */
public enum Kernel {
  /**
   * Vectors where they are available and pay: in hierarchies of six items or more, unless most are
   * so small beside the whole that floats hardly tell them apart.
   */
  AUTO,

  /** Vectors always. */
  VECTOR,

  /** Plain Java always. */
  SCALAR;

  /** Fewer items are searched as fast without vectors. */
  private static final int MIN_ITEMS = 6;

  /** Returns why there can be no vectors in this virtual machine; empty if there can be. */
  public static Optional<String> vectorObstacle() {
    return Vectors.obstacle();
  }

  /**
   * Returns the search over items.
   *
   * @throws IllegalStateException if vectors are asked for and not available
   */
  Traversal over(BvhItems items) {
    if (items.isEmpty()) {
      return Traversal.NONE;
    }
    if (!usesVectors(items)) {
      BvhBuilder builder = builder(items, BinaryTraversal.COSTS);
      return new BinaryTraversal(builder.build(), builder.order(), items);
    }
    BvhBuilder builder = builder(items, WideTree.COSTS);
    return Vectors.over(new WideTree(builder.build(), builder.order(), items));
  }

  /** Returns the search over items that counts the nodes of {@link #SCALAR}'s. */
  static Traversal counting(BvhItems items, LongAdder visits) {
    if (items.isEmpty()) {
      return Traversal.NONE;
    }
    BvhBuilder builder = builder(items, BinaryTraversal.COSTS);
    return new CountingTraversal(builder.build(), builder.order(), items, visits);
  }

  private static BvhBuilder builder(BvhItems items, LeafCost costs) {
    return new BvhBuilder(items.boxes(), items.triangleCount(), costs);
  }

  private boolean usesVectors(BvhItems items) {
    Optional<String> obstacle = vectorObstacle();
    if (this == VECTOR && obstacle.isPresent()) {
      throw new IllegalStateException("the vector kernel is not available: " + obstacle.get());
    }
    return switch (this) {
      case SCALAR -> false;
      case VECTOR -> items.hasFiniteExtent();
      case AUTO ->
          obstacle.isEmpty()
              && items.count() >= MIN_ITEMS
              && items.hasFiniteExtent()
              && items.suitFloats();
    };
  }
}
