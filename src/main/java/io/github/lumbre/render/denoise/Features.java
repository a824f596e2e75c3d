package io.github.lumbre.render.denoise;

import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;

/**
 * What the network sees of a picture, row by row. Rows and columns are counted from a pixel whose
 * column and row in the full frame are multiples of {@link TileFilter#UNIT}, so that a crop is
 * filtered as the whole is. Beyond the picture are its mirror images: repeated pixels of the border
 * would be streaks that no noise explains.
 */
final class Features {
  /** Added to the albedo by which light is divided. */
  private static final float ALBEDO_FLOOR = .05f;

  /** More light counts as this much, so that sums of weighted light are finite floats. */
  private static final float BRIGHTEST = 1e15f;

  private static final float LARGEST_RELATIVE_NOISE = 4;

  /** Added to light by which noise is divided, so that noise of dark pixels is not all. */
  private static final float DARK = .05f;

  private static final int BLOCK = 8;
  private static final double DARK_BLOCK = 1e-6;
  private static final double MIDDLE_GRAY = .18;
  private static final float[] NONE = new float[0];

  private final int width;
  private final int height;
  private final int left;
  private final int top;

  /** Between 0 and {@link #BRIGHTEST}. */
  private final float[] light;

  private final float[] alpha;
  private final float[] noise;
  private final float[] albedo;
  private final float[] albedoNoise;
  private final float[] normal;
  private final float[] normalNoise;

  /** The factor by which the network's light is brighter than the picture's. */
  private final float scale;

  Features(NoisyPicture picture) {
    NoisyPicture.Halves none = new NoisyPicture.Halves(NONE, NONE);
    width = picture.width();
    height = picture.height();
    left = picture.left() % TileFilter.UNIT;
    top = picture.top() % TileFilter.UNIT;
    light = limited(picture.light().mean());
    alpha = picture.alpha();
    noise = picture.light().noise();
    albedo = picture.albedo().orElse(none).mean();
    albedoNoise = picture.albedo().orElse(none).noise();
    normal = picture.normal().orElse(none).mean();
    normalNoise = picture.normal().orElse(none).noise();
    scale = exposure();
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** Returns the number of the picture's first column. */
  int left() {
    return left;
  }

  /** Returns the number of the picture's first row. */
  int top() {
    return top;
  }

  /** Returns the number after the picture's last column. */
  int right() {
    return left + width;
  }

  /** Returns the number after the picture's last row. */
  int bottom() {
    return top + height;
  }

  /** Returns the number of planes of light that are filtered. */
  int planes() {
    return noise.length == 0 ? 6 : 12;
  }

  /** Returns the factor that brings the geometric mean of blocks of 8x8 pixels to middle gray. */
  private float exposure() {
    double sum = 0;
    int lit = 0;
    int across = Math.min(width, BLOCK);
    int down = Math.min(height, BLOCK);
    for (int y = 0; y + down <= height; y += down) {
      for (int x = 0; x + across <= width; x += across) {
        double mean = blockSum(x, y, across, down) / (3 * across * down);
        if (mean > DARK_BLOCK) {
          sum += Elementary.log(mean);
          lit++;
        }
      }
    }
    double factor = MIDDLE_GRAY / Elementary.exp(sum / Math.max(1, lit));
    return (float) Math.max(1e-4, Math.min(1e5, factor));
  }

  private double blockSum(int first, int upper, int across, int down) {
    double sum = 0;
    for (int y = upper; y < upper + down; y++) {
      for (int i = 3 * (y * width + first); i < 3 * (y * width + first + across); i++) {
        sum += light[i];
      }
    }
    return sum;
  }

  /** Returns the values themselves if all are within the limits. */
  private static float[] limited(float[] light) {
    int largest = Float.floatToRawIntBits(BRIGHTEST);
    for (float value : light) {
      // Bits of positive numbers are in their order, and those of negative ones below 0.
      int bits = Float.floatToRawIntBits(value);
      if (bits < 0 || bits > largest) {
        return copyWithinLimits(light);
      }
    }
    return light;
  }

  private static float[] copyWithinLimits(float[] light) {
    float[] limited = new float[light.length];
    for (int i = 0; i < light.length; i++) {
      limited[i] = limited(light[i]);
    }
    return limited;
  }

  private static float limited(float light) {
    return Math.max(0, Math.min(BRIGHTEST, light));
  }

  /** Returns the index of a pixel's first value. */
  private int index(int x, int y) {
    return 3 * (mirrored(y - top, height) * width + mirrored(x - left, width));
  }

  /** Returns the index in a row of a number of pixels that is continued by its mirror images. */
  private static int mirrored(int i, int pixels) {
    if (0 <= i && i < pixels) {
      return i;
    }
    int within = Math.floorMod(i, 2 * pixels);
    return within < pixels ? within : 2 * pixels - 1 - within;
  }

  private float divisor(int index) {
    return albedo.length == 0 ? ALBEDO_FLOOR : clamp(albedo[index], 0) + ALBEDO_FLOOR;
  }

  private static float clamp(float value, float least) {
    return Math.max(least, Math.min(1, value));
  }

  /**
   * Writes the features of some pixels of a row of a tile, {@linkplain Loops#rounded rounded}.
   *
   * @param first the tile's first column
   * @param y the tile's row
   * @param row the row in the maps
   * @param left the first column in the maps
   * @param right after the last column
   */
  void write(int first, int y, Maps maps, int row, int left, int right) {
    int at = maps.at(row);
    float[] values = new float[Network.FEATURES];
    for (int x = left; x < right; x++) {
      write(index(first + x, y), values);
      for (int i = 0; i < values.length; i++) {
        maps.plane(i)[at + x] = Loops.rounded(values[i]);
      }
    }
  }

  /** Writes the features of a pixel. */
  private void write(int i, float[] values) {
    float deviation = 0;
    float brightness = 0;
    float noisiest = 0;
    float largest = Math.max(divisor(i), Math.max(divisor(i + 1), divisor(i + 2)));
    for (int c = 0; c < 3; c++) {
      float value = light[i + c] * scale;
      float divisor = divisor(i + c);
      float error = noise.length == 0 ? 0 : limited(Math.abs(noise[i + c])) * scale;
      values[c] = tone(value);
      values[3 + c] = tone(value / divisor);
      brightness += value;
      deviation += error;
      noisiest = Math.max(noisiest, error / (value + DARK * divisor / largest));
      values[8 + c] = albedo.length == 0 ? 0 : clamp(albedo[i + c], 0);
      values[11 + c] = normal.length == 0 ? 0 : clamp(normal[i + c], -1);
    }
    deviation /= 3;
    values[6] = tone(deviation);
    float relative = relative(deviation / (brightness / 3 + DARK), noisiest);
    values[7] = Math.min(LARGEST_RELATIVE_NOISE, .5f * relative);
    values[14] = length(albedoNoise, i);
    values[15] = length(normalNoise, i);
  }

  /**
   * Returns the relative noise that the network is told. It was trained with that of the mean of
   * the channels; a channel with more than 2.5 times as much is one of a saturated color, and from
   * 4 times on it counts alone.
   */
  private static float relative(float ofMean, float ofNoisiest) {
    return Math.max(ofMean, Math.min(ofNoisiest, 2 * ofNoisiest - 4 * ofMean));
  }

  private static float tone(float light) {
    return (float) (.5 * Elementary.log1p(8.0 * light));
  }

  private static float length(float[] noise, int i) {
    if (noise.length == 0) {
      return 0;
    }
    double x = noise[i];
    double y = noise[i + 1];
    double z = noise[i + 2];
    return (float) Math.min(1, Math.sqrt(x * x + y * y + z * z));
  }

  /**
   * Writes light of some pixels of a row: scaled; the same divided by albedo; then the same two of
   * the noise, if it is known.
   *
   * @param first the first column
   * @param y the row
   * @param rows one array for each plane
   */
  void writeLight(int first, int y, float[][] rows, int count) {
    for (int x = 0; x < count; x++) {
      int i = index(first + x, y);
      for (int c = 0; c < 3; c++) {
        float divisor = divisor(i + c);
        float value = light[i + c] * scale;
        rows[c][x] = value;
        rows[3 + c][x] = value / divisor;
        if (noise.length != 0) {
          float error = Math.max(-BRIGHTEST, Math.min(BRIGHTEST, noise[i + c])) * scale;
          rows[6 + c][x] = error;
          rows[9 + c][x] = error / divisor;
        }
      }
    }
  }

  /**
   * Returns a mixture of plain and divided light, in the picture's units.
   *
   * @param index of the value in the picture
   */
  float mixed(int index, float share, float plain, float divided) {
    return (share * divided * divisor(index) + (1 - share) * plain) / scale;
  }

  /** Returns the network's light in the picture's units. */
  double unscaled(double scaled) {
    return scaled / scale;
  }

  /** Returns the light of a value of the picture. */
  float light(int index) {
    return light[index];
  }

  /** Returns the noise of a value of the picture; call it only if that is known. */
  float noise(int index) {
    return noise[index];
  }

  /**
   * Writes which pixels of a row the network may change by more than a part of their light, or have
   * no light and so nothing to compare with. Pixels that are transparent have neither.
   *
   * @param y the picture's row
   */
  void writeNoisy(int y, double part, boolean[] noisy) {
    double[] squares = new double[3 * width];
    if (noise.length == 0) {
      writeSquaredDifferences(y, squares);
    } else {
      writeVariances(y, squares);
    }
    double factor = noise.length == 0 ? 1 : BuiltInDenoiser.FARTHEST * BuiltInDenoiser.FARTHEST;
    for (int x = 0; x < width; x++) {
      boolean isNoisy = false;
      for (int c = 0; c < 3; c++) {
        double most = part * light[3 * (y * width + x) + c];
        isNoisy |= most == 0 || factor * squares[3 * x + c] > most * most;
      }
      noisy[x] = isNoisy && (alpha.length == 0 || alpha[y * width + x] != 0);
    }
  }

  /** Writes the squares of the largest differences of a row's light to the nearest eight pixels. */
  private void writeSquaredDifferences(int y, double[] squares) {
    int values = 3 * width;
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      for (int i = 0; i < values; i++) {
        for (int near = Math.max(i % 3, i - 3); near <= i + 3 && near < values; near += 3) {
          double difference = light[row * values + near] - (double) light[y * values + i];
          squares[i] = Math.max(squares[i], difference * difference);
        }
      }
    }
  }

  /**
   * Writes the variances of a row's light: each the larger one of its own and of the mean of its
   * neighborhood of 5x5 pixels.
   *
   * @param variances three values for each pixel of the row
   */
  void writeVariances(int y, double[] variances) {
    double[] sums = new double[3 * width];
    int first = Math.max(0, y - 2);
    int last = Math.min(height - 1, y + 2);
    for (int row = first; row <= last; row++) {
      for (int i = 0; i < sums.length; i++) {
        double value = noise[3 * row * width + i];
        sums[i] += value * value;
      }
    }
    Arrays.fill(variances, 0);
    for (int x = 0; x < width; x++) {
      int from = Math.max(0, x - 2);
      int to = Math.min(width - 1, x + 2);
      for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int near = from; near <= to; near++) {
          sum += sums[3 * near + c];
        }
        double own = noise[3 * (y * width + x) + c];
        int count = (to - from + 1) * (last - first + 1);
        variances[3 * x + c] = Math.max(own * own, sum / count);
      }
    }
  }
}
