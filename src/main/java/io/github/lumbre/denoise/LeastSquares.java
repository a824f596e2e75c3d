package io.github.lumbre.denoise;

import java.util.Arrays;

/**
 * Weighted linear least squares of several targets at once, by the normal equations. Mutable: one
 * object serves many fits of a thread.
 */
final class LeastSquares {
  private final int count;
  private final int targets;

  /** Number of elements in a row. */
  private final int stride;

  /** Rows of the upper triangle of the matrix, each with its right-hand sides behind it. */
  private final double[] rows;

  private final double[] terms;
  private final double[] values;

  LeastSquares(int count, int targets) {
    this.count = count;
    this.targets = targets;
    stride = count + targets;
    rows = new double[count * stride];
    terms = new double[stride];
    values = new double[targets];
  }

  void clear() {
    Arrays.fill(rows, 0);
  }

  /** Returns the terms of the next equation or value, which the caller sets. */
  double[] terms() {
    return terms;
  }

  /** Adds an equation with the current terms; its targets start at an index. */
  void add(double weight, float[] values, int first) {
    for (int t = 0; t < targets; t++) {
      terms[count + t] = values[first + t];
    }
    for (int r = 0; r < count; r++) {
      int row = r * stride;
      double factor = weight * terms[r];
      for (int c = r; c < stride; c++) {
        rows[row + c] += factor * terms[c];
      }
    }
  }

  /** Adds the square of a coefficient, times a factor, to what is minimized. */
  void addRidge(int term, double factor) {
    rows[term * stride + term] += factor;
  }

  /** Replaces the right-hand sides by the coefficients. The matrix must be positive definite. */
  void solve() {
    for (int r = 0; r < count; r++) {
      int row = r * stride;
      for (int below = r + 1; below < count; below++) {
        // The matrix is symmetric: the element below the diagonal is the one beside it.
        double factor = rows[row + below] / rows[row + r];
        for (int c = below; c < stride; c++) {
          rows[below * stride + c] -= factor * rows[row + c];
        }
      }
    }
    for (int r = count - 1; r >= 0; r--) {
      int row = r * stride;
      for (int t = count; t < stride; t++) {
        double rest = rows[row + t];
        for (int c = r + 1; c < count; c++) {
          rest -= rows[row + c] * rows[c * stride + t];
        }
        rows[row + t] = rest / rows[row + r];
      }
    }
  }

  /** Returns the targets' values for the current terms, after {@link #solve}; overwritten later. */
  double[] values() {
    Arrays.fill(values, 0);
    for (int r = 0; r < count; r++) {
      int row = r * stride + count;
      double term = terms[r];
      for (int t = 0; t < targets; t++) {
        values[t] += term * rows[row + t];
      }
    }
    return values;
  }
}
