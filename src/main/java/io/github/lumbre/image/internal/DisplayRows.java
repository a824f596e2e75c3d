package io.github.lumbre.image.internal;

import io.github.lumbre.image.Dither;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import java.util.Optional;

/**
 * The rows of a picture quantized for display, with exposure and tone curve applied.
 *
 * @param factor the exposure's factor
 * @param bits bits per channel, 8 or 16
 * @param hasAlpha whether to keep alpha; if not, the picture is composited over the background, or
 *     else over black
 * @param background light that the screen emits where the picture is transparent
 * @param dither of the colors, if there are 8 bits; empty to round them
 */
public record DisplayRows(
    Image image,
    ToneCurve curve,
    double factor,
    int bits,
    boolean hasAlpha,
    Optional<Rgb> background,
    Optional<Dither> dither)
    implements SampleRows {

  /**
   * Returns the rows of a picture.
   *
   * @param keepsAlpha whether to keep alpha if the picture has some, and no background
   */
  public static DisplayRows of(
      Image image, ImageWriter.Options options, int bits, boolean keepsAlpha) {
    // Keep the factor finite, so that black does not become NaN.
    double factor = Math.min(options.exposure().factor(image), Double.MAX_VALUE);
    Optional<Rgb> background =
        options
            .background()
            .filter(color -> image.hasAlpha())
            .map(color -> shown(color, options.curve()));
    boolean hasAlpha = keepsAlpha && image.hasAlpha() && background.isEmpty();
    Optional<Dither> dither = options.dither().filter(given -> bits == Byte.SIZE);
    return new DisplayRows(image, options.curve(), factor, bits, hasAlpha, background, dither);
  }

  /** Returns the light that the last step of a curve encodes as the sRGB values of a color. */
  private static Rgb shown(Rgb color, ToneCurve curve) {
    if (curve.endsInSrgb()) {
      return color;
    }
    Rgb values = ToneCurve.SRGB.apply(color);
    return new Rgb(ungamma(values.r()), ungamma(values.g()), ungamma(values.b()));
  }

  /** Returns the inverse of the last step of {@link ToneCurve#GAMMA22}. */
  private static double ungamma(double encoded) {
    return StrictMath.pow(encoded, 2.2);
  }

  @Override
  public int width() {
    return image.width();
  }

  @Override
  public int height() {
    return image.height();
  }

  @Override
  public int bands() {
    return hasAlpha ? 4 : 3;
  }

  @Override
  public void read(int y, int[] row) {
    boolean isOfBytes = bits == Byte.SIZE && curve.endsInSrgb();
    ToneCurve transfer = curve.endsInSrgb() ? ToneCurve.SRGB : ToneCurve.GAMMA22;
    int bands = bands();
    for (int x = 0; x < image.width(); x++) {
      Rgb mapped = mapped(x, y);
      Rgb shown = isOfBytes ? mapped : transfer.apply(mapped);
      double threshold = dither.isPresent() ? dither.get().threshold(x, y) : .5;
      int i = bands * x;
      row[i] = isOfBytes ? toByte(shown.r(), threshold) : quantized(shown.r(), threshold);
      row[i + 1] = isOfBytes ? toByte(shown.g(), threshold) : quantized(shown.g(), threshold);
      row[i + 2] = isOfBytes ? toByte(shown.b(), threshold) : quantized(shown.b(), threshold);
      if (hasAlpha) {
        row[i + 3] = (int) Math.round(max() * Srgb.clamp(image.alpha(x, y)));
      }
    }
  }

  private int toByte(double linear, double threshold) {
    return dither.isPresent() ? Srgb.toByte(linear, threshold) : Srgb.toByte(linear);
  }

  private int quantized(double shown, double threshold) {
    double value = max() * shown;
    return (int) (dither.isPresent() ? Math.floor(value + (1 - threshold)) : Math.round(value));
  }

  private int max() {
    return (1 << bits) - 1;
  }

  /** Returns the light of a pixel to which the last step of the curve is applied. */
  private Rgb mapped(int x, int y) {
    if (hasAlpha || !image.hasAlpha()) {
      return curve.mapped(exposed(image.pixel(x, y)));
    }
    Rgb exposed = exposed(image.pixel(x, y));
    double alpha = Srgb.clamp(image.alpha(x, y));
    return background.isPresent()
        ? Backdrop.over(clamped(curve.mapped(exposed)), background.get(), alpha)
        : curve.mapped(exposed.times(alpha));
  }

  private static Rgb clamped(Rgb light) {
    return new Rgb(Srgb.clamp(light.r()), Srgb.clamp(light.g()), Srgb.clamp(light.b()));
  }

  /** Returns the linear light that a screen emits for each pixel, in [0,1], with straight alpha. */
  public Image light() {
    float[] rgb = new float[image.rgb().length];
    float[] alpha = new float[hasAlpha ? rgb.length / 3 : 0];
    for (int i = 0; i < rgb.length / 3; i++) {
      int x = i % image.width();
      int y = i / image.width();
      Rgb shown = mapped(x, y);
      rgb[3 * i] = (float) Srgb.clamp(shown.r());
      rgb[3 * i + 1] = (float) Srgb.clamp(shown.g());
      rgb[3 * i + 2] = (float) Srgb.clamp(shown.b());
      if (alpha.length > 0) {
        alpha[i] = image.alpha(x, y);
      }
    }
    return new Image(image.width(), image.height(), rgb, alpha);
  }

  private Rgb exposed(Rgb c) {
    return new Rgb(exposed(c.r()), exposed(c.g()), exposed(c.b()));
  }

  private double exposed(double v) {
    return v > 0 ? Math.min(v * factor, Double.MAX_VALUE) : 0;
  }
}
