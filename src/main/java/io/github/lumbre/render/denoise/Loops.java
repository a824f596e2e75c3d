package io.github.lumbre.render.denoise;

/**
 * The inner loops. Each uses all of its arrays at the same index, as the optimizing compiler needs
 * to make vector code of it. Each result is a sum in a fixed order without fused operations, so
 * that its bits do not depend on the compiler.
 */
final class Loops {
  private static final float SMALLEST_EXPONENT = -16;
  private static final float LARGEST_EXPONENT = 16;

  private Loops() {}

  /** Adds three weighted rows to each of two sums. */
  static void addThree(
      float[][] rows,
      int first,
      float[] sum,
      float[] otherSum,
      int count,
      float[] weights,
      int at,
      int otherAt) {
    addThree(
        rows[first],
        rows[first + 1],
        rows[first + 2],
        sum,
        otherSum,
        count,
        weights[at],
        weights[at + 1],
        weights[at + 2],
        weights[otherAt],
        weights[otherAt + 1],
        weights[otherAt + 2]);
  }

  private static void addThree(
      float[] p,
      float[] q,
      float[] r,
      float[] sum,
      float[] otherSum,
      int count,
      float a,
      float b,
      float c,
      float d,
      float e,
      float f) {
    for (int i = 0; i < count; i++) {
      sum[i] = sum[i] + a * p[i] + b * q[i] + c * r[i];
      otherSum[i] = otherSum[i] + d * p[i] + e * q[i] + f * r[i];
    }
  }

  /** Adds a weighted row to each of two sums. */
  static void addOne(float[] p, float[] sum, float[] otherSum, int count, float a, float b) {
    for (int i = 0; i < count; i++) {
      sum[i] = sum[i] + a * p[i];
      otherSum[i] = otherSum[i] + b * p[i];
    }
  }

  /** Adds the products of two pairs of rows. */
  static void addProducts(
      float[] a, float[] p, float[] b, float[] q, float[] c, float[] r, float[] sum, int count) {
    for (int i = 0; i < count; i++) {
      sum[i] = sum[i] + a[i] * p[i] + b[i] * q[i] + c[i] * r[i];
    }
  }

  /** Adds the products of two rows. */
  static void addProduct(float[] a, float[] p, float[] sum, int count) {
    for (int i = 0; i < count; i++) {
      sum[i] = sum[i] + a[i] * p[i];
    }
  }

  static void rectify(float[] values, int count) {
    for (int i = 0; i < count; i++) {
      values[i] = Math.max(0f, values[i]);
    }
  }

  static void raiseTo(float[] values, float[] others, int count) {
    for (int i = 0; i < count; i++) {
      values[i] = Math.max(values[i], others[i]);
    }
  }

  /** Replaces values by the exponentials of their differences to others, and adds these to sums. */
  static void exponentials(float[] values, float[] largest, float[] sums, int count) {
    for (int i = 0; i < count; i++) {
      float e = exp(values[i] - largest[i]);
      values[i] = e;
      sums[i] = sums[i] + e;
    }
  }

  /** Replaces values by logistic functions of them. */
  static void sigmoids(float[] values, int count) {
    for (int i = 0; i < count; i++) {
      values[i] = 1f / (1f + exp(-values[i]));
    }
  }

  /** Multiplies weights by the exponentials of exponents, which are limited. */
  static void scaleByExponentials(float[] weights, float[] exponents, float limit, int count) {
    for (int i = 0; i < count; i++) {
      weights[i] = weights[i] * exp(Math.max(-limit, Math.min(limit, exponents[i])));
    }
  }

  static void divide(float[] values, float[] divisors, float[] results, int count) {
    for (int i = 0; i < count; i++) {
      results[i] = values[i] / divisors[i];
    }
  }

  /**
   * Returns e to the power x, with x limited to ±16: the 32nd power of a series for e^(x/32). Its
   * relative error is below 2e-6 for |x| ≤ 8, and 3e-5 at most.
   */
  private static float exp(float x) {
    float y = Math.max(SMALLEST_EXPONENT, Math.min(LARGEST_EXPONENT, x)) * .03125f;
    float p = 1f / 120 + y * (1f / 720);
    p = 1f / 24 + y * p;
    p = 1f / 6 + y * p;
    p = .5f + y * p;
    p = 1f + y * p;
    p = 1f + y * p;
    p = p * p;
    p = p * p;
    p = p * p;
    p = p * p;
    return p * p;
  }
}
