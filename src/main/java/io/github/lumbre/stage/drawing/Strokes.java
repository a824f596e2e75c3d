package io.github.lumbre.stage.drawing;

import java.util.Arrays;

/**
 * Line segments that are drawn as one area: where they overlap, the picture is covered once.
 * Mutable.
 *
 * <p>All coordinates are accepted. Segments with a coordinate that is not finite are not drawn, and
 * the others are clipped to the picture. Segments with ends that are more than 1e9 pixels away may
 * be drawn at a wrong place.
 */
public final class Strokes {
  private static final int VALUES = 4;

  private double[] ends = new double[2 * VALUES];
  private int count;

  /** Adds a segment; a segment of length 0 is drawn as a dot. */
  public Strokes add(double x0, double y0, double x1, double y1) {
    int at = VALUES * count;
    if (at == ends.length) {
      ends = Arrays.copyOf(ends, Math.multiplyExact(2, ends.length));
    }
    ends[at] = x0;
    ends[at + 1] = y0;
    ends[at + 2] = x1;
    ends[at + 3] = y1;
    count++;
    return this;
  }

  /**
   * Adds the segments of a polyline.
   *
   * @param points x and y of each of its points, at least two points
   * @throws IllegalArgumentException if there are fewer points, or half a point
   */
  public Strokes polyline(double... points) {
    if (points.length < 4 || points.length % 2 != 0) {
      throw new IllegalArgumentException(
          "points: expected an even number of at least 4 values, found " + points.length);
    }
    for (int i = 0; i + 3 < points.length; i += 2) {
      add(points[i], points[i + 1], points[i + 2], points[i + 3]);
    }
    return this;
  }

  /** Returns the number of segments. */
  public int count() {
    return count;
  }

  /**
   * Returns a key of a pair of integers, another one for each pair, whose hash codes are spread
   * (Steele, Lea and Flood 2014).
   */
  static long key(long column, long row) {
    return (column << 32 | row & 0xffffffffL) * 0x9e3779b97f4a7c15L;
  }

  /** Returns the number of segments for which there is memory. */
  int capacity() {
    return ends.length / VALUES;
  }

  /** Returns the length of a segment. */
  double length(int segment) {
    double x = coordinate(segment, 2) - coordinate(segment, 0);
    double y = coordinate(segment, 3) - coordinate(segment, 1);
    return Math.sqrt(x * x + y * y);
  }

  /** Adds a segment of other strokes. */
  Strokes add(Strokes other, int segment) {
    return add(
        other.coordinate(segment, 0),
        other.coordinate(segment, 1),
        other.coordinate(segment, 2),
        other.coordinate(segment, 3));
  }

  /** Returns a coordinate of a segment: 0 to 3 are x and y of its start and x and y of its end. */
  public double coordinate(int segment, int index) {
    return ends[VALUES * segment + index];
  }
}
