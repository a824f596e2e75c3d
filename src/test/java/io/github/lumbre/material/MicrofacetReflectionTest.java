package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Beckmann;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests microfacet reflection against tables and BSDF invariants. */
class MicrofacetReflectionTest {
  /** An index of refraction with which facets reflect all light. */
  static final double PERFECT = 1e150;

  private static final double[] ROUGHNESSES = {1e-3, .01, .05, .1, .3, .5, 1};
  private static final Rgb TINT = new Rgb(.3, .6, 1);

  private final SplittableRandom random = new SplittableRandom(Effort.seed(41));

  private static MicrofacetReflection bsdf(double ior, Microfacets facets) {
    return new MicrofacetReflection(Rgb.WHITE, ior, facets);
  }

  /** The albedo of perfectly reflecting facets: Beckmann with height-correlated masking. */
  @ParameterizedTest
  @CsvSource({
    ".1, 1, 1, .99986, .9378",
    ".3, .9998, .99146, .92328, .9163",
    ".5, .943, .90284, .86935, .92896",
    "1, .46159, .54802, .76662, .91923",
  })
  void albedoOfPerfectFacetsIsTheTabulatedOne(
      double alpha, double normal, double at30, double at60, double at80) {
    FacetMap map = new FacetMap(MicrofacetDistribution.BECKMANN, alpha);
    Bsdf bsdf = bsdf(PERFECT, map.distribution());
    double[] expected = {normal, at30, at60, at80};
    double[] degrees = {0, 30, 60, 80};
    for (int i = 0; i < 4; i++) {
      Vec3 wo = direction(Math.cos(Math.toRadians(degrees[i])));
      double albedo = map.integral(wo, 0, 200, wi -> bsdf.evaluate(wo, wi).f().g());
      assertThat(albedo).isCloseTo(expected[i], within(1e-4));
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void sampledWeightsAverageToTheAlbedoAndNeverExceedOne(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      FacetMap map = new FacetMap(kind, alpha);
      for (double ior : new double[] {PERFECT, 1.5}) {
        Bsdf bsdf = bsdf(ior, map.distribution());
        for (double cos : COSINES) {
          Vec3 wo = direction(cos);
          double albedo = map.integral(wo, 0, 100, wi -> bsdf.evaluate(wo, wi).f().g());
          double sampled = BsdfLaws.sampledAlbedo(bsdf, wo, 10_000);
          assertThat(sampled).isCloseTo(albedo, within(2e-3)).isLessThanOrEqualTo(1);
          assertThat(BsdfLaws.sampledAlbedo(bsdf, wo.negated(), 10_000))
              .isCloseTo(sampled, within(1e-9));
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void scatteringIsReciprocal(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      Bsdf bsdf = bsdf(1.5, Microfacets.of(kind, alpha));
      for (int i = 0; i < 10_000; i++) {
        Vec3 a = direction(random);
        Vec3 b = i % 2 == 0 ? direction(random) : nearMirror(a, alpha);
        BsdfLaws.assertReciprocal(bsdf, a, b, 64 * EPS);
      }
    }
  }

  private Vec3 nearMirror(Vec3 a, double alpha) {
    return new Vec3(-a.x(), -a.y(), a.z()).plus(alpha, direction(random)).normalized();
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void sampledDirectionsFollowPdfAndThoseBelowTheHorizonAreRefused(MicrofacetDistribution kind) {
    int samples = Effort.count(40_000, 1_000_000);
    for (double alpha : new double[] {1e-3, .1, .5, 1}) {
      FacetMap map = new FacetMap(kind, alpha);
      for (double cos : new double[] {1, .9, -.5, .1, -.01}) {
        map.assertSamplesFollowPdf(
            bsdf(1.5, map.distribution()), direction(cos), 0, samples, random);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void weightIsEvalOverPdf(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      Bsdf bsdf = new MicrofacetReflection(TINT, 1.5, Microfacets.of(kind, alpha));
      for (double cos : COSINES) {
        BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(cos), 1000, random, 1e-12);
        BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(-cos), 1000, random, 1e-12);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void extremesAreHarmless(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      for (double ior : new double[] {.5, 1, 1 + 1e-7, 1.5, 1e6}) {
        BsdfLaws.assertExtremesAreHarmless(bsdf(ior, Microfacets.of(kind, alpha)));
      }
    }
  }

  @Test
  void nothingPassesThrough() {
    Bsdf bsdf = bsdf(1.5, new Beckmann(.3));
    assertThat(bsdf.evaluate(Vec3.Z, new Vec3(.6, 0, -.8)).f().isBlack()).isTrue();
    assertThat(bsdf.pdf(new Vec3(.6, 0, -.8), Vec3.Z)).isZero();
  }

  /** At normal incidence and exitance, the value is F D / 4, with F = 0.04 and D = 1 / πα². */
  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void highlightIsAsHighAsTheDistribution(MicrofacetDistribution kind) {
    double value = bsdf(1.5, Microfacets.of(kind, .2)).evaluate(Vec3.Z, Vec3.Z).f().g();
    assertThat(value).isCloseTo(.04 / (4 * Math.PI * .04), within(1e-13));
  }

  /** The narrowest lobe scatters as much light as the mirror that replaces it. */
  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void albedoIsContinuousWhereTheMirrorTakesOver(MicrofacetDistribution kind) {
    Lobe rough = bsdf(1.5, Microfacets.of(kind, CookTorrance.SMOOTH));
    Lobe mirror = new FresnelMirror(Rgb.WHITE, 1.5);
    for (double cos : COSINES) {
      assertThat(rough.importance(cos)).isEqualTo(mirror.importance(cos));
      double smooth = BsdfLaws.sampledAlbedo(mirror, direction(cos), 1);
      assertThat(relative(BsdfLaws.sampledAlbedo(rough, direction(cos), 10_000), smooth))
          .isLessThan(.01);
    }
  }

  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void noFacetOverhangsOrStandsUpright(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      Microfacets facets = Microfacets.of(kind, alpha);
      assertThat(facets.density(Vec3.X)).isZero();
      assertThat(facets.density(direction(-.1))).isZero();
      assertThat(facets.density(direction(-1))).isZero();
    }
  }

  /** For both distributions, the projected area of all facets is that of the surface. */
  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void facetsCoverTheSurface(MicrofacetDistribution kind) {
    for (double alpha : ROUGHNESSES) {
      Microfacets facets = Microfacets.of(kind, alpha);
      int n = 20_000;
      double sum = 0;
      for (int i = 0; i < n; i++) {
        double tan = alpha * Math.pow((i + .5) / (n - i - .5), 2);
        double step = alpha * 2 * (i + .5) * n / Math.pow(n - i - .5, 3);
        double cos = 1 / Math.sqrt(1 + tan * tan);
        Vec3 m = new Vec3(tan * cos, 0, cos);
        sum += facets.density(m) * cos * 2 * Math.PI * tan * cos * cos * cos * step;
      }
      assertThat(sum).isCloseTo(1, within(1e-6));
    }
  }

  /** From every direction, the projected area of the visible facets is that of the surface. */
  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void visibleFacetsCoverTheSurface(MicrofacetDistribution kind) {
    for (double alpha : new double[] {.05, .5, 1}) {
      FacetMap map = new FacetMap(kind, alpha);
      Microfacets facets = map.distribution();
      for (double cos : COSINES) {
        Vec3 wo = direction(cos);
        double sum =
            map.integral(
                wo,
                0,
                300,
                wi -> {
                  Vec3 m = wo.plus(wi).normalized();
                  return facets.density(m) / (4 * facets.visible(wo.z()));
                });
        assertThat(sum).isCloseTo(1, within(1e-3));
      }
    }
  }
}
