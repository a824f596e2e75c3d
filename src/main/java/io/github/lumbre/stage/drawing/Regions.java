package io.github.lumbre.stage.drawing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongPredicate;

/**
 * Finds the outlines of regions of equal squares of a grid. They pass within a square of the true
 * ones: lines on the borders of surfaces cover the difference.
 */
final class Regions {
  /** The largest distance of points of an outline that are left out, in squares. */
  private static final double FLAT = .9;

  /** The steps to the right, down, to the left and up. */
  private static final int[] STEP_X = {1, 0, -1, 0};

  private static final int[] STEP_Y = {0, 1, 0, -1};

  private final int width;
  private final int height;
  private final long[] keys;

  /** Whether the upper side of each square is on an outline that has been found. */
  private final boolean[] isFound;

  private Regions(int width, long... keys) {
    this.width = width;
    this.keys = keys;
    height = keys.length / width;
    isFound = new boolean[keys.length];
  }

  /**
   * Returns the closed outlines of each region in squares, by its key: what is inside an odd number
   * of them is in the region.
   *
   * @param width of the grid
   * @param keys of the squares, in rows from the top
   * @param isRegion returns whether squares of a key are a region
   */
  static Map<Long, List<double[]>> outlines(int width, long[] keys, LongPredicate isRegion) {
    Regions regions = new Regions(width, keys);
    Map<Long, List<double[]>> outlines = new LinkedHashMap<>();
    for (int i = 0; i < keys.length; i++) {
      int x = i % width;
      int y = i / width;
      if (isRegion.test(keys[i]) && !regions.isFound[i] && !regions.isIn(x, y - 1, keys[i])) {
        double[] outline = Polylines.simplified(regions.outline(x, y), FLAT);
        // Less than a triangle covers nothing.
        if (outline.length >= 8) {
          outlines.computeIfAbsent(keys[i], key -> new ArrayList<>()).add(outline);
        }
      }
    }
    return outlines;
  }

  private boolean isIn(int x, int y, long key) {
    return x >= 0 && y >= 0 && x < width && y < height && keys[y * width + x] == key;
  }

  /** Follows an outline from the upper side of a square, with the region to the right. */
  private double[] outline(int startX, int startY) {
    long key = keys[startY * width + startX];
    double[] points = new double[16];
    int count = 0;
    int x = startX;
    int y = startY;
    int direction = 0;
    do {
      if (direction == 0) {
        isFound[y * width + x] = true;
      }
      points = count == points.length ? Arrays.copyOf(points, 2 * count) : points;
      points[count++] = x + .5 * STEP_X[direction];
      points[count++] = y + .5 * STEP_Y[direction];
      x += STEP_X[direction];
      y += STEP_Y[direction];
      direction = turned(x, y, direction, key);
    } while (x != startX || y != startY || direction != 0);
    points = Arrays.copyOf(points, count + 2);
    points[count] = points[0];
    points[count + 1] = points[1];
    return points;
  }

  /** Returns the next direction of an outline at a corner of squares. */
  private int turned(int x, int y, int direction, long key) {
    int right = (direction + 1) % 4;
    if (!isAhead(x, y, direction, right, key)) {
      return right;
    }
    int left = (direction + 3) % 4;
    return isAhead(x, y, direction, left, key) ? left : direction;
  }

  /** Returns whether the square ahead of a corner, to one side, is in the region. */
  private boolean isAhead(int x, int y, int direction, int side, long key) {
    int column = STEP_X[direction] + STEP_X[side] > 0 ? x : x - 1;
    int row = STEP_Y[direction] + STEP_Y[side] > 0 ? y : y - 1;
    return isIn(column, row, key);
  }
}
