package io.github.lumbre.render;

import io.github.lumbre.integrator.SampleLayers;
import io.github.lumbre.render.FirstMeans.FirstMean;
import io.github.lumbre.scene.Layer;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The exact sums of the layers of a film's pixels; see {@link LayerGrid}. Mutable; different
 * threads may write different pixels.
 */
final class LayerSums {
  private static final double UNIT = 0x1p-32;

  /** The largest magnitude of a value in sums of 64 bits. */
  private static final long ONE = 1L << 32;

  /** The largest magnitude of a value in sums of 128 bits. */
  private static final double LARGEST = 0x1p31;

  /** Bits of one packed component of the mean of a first half. */
  private static final int MEAN_BITS = 21;

  private static final long MEAN_MASK = (1L << MEAN_BITS) - 1;
  private static final long NO_MEAN = 0;

  private final FilmLayers layers;

  /** The layers with sums of 64 bits, with sums of 128 bits, and with means of first halves. */
  private final Layer[] narrow, wide;

  private final List<Layer> guides;

  /** For each layer, the number of sums of its kind before it. */
  private final int[] offsets = new int[Layer.values().length];

  /** For each guide, the number of guides before it. */
  private final int[] guideOrder = new int[Layer.values().length];

  private final int narrowCount, wideCount;
  private final long[] narrowSums;
  private final ExactSums wideSums;
  private final long[] means;

  /** The number of each pixel's samples that hit a surface. */
  private final int[] hits;

  private final PrimitiveCounts counts;

  LayerSums(FilmLayers layers, int pixels) {
    this.layers = layers;
    narrow = with(LayerGrid.UNIT, LayerGrid.GUIDE).toArray(Layer[]::new);
    wide = with(LayerGrid.WIDE).toArray(Layer[]::new);
    guides = with(LayerGrid.GUIDE);
    guides.forEach(guide -> guideOrder[guide.ordinal()] = guides.indexOf(guide));
    narrowCount = setOffsets(narrow);
    wideCount = setOffsets(wide);
    narrowSums = new long[Math.multiplyExact(pixels, narrowCount)];
    wideSums = new ExactSums(Math.multiplyExact(pixels, wideCount));
    means = new long[Math.multiplyExact(pixels, guides.size())];
    hits = new int[layers.countsHits() ? pixels : 0];
    counts = new PrimitiveCounts(layers.countsPrimitives() ? pixels : 0);
  }

  private List<Layer> with(LayerGrid... grids) {
    List<Layer> with = new ArrayList<>();
    for (Layer layer : layers.stored()) {
      if (Arrays.asList(grids).contains(LayerGrid.of(layer))) {
        with.add(layer);
      }
    }
    return with;
  }

  /** Sets the offsets of layers that follow each other. Returns the number of their sums. */
  private int setOffsets(Layer[] sequence) {
    int offset = 0;
    for (Layer layer : sequence) {
      offsets[layer.ordinal()] = offset;
      offset += layers.channels(layer);
    }
    return offset;
  }

  FilmLayers layers() {
    return layers;
  }

  PrimitiveCounts counts() {
    return counts;
  }

  int hits(int pixel) {
    return hits[pixel];
  }

  /**
   * Adds the next sample of a pixel.
   *
   * @param before number of the pixel's samples so far
   */
  void add(int pixel, SampleLayers sample, int before) {
    if ((before & before - 1) == 0 && before != 0) {
      setMeans(pixel, before);
    }
    int at = pixel * narrowCount;
    for (Layer layer : narrow) {
      for (double value : sample.of(layer)) {
        // NaN becomes 0.
        long units = (long) Math.rint(value / UNIT);
        narrowSums[at++] += Math.max(-ONE, Math.min(ONE, units));
      }
    }
    at = pixel * wideCount;
    for (Layer layer : wide) {
      for (double value : sample.of(layer)) {
        wideSums.addSigned(at++, Math.max(-LARGEST, Math.min(LARGEST, orZero(value))));
      }
    }
    int primitive = sample.primitive();
    if (primitive >= 0) {
      if (hits.length != 0) {
        hits[pixel]++;
      }
      counts.add(pixel, primitive, 1);
    }
  }

  private static double orZero(double value) {
    return Double.isNaN(value) ? 0 : value;
  }

  /**
   * Adds the sums of a pixel of other layers of the same kind.
   *
   * @param count number of this pixel's samples
   */
  void addAll(LayerSums other, int from, int to, FirstMean mean, int count) {
    switch (mean) {
      case KEPT -> {}
      case LOST -> Arrays.fill(means, to * guides.size(), (to + 1) * guides.size(), NO_MEAN);
      case OF_OTHER ->
          System.arraycopy(
              other.means, from * guides.size(), means, to * guides.size(), guides.size());
      case OF_ALL -> setMeans(to, count);
    }
    for (int i = 0; i < narrowCount; i++) {
      narrowSums[to * narrowCount + i] += other.narrowSums[from * narrowCount + i];
    }
    for (int i = 0; i < wideCount; i++) {
      wideSums.add(to * wideCount + i, other.wideSums, from * wideCount + i);
    }
    if (hits.length != 0) {
      hits[to] += other.hits[from];
    }
    counts.addAll(other.counts, from, to);
  }

  /** Stores the means of all samples of a pixel so far. */
  private void setMeans(int pixel, int count) {
    for (int guide = 0; guide < guides.size(); guide++) {
      int first = pixel * narrowCount + offsets[guides.get(guide).ordinal()];
      long packed = 1;
      int channels = layers.channels(guides.get(guide));
      for (int i = 0; i < 3; i++) {
        double mean = i < channels ? narrowSums[first + i] * UNIT / count : 0;
        packed = packed << MEAN_BITS | Math.round((mean + 1) / 2 * MEAN_MASK);
      }
      means[pixel * guides.size() + guide] = packed;
    }
  }

  /** Copies all values of other layers of the same kind and size. */
  void set(LayerSums other) {
    System.arraycopy(other.narrowSums, 0, narrowSums, 0, narrowSums.length);
    wideSums.set(other.wideSums);
    System.arraycopy(other.means, 0, means, 0, means.length);
    System.arraycopy(other.hits, 0, hits, 0, hits.length);
    counts.set(other.counts);
  }

  /**
   * Returns the sum of a layer's channel over a pixel's samples.
   *
   * @param layer with sums of 64 or 128 bits
   */
  double sum(Layer layer, int channel, int pixel) {
    if (LayerGrid.of(layer) == LayerGrid.WIDE) {
      return wideSums.get(pixel * wideCount + offsets[layer.ordinal()] + channel);
    }
    return narrowSums[pixel * narrowCount + offsets[layer.ordinal()] + channel] * UNIT;
  }

  /** Returns the whole part of a sum of 128 bits. */
  long whole(Layer layer, int channel, int pixel) {
    return wideSums.whole(pixel * wideCount + offsets[layer.ordinal()] + channel);
  }

  /** Returns the fraction of a sum of 128 bits, in units of 2^-64. */
  long fraction(Layer layer, int channel, int pixel) {
    return wideSums.fraction(pixel * wideCount + offsets[layer.ordinal()] + channel);
  }

  /** Returns whether a guide's mean of the first half of a pixel's samples is known. */
  boolean hasFirstMean(Layer layer, int pixel) {
    return means[pixel * guides.size() + guideOrder[layer.ordinal()]] != NO_MEAN;
  }

  /** Returns a component of a guide's mean of the first half of a pixel's samples, to 2^-20. */
  double firstMean(Layer layer, int channel, int pixel) {
    long packed = means[pixel * guides.size() + guideOrder[layer.ordinal()]];
    long bits = packed >>> MEAN_BITS * (2 - channel) & MEAN_MASK;
    return 2.0 * bits / MEAN_MASK - 1;
  }

  /** Returns the largest number of bytes of a pixel that hits some primitives. */
  int encodedBytes(int pixel) {
    return Long.BYTES * (narrowCount + guides.size())
        + wideCount * (FilmNumbers.MAX_BYTES + Long.BYTES)
        + FilmNumbers.MAX_BYTES
        + counts.encodedBytes(pixel);
  }

  /**
   * Writes a pixel that has samples: sums of 64 bits, means of first halves, sums of 128 bits, the
   * number of samples that hit a surface, and the primitives.
   */
  void encode(int pixel, ByteBuffer out) {
    for (int i = 0; i < narrowCount; i++) {
      out.putLong(Long.reverseBytes(narrowSums[pixel * narrowCount + i]));
    }
    for (int i = 0; i < guides.size(); i++) {
      out.putLong(Long.reverseBytes(means[pixel * guides.size() + i]));
    }
    for (int i = pixel * wideCount; i < (pixel + 1) * wideCount; i++) {
      // The sign moves to the lowest bit, so that small numbers stay short.
      long whole = wideSums.whole(i);
      FilmNumbers.put(out, whole << 1 ^ whole >> Long.SIZE - 1);
      out.putLong(Long.reverseBytes(wideSums.fraction(i)));
    }
    if (hits.length != 0) {
      FilmNumbers.put(out, hits[pixel]);
    }
    counts.encode(pixel, out);
  }

  /**
   * Reads a pixel in the format of {@link #encode}.
   *
   * @param count number of the pixel's samples
   * @throws IllegalArgumentException if the bytes are not a valid pixel
   */
  void decode(int pixel, int count, ByteBuffer in) {
    for (int i = 0; i < narrowCount; i++) {
      long sum = Long.reverseBytes(in.getLong());
      if (Math.abs(sum * UNIT) > count) {
        throw new IllegalArgumentException("expected a layer up to " + count + ", found more");
      }
      narrowSums[pixel * narrowCount + i] = sum;
    }
    for (int i = 0; i < guides.size(); i++) {
      means[pixel * guides.size() + i] = Long.reverseBytes(in.getLong());
    }
    long largest = 2 * (long) LARGEST * count + 1;
    for (int i = pixel * wideCount; i < (pixel + 1) * wideCount; i++) {
      long zigzag = FilmNumbers.get(in, largest);
      wideSums.set(i, zigzag >>> 1 ^ -(zigzag & 1), Long.reverseBytes(in.getLong()));
    }
    if (hits.length != 0) {
      hits[pixel] = (int) FilmNumbers.get(in, count);
    }
    counts.decode(pixel, count, in);
  }
}
