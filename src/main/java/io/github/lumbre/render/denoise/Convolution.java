package io.github.lumbre.render.denoise;

import io.github.lumbre.math.internal.FusedMultiplyAdd;
import io.github.lumbre.render.denoise.Network.Layer;
import java.util.Arrays;
import java.util.Optional;

/**
 * Convolutions of 3x3 taps, with their memory; one for each thread. Pixels that are computed
 * together are copied into arrays of their own, one for each tap of an input, so that the loops use
 * all arrays at the same index.
 */
final class Convolution {
  /**
   * Pixels that are computed together: an input's taps stay in the processor's first cache. With
   * the 16 bytes before their values, arrays of this length take whole cache lines, so that all of
   * those that are made together begin at the same distance from one, and the loops, which begin
   * vectors of one array at a cache line, do so of all.
   */
  private static final int CHUNK = 524;

  private static final int TAPS = 9;

  private final Optional<ScalarConvolution> scalar;
  private final float[][] taps = new float[TAPS][CHUNK];
  private float[][] sums = new float[0][];

  /** Pixels beside each other: column, row and number. */
  private final int[][] runs = new int[CHUNK][3];

  private int runCount;
  private int pixels;

  /**
   * @param isScalar whether {@link ScalarConvolution} computes, with the same results
   */
  Convolution(boolean isScalar) {
    scalar = isScalar ? Optional.of(new ScalarConvolution()) : Optional.empty();
  }

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
    if (scalar.isEmpty() && sums.length < layer.outputs()) {
      sums = new float[layer.outputs()][CHUNK];
    }
    for (int y = first; y < end; y++) {
      int row = y;
      part.forEach(y, (left, right) -> apply(layer, inputs, left, right, row, out));
    }
    finish(layer, inputs, out);
  }

  private void apply(Layer layer, Maps[] inputs, int left, int right, int y, Maps out) {
    if (scalar.isPresent()) {
      scalar.get().apply(layer, inputs, left, right, y, out);
      return;
    }
    for (int x = left, count; x < right; x += count) {
      count = Math.min(right - x, CHUNK - pixels);
      add(x, y, count);
      if (pixels == CHUNK) {
        finish(layer, inputs, out);
      }
    }
  }

  private void add(int x, int y, int count) {
    int[] run = runs[runCount++];
    run[0] = x;
    run[1] = y;
    run[2] = count;
    pixels += count;
  }

  /** Computes the pixels of all runs. */
  private void finish(Layer layer, Maps[] inputs, Maps out) {
    if (pixels == 0) {
      return;
    }
    for (int o = 0; o < layer.outputs(); o++) {
      Arrays.fill(sums[o], 0, pixels, layer.biases()[o]);
    }
    int weight = 0;
    for (Maps maps : inputs) {
      for (int i = 0; i < maps.count(); i++) {
        gather(maps, maps.plane(i));
        accumulate(layer, weight);
        weight += TAPS;
      }
    }
    for (int o = 0; o < layer.outputs(); o++) {
      Loops.rectify(sums[o], 0, pixels);
      scatter(sums[o], out, out.plane(o));
    }
    runCount = 0;
    pixels = 0;
  }

  private void gather(Maps maps, float[] plane) {
    int to = 0;
    for (int i = 0; i < runCount; i++) {
      int[] run = runs[i];
      int from = maps.at(run[1] - 1) + run[0] - 1;
      for (int t = 0; t < taps.length; t++) {
        System.arraycopy(plane, from + t / 3 * maps.stride() + t % 3, taps[t], to, run[2]);
      }
      to += run[2];
    }
  }

  /** Adds the gathered input to all sums. */
  private void accumulate(Layer layer, int weight) {
    int stride = layer.stride();
    for (int o = 0; o < layer.outputs(); o += 2) {
      int at = o * stride + weight;
      add(0, o, layer, at);
      add(3, o, layer, at + 3);
      add(6, o, layer, at + 6);
    }
  }

  private void add(int tap, int o, Layer layer, int at) {
    int other = at + layer.stride();
    boolean isFused = FusedMultiplyAdd.isFast();
    Loops.addThree(
        taps, tap, sums[o], sums[o + 1], pixels, layer.weights(), at, other, isFused);
  }

  private void scatter(float[] from, Maps out, float[] plane) {
    int at = 0;
    for (int i = 0; i < runCount; i++) {
      int[] run = runs[i];
      System.arraycopy(from, at, plane, out.at(run[1]) + run[0], run[2]);
      at += run[2];
    }
  }
}
