package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * Sums of samples, exact: each value is rounded once to a multiple of 2^-64 and added in 128 bits,
 * so that the same samples give the same bits in whatever order and grouping they arrive. Mutable;
 * different threads may write different pixels.
 *
 * <p>A film holds a window of the full frame. Each pixel has samples of consecutive numbers, from
 * the film's first one on, and knows how many, so that pixels may have different ones.
 *
 * <p>Beside the sums, it keeps the mean of each pixel's samples up to the last power of two before
 * their number, from which {@link #halves} tells the noise; it is rounded, and no part of the
 * picture.
 *
 * <p>Takes 60 bytes a pixel, 64 with alpha.
 */
public final class Film {
  /** What one sample value is cut to: 2^30 of them still fit. */
  static final double LARGEST = 0x1p32;

  /** What a pixel takes at most when it is written. */
  public static final int MAX_PIXEL_BYTES = 2 * 5 + 3 * (9 + Long.BYTES) + Long.BYTES;

  private final Crop window;
  private final int firstSample;

  /** Whole parts and fractions (in units of 2^-64, unsigned) of the sums, three a pixel. */
  private final long[] whole;

  private final long[] fraction;
  private final int[] counts;

  /** How many of a pixel's samples cover it; empty if all do. */
  private final int[] covered;

  /** The mean of each pixel's samples up to the last power of two before their number, packed. */
  private final long[] firstMeans;

  /**
   * An empty film.
   *
   * @param firstSample the number of each pixel's first sample, at least 0
   */
  public Film(Crop window, boolean hasAlpha, int firstSample) {
    this.window = Objects.requireNonNull(window, "window");
    if (firstSample < 0) {
      throw new IllegalArgumentException("firstSample: expected at least 0, found " + firstSample);
    }
    this.firstSample = firstSample;
    int pixels = Math.multiplyExact(window.width(), window.height());
    whole = new long[Math.multiplyExact(3, pixels)];
    fraction = new long[3 * pixels];
    counts = new int[pixels];
    covered = new int[hasAlpha ? pixels : 0];
    firstMeans = new long[pixels];
  }

  /** Returns the part of the full frame that this film holds. */
  public Crop window() {
    return window;
  }

  /** Tells whether it is known how many of a pixel's samples cover it. */
  public boolean hasAlpha() {
    return covered.length != 0;
  }

  /** Returns the number of each pixel's first sample. */
  public int firstSample() {
    return firstSample;
  }

  /** Returns how many samples a pixel of the full frame, inside the window, has. */
  public int samples(int x, int y) {
    Objects.checkIndex(x - window.x(), window.width());
    Objects.checkIndex(y - window.y(), window.height());
    return counts[index(x, y)];
  }

  /** Returns how many samples the pixel with the fewest has. */
  public int fewestSamples() {
    return Arrays.stream(counts).min().getAsInt();
  }

  /** Returns how many samples the pixel with the most has. */
  public int mostSamples() {
    return Arrays.stream(counts).max().getAsInt();
  }

  /** Returns the share of pixels that have no sample. */
  public double shareWithoutSamples() {
    return Arrays.stream(counts).filter(count -> count == 0).count() / (double) counts.length;
  }

  /** Returns how many samples half of the pixels have at most, and the others at least. */
  public int medianSamples() {
    int[] sorted = counts.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  /** Returns the light of all samples together, the sum of the means of their channels. */
  public double totalLight() {
    double light = 0;
    for (int i = 0; i < whole.length; i++) {
      light += sum(i) / 3;
    }
    return light;
  }

  /** Returns how many samples a pixel has in the mean. */
  public double meanSamples() {
    return (double) totalSamples() / counts.length;
  }

  /** Returns how many samples all pixels have together. */
  public long totalSamples() {
    return Arrays.stream(counts).asLongStream().sum();
  }

  /**
   * Adds the samples of another film of the same picture, exactly: they may be of other pixels, or
   * have other numbers, but none may be in both films.
   *
   * <p>{@link #halves} stay known, as if one film had taken all samples, where the other film's
   * samples follow on this one's and no power of two lies strictly between their number before and
   * their number after; or where this film has none yet. Add films in the order of their samples.
   *
   * @param other whose window lies inside this one's, and which has alpha just if this one has
   */
  public void addAll(Film other) {
    Crop part = other.window;
    boolean inside =
        part.x() >= window.x()
            && part.y() >= window.y()
            && part.x() + part.width() <= window.x() + window.width()
            && part.y() + part.height() <= window.y() + window.height();
    if (!inside || other.hasAlpha() != hasAlpha()) {
      throw new IllegalArgumentException(
          "other: expected a film inside " + window + ", found " + part);
    }
    for (int from = 0; from < other.counts.length; from++) {
      int to = index(part.x() + from % part.width(), part.y() + from / part.width());
      if (other.counts[from] != 0) {
        firstMeans[to] = firstMeanWith(other, from, to);
      }
      counts[to] = Math.addExact(counts[to], other.counts[from]);
      for (int i = 0; i < 3; i++) {
        add(3 * to + i, other.whole[3 * from + i], other.fraction[3 * from + i]);
      }
      if (hasAlpha()) {
        covered[to] += other.covered[from];
      }
    }
  }

  /**
   * Returns the mean of a pixel's samples up to the last power of two before their number, once
   * those of another film are added; {@link PackedRgb#NONE} if the sums do not contain it.
   */
  private long firstMeanWith(Film other, int from, int to) {
    int count = counts[to];
    if (count == 0) {
      return other.firstMeans[from];
    }
    int power = Integer.highestOneBit(count + other.counts[from] - 1);
    if (other.firstSample != firstSample + count || power > count) {
      return PackedRgb.NONE;
    }
    return power == count ? mean(to) : firstMeans[to];
  }

  /** Returns the mean of all samples of a pixel that has some, packed. */
  private long mean(int pixel) {
    int count = counts[pixel];
    return PackedRgb.of(
        sum(3 * pixel) / count, sum(3 * pixel + 1) / count, sum(3 * pixel + 2) / count);
  }

  /** Returns another film that holds what this one does, and does not change with it. */
  public Film copy() {
    Film copy = new Film(window, hasAlpha(), firstSample);
    copy.set(this);
    return copy;
  }

  /**
   * Makes this film hold what another does, and nothing else.
   *
   * @param other of the same window, which has alpha just if this one has, and the same first
   *     sample
   */
  public void set(Film other) {
    if (!other.window.equals(window)
        || other.hasAlpha() != hasAlpha()
        || other.firstSample != firstSample) {
      throw new IllegalArgumentException(
          "other: expected a film of " + window + ", found " + other.window);
    }
    System.arraycopy(other.whole, 0, whole, 0, whole.length);
    System.arraycopy(other.fraction, 0, fraction, 0, fraction.length);
    System.arraycopy(other.counts, 0, counts, 0, counts.length);
    System.arraycopy(other.covered, 0, covered, 0, covered.length);
    System.arraycopy(other.firstMeans, 0, firstMeans, 0, firstMeans.length);
  }

  /**
   * Writes a pixel, at most {@link #MAX_PIXEL_BYTES}: the number of its samples; if there are any,
   * with alpha how many of them cover it, and of each channel the sum's whole part and its fraction
   * in units of 2^-64; at last the mean that {@link #halves} needs, packed. Fractions and the mean
   * take 8 bytes, the lowest one first; the other numbers 7 bits a byte, the lowest first, and the
   * eighth bit set if more follow.
   *
   * @param pixel row by row from the window's top left
   */
  public void encode(int pixel, ByteBuffer out) {
    putNumber(out, counts[pixel]);
    if (counts[pixel] == 0) {
      return;
    }
    if (hasAlpha()) {
      putNumber(out, covered[pixel]);
    }
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      putNumber(out, whole[i]);
      out.putLong(Long.reverseBytes(fraction[i]));
    }
    out.putLong(Long.reverseBytes(firstMeans[pixel]));
  }

  /**
   * Reads what {@link #encode} wrote into a pixel without samples.
   *
   * @throws IllegalArgumentException if that is no pixel
   * @throws BufferUnderflowException if it is cut off
   */
  public void decode(int pixel, ByteBuffer in) {
    int count = (int) number(in, RenderSettings.MAX_SAMPLES);
    counts[pixel] = count;
    if (count == 0) {
      return;
    }
    if (hasAlpha()) {
      covered[pixel] = (int) number(in, count);
    }
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      whole[i] = number(in, (long) LARGEST * count);
      fraction[i] = Long.reverseBytes(in.getLong());
    }
    firstMeans[pixel] = Long.reverseBytes(in.getLong());
  }

  private static void putNumber(ByteBuffer out, long number) {
    long rest = number;
    while (rest > 0x7f) {
      out.put((byte) (rest | 0x80));
      rest >>>= 7;
    }
    out.put((byte) rest);
  }

  private static long number(ByteBuffer in, long largest) {
    long number = 0;
    for (int shift = 0; shift < Long.SIZE - 1; shift += 7) {
      byte bits = in.get();
      number |= (bits & 0x7fL) << shift;
      if (bits >= 0) {
        if (number > largest) {
          break;
        }
        return number;
      }
    }
    throw new IllegalArgumentException("expected a number up to " + largest + ", found " + number);
  }

  /** Returns the place of a pixel of the full frame: row by row from the window's top left. */
  int index(int x, int y) {
    return (y - window.y()) * window.width() + (x - window.x());
  }

  /** Returns how many samples the pixel at a place has. */
  int samples(int pixel) {
    return counts[pixel];
  }

  /**
   * Adds the next sample; values above {@link #LARGEST} count as that.
   *
   * @param value finite and ≥ 0
   * @param covers whether the sample belongs to the picture, for its alpha
   */
  void add(int pixel, Rgb value, boolean covers) {
    int count = counts[pixel];
    if ((count & count - 1) == 0 && count != 0) {
      firstMeans[pixel] = mean(pixel);
    }
    addSilently(pixel, value, covers);
  }

  /** Adds the next sample without keeping what {@link #halves} needs. */
  void addSilently(int pixel, Rgb value, boolean covers) {
    add(3 * pixel, value.r());
    add(3 * pixel + 1, value.g());
    add(3 * pixel + 2, value.b());
    counts[pixel]++;
    if (covers && covered.length != 0) {
      covered[pixel]++;
    }
  }

  private void add(int i, double value) {
    assert value >= 0 && value < Double.POSITIVE_INFINITY : value;
    double cut = Math.min(value, LARGEST);
    long units = (long) cut;
    // The rest times 2^64; only a rest below 2^-12 needs rounding, so it cannot become 2^64.
    double rest = Math.rint((cut - units) * 0x1p64);
    long bits = rest < 0x1p63 ? (long) rest : (long) (rest - 0x1p63) | Long.MIN_VALUE;
    add(i, units, bits);
  }

  private void add(int i, long units, long bits) {
    long sum = fraction[i] + bits;
    whole[i] += units + (Long.compareUnsigned(sum, bits) < 0 ? 1 : 0);
    fraction[i] = sum;
  }

  /** Returns the means of the samples; pixels without samples are black and transparent. */
  public Image develop() {
    float[] rgb = new float[whole.length];
    float[] alpha = new float[covered.length];
    for (int pixel = 0; pixel < counts.length; pixel++) {
      // Straight alpha: the colour is the mean over the covering samples alone.
      int count = covered.length == 0 ? counts[pixel] : covered[pixel];
      for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
        rgb[i] = count == 0 ? 0 : (float) (sum(i) / count);
      }
      if (covered.length != 0 && count != 0) {
        alpha[pixel] = (float) count / counts[pixel];
      }
    }
    return new Image(window.width(), window.height(), rgb, alpha);
  }

  /**
   * Returns the means of two parts of a pixel's samples; empty if it has fewer than two, or if it
   * is not known what it had before.
   *
   * @param x of the full frame, inside the window
   * @param y of the full frame, inside the window
   */
  public Optional<PixelHalves> halves(int x, int y) {
    int count = samples(x, y);
    int pixel = index(x, y);
    if (count < 2 || firstMeans[pixel] == PackedRgb.NONE) {
      return Optional.empty();
    }
    int firstCount = Integer.highestOneBit(count - 1);
    int secondCount = count - firstCount;
    Rgb first = PackedRgb.unpacked(firstMeans[pixel]);
    Rgb all = new Rgb(sum(3 * pixel), sum(3 * pixel + 1), sum(3 * pixel + 2));
    Rgb second = all.plus(first.times(-firstCount)).times(1.0 / secondCount);
    return Optional.of(new PixelHalves(firstCount, first, secondCount, second));
  }

  private double sum(int i) {
    double low = (fraction[i] >>> 1) * 0x1p-63 + (fraction[i] & 1) * 0x1p-64;
    return whole[i] + low;
  }
}
