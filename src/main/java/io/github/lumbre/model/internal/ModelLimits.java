package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.Optional;

/** Limits that are checked before memory is allocated. Stateless. */
public final class ModelLimits {
  /** The largest number of vertices or triangles: three numbers each fit into one Java array. */
  public static final int MAX_COUNT = (Integer.MAX_VALUE - 8) / 3;

  /** The largest number of parts of one model. */
  public static final int MAX_PARTS = 10_000;

  /** Items between two checks for an interrupt, minus 1; a power of two minus 1. */
  public static final int INTERRUPT_MASK = (1 << 14) - 1;

  private ModelLimits() {}

  /**
   * Checks that the scene of a model can fit into the heap, before anything of it is allocated.
   *
   * @param triangles of all meshes, each counted once
   * @throws ModelFormatException if it cannot
   */
  public static void requireHeap(String location, long triangles) throws ModelFormatException {
    requireHeap(location, HeapNeed.ofTriangles(triangles), Runtime.getRuntime().maxMemory());
  }

  /**
   * Checks that the scene of points can fit into the heap, before anything of it is allocated.
   *
   * @throws ModelFormatException if it cannot
   */
  public static void requireHeapOfPoints(String location, long points)
      throws ModelFormatException {
    requireHeap(location, HeapNeed.ofPoints(points), Runtime.getRuntime().maxMemory());
  }

  static void requireHeap(String location, HeapNeed need, long heap) throws ModelFormatException {
    long bytes = need.bytes();
    if (bytes > heap) {
      throw Kind.TOO_LARGE.at(
          location,
          ("expected a model that fits into the heap of %d MiB, found %s,"
                  + " which take %d MiB or more; Java's option -Xmx sets the heap")
              .formatted(heap >> 20, need.items(), (bytes >> 20) + 1));
    }
  }

  /**
   * Checks that a model fits into the heap, and the memory that the limits allow.
   *
   * @param bytes that the model needs at least
   * @throws ModelFormatException if it does not
   */
  public static void requireMemory(String location, long bytes, Limits limits)
      throws ModelFormatException {
    require(location, "bytes of memory for the model", limits.heap(), bytes);
  }

  /**
   * Checks the number of triangles.
   *
   * @throws ModelFormatException if there are more than the limits allow
   */
  public static void requireTriangles(String location, long found, Limits limits)
      throws ModelFormatException {
    require(location, "triangles", limits.triangles(), found);
  }

  /**
   * Checks the number of triangles and points up to a mesh; a point counts as a triangle.
   *
   * @throws ModelFormatException if there are more than the limits allow
   */
  public static void requireItems(String location, ModelGeometry last, long found, Limits limits)
      throws ModelFormatException {
    require(location, last.items(), limits.triangles(), found);
  }

  /**
   * Checks a number of things against a limit.
   *
   * @param things what is counted, in the plural
   * @throws ModelFormatException if there are more
   */
  public static void require(String location, String things, long max, long found)
      throws ModelFormatException {
    Optional<String> excess = Limits.excess(things, max, found);
    if (excess.isPresent()) {
      throw Kind.TOO_LARGE.at(location, excess.get());
    }
  }
}
