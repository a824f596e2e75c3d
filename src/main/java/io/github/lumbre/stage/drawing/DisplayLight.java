package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.DisplayRows;
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
