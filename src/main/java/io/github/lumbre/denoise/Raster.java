package io.github.lumbre.denoise;

import java.util.function.DoubleBinaryOperator;

/**
 * Values of pixels in some channels, pixel by pixel, row by row. Operations return new rasters.
 *
 * @param values shared with the creator
 */
record Raster(int width, int height, int channels, float[] values) {
  Raster(int width, int height, int channels) {
    this(width, height, channels, new float[Math.multiplyExact(channels, width * height)]);
  }

  int pixels() {
    return width * height;
  }

  /** Returns the values of a function of the values of this raster and of another one. */
  Raster with(Raster other, DoubleBinaryOperator function) {
    Raster result = new Raster(width, height, channels);
    for (int i = 0; i < values.length; i++) {
      result.values[i] = (float) function.applyAsDouble(values[i], other.values[i]);
    }
    return result;
  }

  Raster plus(Raster other) {
    return with(other, (a, b) -> a + b);
  }

  Raster minus(Raster other) {
    return with(other, (a, b) -> a - b);
  }

  Raster times(double factor) {
    return with(this, (a, b) -> factor * a);
  }

  Raster squared() {
    return with(this, (a, b) -> a * a);
  }

  /** Returns the channels of this raster and then those of another one. */
  Raster beside(Raster other) {
    Raster result = new Raster(width, height, channels + other.channels);
    for (int i = 0; i < pixels(); i++) {
      System.arraycopy(values, i * channels, result.values, i * result.channels, channels);
      System.arraycopy(
          other.values,
          i * other.channels,
          result.values,
          i * result.channels + channels,
          other.channels);
    }
    return result;
  }

  /** Returns some of the channels. */
  Raster part(int first, int count) {
    Raster result = new Raster(width, height, count);
    for (int i = 0; i < pixels(); i++) {
      System.arraycopy(values, i * channels + first, result.values, i * count, count);
    }
    return result;
  }

  /** Returns the means over squares with 2 radius + 1 pixels a side, cut at the borders. */
  Raster blurred(int radius) {
    Raster rows = new Raster(width, height, channels);
    for (int y = 0; y < height; y++) {
      for (int c = 0; c < channels; c++) {
        blur(rows, y * width * channels + c, channels, width, radius);
      }
    }
    Raster result = new Raster(width, height, channels);
    for (int x = 0; x < width; x++) {
      for (int c = 0; c < channels; c++) {
        rows.blur(result, x * channels + c, width * channels, height, radius);
      }
    }
    return result;
  }

  /** Stores the means of neighbors in a row or a column. */
  private void blur(Raster result, int first, int step, int count, int radius) {
    for (int i = 0; i < count; i++) {
      int left = Math.max(0, i - radius);
      int right = Math.min(count - 1, i + radius);
      // A running sum would leave rounding errors of bright pixels in the dark ones after them.
      double sum = 0;
      for (int near = left; near <= right; near++) {
        sum += values[first + near * step];
      }
      result.values[first + i * step] = (float) (sum / (right - left + 1));
    }
  }

  /** Returns the means of squares of four pixels: a raster of half the size, rounded up. */
  Raster halved() {
    Raster result = new Raster((width + 1) / 2, (height + 1) / 2, channels);
    for (int y = 0; y < result.height; y++) {
      int top = 2 * y * width;
      int bottom = Math.min(2 * y + 1, height - 1) * width;
      for (int x = 0; x < result.width; x++) {
        int left = 2 * x;
        int right = Math.min(2 * x + 1, width - 1);
        for (int c = 0; c < channels; c++) {
          float sum =
              values[(top + left) * channels + c]
                  + values[(top + right) * channels + c]
                  + values[(bottom + left) * channels + c]
                  + values[(bottom + right) * channels + c];
          result.values[(y * result.width + x) * channels + c] = sum / 4;
        }
      }
    }
    return result;
  }

  /**
   * Returns a bilinear interpolation of this raster, of the size of one that {@link #halved} made
   * it from.
   */
  Raster doubled(int newWidth, int newHeight) {
    Raster result = new Raster(newWidth, newHeight, channels);
    for (int y = 0; y < newHeight; y++) {
      // Pixel centers: row y of the result is at (y - 0.5)/2 here.
      int above = Math.max(0, (y + 1) / 2 - 1);
      int below = Math.min(height - 1, (y + 1) / 2);
      double down = y % 2 == 0 ? .75 : .25;
      for (int x = 0; x < newWidth; x++) {
        int left = Math.max(0, (x + 1) / 2 - 1);
        int right = Math.min(width - 1, (x + 1) / 2);
        double across = x % 2 == 0 ? .75 : .25;
        for (int c = 0; c < channels; c++) {
          double top = value(left, above, c) * (1 - across) + value(right, above, c) * across;
          double bottom = value(left, below, c) * (1 - across) + value(right, below, c) * across;
          result.values[(y * newWidth + x) * channels + c] =
              (float) (top * (1 - down) + bottom * down);
        }
      }
    }
    return result;
  }

  float value(int x, int y, int channel) {
    return values[(y * width + x) * channels + channel];
  }
}
