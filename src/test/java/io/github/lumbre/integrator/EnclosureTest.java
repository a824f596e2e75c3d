package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import io.github.lumbre.testing.TestScenes;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests the mean and the variance of roulette for paths inside closed spheres, which only roulette
 * ends. The light is mostly ambient and the same at every vertex, so only roulette varies.
 */
class EnclosureTest {
  private static final Ray FROM_INSIDE = new Ray(new Vec3(.1, .2, -.3), new Vec3(.6, .64, .48));

  /** Returns a sphere of a given reflectance with an ambient irradiance of π. */
  private static Scene furnace(double albedo) {
    return empty().add(sphere(0, 0, 0, 1), matte(albedo)).addAmbient(Rgb.gray(Math.PI)).build();
  }

  /** Returns the moments of single samples, each from its own pixel. */
  private static Moments moments(Scene scene, int depth, Ray ray, int samples, long seed) {
    PathTracer tracer = new PathTracer(scene, depth);
    Sampler sampler = new SobolSampler(Effort.seed(seed));
    RenderContext scratch = new RenderContext();
    Moments moments = new Moments();
    for (int i = 0; i < samples; i++) {
      sampler.startSample(i & 0xffff, i >>> 16, 0);
      moments.add(tracer.radiance(ray, sampler, scratch).r());
    }
    return moments;
  }

  /**
   * ρ + ρ² + … + ρᴺ: the radiance of an enclosure with emission 1 after N bounces, without the
   * emission.
   */
  @ParameterizedTest
  @CsvSource({
    ".2, 0, 1",
    ".2, 1, 1.2",
    ".2, 2, 1.24",
    ".2, 5, 1.24992",
    ".2, 10, 1.249999974",
    ".2, 50, 1.25",
    ".5, 0, 1",
    ".5, 1, 1.5",
    ".5, 2, 1.75",
    ".5, 5, 1.96875",
    ".5, 10, 1.999023438",
    ".5, 50, 2",
    ".8, 1, 1.8",
    ".8, 2, 2.44",
    ".8, 5, 3.68928",
    ".8, 10, 4.57050327",
    ".8, 50, 4.99994291",
    ".8, 100, 5",
    ".9, 2, 2.71",
    ".9, 5, 4.68559",
    ".9, 10, 6.861894039",
    ".9, 50, 9.953616023",
    ".9, 100, 9.999760947",
    ".9, 1000, 10",
    ".95, 5, 5.298162187",
    ".95, 10, 8.623998154",
    ".95, 50, 18.53804547",
    ".95, 100, 19.88750994",
    ".95, 1000, 20",
    ".99, 1, 1.99",
    ".99, 5, 5.85198506",
    ".99, 10, 10.46617457",
    ".99, 50, 40.10439935",
    ".99, 100, 63.76279821",
    ".99, 1000, 99.99572605",
  })
  void furnaceIsTruncatedAtTheDepth(double albedo, int bounces, double radiance) {
    int samples = Effort.count(4000, 250_000);
    Moments moments = moments(furnace(albedo), bounces, FROM_INSIDE, samples, bounces);

    // The table has ten digits.
    double rounding = 1e-9 * radiance;
    double distance = Math.abs(moments.mean() - (radiance - 1));
    double z = Math.max(0, distance - rounding) / Math.sqrt(moments.variance() / samples + 1e-300);
    assertThat(Statistics.deviation(z)).isLessThan(Statistics.CRITICAL_Z);
  }

  /**
   * A path survives with certainty while its throughput is at least half of that behind the first
   * surface, ρ/2. Where it would fall below, roulette returns it to ρ/2, and from then on it
   * survives with ρ, so that the number of further vertices has a geometric distribution. With
   * probabilities of ρ² or less, the variance would be infinite. With this number of samples, the
   * variance has a standard error of 1 %.
   */
  @ParameterizedTest
  @CsvSource({".5, 700000", ".8, 200000", ".95, 100000"})
  void rouletteKeepsTheVarianceFinite(double albedo, int quick) {
    int samples = Effort.count(quick, 3 * quick);
    Moments moments = moments(furnace(albedo), 100_000, FROM_INSIDE, samples, 7);

    double all = albedo / (1 - albedo);
    double survival = 2 * albedo;
    while (survival >= 1) {
      survival *= albedo;
    }
    double each = .5 * albedo * albedo;
    double rest = survival * each / (1 - albedo);
    double square = survival * each * each * (1 + albedo) / ((1 - albedo) * (1 - albedo));
    double variance = square - rest * rest;
    assertThat(Statistics.deviation(moments.z(all))).isLessThan(Statistics.CRITICAL_Z);
    assertThat(moments.variance()).isCloseTo(variance, within(.05 * variance));
  }

  @Test
  void deeperPathsAreNeverDarker() {
    Scene scene =
        empty().add(sphere(0, 0, 0, 1), matte(.95)).add(point(Vec3.ZERO, Math.PI)).build();
    RenderContext scratch = new RenderContext();
    Sampler sampler = new SobolSampler(Effort.seed(3));
    for (int sample = 0; sample < Effort.count(50, 300); sample++) {
      double before = 0;
      for (int depth = 0; depth <= 1000; depth = depth < 20 ? depth + 1 : 2 * depth) {
        sampler.startSample(5, 6, sample);
        double radiance = new PathTracer(scene, depth).radiance(FROM_INSIDE, sampler, scratch).r();
        assertThat(radiance).isGreaterThanOrEqualTo(before);
        before = radiance;
      }
    }
  }

  /**
   * All pairs of points on a sphere have the same form factor: with a light of intensity π at the
   * center, Bᵢ = ρᵢ / (1 − (ρ₁ + ρ₂) / 2).
   */
  @ParameterizedTest
  @CsvSource({".5, .5", ".9, .9", ".2, .8", ".95, .1"})
  void hemispheresOfDifferentReflectanceLightEachOther(double upper, double lower) {
    Texture<Rgb> halves = (u, v) -> Rgb.gray(v < .5 ? upper : lower);

    Scene scene =
        empty().add(sphere(0, 0, 0, 1), new Matte(halves)).add(point(Vec3.ZERO, Math.PI)).build();
    int samples = Effort.count(20_000, 200_000);
    double all = 1 / (1 - .5 * (upper + lower));
    for (Vec3 way : new Vec3[] {new Vec3(.48, .8, .36), new Vec3(.48, -.8, .36)}) {
      double own = way.y() > 0 ? upper : lower;
      Moments moments = moments(scene, 100_000, new Ray(Vec3.ZERO, way), samples, 5);
      assertThat(Math.sqrt(moments.variance() / samples)).isLessThan(.03 * own * all);
      assertThat(Statistics.deviation(moments.z(own * all))).isLessThan(Statistics.CRITICAL_Z);
    }
  }

  /** White shapes of any form are invisible in a white environment. */
  @Test
  void whiteHollowsUnderAWhiteDomeAreWhite() {
    Scene scene =
        empty()
            .add(TestScenes.floor(), matte(1))
            .add(sphere(0, 1, 0, 1), matte(1))
            .add(sphere(1.5, .6, .3, .6), matte(1))
            .add(sphere(.4, .3, -1.4, .3), matte(1))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();
    for (double x : new double[] {.6, 1, 3}) {
      Ray ray = TestScenes.lookingDownAt(x);
      Estimate estimate = Estimate.of(new PathTracer(scene, 100_000), ray, Effort.count(64, 1024));
      assertThat(estimate.error()).isLessThan(5e-3);
      assertThat(estimate.z(1)).isLessThan(Estimate.CRITICAL);
    }
  }
}
