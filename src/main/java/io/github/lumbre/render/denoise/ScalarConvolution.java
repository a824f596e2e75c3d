package io.github.lumbre.render.denoise;

import io.github.lumbre.math.internal.FusedMultiplyAdd;
import io.github.lumbre.render.denoise.Network.Layer;
import java.util.Arrays;

/**
 * Convolutions of 3x3 taps where the fast compiler is alone, which makes no vector code of loops:
 * sixteen sums, of four pixels and four outputs, stay in registers while the inputs are added, and
 * inputs that are 0 are left out, which are half of all.
 *
 * <p>A sum has its terms in the same order as by {@link Convolution}, and so the same bits. A
 * thumbnail is denoised in half of the time (docs/measurements/2026-11-start.md). The launchers
 * set the property where they choose that compiler: {@code src/main/jvm/short-options}.
 */
final class ScalarConvolution {
  private static final boolean IS_USED =
      Boolean.getBoolean("lumbre.scalar") && FusedMultiplyAdd.isFast();

  /** Pixels that are computed together, and outputs; each layer has a multiple of it. */
  private static final int BLOCK = 4;

  private static final int SIDE = 3;

  /** Values of an input's row that the pixels of a block need. */
  private static final int WIDTH = BLOCK + SIDE - 1;

  /** Rows of the inputs around a block that are not 0: values, and where their weights are. */
  private float[] values = new float[0];

  private int[] places = new int[0];
  private final float[] sums = new float[BLOCK * BLOCK];

  /** Returns whether this JVM computes convolutions so. */
  static boolean isUsed() {
    return IS_USED;
  }

  /**
   * Computes pixels of a row of a layer, with negative values replaced by 0.
   *
   * @param inputs as those of {@link Convolution#apply}
   * @param left the first column
   * @param right after the last column
   */
  void apply(Layer layer, Maps[] inputs, int left, int right, int y, Maps out) {
    if (places.length < SIDE * layer.inputs()) {
      places = new int[SIDE * layer.inputs()];
      values = new float[WIDTH * places.length];
    }
    for (int x = left; x < right; x += BLOCK) {
      int pixels = Math.min(BLOCK, right - x);
      int rows = gather(inputs, x, y, pixels);
      for (int o = 0; o < layer.outputs(); o += BLOCK) {
        add(layer, o, rows, places, values, sums);
        for (int i = 0; i < BLOCK; i++) {
          System.arraycopy(sums, BLOCK * i, out.plane(o + i), out.at(y) + x, pixels);
        }
      }
    }
    for (int o = 0; o < layer.outputs(); o++) {
      Loops.rectify(out.plane(o), out.at(y) + left, out.at(y) + right);
    }
  }

  /** Gathers the rows around some pixels; returns their number. */
  private int gather(Maps[] inputs, int x, int y, int pixels) {
    int rows = 0;
    int place = 0;
    for (Maps in : inputs) {
      int stride = in.stride();
      for (int i = 0; i < in.count(); i++) {
        float[] plane = in.plane(i);
        int from = in.at(y - 1) + x - 1;
        for (int row = 0; row < SIDE; row++) {
          places[rows] = place;
          int to = WIDTH * rows;
          rows += pixels < BLOCK ? copy(plane, from, pixels, to) : copy(plane, from, values, to);
          from += stride;
          place += SIDE;
        }
      }
    }
    return rows;
  }

  /** Copies the row around a block; returns 1, or 0 if all of it is 0. */
  private static int copy(float[] plane, int from, float[] values, int to) {
    float p0 = plane[from];
    float p1 = plane[from + 1];
    float p2 = plane[from + 2];
    float p3 = plane[from + 3];
    float p4 = plane[from + 4];
    float p5 = plane[from + 5];
    if (p0 == 0 && p1 == 0 && p2 == 0 && p3 == 0 && p4 == 0 && p5 == 0) {
      return 0;
    }
    values[to] = p0;
    values[to + 1] = p1;
    values[to + 2] = p2;
    values[to + 3] = p3;
    values[to + 4] = p4;
    values[to + 5] = p5;
    return 1;
  }

  /** Copies the row around fewer pixels; those that a block lacks are 0. */
  private int copy(float[] plane, int from, int pixels, int to) {
    Arrays.fill(values, to, to + WIDTH, 0);
    System.arraycopy(plane, from, values, to, pixels + SIDE - 1);
    return copy(values, to, values, to);
  }

  /**
   * Computes sums of four outputs and four pixels.
   *
   * @param output the first output
   * @param rows the number of rows that are added
   */
  private static void add(
      Layer layer, int output, int rows, int[] places, float[] values, float[] sums) {
    float[] weights = layer.weights();
    float[] biases = layer.biases();
    int stride = layer.stride();
    int start = output * stride;
    float a0 = biases[output];
    float a1 = a0;
    float a2 = a0;
    float a3 = a0;
    float b0 = biases[output + 1];
    float b1 = b0;
    float b2 = b0;
    float b3 = b0;
    float c0 = biases[output + 2];
    float c1 = c0;
    float c2 = c0;
    float c3 = c0;
    float d0 = biases[output + 3];
    float d1 = d0;
    float d2 = d0;
    float d3 = d0;
    for (int row = 0, from = 0; row < rows; row++, from += WIDTH) {
      int at = start + places[row];
      float p0 = values[from];
      float p1 = values[from + 1];
      float p2 = values[from + 2];
      float p3 = values[from + 3];
      float p4 = values[from + 4];
      float p5 = values[from + 5];
      float w = weights[at];
      a0 = Math.fma(w, p0, a0);
      a1 = Math.fma(w, p1, a1);
      a2 = Math.fma(w, p2, a2);
      a3 = Math.fma(w, p3, a3);
      w = weights[at + 1];
      a0 = Math.fma(w, p1, a0);
      a1 = Math.fma(w, p2, a1);
      a2 = Math.fma(w, p3, a2);
      a3 = Math.fma(w, p4, a3);
      w = weights[at + 2];
      a0 = Math.fma(w, p2, a0);
      a1 = Math.fma(w, p3, a1);
      a2 = Math.fma(w, p4, a2);
      a3 = Math.fma(w, p5, a3);
      w = weights[at + stride];
      b0 = Math.fma(w, p0, b0);
      b1 = Math.fma(w, p1, b1);
      b2 = Math.fma(w, p2, b2);
      b3 = Math.fma(w, p3, b3);
      w = weights[at + stride + 1];
      b0 = Math.fma(w, p1, b0);
      b1 = Math.fma(w, p2, b1);
      b2 = Math.fma(w, p3, b2);
      b3 = Math.fma(w, p4, b3);
      w = weights[at + stride + 2];
      b0 = Math.fma(w, p2, b0);
      b1 = Math.fma(w, p3, b1);
      b2 = Math.fma(w, p4, b2);
      b3 = Math.fma(w, p5, b3);
      w = weights[at + 2 * stride];
      c0 = Math.fma(w, p0, c0);
      c1 = Math.fma(w, p1, c1);
      c2 = Math.fma(w, p2, c2);
      c3 = Math.fma(w, p3, c3);
      w = weights[at + 2 * stride + 1];
      c0 = Math.fma(w, p1, c0);
      c1 = Math.fma(w, p2, c1);
      c2 = Math.fma(w, p3, c2);
      c3 = Math.fma(w, p4, c3);
      w = weights[at + 2 * stride + 2];
      c0 = Math.fma(w, p2, c0);
      c1 = Math.fma(w, p3, c1);
      c2 = Math.fma(w, p4, c2);
      c3 = Math.fma(w, p5, c3);
      w = weights[at + 3 * stride];
      d0 = Math.fma(w, p0, d0);
      d1 = Math.fma(w, p1, d1);
      d2 = Math.fma(w, p2, d2);
      d3 = Math.fma(w, p3, d3);
      w = weights[at + 3 * stride + 1];
      d0 = Math.fma(w, p1, d0);
      d1 = Math.fma(w, p2, d1);
      d2 = Math.fma(w, p3, d2);
      d3 = Math.fma(w, p4, d3);
      w = weights[at + 3 * stride + 2];
      d0 = Math.fma(w, p2, d0);
      d1 = Math.fma(w, p3, d1);
      d2 = Math.fma(w, p4, d2);
      d3 = Math.fma(w, p5, d3);
    }
    sums[0] = a0;
    sums[1] = a1;
    sums[2] = a2;
    sums[3] = a3;
    sums[4] = b0;
    sums[5] = b1;
    sums[6] = b2;
    sums[7] = b3;
    sums[8] = c0;
    sums[9] = c1;
    sums[10] = c2;
    sums[11] = c3;
    sums[12] = d0;
    sums[13] = d1;
    sums[14] = d2;
    sums[15] = d3;
  }
}
