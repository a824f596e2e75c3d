package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.SampleLayers;
import io.github.lumbre.render.FirstMeans.FirstMean;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The exact sums of the samples of each pixel. Each value is rounded once to a multiple of 2^-64
 * and added in 128 bits. The sums are therefore bit-identical for any order and grouping of the
 * samples. Mutable; different threads may write different pixels.
 *
 * <p>A film holds a window of the full frame. The samples of each pixel have consecutive numbers,
 * starting with the film's first one. Each pixel stores its own sample count.
 *
 * <p>A film also stores, for each pixel, the mean of its first samples, up to the largest power of
 * two below their number. {@link #halves} estimates the noise from it. This mean is rounded, and
 * does not affect the picture.
 *
 * <p>A film takes 60 bytes per pixel, 64 with alpha, and {@link FilmLayers#bytesPerPixel} more.
 */
public final class Film {
  /** The maximum of one sample value; the sums can hold 2^30 such values. */
  static final double LARGEST = 0x1p32;

  /** Light below this is held with less than four digits, and below 2^-65 it is black. */
  static final double FAINT = 1e-16;

  /** The maximum size of an encoded pixel without layers, in bytes. */
  public static final int MAX_PIXEL_BYTES =
      2 * 5 + 3 * (FilmNumbers.MAX_BYTES + Long.BYTES) + Long.BYTES;

  private final Crop window;
  private final int firstSample;

  /** The number of poses whose samples take turns. */
  private final int poses;

  /** The light that samples find which do not cover a pixel. */
  private final Optional<Rgb> background;

  /** Three sums per pixel. */
  private final ExactSums sums;

  private final int[] counts;

  /** The number of each pixel's samples that cover it; empty without alpha. */
  private final int[] covered;

  private final FirstMeans firstMeans;

  private final LayerSums layers;

  /** Creates an empty film without layers; see {@link #Film(Crop, boolean, int, FilmLayers)}. */
  public Film(Crop window, boolean hasAlpha, int firstSample) {
    this(window, hasAlpha, firstSample, FilmLayers.NONE);
  }

  /** Creates an empty film of a scene that stands still. */
  public Film(Crop window, boolean hasAlpha, int firstSample, FilmLayers layers) {
    this(window, hasAlpha, firstSample, layers, 1);
  }

  /** Creates an empty film without a background. */
  public Film(Crop window, boolean hasAlpha, int firstSample, FilmLayers layers, int poses) {
    this(window, hasAlpha, firstSample, layers, poses, Optional.empty());
  }

  /**
   * Creates an empty film.
   *
   * @param window the part of the full frame that the film holds
   * @param hasAlpha whether the film counts the samples that cover a pixel
   * @param firstSample the number of each pixel's first sample, at least 0
   * @param layers the layers that the film records besides the picture
   * @param poses the number of poses whose samples take turns, 1 for a scene that stands still
   * @param background the light that samples find which do not cover a pixel, of {@link
   *     RenderSettings#background}; empty if they find none
   * @throws IllegalArgumentException if {@code firstSample} is negative or not a multiple of the
   *     poses, or if {@code poses} is not a power of two
   */
  public Film(
      Crop window,
      boolean hasAlpha,
      int firstSample,
      FilmLayers layers,
      int poses,
      Optional<Rgb> background) {
    this.background = Objects.requireNonNull(background, "background");
    this.window = Objects.requireNonNull(window, "window");
    if (Integer.bitCount(poses) != 1 || poses < 1) {
      throw new IllegalArgumentException("poses: expected a power of two, found " + poses);
    }
    if (firstSample < 0 || firstSample % poses != 0) {
      String expected = poses == 1 ? "at least 0" : "a multiple of " + poses;
      throw new IllegalArgumentException(
          "firstSample: expected " + expected + ", found " + firstSample);
    }
    this.firstSample = firstSample;
    this.poses = poses;
    int pixels = Math.multiplyExact(window.width(), window.height());
    sums = new ExactSums(Math.multiplyExact(3, pixels));
    counts = new int[pixels];
    covered = new int[hasAlpha ? pixels : 0];
    firstMeans = new FirstMeans(sums, counts);
    this.layers = new LayerSums(layers, pixels);
  }

  /** Returns the part of the full frame that this film holds. */
  public Crop window() {
    return window;
  }

  /** Returns whether the film counts the samples that cover a pixel. */
  public boolean hasAlpha() {
    return covered.length != 0;
  }

  /**
   * Returns the light that samples find which do not cover a pixel; empty if they find none. {@link
   * #develop} leaves it out.
   */
  public Optional<Rgb> background() {
    return background;
  }

  /** Returns the layers that the film records besides the picture. */
  public FilmLayers layers() {
    return layers.layers();
  }

  /** Returns the sums of the light, three for each pixel. */
  ExactSums sums() {
    return sums;
  }

  LayerSums layerSums() {
    return layers;
  }

  /** Returns the number of each pixel's first sample. */
  public int firstSample() {
    return firstSample;
  }

  /**
   * Returns the number of samples of a pixel.
   *
   * @param x the pixel's column in the full frame, inside the window
   * @param y the pixel's row in the full frame, inside the window
   * @throws IndexOutOfBoundsException if the pixel is outside the window
   */
  public int samples(int x, int y) {
    Objects.checkIndex(x - window.x(), window.width());
    Objects.checkIndex(y - window.y(), window.height());
    return counts[index(x, y)];
  }

  /** Returns the number of poses whose samples take turns; 1 for a scene that stands still. */
  public int poses() {
    return poses;
  }

  /** Returns whether a number of samples has equally many of each pose. */
  boolean isWhole(int samples) {
    return (samples & poses - 1) == 0;
  }

  /** Returns whether a number of samples has two parts, each with all poses. */
  boolean hasHalves(int samples) {
    return samples >= 2 * poses && isWhole(samples);
  }

  /** Returns the smallest number of samples of any pixel. */
  public int fewestSamples() {
    int fewest = counts[0];
    for (int count : counts) {
      fewest = Math.min(fewest, count);
    }
    return fewest;
  }

  /** Returns the largest number of samples of any pixel. */
  public int mostSamples() {
    int most = counts[0];
    for (int count : counts) {
      most = Math.max(most, count);
    }
    return most;
  }

  /** Returns the fraction of pixels without samples, 0 to 1. */
  public double shareWithoutSamples() {
    return (double) Arrays.stream(counts).filter(count -> count == 0).count() / counts.length;
  }

  /** Returns the median number of samples per pixel; the upper one of two middle values. */
  public int medianSamples() {
    int[] sorted = counts.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  /** Returns the sum, over all samples, of the mean of the three channels. */
  public double totalLight() {
    double light = 0;
    for (int i = 0; i < sums.size(); i++) {
      light += sums.get(i) / 3;
    }
    return light;
  }

  /** Returns the mean number of samples per pixel. */
  public double meanSamples() {
    return (double) totalSamples() / counts.length;
  }

  /** Returns the total number of samples of all pixels. */
  public long totalSamples() {
    long total = 0;
    for (int count : counts) {
      total += count;
    }
    return total;
  }

  /**
   * Adds the samples of another film of the same scene and settings, exactly. The two films may
   * hold different pixels or different sample numbers, but no sample may be in both.
   *
   * <p>{@link #halves} stay known, as if one film had taken all samples, if the samples of the
   * other film continue those of this film and no power of two lies strictly between the numbers of
   * samples before and after, or if this film has none yet. Add films in the order of their
   * samples.
   *
   * @param other a film whose window lies inside the window of this film; it has alpha exactly if
   *     this film has, and the same layers
   * @throws IllegalArgumentException if {@code other} has another window, alpha or other layers
   * @throws ArithmeticException if the number of samples of a pixel overflows
   */
  public void addAll(Film other) {
    Crop part = other.window;
    if (!window.contains(part) || other.hasAlpha() != hasAlpha()) {
      throw new IllegalArgumentException(
          "other: expected a film inside " + window + ", found " + part);
    }
    requireSameLayers(other);
    for (int from = 0; from < other.counts.length; from++) {
      int to = index(part.x() + from % part.width(), part.y() + from / part.width());
      if (other.counts[from] != 0) {
        boolean continues = other.firstSample == firstSample + counts[to];
        FirstMean mean = firstMeans.add(other.firstMeans, from, to, continues);
        layers.addAll(other.layers, from, to, mean, counts[to]);
      }
      counts[to] = Math.addExact(counts[to], other.counts[from]);
      for (int i = 0; i < 3; i++) {
        sums.add(3 * to + i, other.sums, 3 * from + i);
      }
      if (hasAlpha()) {
        covered[to] += other.covered[from];
      }
    }
  }

  private void requireSameLayers(Film other) {
    if (!other.layers().equals(layers())) {
      throw new IllegalArgumentException(
          "other: expected a film with " + layers() + ", found " + other.layers());
    }
  }

  /** Returns an independent copy of this film. */
  public Film copy() {
    Film copy = new Film(window, hasAlpha(), firstSample, layers(), poses, background);
    copy.set(this);
    return copy;
  }

  /**
   * Replaces the contents of this film with a copy of another film's.
   *
   * @param other a film with the same window, alpha, first sample and layers
   * @throws IllegalArgumentException if {@code other} differs in one of these
   */
  public void set(Film other) {
    if (!other.window.equals(window)
        || other.hasAlpha() != hasAlpha()
        || other.firstSample != firstSample) {
      throw new IllegalArgumentException(
          "other: expected a film of " + window + ", found " + other.window);
    }
    requireSameLayers(other);
    layers.set(other.layers);
    sums.set(other.sums);
    System.arraycopy(other.counts, 0, counts, 0, counts.length);
    System.arraycopy(other.covered, 0, covered, 0, covered.length);
    firstMeans.set(other.firstMeans);
  }

  /** Returns the maximum number of bytes that {@link #encode} writes for a pixel. */
  public int encodedBytes(int pixel) {
    return MAX_PIXEL_BYTES + layers.encodedBytes(pixel);
  }

  /**
   * Writes a pixel in at most {@link #encodedBytes(int)} bytes. The first value is its sample
   * count. If this is not 0, these values follow: with alpha, the number of samples that cover the
   * pixel; for each channel, the whole part of the sum and its fraction in units of 2^-64; and the
   * packed mean that {@link #halves} needs; and the layers. Fractions and the mean take 8 bytes,
   * little-endian; for other numbers see {@link FilmNumbers}.
   *
   * @param pixel the pixel's index, row by row from the window's top left
   */
  public void encode(int pixel, ByteBuffer out) {
    FilmNumbers.put(out, counts[pixel]);
    if (counts[pixel] == 0) {
      return;
    }
    if (hasAlpha()) {
      FilmNumbers.put(out, covered[pixel]);
    }
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      FilmNumbers.put(out, sums.whole(i));
      out.putLong(Long.reverseBytes(sums.fraction(i)));
    }
    out.putLong(Long.reverseBytes(firstMeans.packed(pixel)));
    layers.encode(pixel, out);
  }

  /**
   * Reads a pixel in the format of {@link #encode}, and replaces its samples. If this throws an
   * exception, the pixel has no meaning until it is read again.
   *
   * @param pixel the pixel's index, row by row from the window's top left
   * @throws IllegalArgumentException if the bytes are not a valid pixel
   * @throws BufferUnderflowException if the bytes are truncated
   */
  public void decode(int pixel, ByteBuffer in) {
    int count = (int) FilmNumbers.get(in, RenderSettings.MAX_SAMPLES);
    counts[pixel] = count;
    if (count == 0) {
      return;
    }
    if (hasAlpha()) {
      covered[pixel] = (int) FilmNumbers.get(in, count);
    }
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      long whole = FilmNumbers.get(in, (long) LARGEST * count);
      sums.set(i, whole, Long.reverseBytes(in.getLong()));
    }
    firstMeans.set(pixel, Long.reverseBytes(in.getLong()));
    layers.decode(pixel, count, in);
  }

  /** Returns the index of a pixel of the full frame, row by row from the window's top left. */
  int index(int x, int y) {
    return (y - window.y()) * window.width() + (x - window.x());
  }

  /** Returns the number of samples of the pixel at an index. */
  int samples(int pixel) {
    return counts[pixel];
  }

  /** Returns the number of samples that cover the pixel at an index: all of them without alpha. */
  int covered(int pixel) {
    return hasAlpha() ? covered[pixel] : counts[pixel];
  }

  /**
   * Adds the next sample of a pixel; values above {@link #LARGEST} are reduced to it.
   *
   * @param pixel the pixel's index
   * @param value finite and ≥ 0
   * @param covers whether the sample covers the pixel, for its alpha
   */
  void add(int pixel, Rgb value, boolean covers) {
    int count = counts[pixel];
    if ((count & count - 1) == 0 && count != 0) {
      firstMeans.store(pixel);
    }
    addSilently(pixel, value, covers);
  }

  /**
   * Adds the next sample of a pixel with its layers.
   *
   * @param sample the sample's layers, of which the film stores all
   */
  void add(int pixel, Rgb value, boolean covers, SampleLayers sample) {
    layers.add(pixel, sample, counts[pixel]);
    add(pixel, value, covers);
  }

  /** Adds the next sample of a pixel without storing the mean for {@link #halves}. */
  void addSilently(int pixel, Rgb value, boolean covers) {
    addTo(3 * pixel, value.r());
    addTo(3 * pixel + 1, value.g());
    addTo(3 * pixel + 2, value.b());
    counts[pixel]++;
    if (covers && covered.length != 0) {
      covered[pixel]++;
    }
  }

  // Not named "add", because the JVM's options name all methods called Film.add.
  private void addTo(int i, double value) {
    assert value >= 0 && value < Double.POSITIVE_INFINITY : value;
    sums.add(i, Math.min(value, LARGEST));
  }

  /**
   * Returns the mean of the samples of each pixel. Pixels without samples are black, and
   * transparent if the film has alpha. Where samples do not cover a pixel, the color is the mean of
   * those that do; {@link RenderSettings#development} puts the background behind it.
   */
  public Image develop() {
    return new LayerDevelopment(this).picture();
  }

  /**
   * Returns the values of a layer: all channels of a pixel, pixel by pixel from the window's top
   * left; see {@link Layer}. Light is not divided by alpha.
   *
   * @throws IllegalArgumentException if the film does not have the layer, or if the layer has no
   *     channels of its own ({@link Layer#OBJECT}, {@link Layer#MATERIAL}, {@link Layer#LIGHTS})
   */
  public float[] develop(Layer layer) {
    return new LayerDevelopment(this).of(layer);
  }

  /**
   * Returns the light of a light group: R, G and B, pixel by pixel from the window's top left.
   *
   * @param group number of the group, 0 to {@link FilmLayers#lightGroups} - 1
   * @throws IllegalArgumentException if the film does not have {@link Layer#LIGHTS}
   * @throws IndexOutOfBoundsException if there is no such group
   */
  public float[] developLightGroup(int group) {
    return new LayerDevelopment(this).lightGroup(group);
  }

  /**
   * Returns the light that belongs to no group, as {@link #developLightGroup} does: the picture
   * minus all groups.
   *
   * @throws IllegalArgumentException if the film does not have {@link Layer#LIGHTS}
   */
  public float[] developUngroupedLight() {
    return new LayerDevelopment(this).ungroupedLight();
  }

  /**
   * Returns the number of samples of each primitive that samples of a pixel hit, by its number in
   * the scene.
   *
   * @param pixel the pixel's index, row by row from the window's top left
   * @throws IllegalArgumentException if the film has neither {@link Layer#OBJECT} nor {@link
   *     Layer#MATERIAL}
   */
  public Map<Integer, Integer> primitives(int pixel) {
    if (!layers().countsPrimitives()) {
      throw new IllegalArgumentException("expected a film with ids, found " + layers());
    }
    return layers.counts().of(pixel);
  }

  /**
   * Returns an estimate of the noise of each pixel's light, with its sign: R, G and B, pixel by
   * pixel from the window's top left. If the samples had two equal halves, their means would be the
   * pixel's light plus and minus this value; its square estimates the variance ({@link
   * Layer#VARIANCE}). NaN where {@link #halves} are not known. Light is not divided by alpha.
   */
  public float[] developNoise() {
    return new LayerDevelopment(this).noise();
  }

  /**
   * Returns an estimate of the noise of a layer for denoisers, as {@link #developNoise()} does for
   * light.
   *
   * @throws IllegalArgumentException if the film does not have the layer, or if it is none of
   *     {@link Layer#DENOISING_ALBEDO}, {@link Layer#DENOISING_NORMAL} and {@link
   *     Layer#DENOISING_ALPHA}
   */
  public float[] developNoise(Layer layer) {
    return new LayerDevelopment(this).noise(layer);
  }

  /**
   * Returns the means of two parts of a pixel's samples, each with all poses. Empty with fewer than
   * two samples of each pose, and if the stored mean was lost when films were added.
   *
   * @param x the pixel's column in the full frame, inside the window
   * @param y the pixel's row in the full frame, inside the window
   */
  public Optional<PixelHalves> halves(int x, int y) {
    return hasHalves(samples(x, y)) ? firstMeans.halves(index(x, y)) : Optional.empty();
  }

  /** Returns the size and the mean number of samples, for people. */
  @Override
  public String toString() {
    return "Film of %sx%s pixels with %s samples per pixel"
        .formatted(window.width(), window.height(), meanSamples());
  }
}
