package io.github.lumbre.image.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import java.util.Optional;

/** Puts the background of {@link ImageWriter.Options#background} behind pictures. Stateless. */
public final class Backdrop {
  private Backdrop() {}

  /**
   * Returns a picture in linear light over a background, without alpha; the picture itself if there
   * is no background, or it has no alpha.
   */
  public static Image asLight(Image image, Optional<Rgb> background) {
    if (background.isEmpty() || !image.hasAlpha()) {
      return image;
    }
    Rgb behind = background.get();
    float[] from = image.rgb();
    float[] rgb = new float[from.length];
    for (int i = 0; i < rgb.length; i += 3) {
      double alpha = image.alpha(i / 3 % image.width(), i / 3 / image.width());
      rgb[i] = mixed(from[i], behind.r(), alpha);
      rgb[i + 1] = mixed(from[i + 1], behind.g(), alpha);
      rgb[i + 2] = mixed(from[i + 2], behind.b(), alpha);
    }
    return new Image(image.width(), image.height(), rgb, new float[0]);
  }

  private static float mixed(double above, double behind, double alpha) {
    // What is not covered may be infinite.
    return (float) (alpha == 0 ? behind : alpha * above + (1 - alpha) * behind);
  }

  /** Returns a color over another one: the "over" operator (Porter and Duff 1984). */
  static Rgb over(Rgb above, Rgb behind, double alpha) {
    return above.times(alpha).plus(behind.times(1 - alpha));
  }
}
