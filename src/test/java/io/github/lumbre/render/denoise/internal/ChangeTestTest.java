package io.github.lumbre.render.denoise.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ChangeTestTest {
  private static final int SIZE = 40;
  private static final int PIXELS = SIZE * SIZE;
  private static final int MIDDLE = SIZE / 2 * SIZE + SIZE / 2;

  private final float[] differences = new float[3 * PIXELS];
  private final float[] counts = new float[PIXELS];

  ChangeTestTest() {
    Arrays.fill(counts, 1);
  }

  /** Weighs differences whose noise has a standard deviation of 1 in each channel. */
  private float[] weights() throws InterruptedException {
    float[] variances = new float[PIXELS];
    Arrays.fill(variances, 3);
    return new ChangeTest(SIZE, SIZE, i -> 1e-12, 2).weights(differences, variances, counts);
  }

  private void addNoise(double deviation) {
    Random random = new Random(1);
    for (int i = 0; i < differences.length; i++) {
      differences[i] += (float) (deviation * random.nextGaussian());
    }
  }

  private static double mean(float[] weights) {
    return IntStream.range(0, PIXELS).mapToDouble(i -> weights[i]).average().orElseThrow();
  }

  @Test
  void noiseIsNoChange() throws InterruptedException {
    addNoise(1);
    assertThat(mean(weights())).isGreaterThan(.8);
  }

  @Test
  void moreNoiseThanExpectedIsAChange() throws InterruptedException {
    addNoise(2);
    assertThat(mean(weights())).isLessThan(.05);
  }

  /** Each pixel differs by less than its noise, but all of them differ alike. */
  @Test
  void smallChangesOfOneSignAreFound() throws InterruptedException {
    addNoise(.3);
    assertThat(mean(weights())).isEqualTo(1);
    for (int i = 0; i < differences.length; i++) {
      differences[i] += .7f;
    }
    assertThat(mean(weights())).isLessThan(.1);
  }

  @Test
  void changesOfOnePixelAreFoundAndStayNearIt() throws InterruptedException {
    Arrays.fill(differences, 3 * MIDDLE, 3 * MIDDLE + 3, 15);
    float[] weights = weights();
    assertThat(weights[MIDDLE]).isLessThan(1e-3f);
    assertThat(weights[MIDDLE + 1]).isLessThan(1e-3f);
    assertThat(weights[MIDDLE + 4]).isEqualTo(1);
  }

  @Test
  void pixelsWithoutADifferenceDoNotCount() throws InterruptedException {
    Arrays.fill(differences, 3 * MIDDLE, 3 * MIDDLE + 3, 15);
    counts[MIDDLE] = 0;
    float[] weights = weights();
    assertThat(weights[MIDDLE]).isZero();
    assertThat(weights[MIDDLE + 1]).isEqualTo(1);
  }
}
