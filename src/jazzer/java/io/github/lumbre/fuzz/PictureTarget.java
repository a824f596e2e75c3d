package io.github.lumbre.fuzz;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;

/** Any bytes as a picture: PNG, JPEG, portable float map, Radiance HDR or OpenEXR. */
public final class PictureTarget {
  private static final int MAX_DENOISED_PIXELS = 400;

  private PictureTarget() {}

  /** Reads a picture and its layers, and denoises it; what else it throws is a defect. */
  public static void fuzzerTestOneInput(byte[] file) throws InterruptedException {
    try {
      LinearReader.decode(file);
    } catch (ImageFormatException e) {
      // Its layers may be readable nevertheless.
    }
    LayeredImage layers;
    try {
      layers = LayeredImage.of(file);
    } catch (ImageFormatException e) {
      return;
    }
    denoise(layers);
  }

  private static void denoise(LayeredImage layers) throws InterruptedException {
    NoisyPicture noisy;
    try {
      noisy = NoisyPicture.of(layers);
    } catch (IllegalArgumentException e) {
      return;
    }
    if (noisy.width() * noisy.height() <= MAX_DENOISED_PIXELS) {
      for (float value : BuiltInDenoiser.denoise(noisy, 1).image().rgb()) {
        if (!(value >= 0)) {
          throw new IllegalStateException("denoised light: " + value);
        }
      }
    }
  }
}
