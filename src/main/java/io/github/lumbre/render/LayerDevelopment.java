package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.math.BigInteger;
import java.util.Objects;
import java.util.Optional;

/** Computes a film's picture and the values of its layers from its sums. */
final class LayerDevelopment {
  /** The sums count multiples of 2^-64. */
  private static final double UNIT = 0x1p-64;

  private final Film film;
  private final LayerSums sums;
  private final int pixels;

  LayerDevelopment(Film film) {
    this.film = film;
    sums = film.layerSums();
    pixels = (int) film.window().pixels();
  }

  Image picture() {
    Rgb behind = film.background().orElse(Rgb.BLACK);
    double[] background = {behind.r(), behind.g(), behind.b()};
    float[] rgb = new float[3 * pixels];
    float[] alpha = new float[film.hasAlpha() ? pixels : 0];
    for (int pixel = 0; pixel < pixels; pixel++) {
      // Straight alpha: the color is the mean over the covering samples only.
      int count = film.covered(pixel);
      double others = film.samples(pixel) - count;
      for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
        double light = film.sums().get(i) - (others == 0 ? 0 : others * background[i % 3]);
        rgb[i] = count == 0 ? 0 : (float) (light / count);
      }
      if (alpha.length != 0 && count != 0) {
        alpha[pixel] = (float) count / film.samples(pixel);
      }
    }
    return new Image(film.window().width(), film.window().height(), rgb, alpha);
  }

  private void require(Layer layer) {
    if (!film.layers().kinds().contains(layer)) {
      throw new IllegalArgumentException(
          layer + ": expected one of the film's layers " + film.layers().kinds());
    }
  }

  /** Returns the values of a layer with one value for each channel. */
  float[] of(Layer layer) {
    require(layer);
    if (LayerGrid.of(layer) == LayerGrid.COUNTS || layer == Layer.LIGHTS) {
      throw new IllegalArgumentException(layer + ": expected a layer with channels of its own");
    }
    int channels = layer.channels().size();
    float[] values = new float[Math.multiplyExact(pixels, channels)];
    for (int pixel = 0; pixel < pixels; pixel++) {
      if (film.samples(pixel) != 0) {
        for (int channel = 0; channel < channels; channel++) {
          values[channels * pixel + channel] = (float) value(layer, channel, pixel);
        }
      }
    }
    return values;
  }

  private double value(Layer layer, int channel, int pixel) {
    int samples = film.samples(pixel);
    return switch (layer) {
      case SAMPLES -> samples;
      case VARIANCE -> variance(channel, pixel);
      case INDIRECT -> rest(pixel, channel, Layer.DIRECT, channel, 3) / samples;
      default -> {
        int count = FilmLayers.isOfHits(layer) ? sums.hits(pixel) : samples;
        yield count == 0 ? 0 : sums.sum(layer, channel, pixel) / count;
      }
    };
  }

  /**
   * Returns an estimate of the variance of a pixel's mean, from the difference of its halves;
   * negative if they are not known. See {@link PixelHalves#relativeSquaredError}.
   */
  private double variance(int channel, int pixel) {
    double noise = noise(halves(pixel), channel);
    return Double.isNaN(noise) ? -1 : noise * noise;
  }

  /** Returns the noise of the light, three values for each pixel. */
  float[] noise() {
    float[] values = new float[Math.multiplyExact(3, pixels)];
    for (int pixel = 0; pixel < pixels; pixel++) {
      Optional<PixelHalves> halves = halves(pixel);
      for (int channel = 0; channel < 3; channel++) {
        values[3 * pixel + channel] = (float) noise(halves, channel);
      }
    }
    return values;
  }

  private Optional<PixelHalves> halves(int pixel) {
    Crop window = film.window();
    return film.halves(window.x() + pixel % window.width(), window.y() + pixel / window.width());
  }

  private static double noise(Optional<PixelHalves> both, int channel) {
    if (both.isEmpty()) {
      return Double.NaN;
    }
    PixelHalves halves = both.get();
    double difference =
        switch (channel) {
          case 0 -> halves.first().r() - halves.second().r();
          case 1 -> halves.first().g() - halves.second().g();
          default -> halves.first().b() - halves.second().b();
        };
    return difference * weight(halves.firstCount(), halves.secondCount());
  }

  /** Returns by how much the difference of two means tells of the error of the mean of both. */
  private static double weight(double firstCount, double secondCount) {
    return Math.sqrt(firstCount * secondCount) / (firstCount + secondCount);
  }

  /** Returns the noise of a layer for denoisers, one value for each of its channels. */
  float[] noise(Layer layer) {
    require(layer);
    if (LayerGrid.of(layer) != LayerGrid.GUIDE) {
      throw new IllegalArgumentException(layer + ": expected a layer for denoisers");
    }
    int channels = layer.channels().size();
    float[] values = new float[Math.multiplyExact(channels, pixels)];
    for (int pixel = 0; pixel < pixels; pixel++) {
      int samples = film.samples(pixel);
      boolean isKnown = film.hasHalves(samples) && sums.hasFirstMean(layer, pixel);
      for (int channel = 0; channel < channels; channel++) {
        values[channels * pixel + channel] =
            isKnown ? (float) noise(layer, channel, pixel, samples) : Float.NaN;
      }
    }
    return values;
  }

  private double noise(Layer layer, int channel, int pixel, int samples) {
    int firstCount = Integer.highestOneBit(samples - 1);
    double first = sums.firstMean(layer, channel, pixel);
    double mean = sums.sum(layer, channel, pixel) / samples;
    // The mean of all is firstCount/samples of the way from the second mean to the first.
    double difference = (first - mean) * samples / (samples - firstCount);
    return difference * weight(firstCount, samples - firstCount);
  }

  /** Returns the light of a group, three values for each pixel. */
  float[] lightGroup(int group) {
    require(Layer.LIGHTS);
    Objects.checkIndex(group, film.layers().lightGroups());
    float[] values = new float[Math.multiplyExact(3, pixels)];
    for (int i = 0; i < values.length; i++) {
      int samples = film.samples(i / 3);
      if (samples != 0) {
        values[i] = (float) (sums.sum(Layer.LIGHTS, 3 * group + i % 3, i / 3) / samples);
      }
    }
    return values;
  }

  /** Returns the light of all lights without a group, three values for each pixel. */
  float[] ungroupedLight() {
    require(Layer.LIGHTS);
    float[] values = new float[Math.multiplyExact(3, pixels)];
    int all = 3 * film.layers().lightGroups();
    for (int i = 0; i < values.length; i++) {
      int samples = film.samples(i / 3);
      if (samples != 0) {
        values[i] = (float) (rest(i / 3, i % 3, Layer.LIGHTS, i % 3, all) / samples);
      }
    }
    return values;
  }

  /**
   * Returns the sum of a pixel's light minus sums of a layer, at least 0: the exact difference can
   * be below 0 by the rounding of single samples.
   *
   * @param first first channel of the layer to subtract; then each third
   * @param end channel before which to stop
   */
  private double rest(int pixel, int channel, Layer layer, int first, int end) {
    int own = 3 * pixel + channel;
    BigInteger rest = exact(film.sums().whole(own), film.sums().fraction(own));
    for (int i = first; i < end; i += 3) {
      rest = rest.subtract(exact(sums.whole(layer, i, pixel), sums.fraction(layer, i, pixel)));
    }
    return Math.max(0, rest.doubleValue() * UNIT);
  }

  private static BigInteger exact(long whole, long fraction) {
    BigInteger low = BigInteger.valueOf(fraction & Long.MAX_VALUE);
    BigInteger bits = fraction < 0 ? low.setBit(Long.SIZE - 1) : low;
    return BigInteger.valueOf(whole).shiftLeft(Long.SIZE).add(bits);
  }
}
