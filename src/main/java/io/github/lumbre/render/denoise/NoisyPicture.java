package io.github.lumbre.render.denoise;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.math.sampling.internal.Hash;
import io.github.lumbre.render.Film;
import io.github.lumbre.scene.Layer;
import java.util.List;
import java.util.Optional;

/**
 * What a denoiser knows of a picture: its light, and guides that tell where surfaces differ. All
 * arrays have three values for each pixel, row by row from the top left, and are not copied.
 *
 * @param width in pixels, at least 1
 * @param height in pixels, at least 1
 * @param left column of its first pixel in the full frame; 0 if it is not a crop
 * @param top row of its first pixel in the full frame
 * @param light mean light of the samples, at least 0, not divided by alpha, and its noise
 * @param albedo {@link Layer#DENOISING_ALBEDO}; empty if it is not known
 * @param normal {@link Layer#DENOISING_NORMAL}; empty if it is not known
 * @param alpha one value in [0,1] for each pixel, or none for an opaque picture
 * @param alphaNoise the noise of alpha as in {@link Halves}; none if it is not known
 * @param replaced number of pixels whose light was not finite and was replaced by the light of
 *     their neighbors
 * @param background what the light contains of the background where alpha is not 1; empty if it is
 *     black there
 */
public record NoisyPicture(
    int width,
    int height,
    int left,
    int top,
    Halves light,
    Optional<Halves> albedo,
    Optional<Halves> normal,
    float[] alpha,
    float[] alphaNoise,
    int replaced,
    Optional<Rgb> background) {
  private static final int CHANNELS = 3;

  /**
   * Means of a pixel's samples, and an estimate of their noise: if the samples had two equal
   * halves, the means of these would be mean + noise and mean - noise.
   *
   * @param mean finite values
   * @param noise finite values, or none if the noise is not known
   */
  public record Halves(float[] mean, float[] noise) {
    /** Returns whether the noise is known. */
    public boolean isNoiseKnown() {
      return noise.length != 0;
    }
  }

  /**
   * @throws IllegalArgumentException if an array does not have the picture's size
   */
  public NoisyPicture {
    require("light", light.mean, CHANNELS * width * height);
    require("noise", light.noise, light.noise.length == 0 ? 0 : CHANNELS * width * height);
    require("alpha", alpha, alpha.length == 0 ? 0 : width * height);
    require("alphaNoise", alphaNoise, alphaNoise.length == 0 ? 0 : alpha.length);
    for (Halves guide : List.of(albedo.orElse(light), normal.orElse(light))) {
      require("guide", guide.mean, CHANNELS * width * height);
      require("noise", guide.noise, guide.noise.length == 0 ? 0 : CHANNELS * width * height);
    }
  }

  /** Makes a picture without a background, as the canonical constructor does. */
  public NoisyPicture(
      int width,
      int height,
      int left,
      int top,
      Halves light,
      Optional<Halves> albedo,
      Optional<Halves> normal,
      float[] alpha,
      float[] alphaNoise,
      int replaced) {
    this(
        width,
        height,
        left,
        top,
        light,
        albedo,
        normal,
        alpha,
        alphaNoise,
        replaced,
        Optional.empty());
  }

  /** Makes a picture that is not a crop, as the canonical constructor does. */
  public NoisyPicture(
      int width,
      int height,
      Halves light,
      Optional<Halves> albedo,
      Optional<Halves> normal,
      float[] alpha,
      int replaced) {
    this(width, height, 0, 0, light, albedo, normal, alpha, new float[0], replaced);
  }

  private static void require(String name, float[] values, int expected) {
    if (values.length != expected) {
      throw new IllegalArgumentException(
          name + ": expected " + expected + " values, found " + values.length);
    }
  }

  /**
   * Returns the picture of a film. Its noise is known if {@link Film#halves} are known for all
   * pixels: with at least 2 samples in each.
   */
  public static NoisyPicture of(Film film) {
    Image image = film.develop();
    int width = image.width();
    int height = image.height();
    float[] light = Backdrop.asLight(image, film.background()).rgb().clone();
    float[] alpha = new float[film.hasAlpha() ? width * height : 0];
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = image.alpha(i % width, i / width);
      for (int c = 0; c < CHANNELS && film.background().isEmpty(); c++) {
        light[CHANNELS * i + c] *= alpha[i];
      }
    }
    Optional<Halves> smooth =
        alpha.length == 0 ? Optional.empty() : guide(film, Layer.DENOISING_ALPHA);
    return new NoisyPicture(
        width,
        height,
        film.window().x(),
        film.window().y(),
        new Halves(light, known(film.developNoise())),
        guide(film, Layer.DENOISING_ALBEDO),
        guide(film, Layer.DENOISING_NORMAL),
        smooth.map(Halves::mean).orElse(alpha),
        smooth.map(Halves::noise).orElseGet(() -> known(alphaNoise(film, alpha))),
        0,
        film.background());
  }

  /** Returns the noise of counts: each sample covers its pixel or not. NaN with one sample. */
  private static float[] alphaNoise(Film film, float[] alpha) {
    float[] variance = new float[alpha.length];
    for (int i = 0; i < alpha.length; i++) {
      int x = film.window().x() + i % film.window().width();
      int y = film.window().y() + i / film.window().width();
      variance[i] = alpha[i] * (1 - alpha[i]) / (film.samples(x, y) - 1);
    }
    return noise(variance, 1);
  }

  private static Optional<Halves> guide(Film film, Layer layer) {
    return film.layers().kinds().contains(layer)
        ? Optional.of(new Halves(film.develop(layer), known(film.developNoise(layer))))
        : Optional.empty();
  }

  /** Returns noise; none if the noise of a pixel is not known. */
  private static float[] known(float[] noise) {
    float sum = 0;
    for (float value : noise) {
      // 0 if the value is finite, otherwise NaN. A call for each value takes long at the start.
      sum += value - value;
    }
    return sum == 0 ? noise : new float[0];
  }

  /**
   * Returns the picture of an OpenEXR file with the layers {@code variance}, {@code
   * denoisingAlbedo} and {@code denoisingNormal}; {@code albedo} and {@code normal} stand in for
   * the latter. {@code denoisingAlpha} stands in for alpha.
   *
   * <p>A file has the variance but not the sign of the noise. Both signs are equally likely, so
   * that a random choice, which does not depend on the picture, names one of the halves the first.
   *
   * @throws IllegalArgumentException if the file has no picture, or one without any finite pixel
   */
  public static NoisyPicture of(LayeredImage file) {
    ImageLayer picture =
        file.layer("")
            .filter(layer -> layer.channels().containsAll(List.of("R", "G", "B")))
            .orElseThrow(() -> new IllegalArgumentException("expected channels R, G and B"));
    int pixels = file.width() * file.height();
    float[] light = values(picture, List.of("R", "G", "B"));
    int replaced = Repair.replaceNonFinite(light, file.width(), file.height());
    float[] noise =
        file.layer("variance")
            .filter(layer -> layer.channels().containsAll(List.of("R", "G", "B")))
            .map(layer -> known(noise(values(layer, List.of("R", "G", "B")), CHANNELS)))
            .orElse(new float[0]);
    float[] alpha = new float[0];
    if (picture.channels().contains("A")) {
      alpha = values(file.layer("denoisingAlpha").orElse(picture), List.of("A"));
      for (int i = 0; i < pixels; i++) {
        alpha[i] = alpha[i] >= 0 ? Math.min(1, alpha[i]) : 0;
      }
    }
    return new NoisyPicture(
        file.width(),
        file.height(),
        new Halves(light, noise),
        guide(file, List.of("R", "G", "B"), "denoisingAlbedo", "albedo"),
        guide(file, List.of("X", "Y", "Z"), "denoisingNormal", "normal"),
        alpha,
        replaced);
  }

  /** Returns noise of a variance, with a random sign for each pixel. */
  private static float[] noise(float[] variance, int channels) {
    float[] noise = new float[variance.length];
    for (int i = 0; i < noise.length; i += channels) {
      int sign = (Hash.of(0, i) & 1) == 0 ? 1 : -1;
      for (int c = 0; c < channels; c++) {
        noise[i + c] = (float) (sign * Math.sqrt(variance[i + c]));
      }
    }
    return noise;
  }

  private static Optional<Halves> guide(
      LayeredImage file, List<String> channels, String name, String otherName) {
    return file.layer(name)
        .or(() -> file.layer(otherName))
        .filter(layer -> layer.channels().containsAll(channels))
        .map(layer -> new Halves(zeroIfNotFinite(values(layer, channels)), new float[0]));
  }

  private static float[] zeroIfNotFinite(float[] values) {
    for (int i = 0; i < values.length; i++) {
      if (!Float.isFinite(values[i])) {
        values[i] = 0;
      }
    }
    return values;
  }

  /** Returns a copy of some channels of a layer. */
  private static float[] values(ImageLayer layer, List<String> channels) {
    int count = layer.channels().size();
    int pixels = layer.width() * layer.height();
    float[] values = new float[Math.multiplyExact(pixels, channels.size())];
    for (int c = 0; c < channels.size(); c++) {
      int from = layer.channels().indexOf(channels.get(c));
      for (int i = 0; i < pixels; i++) {
        values[i * channels.size() + c] = layer.values()[i * count + from];
      }
    }
    return values;
  }

  /** Returns this picture with another alpha, whose noise is not known. */
  NoisyPicture withAlpha(float[] other) {
    return new NoisyPicture(
        width,
        height,
        left,
        top,
        light,
        albedo,
        normal,
        other,
        new float[0],
        replaced,
        background);
  }

  /**
   * Returns a picture with other light and the same alpha, by which the light is divided. At edges
   * before a background, alpha changes, too.
   *
   * @param light three values for each pixel
   */
  Image withLight(float[] light) {
    if (background.isPresent()) {
      return EdgeCoverage.separated(width, height, light, alpha, background.get());
    }
    float[] rgb = new float[light.length];
    for (int i = 0; i < rgb.length; i++) {
      float coverage = alpha.length == 0 ? 1 : alpha[i / CHANNELS];
      float shown = coverage == 0 ? 0 : Math.max(0, light[i]) / coverage;
      rgb[i] = Math.min(Float.MAX_VALUE, shown);
    }
    return new Image(width, height, rgb, alpha);
  }
}
