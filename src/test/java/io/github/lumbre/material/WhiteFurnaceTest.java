package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.direction;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Figures;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * In a uniform environment of radiance 1, the mean of independent samples of every lobe is its
 * albedo, known from quadrature. No lobe scatters more light than it receives.
 *
 * <p>Quick builds check this more coarsely with lattice points. With a million weights of standard
 * deviation 0.3, a bias of 0.3 % is detected with a probability above 0.99.
 */
@Tag(Effort.EXHAUSTIVE)
class WhiteFurnaceTest {
  private static final int SAMPLES = 1_000_000;
  private static final int POINTS = 200;

  /** The maximum weight of a sample, which the Phong lobe with exponent 0 has. */
  private static final double HEAVIEST = 2;

  private static final double[] COSINES = {.01, .03, .1, .2, .3, .5, .7, .9, .97, 1};
  private static final double[] EXPONENTS = {0, 1, 10, 52, 1e3, 1e6, 1e9};
  private static final double[] ROUGHNESSES = {1e-3, .01, .05, .1, .3, .5, 1};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(48));

  /** An integral and its error bound. */
  private record Albedo(double value, double error) {
    /** Returns the albedo from two quadratures; the second has twice as many points per side. */
    static Albedo of(double coarse, double fine) {
      return new Albedo(fine, 2 * Math.abs(fine - coarse) + 1e-9);
    }
  }

  /**
   * Checks that the mean is close to the albedo, with an error probability of 1e-6, even if samples
   * with large or zero weights are rare (Maurer &amp; Pontil 2009, theorem 4).
   */
  private void assertAverage(Bsdf bsdf, Vec3 wo, Albedo albedo) {
    Moments moments =
        Statistics.moments(
            SAMPLES,
            () -> bsdf.sample(wo, random.nextDouble(), Draws.inSquare(random)).weight().max());
    double log = Math.log(2 / Statistics.ALPHA);
    double chance =
        Math.sqrt(2 * log * moments.variance() / SAMPLES)
            + 7 * HEAVIEST * log / (3.0 * (SAMPLES - 1));
    double distance = Math.abs(moments.mean() - albedo.value);
    assertThat(albedo.error).isLessThan(2e-3);
    assertThat(distance)
        .as("%s, wo %s: %s, expected %s", bsdf, wo, moments.mean(), albedo)
        .isLessThanOrEqualTo(chance + albedo.error);
    assertThat(moments.mean()).isLessThanOrEqualTo(1 + chance);
    Figures.worst("furnace: share of what chance allows", distance / (chance + albedo.error));
    Figures.worst("furnace: mean weight beyond 1", moments.mean() - 1);
  }

  @Test
  void matteSurfacesScatterWhatArrives() {
    for (double cos : COSINES) {
      assertAverage(new Lambertian(Rgb.WHITE), direction(cos), new Albedo(1, 0));
    }
  }

  @Test
  void phongLobesScatterTheirAlbedo() {
    for (double exponent : EXPONENTS) {
      PhongLobe lobe = new PhongLobe(Rgb.WHITE, exponent);
      for (double cos : COSINES) {
        Vec3 wo = direction(cos);
        assertAverage(lobe, wo, new Albedo(PhongLobeTest.albedo(lobe, wo), 1e-8));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void facetsReflectTheirAlbedo(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      FacetMap map = new FacetMap(kind, alpha);
      for (double ior : new double[] {MicrofacetReflectionTest.PERFECT, 1.5}) {
        Bsdf bsdf = new MicrofacetReflection(Rgb.WHITE, ior, map.distribution());
        for (double cos : COSINES) {
          Vec3 wo = direction(cos);
          double coarse = map.integral(wo, 0, POINTS, wi -> bsdf.evaluate(wo, wi).f().g());
          double fine = map.integral(wo, 0, 2 * POINTS, wi -> bsdf.evaluate(wo, wi).f().g());
          assertAverage(bsdf, wo, Albedo.of(coarse, fine));
        }
      }
    }
  }

  @Test
  void groundGlassReflectsAndPassesItsAlbedo() {
    for (double alpha : ROUGHNESSES) {
      RoughDielectric glass = new RoughDielectric(Rgb.WHITE, Rgb.WHITE, 1.5, new Ggx(alpha));
      for (double cos : COSINES) {
        for (Vec3 wo : new Vec3[] {direction(cos), direction(-cos)}) {
          double coarse = both(glass, wo, POINTS);
          assertAverage(glass, wo, Albedo.of(coarse, both(glass, wo, 2 * POINTS)));
        }
      }
    }
  }

  private static double both(RoughDielectric glass, Vec3 wo, int points) {
    return RoughDielectricTest.albedo(glass, wo, false, points)
        + RoughDielectricTest.albedo(glass, wo, true, points);
  }
}
