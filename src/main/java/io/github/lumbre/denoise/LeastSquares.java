package io.github.lumbre.denoise;

import java.util.Arrays;

/**
 * Weighted linear least squares of several targets at once, by the normal equations. Mutable: one
 * object serves many fits of a thread.
 */
final class LeastSquares {
  private final int count;
  private final int targets;

  /** The upper triangle of the matrix, and the right-hand sides behind it. */
  private final double[][] rows;

  private final double[] terms;

  LeastSquares(int count, int targets) {
    this.count = count;
    this.targets = targets;
    rows = new double[count][count + targets];
    terms = new double[count];
  }

  void clear() {
    for (double[] row : rows) {
      Arrays.fill(row, 0);
    }
  }

  /** Returns the terms of the next equation or value, which the caller sets. */
  double[] terms() {
    return terms;
  }

  /** Adds an equation with the current terms; its targets start at an index. */
  void add(double weight, float[] values, int first) {
    for (int r = 0; r < count; r++) {
      double[] row = rows[r];
      double factor = weight * terms[r];
      for (int c = r; c < count; c++) {
        row[c] += factor * terms[c];
      }
      for (int t = 0; t < targets; t++) {
        row[count + t] += factor * values[first + t];
      }
    }
  }

  /** Adds the square of a coefficient, times a factor, to what is minimized. */
  void addRidge(int term, double factor) {
    rows[term][term] += factor;
  }

  /** Replaces the right-hand sides by the coefficients. The matrix must be positive definite. */
  void solve() {
    for (int r = 0; r < count; r++) {
      for (int below = r + 1; below < count; below++) {
        // The matrix is symmetric: the element below the diagonal is the one beside it.
        double factor = rows[r][below] / rows[r][r];
        for (int c = below; c < count + targets; c++) {
          rows[below][c] -= factor * rows[r][c];
        }
      }
    }
    for (int r = count - 1; r >= 0; r--) {
      for (int t = count; t < count + targets; t++) {
        double rest = rows[r][t];
        for (int c = r + 1; c < count; c++) {
          rest -= rows[r][c] * rows[c][t];
        }
        rows[r][t] = rest / rows[r][r];
      }
    }
  }

  /** Returns a target's value for the current terms, after {@link #solve}. */
  double value(int target) {
    double value = 0;
    for (int r = 0; r < count; r++) {
      value += terms[r] * rows[r][count + target];
    }
    return value;
  }
}
