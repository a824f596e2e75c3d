package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;
import java.util.List;

/** A bounding volume hierarchy over shapes. Immutable, shared by all threads. */
public final class Bvh {
  private Bvh() {}

  /** Builds the hierarchy over shapes, which are numbered by their place in the list. */
  public static Bvh over(List<? extends Shape> shapes) {
    throw new UnsupportedOperationException();
  }

  /** Finds the nearest hit along a ray; tells whether there is one. */
  public boolean intersect(Ray ray, NearestHit nearest) {
    throw new UnsupportedOperationException();
  }

  /** Tells whether anything lies on a ray. */
  public boolean isOccluded(Ray ray, NearestHit scratch) {
    throw new UnsupportedOperationException();
  }
}
