package io.github.lumbre.image.internal;

import io.github.lumbre.image.Pixels;

/** The alpha of formats in which many programs write 0 for pictures that are opaque. Stateless. */
public final class EmptyAlpha {
  private EmptyAlpha() {}

  /** Returns a picture of 8-bit values, without its alpha if that is 0 everywhere. */
  public static Pixels dropped(Pixels pixels) {
    int width = pixels.width();
    int height = pixels.height();
    for (int i = 0; i < width * height; i++) {
      if (pixels.alpha(i % width, i / width) != 0) {
        return pixels;
      }
    }
    byte[] rgb = new byte[Math.multiplyExact(3, width * height)];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (byte) pixels.raw(i / 3 % width, i / 3 / width, i % 3);
    }
    return Pixels.of(width, height, 3, rgb);
  }
}
