package io.github.lumbre.render;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * The number of branches of the paths of each pixel: one number for each cell of a grid over the
 * full frame. Immutable; shared by threads.
 */
final class SplitPlan {
  /** The largest number of cells of a grid, and so its size in bytes. */
  static final int MOST_CELLS = 1 << 16;

  /** The plan of paths that are not split. */
  static final SplitPlan NONE = new SplitPlan(1, 1, 1, 1, new byte[1]);

  private final int width;
  private final int height;
  private final int columns;
  private final int rows;

  /** The logarithm of the number of branches to the base 2, row by row. */
  private final byte[] exponents;

  /**
   * Creates a plan.
   *
   * @param width width of the full frame in pixels
   * @param height height of the full frame in pixels
   * @param columns of the grid, at most {@code width}
   * @param rows of the grid, at most {@code height}
   * @param exponents logarithms of the numbers of branches to the base 2, row by row
   */
  SplitPlan(int width, int height, int columns, int rows, byte[] exponents) {
    if (exponents.length != columns * rows || exponents.length > MOST_CELLS) {
      throw new IllegalArgumentException(
          "exponents: expected " + columns * rows + ", found " + exponents.length);
    }
    this.width = width;
    this.height = height;
    this.columns = columns;
    this.rows = rows;
    this.exponents = exponents.clone();
  }

  /** Returns whether no path is split. */
  boolean isEmpty() {
    return pixelsWith(0) == exponents.length;
  }

  /** Returns the number of branches of all samples of a pixel of the full frame. */
  int branches(int x, int y) {
    if (this == NONE) {
      return 1;
    }
    int column = (int) ((long) x * columns / width);
    int row = (int) ((long) y * rows / height);
    return 1 << exponents[row * columns + column];
  }

  /** Returns the share of the frame whose paths have a number of branches. */
  double share(int exponent) {
    return (double) pixelsWith(exponent) / exponents.length;
  }

  private int pixelsWith(int exponent) {
    int count = 0;
    for (byte other : exponents) {
      count += other == exponent ? 1 : 0;
    }
    return count;
  }

  /** Returns the mean number of branches over the frame. */
  double meanBranches() {
    double sum = 0;
    for (byte exponent : exponents) {
      sum += 1 << exponent;
    }
    return sum / exponents.length;
  }

  /** Returns the SHA-256 of the plan, as hexadecimal digits. */
  String hash() {
    ByteBuffer numbers = ByteBuffer.allocate(16 + exponents.length);
    numbers.putInt(width).putInt(height).putInt(columns).putInt(rows).put(exponents);
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(numbers.array()));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has SHA-256", e);
    }
  }
}
