package io.github.lumbre.denoise;

import java.util.Arrays;

/**
 * The weights of the pixels around some pixels of a tile, the <i>anchors</i>. For each offset, the
 * distances of all values of the tile are computed at once, since the squares of neighbors that are
 * compared overlap. Mutable: one object serves many tiles of a thread.
 */
final class Neighborhoods {
  static final int TILE_WIDTH = 128;
  static final int TILE_HEIGHT = 4;

  private static final int CHANNELS = 3;
  private static final int REACH = Similarity.PATCH;

  /** Smaller weights are 0. */
  private static final float LEAST_WEIGHT = 1e-4f;

  private final Similarity similarity;
  private final int radius;
  private final int width;
  private final int height;

  /** Positions of the anchors, and how many there are in each row. */
  private final int[] across = new int[TILE_WIDTH * TILE_HEIGHT];

  private final int[] ends = new int[TILE_HEIGHT];
  private int top;
  private int rows;
  private int count;
  private float[] weights = new float[0];

  /** Distances of the rows of the tile and its surroundings, for one offset. */
  private final float[][] distances =
      new float[TILE_HEIGHT + 2 * REACH][CHANNELS * (TILE_WIDTH + 2 * REACH)];

  private final Similarity.Rows buffers = new Similarity.Rows(CHANNELS * (TILE_WIDTH + 2 * REACH));
  private final float[] sums = new float[CHANNELS * (TILE_WIDTH + 2 * REACH)];

  /**
   * @param radius half of the side of the square of pixels that get a weight
   */
  Neighborhoods(Similarity similarity, int radius) {
    this.similarity = similarity;
    this.radius = radius;
    width = similarity.color().width();
    height = similarity.color().height();
  }

  /** Starts a tile without anchors; its first row is at this height. */
  void start(int y) {
    top = y;
    rows = 0;
    count = 0;
  }

  /** Adds an anchor to the current row, from left to right. */
  void add(int x) {
    across[count++] = x;
  }

  /** Ends a row of the tile. */
  void endRow() {
    ends[rows++] = count;
  }

  int count() {
    return count;
  }

  /** Returns the column of an anchor. */
  int x(int anchor) {
    return across[anchor];
  }

  /** Returns the row of an anchor. */
  int y(int anchor) {
    int row = 0;
    while (ends[row] <= anchor) {
      row++;
    }
    return top + row;
  }

  /** Returns a weight; 0 outside of the picture. */
  float weight(int anchor, int dx, int dy) {
    return weights[anchor * side() * side() + (dy + radius) * side() + dx + radius];
  }

  private int side() {
    return 2 * radius + 1;
  }

  /** Computes the weights of all anchors. */
  void weigh() {
    int needed = count * side() * side();
    if (weights.length < needed) {
      weights = new float[needed];
    }
    Arrays.fill(weights, 0, needed, 0);
    if (count == 0) {
      return;
    }
    int left = width;
    int right = 0;
    for (int k = 0; k < count; k++) {
      left = Math.min(left, across[k]);
      right = Math.max(right, across[k]);
    }
    left = Math.max(0, left - REACH);
    right = Math.min(width, right + REACH + 1);
    for (int dy = -radius; dy <= radius; dy++) {
      for (int dx = -radius; dx <= radius; dx++) {
        weigh(dx, dy, Math.max(left, -dx), Math.min(right, width - dx));
      }
    }
  }

  /** Computes the weights of one offset from distances between two columns. */
  private void weigh(int dx, int dy, int left, int right) {
    if (left >= right) {
      return;
    }
    int first = 0;
    while (ends[first] == 0) {
      first++;
    }
    int last = rows - 1;
    while (last > 0 && ends[last - 1] == count) {
      last--;
    }
    int from = Math.max(Math.max(0, -dy), top + first - REACH);
    int to = Math.min(Math.min(height, height - dy), top + last + REACH + 1);
    int values = CHANNELS * (right - left);
    for (int y = from; y < to; y++) {
      int at = CHANNELS * (y * width + left);
      int shift = CHANNELS * (dy * width + dx);
      similarity.distances(at, shift, values, buffers, distances[y - top + REACH]);
    }
    for (int row = first; row <= last; row++) {
      int y = top + row;
      int start = row == 0 ? 0 : ends[row - 1];
      if (start != ends[row] && y + dy >= 0 && y + dy < height) {
        int above = Math.max(from, y - REACH);
        int below = Math.min(to, y + REACH + 1);
        sum(above, below, values);
        for (int k = start; k < ends[row]; k++) {
          if (across[k] >= left && across[k] < right) {
            weigh(k, y, dx, dy, left, right, below - above);
          }
        }
      }
    }
  }

  private void sum(int above, int below, int values) {
    float[] first = distances[above - top + REACH];
    System.arraycopy(first, 0, sums, 0, values);
    for (int y = above + 1; y < below; y++) {
      float[] more = distances[y - top + REACH];
      for (int i = 0; i < values; i++) {
        sums[i] += more[i];
      }
    }
  }

  private void weigh(int anchor, int y, int dx, int dy, int left, int right, int patchRows) {
    int x = across[anchor];
    int start = Math.max(left, x - REACH);
    int end = Math.min(right, x + REACH + 1);
    float sum = 0;
    for (int i = CHANNELS * (start - left); i < CHANNELS * (end - left); i++) {
      sum += sums[i];
    }
    float distance = sum / (CHANNELS * (end - start) * patchRows);
    int p = y * width + x;
    float weight = dx == 0 && dy == 0 ? 1 : similarity.weight(p, p + dy * width + dx, distance);
    if (weight >= LEAST_WEIGHT) {
      weights[anchor * side() * side() + (dy + radius) * side() + dx + radius] = weight;
    }
  }
}
