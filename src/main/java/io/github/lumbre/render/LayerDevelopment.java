package io.github.lumbre.render;

import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.math.BigInteger;
import java.util.Optional;

/** Computes the values of a film's layers from its sums. */
final class LayerDevelopment {
  /** The sums count multiples of 2^-64. */
  private static final double UNIT = 0x1p-64;

  private final Film film;
  private final LayerSums sums;
  private final int pixels;

  LayerDevelopment(Film film) {
    this.film = film;
    sums = film.layerSums();
    Crop window = film.window();
    pixels = window.width() * window.height();
  }

  /** Returns the values of a layer with one value for each channel. */
  float[] of(Layer layer) {
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
    Crop window = film.window();
    Optional<PixelHalves> halves =
        film.halves(window.x() + pixel % window.width(), window.y() + pixel / window.width());
    return halves.map(both -> variance(both, channel)).orElse(-1.0);
  }

  private static double variance(PixelHalves halves, int channel) {
    double all = (double) halves.firstCount() + halves.secondCount();
    double factor = halves.firstCount() / all * (halves.secondCount() / all);
    double difference =
        switch (channel) {
          case 0 -> halves.first().r() - halves.second().r();
          case 1 -> halves.first().g() - halves.second().g();
          default -> halves.first().b() - halves.second().b();
        };
    return factor * difference * difference;
  }

  /** Returns the light of a group, three values for each pixel. */
  float[] lightGroup(int group) {
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
    BigInteger rest = exact(film.whole(channel, pixel), film.fraction(channel, pixel));
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
