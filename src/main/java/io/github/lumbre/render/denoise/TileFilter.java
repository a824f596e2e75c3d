package io.github.lumbre.render.denoise;

import io.github.lumbre.render.denoise.Network.Layer;

/** The network over a tile of a picture. */
final class TileFilter {
  /** Sides of tiles are multiples of it, so that all levels have whole pixels. */
  static final int UNIT = 1 << Network.LEVELS - 1;

  private final Network network = Network.get();
  private final Features picture;
  private final FilteredUnits units;
  private final Workers workers;
  private final int left;
  private final int top;
  private final int width;
  private final int height;

  /**
   * @param left the tile's first column, counted as {@link Features} does, a multiple of {@link
   *     #UNIT}
   * @param top the first row, a multiple of {@link #UNIT}
   * @param width a multiple of {@link #UNIT}; beyond the picture are its mirror images
   * @param height a multiple of {@link #UNIT}
   */
  TileFilter(
      Features picture,
      FilteredUnits units,
      Workers workers,
      int left,
      int top,
      int width,
      int height) {
    this.picture = picture;
    this.units = units;
    this.workers = workers;
    this.left = left;
    this.top = top;
    this.width = width;
    this.height = height;
  }

  /** Returns the filtered light at full size. */
  FilterLevel filtered() throws InterruptedException {
    Maps[] encoded = encoded();
    Maps[] decoded = new Maps[Network.LEVELS];
    decoded[Network.LEVELS - 1] = encoded[Network.LEVELS - 1];
    for (int level = Network.LEVELS - 2; level > 0; level--) {
      decoded[level] = decoded(level, decoded[level + 1], encoded[level]);
    }
    FilterLevel[] levels = new FilterLevel[Network.LEVELS];
    for (int level = 0; level < Network.LEVELS; level++) {
      levels[level] = new FilterLevel(level, width >> level, height >> level, picture.planes());
    }
    filterFinest(decoded[1], encoded[0], levels);
    for (int level = 1; level < Network.LEVELS; level++) {
      filter(level, decoded[level], levels);
    }
    for (int level = Network.LEVELS - 2; level >= 0; level--) {
      combine(levels[level], levels[level + 1]);
    }
    return levels[0];
  }

  private FilteredPart part(int level) {
    return new FilteredPart(units, left, top, width >> level, level);
  }

  private Maps maps(int level, int planes) {
    return new Maps(width >> level, 0, height >> level, planes);
  }

  /** Returns the features of each level, from the finest to the coarsest. */
  private Maps[] encoded() throws InterruptedException {
    Maps[] encoded = new Maps[Network.LEVELS];
    Maps pooled = null;
    for (int level = 0; level < Network.LEVELS; level++) {
      Maps in = pooled;
      Maps out = maps(level, network.down(level)[1].outputs());
      Maps next = level + 1 < Network.LEVELS ? maps(level + 1, out.count()) : null;
      Layer[] layers = network.down(level);
      FilteredPart part = part(level);
      FilteredPart coarse = part(level + 1);
      workers.compute(
          height >> level,
          (first, end, convolution) -> {
            Maps from = in == null ? features(first, end) : in;
            pair(layers, new Maps[] {from}, first, end, part, convolution, out);
            if (next != null) {
              pool(out, next, first / 2, end / 2, coarse);
            }
          });
      encoded[level] = out;
      pooled = next;
    }
    return encoded;
  }

  /** Returns the features of a strip and of two rows on each side, as far as the tile has them. */
  private Maps features(int first, int end) {
    Maps features = new Maps(width, first - 2, end - first + 4, Network.FEATURES);
    for (int y = Math.max(0, first - 2); y < Math.min(height, end + 2); y++) {
      int row = y;
      part(0).forEach(y, (x, right) -> picture.write(left, top + row, features, row, x, right));
    }
    return features;
  }

  /** Computes two layers of a strip, without keeping the features between them. */
  private void pair(
      Layer[] layers,
      Maps[] inputs,
      int first,
      int end,
      FilteredPart part,
      Convolution convolution,
      Maps out) {
    int rows = height >> part.level();
    Layer before = layers[0];
    Maps between = new Maps(out.width(), first - 1, end - first + 2, before.outputs());
    convolution.apply(
        before, inputs, Math.max(0, first - 1), Math.min(rows, end + 1), part, between);
    convolution.apply(layers[1], new Maps[] {between}, first, end, part, out);
  }

  private static void pool(Maps fine, Maps coarse, int first, int end, FilteredPart part) {
    int below = fine.stride();
    for (int y = first; y < end; y++) {
      int row = y;
      part.forEach(
          y,
          (left, right) -> {
            for (int c = 0; c < fine.count(); c++) {
              float[] from = fine.plane(c);
              for (int x = left; x < right; x++) {
                int i = fine.at(2 * row) + 2 * x;
                float upper = Math.max(from[i], from[i + 1]);
                float lower = Math.max(from[i + below], from[i + below + 1]);
                coarse.plane(c)[coarse.at(row) + x] = Math.max(upper, lower);
              }
            }
          });
    }
  }

  private Maps decoded(int level, Maps coarser, Maps encoded) throws InterruptedException {
    Layer[] layers = network.up(level);
    Maps out = maps(level, layers[1].outputs());
    workers.compute(
        height >> level,
        (first, end, convolution) ->
            pair(
                layers,
                joined(level, coarser, encoded, first, end),
                first,
                end,
                part(level),
                convolution,
                out));
    return out;
  }

  /** Returns a coarser level at twice its size, and beside it the features of the finer level. */
  private Maps[] joined(int level, Maps coarser, Maps encoded, int first, int end) {
    Maps doubled = new Maps(encoded.width(), first - 2, end - first + 4, coarser.count());
    for (int y = Math.max(0, first - 2); y < Math.min(height >> level, end + 2); y++) {
      int from = coarser.at(y / 2);
      int to = doubled.at(y);
      part(level)
          .forEach(
              y,
              (left, right) -> {
                for (int c = 0; c < coarser.count(); c++) {
                  twice(coarser.plane(c), from, doubled.plane(c), to, left / 2, right / 2);
                }
              });
    }
    return new Maps[] {doubled, encoded};
  }

  /** Writes each value of a row, from one to another, to two pixels of a finer one. */
  private static void twice(float[] row, int from, float[] fine, int to, int left, int right) {
    for (int x = left; x < right; x++) {
      float value = row[from + x];
      fine[to + 2 * x] = value;
      fine[to + 2 * x + 1] = value;
    }
  }

  private void filterFinest(Maps coarser, Maps encoded, FilterLevel[] levels)
      throws InterruptedException {
    Layer[] layers = network.up(0);
    FilterLevel.Light light =
        (x, y, rows, count) -> picture.writeLight(left + x, top + y, rows, count);
    workers.compute(
        height,
        (first, end, convolution) -> {
          Maps decoded = new Maps(width, first, end - first, layers[1].outputs());
          Maps[] inputs = joined(0, coarser, encoded, first, end);
          pair(layers, inputs, first, end, part(0), convolution, decoded);
          new LevelFilter(network.head(0), levels[0], levels[1], light)
              .apply(decoded, first, end, part(0));
        });
  }

  private void filter(int index, Maps decoded, FilterLevel[] levels) throws InterruptedException {
    FilterLevel level = levels[index];
    FilterLevel next = index + 1 < levels.length ? levels[index + 1] : null;
    workers.compute(
        level.height,
        (first, end, convolution) ->
            new LevelFilter(network.head(index), level, next, level.light())
                .apply(decoded, first, end, part(index)));
  }

  private void combine(FilterLevel level, FilterLevel coarser) throws InterruptedException {
    float[][] change = new float[coarser.filtered.length][coarser.width * coarser.height];
    workers.compute(
        coarser.height, (first, end, convolution) -> coarser.subtract(level, change, first, end));
    workers.compute(level.height, (first, end, convolution) -> level.add(change, first, end));
  }
}
