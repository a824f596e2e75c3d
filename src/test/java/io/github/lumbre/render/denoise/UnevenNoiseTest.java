package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests saturated colors under white reflections, whose relative noise differs by channel. */
class UnevenNoiseTest {
  private static final int SIDE = 64;
  private static final double REFLECTED = .02;

  private static NoisyPicture.Halves even(double... color) {
    float[] mean = new float[3 * SIDE * SIDE];
    for (int i = 0; i < mean.length; i++) {
      mean[i] = (float) color[i % 3];
    }
    return new NoisyPicture.Halves(mean, new float[mean.length]);
  }

  /** Returns a plastic that reflects white light, which one of 32 samples finds, four in a half. */
  private static NoisyPicture plastic(double red, double green, double blue) {
    NoisyPicture.Halves light =
        even(red * .8 + REFLECTED, green * .8 + REFLECTED, blue * .8 + REFLECTED);
    Random random = new Random(5);
    for (int i = 0; i < light.mean().length; i += 3) {
      double[] found = new double[2];
      for (int sample = 0; sample < 8; sample++) {
        found[sample % 2] += random.nextInt(32) == 0 ? 8 * REFLECTED : 0;
      }
      for (int c = i; c < i + 3; c++) {
        light.mean()[c] += (float) ((found[0] + found[1]) / 2 - REFLECTED);
        light.noise()[c] = (float) ((found[0] - found[1]) / 2);
      }
    }
    NoisyPicture.Halves albedo = even(red + .04, green + .04, blue + .04);
    return new NoisyPicture(
        SIDE,
        SIDE,
        light,
        Optional.of(albedo),
        Optional.of(even(0, 0, 1)),
        new float[0],
        0);
  }

  /** Returns the deviation of a channel from its mean in the middle of a picture. */
  private static double deviation(float[] rgb, int channel) {
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
      if (i / SIDE >= 16 && i / SIDE < 48 && i % SIDE >= 16 && i % SIDE < 48) {
        double value = rgb[3 * i + channel];
        sum += value;
        squares += value * value;
        count++;
      }
    }
    return Math.sqrt(squares / count - sum * sum / count / count);
  }

  @Test
  void saturatedColorsLoseTheGrainOfTheirDarkChannels() throws InterruptedException {
    for (double[] color : new double[][] {{.64, 0, 0}, {0, .64, 0}, {.64, 0, .64}}) {
      NoisyPicture noisy = plastic(color[0], color[1], color[2]);
      float[] clean = BuiltInDenoiser.denoise(noisy, 2).image().rgb();
      for (int c = 0; c < 3; c++) {
        assertThat(deviation(clean, c))
            .as(Arrays.toString(color) + " " + c)
            .isLessThan(deviation(noisy.light().mean(), c) / 8);
      }
    }
  }

  /** Where all channels have the same relative noise, the network's result stays. */
  @Test
  void grayStays() {
    NoisyPicture noisy = plastic(.3, .3, .3);
    float[] result = noisy.light().mean().clone();
    new UnevenNoise(new Features(noisy), noisy.light().mean(), noisy.light().noise())
        .write(30, 0, SIDE, result);
    assertThat(result).isEqualTo(noisy.light().mean());
  }

  /** A pattern that noise does not explain stays in the noisiest channel, too. */
  @Test
  void patternsStay() {
    NoisyPicture noisy = plastic(.64, 0, 0);
    float[] filtered = even(.5, .02, .02).mean();
    float[] noise = new float[filtered.length];
    for (int i = 0; i < filtered.length; i += 3) {
      int x = i / 3 % SIDE;
      filtered[i + 1] += x / 2 % 2 == 0 ? .01f : -.01f;
      noise[i + 1] = (x + i / 3 / SIDE) % 2 == 0 ? .002f : -.002f;
    }
    float[] result = filtered.clone();
    new UnevenNoise(new Features(noisy), filtered, noise).write(30, 0, SIDE, result);
    int at = 3 * (30 * SIDE + 32) + 1;
    // The noise is 4 % of the variance of the pattern.
    assertThat(result[at] - .02).isCloseTo(.96 * .01, within(2e-4));
    assertThat(result[at - 1]).isEqualTo(filtered[at - 1]);
  }
}
