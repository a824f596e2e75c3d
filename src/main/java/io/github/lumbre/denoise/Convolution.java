package io.github.lumbre.denoise;

import io.github.lumbre.denoise.Network.Layer;
import java.util.Arrays;

/**
 * Convolutions of 3x3 taps, with their memory; one for each thread. Rows are copied into arrays of
 * their own, one for each tap, so that the loops use all arrays at the same index.
 */
final class Convolution {
  /** Pixels that are computed together: their inputs stay in the processor's cache. */
  private static final int CHUNK = 512;

  private static final int TAPS = 9;

  private float[][] taps = new float[0][];
  private float[] sum = new float[0];
  private float[] otherSum = new float[0];

  /**
   * Computes rows of a layer, with negative values replaced by 0.
   *
   * @param inputs maps of the same width whose planes are the layer's inputs, one after the other
   * @param first the first row; the inputs have the row above it, unless that is outside the tile
   * @param end after the last row
   * @param out receives the rows
   */
  void apply(Layer layer, Maps[] inputs, int first, int end, Maps out) {
    int width = out.width();
    int rows = Math.max(1, CHUNK / out.stride());
    int columns = rows > 1 ? width : Math.min(width, CHUNK);
    prepare(TAPS * layer.inputs(), rows > 1 ? rows * out.stride() : columns);
    for (int y = first; y < end; y += rows) {
      int height = Math.min(rows, end - y);
      for (int x = 0; x < width; x += columns) {
        int count = height > 1 ? height * out.stride() - 2 : Math.min(columns, width - x);
        gather(inputs, x, y, count);
        for (int o = 0; o < layer.outputs(); o += 2) {
          sums(layer, o, count);
          scatter(sum, out, o, x, y, height, count);
          scatter(otherSum, out, o + 1, x, y, height, count);
        }
      }
    }
  }

  private void prepare(int arrays, int length) {
    if (taps.length < arrays || sum.length < length) {
      taps = new float[arrays][length];
      sum = new float[length];
      otherSum = new float[length];
    }
  }

  private void gather(Maps[] inputs, int x, int y, int count) {
    int tap = 0;
    for (Maps maps : inputs) {
      int corner = maps.at(y) + x - maps.stride() - 1;
      for (int i = 0; i < maps.count(); i++) {
        for (int t = 0; t < TAPS; t++) {
          int from = corner + t / 3 * maps.stride() + t % 3;
          System.arraycopy(maps.plane(i), from, taps[tap++], 0, count);
        }
      }
    }
  }

  private void sums(Layer layer, int output, int count) {
    Arrays.fill(sum, 0, count, layer.biases()[output]);
    Arrays.fill(otherSum, 0, count, layer.biases()[output + 1]);
    int all = TAPS * layer.inputs();
    int at = output * all;
    for (int t = 0; t < all; t += 3) {
      Loops.addThree(taps, t, sum, otherSum, count, layer.weights(), at + t, at + all + t);
    }
    Loops.rectify(sum, count);
    Loops.rectify(otherSum, count);
  }

  private static void scatter(
      float[] from, Maps out, int plane, int x, int y, int height, int count) {
    for (int r = 0; r < height; r++) {
      int length = height > 1 ? out.width() : count;
      System.arraycopy(from, r * out.stride(), out.plane(plane), out.at(y + r) + x, length);
    }
  }
}
