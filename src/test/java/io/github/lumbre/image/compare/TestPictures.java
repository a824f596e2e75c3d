package io.github.lumbre.image.compare;

import io.github.lumbre.image.Image;

/** Pictures that a few lines of code in any language can reproduce. */
public final class TestPictures {
  /** The value of a channel at a pixel. */
  @FunctionalInterface
  public interface Value {
    double at(int x, int y, int channel);
  }

  private TestPictures() {}

  public static Image of(int width, int height, Value value) {
    float[] rgb = new float[3 * width * height];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) value.at(i / 3 % width, i / 3 / width, i % 3);
    }
    return new Image(width, height, rgb, new float[0]);
  }

  /** Returns a red ramp to the right, a green ramp downwards and a blue checkerboard. */
  public static Image pattern(int width, int height) {
    return of(width, height, (x, y, c) -> patternAt(x, y, c, width, height));
  }

  public static double patternAt(int x, int y, int channel, int width, int height) {
    return switch (channel) {
      case 0 -> x / (width - 1.0);
      case 1 -> y / (height - 1.0);
      default -> (x / 8 + y / 8) % 2 * .5 + .25;
    };
  }

  /** Returns the pattern with added pseudo-noise, clamped to [0,1]. */
  static Image noisy(int width, int height, double amplitude) {
    return of(
        width,
        height,
        (x, y, c) -> {
          int i = (y * width + x) * 3 + c;
          double noise = (i * 7919 % 101) / 100.0 - .5;
          double value = patternAt(x, y, c, width, height) + amplitude * noise;
          return Math.max(0, Math.min(value, 1));
        });
  }
}
