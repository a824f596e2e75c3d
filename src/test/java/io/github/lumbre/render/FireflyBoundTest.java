package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Pictures whose light comes in part from few bright samples, without a scene: each sample of a
 * pixel is its base, and with a probability of q it is V brighter, so that the pixel converges to
 * base + q V.
 */
class FireflyBoundTest {
  private static final int SIDE = 24;
  private static final int PICTURES = 200;
  private static final double CONFIDENCE = .95;

  private record Light(double base, double probability, double brightness) {
    double converged() {
      return base + probability * brightness;
    }
  }

  private static Film film(Light light, int samples, SplittableRandom random) {
    Film film = new Film(new Crop(0, 0, SIDE, SIDE), false, 0);
    for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
      for (int i = 0; i < samples; i++) {
        double base = light.base * (.5 + random.nextDouble());
        double extra = random.nextDouble() < light.probability ? light.brightness : 0;
        film.add(pixel, Rgb.gray(base + extra), true);
      }
    }
    return film;
  }

  private static double error(Film film, double converged) {
    double sum = 0;
    float[] rgb = film.develop().rgb();
    for (float value : rgb) {
      sum += (value - converged) * (value - converged) / (converged * converged + .01);
    }
    return sum / rgb.length;
  }

  /**
   * Of bounds that hold with 95 %, more than 20 of 200 fail with a probability of .001. If pixels
   * are compared with their own halves alone, all 200 of 16 samples fail in the first row.
   */
  @Test
  void boundsHoldWhereFewBrightSamplesCarryTheNoise() {
    Light[] lights = {
      new Light(.3, 1 / 3000.0, 400),
      new Light(.1, 1 / 1000.0, 100),
      new Light(.3, 0, 0)
    };
    for (Light light : lights) {
      for (int samples : new int[] {16, 48, 64}) {
        SplittableRandom random = new SplittableRandom(samples);
        int beyond = 0;
        double ratio = 0;
        for (int i = 0; i < PICTURES; i++) {
          Film film = film(light, samples, random);
          double error = error(film, light.converged());
          NoiseEstimate noise = NoiseEstimate.of(film, CONFIDENCE).orElseThrow();
          beyond += error > noise.upperRelativeMse() ? 1 : 0;
          ratio += noise.upperRelativeRmse() / Math.sqrt(error) / PICTURES;
        }
        assertThat(beyond).as(light + ", " + samples).isLessThanOrEqualTo(20);
        assertThat(ratio).as(light + ", " + samples).isBetween(1., 2.6);
      }
    }
  }
}
