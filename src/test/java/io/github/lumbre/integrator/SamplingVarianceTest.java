package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import org.junit.jupiter.api.Test;

/**
 * The variance of one sample of direct light is that of the intended sampling density. A wrong
 * density keeps the mean, so no other test would detect it.
 */
class SamplingVarianceTest {
  private static final double ALBEDO = .5;

  /** The factor from irradiance to the radiance of the floor. */
  private static final double SCALE = ALBEDO / Math.PI;

  private static Moments moments(Scene scene, MisHeuristic strategy, int samples) {
    PathTracer tracer = new PathTracer(scene, PathOptions.toDepth(1).by(strategy));
    Sampler sampler = new SobolSampler(Effort.seed(1));
    RenderContext scratch = new RenderContext();
    Moments moments = new Moments();
    for (int i = 0; i < samples; i++) {
      // Every sample has its own pixel, so the samples are independent.
      sampler.startSample(i & 0xffff, i >>> 16, 0);
      moments.add(tracer.radiance(lookingDownAt(0), sampler, scratch).r() / SCALE);
    }
    return moments;
  }

  private static Scene under(double height) {
    return empty()
        .add(floor(), matte(ALBEDO))
        .addAreaLight(ceilingLamp(1, 1, height), glow(1))
        .build();
  }

  private static void assertVariance(
      Scene scene, MisHeuristic strategy, int samples, double expected) {
    double variance = moments(scene, strategy, samples).variance();

    assertThat(variance).isCloseTo(expected, within(.05 * expected));
  }

  @Test
  void nearRectangleIsSampledBySolidAngle() {
    assertVariance(under(1), MisHeuristic.LIGHT, Effort.count(100_000, 1_000_000), .00106004);
  }

  /** For sampling by area: E[(cos² / d²)²] − E², integrated over the light by the midpoint rule. */
  @Test
  void farRectangleIsSampledByArea() {
    double height = 2;
    int n = 500;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < n * n; i++) {
      double x = (i % n + .5) / n - .5;
      double y = (i / n + .5) / n - .5;
      double dd = x * x + y * y + height * height;
      double value = height * height / (dd * dd);
      sum += value / (n * n);
      squares += value * value / (n * n);
    }

    double expected = squares - sum * sum;
    assertVariance(under(height), MisHeuristic.LIGHT, Effort.count(100_000, 1_000_000), expected);
  }

  @Test
  void diffuseSurfaceScattersByTheCosine() {
    assertVariance(under(1), MisHeuristic.BSDF, Effort.count(200_000, 1_000_000), 1.79742);
  }

  /** If all light comes from a small part of the environment, every sample goes there. */
  @Test
  void smallBrightPartOfADomeIsSampled() {
    EnvironmentLight dome =
        EnvironmentLight.image(
            Frame.WORLD,
            (u, v) -> Rgb.gray(v > .9 && v < .92 && u > .3 && u < .32 ? 1000 : 0),
            100,
            100);
    Scene scene = empty().add(floor(), matte(ALBEDO)).add(dome).build();
    Moments moments = moments(scene, MisHeuristic.LIGHT, Effort.count(20_000, 500_000));

    // Rows of the table narrow by 10 % towards the zenith, which gives a standard deviation of
    // 0.1/√12. Uniform samples would hit the part once in 10,000.
    assertThat(moments.mean()).isPositive();
    assertThat(Math.sqrt(moments.variance())).isLessThan(.04 * moments.mean());
  }
}
