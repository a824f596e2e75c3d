package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the mean, the continuity and the tiling of noise. */
class NoiseTest {
  @ParameterizedTest
  @CsvSource({
    "1, 64, 64",
    "32, 1000, 999",
    "100, 640, 480",
    "128, 500, 500",
    "1e6, 77, 5",
    "256, 1, 300"
  })
  void theMeanOfAllSeedsIsHalfTheOctavesWeight(double coarsest, int width, int height) {
    int count = 20_000;
    double sum = 0;
    double squares = 0;
    for (int seed = 0; seed < count; seed++) {
      Noise noise = new Noise(seed, width, height, coarsest);
      double t = noise.turbulence(seed * 37 % width, seed * 101 % height);
      sum += t;
      squares += t * t;
    }
    int octaves = 1 + (int) Math.floor(Math.log(coarsest) / Math.log(2));
    double mean = sum / count;
    double deviation = Math.sqrt((squares / count - mean * mean) / count);
    assertThat(mean).isCloseTo((1 - Math.pow(2, -octaves)) / 2, within(4.8916 * deviation));
    assertThat(deviation).isBetween(1e-4, 3e-3);
  }

  /**
   * Returns a bound of the step between texels. Neighboring cells differ by less than 1, so an
   * octave changes per texel by less than its number of cells per texel.
   */
  private static double largestStep(int size, double coarsest) {
    double step = 0;
    double weight = .5;
    for (double scale = coarsest; scale >= 1; scale /= 2) {
      double cells = Math.max(1, Math.rint(size / scale));
      step += weight * (cells == 1 ? 0 : Math.min(1, cells / size));
      weight /= 2;
    }
    return step;
  }

  @ParameterizedTest
  @CsvSource({
    "1024, 256, 1024",
    "1000, 300, 128",
    "300, 1000, 100",
    "97, 89, 89",
    "640, 1, 640",
    "100, 150, 1e300"
  })
  void stepsAreBoundedAcrossTheBordersToo(int width, int height, double coarsest) {
    Noise noise = new Noise(3, width, height, coarsest);
    double across = largestStep(width, coarsest);
    double down = largestStep(height, coarsest);
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        double here = noise.turbulence(column, row);
        double right = noise.turbulence((column + 1) % width, row);
        double below = noise.turbulence(column, (row + 1) % height);
        if (Math.abs(here - right) > across || Math.abs(here - below) > down) {
          throw new AssertionError("column " + column + ", row " + row);
        }
      }
    }
  }

  @Test
  void theFinestScaleHasAValueOfItsOwnForEveryTexel() {
    Noise noise = new Noise(5, 50, 40, 1);
    Set<Double> values = new HashSet<>();
    for (int i = 0; i < 2000; i++) {
      values.add(2 * noise.turbulence(i % 50, i / 50));
    }
    assertThat(values).hasSize(2000).allMatch(v -> v >= 0 && v < 1);
  }

  @Test
  void noiseOfOneRowOrColumnVariesAlongIt() {
    for (double coarsest : new double[] {1, 2, 16}) {
      Noise row = new Noise(5, 64, 1, coarsest);
      Noise column = new Noise(5, 1, 64, coarsest);
      Set<Double> across = new HashSet<>();
      Set<Double> down = new HashSet<>();
      for (int i = 0; i < 64; i++) {
        across.add(row.turbulence(i, 0));
        down.add(column.turbulence(0, i));
      }
      assertThat(across).hasSize(64);
      assertThat(down).hasSize(64);
    }
  }

  @Test
  void sizesWithoutTexelsAreRefused() {
    assertThatThrownBy(() -> new Noise(0, 10, 0, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("width and height: expected 1 to 16384, found 10x0");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, .999, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void scalesBelowATexelAreRefused(double coarsest) {
    assertThatThrownBy(() -> new Noise(0, 10, 10, coarsest))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("coarsest: expected a finite number >= 1, found " + coarsest);
  }
}
