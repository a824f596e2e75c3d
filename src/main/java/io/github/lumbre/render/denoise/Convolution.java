package io.github.lumbre.render.denoise;

import io.github.lumbre.render.denoise.Network.Layer;
import java.util.Arrays;

/**
 * Convolutions of 3x3 taps, with their memory; one for each thread. Pixels that are computed
 * together are copied into arrays of their own, one for each tap, so that the loops use all arrays
 * at the same index.
 */
final class Convolution {
  /** Pixels that are computed together: a tap's inputs stay in the processor's first cache. */
  private static final int CHUNK = 512;

  private static final int TAPS = 9;

  private float[][] taps = new float[0][];
  private float[][] sums = new float[0][];

  /** Pixels beside each other: column, row and number. */
  private final int[][] runs = new int[CHUNK][3];

  private int runCount;
  private int pixels;

  /**
   * Computes rows of a layer, with negative values replaced by 0. Pixels that are not filtered stay
   * as they are.
   *
   * @param inputs maps of the same width whose planes are the layer's inputs, one after the other
   * @param first the first row; the inputs have the row above it, unless that is outside the tile
   * @param end after the last row
   * @param out receives the rows
   */
  void apply(Layer layer, Maps[] inputs, int first, int end, FilteredPart part, Maps out) {
    if (taps.length < TAPS * layer.inputs()) {
      taps = new float[TAPS * layer.inputs()][CHUNK];
    }
    if (sums.length < layer.outputs()) {
      sums = new float[layer.outputs()][CHUNK];
    }
    for (int y = first; y < end; y++) {
      int row = y;
      part.forEach(
          y,
          (left, right) -> {
            for (int x = left, count; x < right; x += count) {
              count = Math.min(right - x, CHUNK - pixels);
              gather(inputs, x, row, count);
              if (pixels == CHUNK) {
                finish(layer, out);
              }
            }
          });
    }
    finish(layer, out);
  }

  private void gather(Maps[] inputs, int x, int y, int count) {
    int tap = 0;
    for (Maps maps : inputs) {
      int corner = maps.at(y) + x - maps.stride() - 1;
      for (int i = 0; i < maps.count(); i++) {
        for (int t = 0; t < TAPS; t++) {
          int from = corner + t / 3 * maps.stride() + t % 3;
          System.arraycopy(maps.plane(i), from, taps[tap++], pixels, count);
        }
      }
    }
    int[] run = runs[runCount++];
    run[0] = x;
    run[1] = y;
    run[2] = count;
    pixels += count;
  }

  /** Computes the gathered pixels. */
  private void finish(Layer layer, Maps out) {
    for (int o = 0; o < layer.outputs(); o++) {
      Arrays.fill(sums[o], 0, pixels, layer.biases()[o]);
    }
    int all = TAPS * layer.inputs();
    for (int first = 0; first < all; first += TAPS) {
      for (int o = 0; o < layer.outputs(); o += 2) {
        for (int t = first; t < first + TAPS; t += 3) {
          int at = o * all + t;
          Loops.addThree(taps, t, sums[o], sums[o + 1], pixels, layer.weights(), at, at + all);
        }
      }
    }
    for (int o = 0; o < layer.outputs(); o++) {
      Loops.rectify(sums[o], pixels);
      scatter(sums[o], out, o);
    }
    runCount = 0;
    pixels = 0;
  }

  private void scatter(float[] from, Maps out, int plane) {
    int at = 0;
    for (int i = 0; i < runCount; i++) {
      int[] run = runs[i];
      System.arraycopy(from, at, out.plane(plane), out.at(run[1]) + run[0], run[2]);
      at += run[2];
    }
  }
}
