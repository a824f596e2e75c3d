package io.github.lumbre.integrator.guiding;

import java.util.Arrays;

/** Builds the quadtree of a cell of a {@link Guide}. Mutable; used once. */
final class SquareBuilder {
  /** A square with a smaller part of its cell's light is not divided. */
  private static final double LEAST_SHARE = .02;

  /** A square with fewer records is not divided. */
  private static final int LEAST_RECORDS = 8;

  private static final int MOST_DIVISIONS = Guide.DIGITS - 1;

  /**
   * Records that each divided square has in addition to its own, spread evenly. Without them, a
   * part where no record happened to lie would never be sampled.
   */
  private static final double EVEN_RECORDS = 4;

  /** Beyond this number of ints, squares are not divided, but for the first one. */
  private final int limit;

  private final GuideRecords records;
  private final RecordValues values;
  private int[] squares = new int[256];
  private int size;

  /** Node of the square that was added last, or -1 if it was not divided. */
  private int added;

  SquareBuilder(GuideRecords records, RecordValues values, int limit) {
    this.records = records;
    this.values = values;
    this.limit = limit;
  }

  /**
   * Returns the nodes of the quadtree of a cell; the first one is its root.
   *
   * @param order the records of the cell
   * @param fraction part of the cell's directions that follow the guide
   */
  int[] build(RecordOrder order, float fraction) {
    double light = 0;
    for (int i = 0; i < order.size(); i++) {
      light += values.value(order.record(i));
    }
    square(order, 0, order.size(), 0, 0, 0, LEAST_SHARE * light);
    squares[Guide.FRACTION] = Float.floatToRawIntBits(fraction);
    return Arrays.copyOf(squares, size);
  }

  /** Copies the nodes of a quadtree to where they are used. */
  static void copy(int[] squares, int[] target, int to) {
    System.arraycopy(squares, 0, target, to, squares.length);
    for (int node = to; node < to + squares.length; node += Guide.SQUARE_STRIDE) {
      for (int child = node + Guide.CHILDREN; child < node + Guide.CHILDREN + 4; child++) {
        if (target[child] >= 0) {
          target[child] += to;
        }
      }
    }
  }

  /**
   * Adds a square.
   *
   * @param u low corner, as is v
   * @param least light of a square that is divided
   * @return the weight of the square among its neighbors
   */
  private double square(
      RecordOrder order, int from, int to, double u, double v, int divisions, double least) {
    double side = Math.scalb(1, -divisions);
    double light = 0;
    double moment = 0;
    for (int i = from; i < to; i++) {
      double value = values.value(order.record(i));
      light += value;
      moment += value * value * records.number(order.record(i), GuideRecords.ALL_PDF);
    }
    if (divisions > 0 && (light < least || to - from < LEAST_RECORDS || isFull(divisions))) {
      added = -1;
      // The density of least variance is the root of the second moment (Rath et al. 2020).
      return Math.sqrt(moment) * side;
    }
    int node = size;
    size += Guide.SQUARE_STRIDE;
    if (squares.length < size) {
      squares = Arrays.copyOf(squares, 2 * squares.length);
    }
    double half = side / 2;
    int middle = order.divide(from, to, GuideRecords.U, (float) (u + half));
    int lower = order.divide(from, middle, GuideRecords.V, (float) (v + half));
    int upper = order.divide(middle, to, GuideRecords.V, (float) (v + half));
    int[] ends = {from, lower, middle, upper, to};
    double[] weights = new double[4];
    double sum = 0;
    for (int i = 0; i < 4; i++) {
      // The ranges lie column by column, the children row by row.
      int child = (i & 1) << 1 | i >> 1;
      double left = u + (child & 1) * half;
      double low = v + (child >> 1) * half;
      weights[child] = square(order, ends[i], ends[i + 1], left, low, divisions + 1, least);
      squares[node + Guide.CHILDREN + child] = added;
      sum += weights[child];
    }
    double even = sum / 4 * EVEN_RECORDS / Math.max(1, to - from);
    setPart(node, weights[0] + weights[2] + 2 * even, weights[1] + weights[3] + 2 * even);
    setPart(node + 1, weights[0] + even, weights[2] + even);
    setPart(node + 2, weights[1] + even, weights[3] + even);
    added = node;
    return sum;
  }

  private boolean isFull(int divisions) {
    return divisions >= MOST_DIVISIONS || size > limit;
  }

  private void setPart(int index, double low, double high) {
    double sum = low + high;
    float part = sum > 0 && sum < Double.POSITIVE_INFINITY ? (float) (low / sum) : .5f;
    squares[index] = Float.floatToRawIntBits(part);
  }
}
