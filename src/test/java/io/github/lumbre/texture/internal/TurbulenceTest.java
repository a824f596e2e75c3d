package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/**
 * Checks the report's statement that turbulence has structure and raw noise has none: texels
 * correlate with near ones at all scales up to the coarsest. {@link #main} draws both.
 */
class TurbulenceTest {
  private static final int SIDE = 512;
  private static final int COARSEST = 128;

  /** A random value for each texel, as turbulence adds at its finest scale. */
  private static final Noise RAW = new Noise(1, SIDE, SIDE, 1);

  private static final Noise TURBULENCE = new Noise(1, SIDE, SIDE, COARSEST);

  /** Returns the correlation of texels at a distance along a row: 1 if equal, 0 if uncorrelated. */
  private static double correlation(Noise noise, int distance) {
    double mean = 0;
    double square = 0;
    double product = 0;
    int count = SIDE * SIDE;
    for (int i = 0; i < count; i++) {
      int column = i % SIDE;
      int row = i / SIDE;
      double here = noise.turbulence(column, row);
      mean += here / count;
      square += here * here / count;
      product += here * noise.turbulence((column + distance) % SIDE, row) / count;
    }
    return (product - mean * mean) / (square - mean * mean);
  }

  /** For this number of uncorrelated pairs, the correlation has the standard deviation 1/512. */
  @Test
  void rawNoiseIsUnrelatedAtAllDistances() {
    for (int distance = 1; distance <= COARSEST; distance *= 2) {
      assertThat(correlation(RAW, distance)).isCloseTo(0, within(5.0 / SIDE));
    }
  }

  @Test
  void turbulenceIsTheMoreAlikeTheNearerUpToItsCoarsestScale() {
    double nearer = 1;
    for (int distance = 1; distance <= COARSEST; distance *= 2) {
      double here = correlation(TURBULENCE, distance);
      assertThat(here).isLessThan(nearer);
      nearer = here;
    }
    assertThat(correlation(TURBULENCE, COARSEST / 4)).isGreaterThan(.5);
    assertThat(nearer).isLessThan(.5);
  }

  /**
   * Draws both side by side, with raw noise on the left.
   *
   * @param arguments the PNG file to write
   * @throws IOException if it cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    int size = 200;
    float[] rgb = new float[3 * 2 * size * size];
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        int at = 3 * (2 * size * row + column);
        fill(rgb, at, 2 * RAW.turbulence(column, row));
        fill(rgb, at + 3 * size, TURBULENCE.turbulence(column, row));
      }
    }
    ImageWriter.write(new Image(2 * size, size, rgb, new float[0]), Path.of(arguments[0]));
  }

  private static void fill(float[] rgb, int at, double value) {
    for (int channel = 0; channel < 3; channel++) {
      rgb[at + channel] = (float) (value * value);
    }
  }
}
