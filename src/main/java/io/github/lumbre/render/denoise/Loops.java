package io.github.lumbre.render.denoise;

/**
 * The inner loops. Each uses all of its arrays at the same index, as the optimizing compiler needs
 * to make vector code of it. Each result is a sum in a fixed order, of products that are the same
 * fused or not, so that its bits depend neither on the compiler nor on the processor.
 */
final class Loops {
  private static final float SMALLEST_EXPONENT = -16;
  private static final float LARGEST_EXPONENT = 16;

  /** Adding and subtracting it leaves multiples of 2^-64. */
  private static final float SMALL = 0x1p-40f;

  /** Splits a float of 24 significant bits into 13 and 11 (Dekker 1971). */
  private static final float SPLIT = 0x1p11f + 1;

  private Loops() {}

  /**
   * Returns a near value that has at most 13 significant bits and is a multiple of 2^-64. Its
   * product with a weight of the network, which has 11 and is a multiple of 2^-24, is a float: a
   * sum with that product has the same bits whether both operations are fused or not.
   */
  static float rounded(float value) {
    float coarse = value + SMALL - SMALL;
    float split = coarse * SPLIT;
    return split - (split - coarse);
  }

  /**
   * Adds three weighted rows to each of two sums: nearly all of the network's work.
   *
   * <p>Its two loops are in one method, because that is too long to be inlined: else the compiler
   * would make vector code of them in each of the callers, too.
   *
   * @param rows {@linkplain #rounded rounded} values
   * @param first the first of the three rows
   * @param weights of the network
   * @param at index of the three weights of a sum
   * @param otherAt index of those of the other sum
   * @param isFused whether the operations are fused; the results are the same
   */
  static void addThree(
      float[][] rows,
      int first,
      float[] sum,
      float[] otherSum,
      int count,
      float[] weights,
      int at,
      int otherAt,
      boolean isFused) {
    float[] p = rows[first];
    float[] q = rows[first + 1];
    float[] r = rows[first + 2];
    float a = weights[at];
    float b = weights[at + 1];
    float c = weights[at + 2];
    float d = weights[otherAt];
    float e = weights[otherAt + 1];
    float f = weights[otherAt + 2];
    if (isFused) {
      for (int i = 0; i < count; i++) {
        float x = p[i];
        float y = q[i];
        float z = r[i];
        float one = Math.fma(c, z, Math.fma(b, y, Math.fma(a, x, sum[i])));
        float other = Math.fma(f, z, Math.fma(e, y, Math.fma(d, x, otherSum[i])));
        sum[i] = one;
        otherSum[i] = other;
      }
    } else {
      for (int i = 0; i < count; i++) {
        float x = p[i];
        float y = q[i];
        float z = r[i];
        float one = sum[i] + a * x + b * y + c * z;
        float other = otherSum[i] + d * x + e * y + f * z;
        sum[i] = one;
        otherSum[i] = other;
      }
    }
  }

  /** Adds the products of two rows. */
  static void addProduct(float[] a, float[] p, float[] sum, int count) {
    for (int i = 0; i < count; i++) {
      sum[i] = sum[i] + a[i] * p[i];
    }
  }

  /** Replaces negative values by 0, and rounds the others; up to half of the largest float. */
  static void rectify(float[] values, int first, int end) {
    for (int i = first; i < end; i++) {
      values[i] = rounded(.5f * (values[i] + Math.abs(values[i])));
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
