package io.github.lumbre.cli.view;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Pictures as the page reads them: five little-endian 32-bit numbers (width, height, channels,
 * bytes per value, version), then the values of the pixels from the top left, as half or single
 * floats.
 */
final class PictureBytes {
  private static final int HEADER_INTS = 5;

  private PictureBytes() {}

  /** Returns a picture with 3 channels, or 4 with alpha. */
  static byte[] of(Image image, boolean isExact, long version) {
    if (!image.hasAlpha()) {
      return of(image.rgb(), image.width(), image.height(), 3, isExact, version);
    }
    float[] values = new float[4 * image.width() * image.height()];
    float[] rgb = image.rgb();
    for (int i = 0; i < values.length / 4; i++) {
      System.arraycopy(rgb, 3 * i, values, 4 * i, 3);
      values[4 * i + 3] = image.alpha(i % image.width(), i / image.width());
    }
    return of(values, image.width(), image.height(), 4, isExact, version);
  }

  static byte[] of(ImageLayer layer, boolean isExact, long version) {
    return of(
        layer.values(), layer.width(), layer.height(), layer.channels().size(), isExact, version);
  }

  private static byte[] of(
      float[] values, int width, int height, int channels, boolean isExact, long version) {
    int size = isExact ? Float.BYTES : Short.BYTES;
    int bytes = Math.addExact(HEADER_INTS * Integer.BYTES, Math.multiplyExact(size, values.length));
    ByteBuffer out = ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(width).putInt(height).putInt(channels).putInt(size).putInt((int) version);
    if (isExact) {
      out.asFloatBuffer().put(values);
    } else {
      for (float value : values) {
        out.putShort(half(value));
      }
    }
    return out.array();
  }

  /**
   * Returns the bits of the nearest half float (IEEE 754 binary16); too large values are infinite.
   */
  static short half(float value) {
    int bits = Float.floatToRawIntBits(value);
    int sign = bits >>> 16 & 0x8000;
    int magnitude = bits & 0x7fffffff;
    if (magnitude >= 0x47800000) {
      boolean isNan = magnitude > 0x7f800000;
      return (short) (sign | (isNan ? 0x7e00 : 0x7c00));
    }
    if (magnitude < 0x38800000) {
      // Subnormal: multiples of 2^-24, rounded to even.
      return (short) (sign | (int) Math.rint(Math.abs((double) value) * 0x1p24));
    }
    int rounded = magnitude + 0xfff + (magnitude >>> 13 & 1);
    return (short) (sign | (rounded - 0x38000000) >>> 13);
  }
}
