package io.github.lumbre.render.denoise;

import io.github.lumbre.math.internal.FusedMultiplyAdd;
import io.github.lumbre.render.denoise.Network.Layer;
import java.util.Arrays;

/** Filters rows of a level with predicted kernels, and pools their light into the next level. */
final class LevelFilter {
  /** Pixels that are computed together, an even number; whole cache lines, as in convolutions. */
  private static final int CHUNK = 268;

  private static final float[] ONES = ones();
  private static final int RADIUS = Network.SIDE / 2;
  private static final float LARGEST_EXPONENT = 8;

  private final Layer head;
  private final FilterLevel level;
  private final FilterLevel next;
  private final FilterLevel.Light source;
  private final int planes;
  private final float[][] inputs;
  private final float[][] outputs;
  private final float[][] wide;

  /** By row modulo the side of the kernels, plane and shift. */
  private final float[][][][] shifted;

  private final float[] largest = new float[CHUNK];
  private final float[] sums = new float[CHUNK];
  private final float[] weights = new float[CHUNK];
  private final float[] result = new float[CHUNK];

  /**
   * @param next the next coarser level; null for the coarsest
   */
  LevelFilter(Layer head, FilterLevel level, FilterLevel next, FilterLevel.Light source) {
    this.head = head;
    this.level = level;
    this.next = next;
    this.source = source;
    planes = level.filtered.length;
    inputs = new float[head.stride()][CHUNK];
    outputs = new float[(head.outputs() + 1) / 2 * 2][CHUNK];
    wide = new float[planes][CHUNK + 2 * RADIUS];
    shifted = new float[Network.SIDE][planes][Network.SIDE][CHUNK];
  }

  /**
   * @param decoded the inputs of the head
   * @param first an even number
   */
  void apply(Maps decoded, int first, int end, FilteredPart part) {
    for (int y = first, bottom; y < end; y = bottom) {
      bottom = part.bottom(y, end);
      for (int x = 0, right; x < level.width; x = right) {
        right = Math.min(part.end(x, y), x + CHUNK);
        if (part.contains(x, y)) {
          apply(decoded, x, y, bottom, right - x);
        } else if (next != null) {
          poolEvenly(x, y, bottom, right - x);
        }
      }
    }
  }

  private void apply(Maps decoded, int x, int first, int end, int count) {
    for (int y = first - RADIUS; y < first + RADIUS; y++) {
      shift(x, y, count);
    }
    for (int y = first; y < end; y++) {
      shift(x, y + RADIUS, count);
      predict(decoded, x, y, count);
      filter(x, y, count);
      int at = y * level.width + x;
      System.arraycopy(outputs[Network.SHARE], 0, level.share, at, count);
      if (level.mix.length != 0) {
        Loops.sigmoids(outputs[Network.MIX], count);
        System.arraycopy(outputs[Network.MIX], 0, level.mix, at, count);
      }
      if (next != null) {
        pool(x, y, count);
      }
    }
  }

  /** Pools pixels that are not filtered, as if the network predicted equal weights. */
  private void poolEvenly(int x, int first, int end, int count) {
    Arrays.fill(outputs[Network.WEIGHT], 0);
    for (int y = first; y < end; y++) {
      shift(x, y, count);
      pool(x, y, count);
    }
  }

  private float[][][] row(int y) {
    return shifted[Math.floorMod(y, Network.SIDE)];
  }

  private void shift(int x, int y, int count) {
    source.write(x - RADIUS, y, wide, count + 2 * RADIUS);
    for (int c = 0; c < planes; c++) {
      for (int d = 0; d < Network.SIDE; d++) {
        System.arraycopy(wide[c], d, row(y)[c][d], 0, count);
      }
    }
  }

  private void predict(Maps decoded, int x, int y, int count) {
    for (int i = 0; i < head.inputs(); i++) {
      System.arraycopy(decoded.plane(i), decoded.at(y) + x, inputs[i], 0, count);
    }
    boolean isFused = FusedMultiplyAdd.isFast();
    for (int o = 0; o < outputs.length; o += 2) {
      int second = Math.min(o + 1, head.outputs() - 1);
      Arrays.fill(outputs[o], head.biases()[o]);
      Arrays.fill(outputs[o + 1], head.biases()[second]);
      for (int i = 0; i < head.stride(); i += 3) {
        int at = o * head.stride() + i;
        int otherAt = second * head.stride() + i;
        float[] all = head.weights();
        Loops.addThree(inputs, i, outputs[o], outputs[o + 1], count, all, at, otherAt, isFused);
      }
    }
    Loops.sigmoids(outputs[Network.SHARE], count);
  }

  private void filter(int x, int y, int count) {
    System.arraycopy(outputs[0], 0, largest, 0, count);
    for (int t = 1; t < Network.TAPS; t++) {
      Loops.raiseTo(largest, outputs[t], count);
    }
    Arrays.fill(sums, 0);
    for (int t = 0; t < Network.TAPS; t++) {
      Loops.exponentials(outputs[t], largest, sums, count);
    }
    for (int c = 0; c < planes; c++) {
      Arrays.fill(result, 0);
      for (int d = 0; d < Network.SIDE; d++) {
        float[][] near = row(y + d - RADIUS)[c];
        for (int t = 0; t < Network.SIDE; t++) {
          Loops.addProduct(outputs[d * Network.SIDE + t], near[t], result, count);
        }
      }
      Loops.divide(result, sums, result, count);
      System.arraycopy(result, 0, level.filtered[c], y * level.width + x, count);
    }
  }

  /** Adds a row to the weighted means of 2x2 pixels. */
  private void pool(int x, int y, int count) {
    if (level.weight.length == 0) {
      Arrays.fill(weights, 1);
    } else {
      System.arraycopy(level.weight, y * level.width + x, weights, 0, count);
    }
    Loops.scaleByExponentials(weights, outputs[Network.WEIGHT], LARGEST_EXPONENT, count);
    int at = y / 2 * next.width + x / 2;
    pool(weights, ONES, next.weight, at, count);
    for (int c = 0; c < planes; c++) {
      pool(weights, row(y)[c][RADIUS], next.light[c], at, count);
    }
    if (y % 2 != 0) {
      for (float[] plane : next.light) {
        divide(plane, next.weight, at, at + count / 2);
      }
      for (int i = at; i < at + count / 2; i++) {
        next.weight[i] *= .25f;
      }
    }
  }

  /** Adds the weighted values of every two pixels to one. */
  private static void pool(float[] weights, float[] values, float[] to, int at, int count) {
    for (int i = 0; i < count / 2; i++) {
      to[at + i] += weights[2 * i] * values[2 * i] + weights[2 * i + 1] * values[2 * i + 1];
    }
  }

  private static void divide(float[] values, float[] divisors, int from, int to) {
    for (int i = from; i < to; i++) {
      values[i] /= divisors[i];
    }
  }

  private static float[] ones() {
    float[] ones = new float[CHUNK];
    Arrays.fill(ones, 1);
    return ones;
  }
}
