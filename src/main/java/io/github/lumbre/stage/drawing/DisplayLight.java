package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.DisplayRows;
import io.github.lumbre.image.internal.Srgb;
import java.util.Optional;

/**
 * A picture in the light of the screen that shows it: with exposure and tone curve, but without the
 * transfer curve of files, such as sRGB.
 *
 * @param image linear, in [0,1]
 * @param options for writing the picture: they apply the transfer curve alone
 */
public record DisplayLight(Image image, ImageWriter.Options options) {
  /** Returns the same picture with the background put behind it that its options state. */
  public DisplayLight withBackground() {
    return options.background().isPresent() ? of(image, options) : this;
  }

  /** Returns the same picture for files of the sRGB curve. */
  public Image inSrgb() {
    if (options.curve().endsInSrgb()) {
      return image;
    }
    float[] rgb = new float[image.rgb().length];
    float[] alpha = new float[image.hasAlpha() ? rgb.length / 3 : 0];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) Srgb.decode(options.curve().apply(Rgb.gray(image.rgb()[i])).r());
    }
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = image.alpha(i % image.width(), i / image.width());
    }
    return new Image(image.width(), image.height(), rgb, alpha);
  }

  /** Returns a picture as options show it, with the background that they put behind it. */
  public static DisplayLight of(Image picture, ImageWriter.Options options) {
    ToneCurve transfer = options.curve().endsInSrgb() ? ToneCurve.SRGB : ToneCurve.GAMMA22;
    return new DisplayLight(
        DisplayRows.of(picture, options, Byte.SIZE, picture.hasAlpha()).light(),
        new ImageWriter.Options(
            Exposure.NONE,
            transfer,
            options.pngBits(),
            options.jpegQuality(),
            options.metadata(),
            Optional.empty(),
            options.dither()));
  }
}
