package io.github.lumbre.image.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;

/**
 * The rows of a picture quantized for display, with exposure and tone curve applied.
 *
 * @param factor the exposure's factor
 * @param bits bits per channel, 8 or 16
 * @param hasAlpha whether to keep alpha; if not, the picture is composited over black
 */
public record DisplayRows(Image image, ToneCurve curve, double factor, int bits, boolean hasAlpha)
    implements SampleRows {

  public static DisplayRows of(
      Image image, ImageWriter.Options options, int bits, boolean hasAlpha) {
    // Keep the factor finite, so that black does not become NaN.
    double factor = Math.min(options.exposure().factor(image), Double.MAX_VALUE);
    return new DisplayRows(image, options.curve(), factor, bits, hasAlpha);
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
    boolean isOverBlack = image.hasAlpha() && !hasAlpha;
    boolean isOfBytes = bits == Byte.SIZE && curve.endsInSrgb();
    int bands = bands();
    for (int x = 0; x < image.width(); x++) {
      Rgb exposed = exposed(image.pixel(x, y));
      Rgb light = isOverBlack ? exposed.times(Srgb.clamp(image.alpha(x, y))) : exposed;
      int i = bands * x;
      if (isOfBytes) {
        Rgb mapped = curve.mapped(light);
        row[i] = Srgb.toByte(mapped.r());
        row[i + 1] = Srgb.toByte(mapped.g());
        row[i + 2] = Srgb.toByte(mapped.b());
      } else {
        Rgb shown = curve.apply(light);
        row[i] = quantized(shown.r());
        row[i + 1] = quantized(shown.g());
        row[i + 2] = quantized(shown.b());
      }
      if (hasAlpha) {
        row[i + 3] = quantized(Srgb.clamp(image.alpha(x, y)));
      }
    }
  }

  /** Returns the linear light that a screen emits for each pixel, in [0,1], with straight alpha. */
  public Image light() {
    float[] rgb = new float[image.rgb().length];
    float[] alpha = new float[image.hasAlpha() ? rgb.length / 3 : 0];
    for (int i = 0; i < rgb.length / 3; i++) {
      int x = i % image.width();
      int y = i / image.width();
      Rgb shown = curve.mapped(exposed(image.pixel(x, y)));
      rgb[3 * i] = (float) Srgb.clamp(shown.r());
      rgb[3 * i + 1] = (float) Srgb.clamp(shown.g());
      rgb[3 * i + 2] = (float) Srgb.clamp(shown.b());
      if (alpha.length > 0) {
        alpha[i] = image.alpha(x, y);
      }
    }
    return new Image(image.width(), image.height(), rgb, alpha);
  }

  private int quantized(double shown) {
    return (int) Math.round(((1 << bits) - 1) * shown);
  }

  private Rgb exposed(Rgb c) {
    return new Rgb(exposed(c.r()), exposed(c.g()), exposed(c.b()));
  }

  private double exposed(double v) {
    return v > 0 ? Math.min(v * factor, Double.MAX_VALUE) : 0;
  }
}
