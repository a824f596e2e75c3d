package io.github.lumbre.lab.metrics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the noise estimate from independent pictures. */
class PictureNoiseTest {
  private static final int SIDE = 100;

  private final SplittableRandom random = new SplittableRandom(6);

  private static Image pixel(float value) {
    return new Image(1, 1, new float[] {value, value, value}, new float[0]);
  }

  @Test
  void errorIsHalfTheSquaredDifferenceOverTheSquaredMean() {
    PictureNoise noise = PictureNoise.of(List.of(pixel(.5f), pixel(.7f)));
    assertThat(noise.relativeMse()).isCloseTo(.02 / (.36 + .01), within(1e-7));
  }

  @Test
  void everyPairHasItsEstimateOverTheMeanOfAll() {
    PictureNoise noise = PictureNoise.of(List.of(pixel(0), pixel(2), pixel(1), pixel(1)));
    assertThat(noise.relativeMses()).hasSize(2);
    assertThat(noise.relativeMses().get(0)).isCloseTo(2 / 1.01, within(1e-7));
    assertThat(noise.relativeMses().get(1)).isZero();
    assertThat(noise.relativeMse()).isCloseTo(1 / 1.01, within(1e-7));
  }

  @Test
  void estimateIsTheErrorThatAReferenceWouldTell() {
    // 60000 squared differences: a standard error below 1 %.
    double mean = .4;
    double width = .1;
    List<Image> pictures = Stream.generate(() -> noisy(mean, width)).limit(4).toList();
    double variance = width * width / 12;
    assertThat(PictureNoise.of(pictures).relativeMse())
        .isCloseTo(variance / (mean * mean + .01), within(.04 * variance / (mean * mean + .01)));
  }

  private Image noisy(double mean, double width) {
    float[] rgb = new float[3 * SIDE * SIDE];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) (mean + width * (random.nextDouble() - .5));
    }
    return new Image(SIDE, SIDE, rgb, new float[0]);
  }
}
