package io.github.lumbre.image.internal;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;

/** Pictures for tests, and helper functions to write them. */
public final class ImageFixture {
  private ImageFixture() {}

  /** Returns a picture of random values in [0,2), optionally with random alpha. */
  public static Image random(int width, int height, boolean withAlpha) {
    SplittableRandom random = new SplittableRandom(width * 31L + height);
    float[] rgb = new float[3 * width * height];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) random.nextDouble(2);
    }
    float[] alpha = new float[withAlpha ? width * height : 0];
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = (float) random.nextDouble();
    }
    return new Image(width, height, rgb, alpha);
  }

  /** Returns a picture of one row of grays. */
  public static Image grays(double... values) {
    float[] rgb = new float[3 * values.length];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) values[i / 3];
    }
    return new Image(values.length, 1, rgb, new float[0]);
  }

  /** Returns options without dithering. */
  public static ImageWriter.Options options(ToneCurve curve, int bits) {
    return new ImageWriter.Options(Exposure.NONE, curve, bits, Map.of())
        .withDither(Optional.empty());
  }

  /** Writes a picture to a file and returns the file's bytes. */
  public static byte[] written(Image image, Path file, ImageWriter.Options options)
      throws IOException {
    ImageWriter.write(image, file, options);
    return Files.readAllBytes(file);
  }
}
