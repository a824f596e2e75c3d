package io.github.lumbre.geometry;

import io.github.lumbre.math.internal.FusedMultiplyAdd;
import java.util.Optional;

/** The number of floats that a vector of this processor holds in this JVM. */
final class VectorLanes {
  static final String MODULE = "jdk.incubator.vector";

  private static final Class<?>[] ELEMENTS = {
    byte.class, short.class, int.class, long.class, float.class, double.class
  };
  private static final int[] BITS = {
    Byte.SIZE, Short.SIZE, Integer.SIZE, Long.SIZE, Float.SIZE, Double.SIZE
  };

  /** Java's smallest vectors. */
  private static final int LEAST_BITS = 64;

  private VectorLanes() {}

  /**
   * Returns the reason why vectors with so many floats are of no use; empty if they are. Without
   * fused multiply-add, Java would compute with objects instead.
   */
  static Optional<String> obstacle(int lanes) {
    if (lanes < WideTree.WIDTH) {
      return Optional.of("this processor's vectors hold " + lanes + " floats, but 8 are needed");
    }
    return FusedMultiplyAdd.isFast()
        ? Optional.empty()
        : Optional.of("Java uses no fused multiply-add (FMA) on this processor");
  }

  /** Loads none of the module's classes of vectors, which take long to load. */
  static int ofModule() {
    try {
      Class<?> shape = Class.forName(MODULE + ".VectorShape");
      Object preferred = shape.getMethod("preferredShape").invoke(null);
      return (int) shape.getMethod("vectorBitSize").invoke(preferred) / Float.SIZE;
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  /**
   * Returns the same number without the module, as the module itself computes it: the size that
   * vectors of all types of elements can have.
   *
   * @throws IllegalStateException if java.base does not export jdk.internal.vm.vector
   */
  static int withoutModule() {
    try {
      Class<?> support = Class.forName("jdk.internal.vm.vector.VectorSupport");
      var count = support.getMethod("getMaxLaneCount", Class.class);
      int bits = Integer.MAX_VALUE;
      for (int i = 0; i < ELEMENTS.length; i++) {
        int most = (int) count.invoke(null, ELEMENTS[i]) * BITS[i];
        bits = Math.min(bits, Math.max(most, LEAST_BITS));
      }
      return bits / Float.SIZE;
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }
}
