package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the light that rough materials of the scene format scatter repeatedly. */
class MultipleScatteringTest {
  private static final Texture<Rgb> WHITE = Texture.constant(Rgb.WHITE);
  private static final Rgb COLOR = new Rgb(.9, .5, .1);
  private static final double[] ALPHAS = {.01, .1, .3, .6, 1};
  private static final double[] COSINES = {1, .6, .2, .05};

  /** The error of 4000 lattice points in the mean weight. */
  private static final double LATTICE = 4e-3;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(71));

  private static Glass glass(double ior, double alpha) {
    return new Glass(WHITE, WHITE, ScalarTexture.constant(ior), ScalarTexture.constant(alpha));
  }

  private static CookTorrance metal(Rgb color, double ior, double alpha) {
    return new CookTorrance(
        Texture.constant(Rgb.BLACK),
        Texture.constant(color),
        ScalarTexture.constant(alpha),
        ScalarTexture.constant(ior),
        MicrofacetDistribution.GGX);
  }

  private static double albedo(Material material, double cosine) {
    return BsdfLaws.sampledAlbedo(material.at(0, 0), direction(cosine), 4000);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1 / 2.4, 1 / 1.5, 1.05, 1.33, 1.5, 2.4})
  void clearGlassKeepsItsLight(double ior) {
    for (double alpha : ALPHAS) {
      Glass glass = glass(ior, alpha).withMultipleScattering();
      for (double cosine : COSINES) {
        for (double side : new double[] {1, -1}) {
          assertThat(albedo(glass, side * cosine))
              .as("index %s, alpha %s, cosine %s", ior, alpha, side * cosine)
              .isBetween(.99 - LATTICE, 1 + LATTICE);
        }
      }
    }
  }

  @Test
  void facetsThatReflectEverythingKeepTheirLight() {
    for (double alpha : ALPHAS) {
      CookTorrance metal = metal(Rgb.WHITE, 1e6, alpha).withMultipleScattering();
      for (double cosine : COSINES) {
        assertThat(albedo(metal, cosine))
            .as("alpha %s, cosine %s", alpha, cosine)
            .isBetween(.99 - LATTICE, 1 + LATTICE);
      }
    }
  }

  /**
   * Facets of mean reflectance F return F² E / (1 - F (1 - E)) of what a first one loses, where E
   * is the mean part that leaves after each reflection (Kulla and Conty 2017).
   */
  @Test
  void facetsThatAbsorbReturnPartOfTheLostLight() {
    double fresnel = MultipleScattering.meanReflectance(CookTorrance.DEFAULT_IOR);
    for (double alpha : new double[] {.3, .6, 1}) {
      FacetLoss lost = FacetLoss.of(1e9, alpha);
      double leaves = 1 - lost.mean(false);
      double share = fresnel * fresnel * leaves / (1 - fresnel * (1 - leaves));
      CookTorrance single = metal(Rgb.WHITE, CookTorrance.DEFAULT_IOR, alpha);
      double once = albedo(single, .7);
      double all = albedo(single.withMultipleScattering(), .7);
      assertThat(all - once).isCloseTo(lost.at(.7) * share, within(2e-3));
    }
  }

  /** With the flag, smooth surfaces stay as they are; without it, rough ones too. */
  @Test
  void classicScatteringIsThatOfOneFacet() {
    assertThat(glass(1.5, .4).at(0, 0))
        .isEqualTo(new RoughDielectric(Rgb.WHITE, Rgb.WHITE, 1.5, new Ggx(.4)));
    assertThat(metal(COLOR, 2, .4).at(0, 0))
        .isEqualTo(new MicrofacetReflection(COLOR, 2, new Ggx(.4)));
    assertThat(glass(1.5, 1e-4).withMultipleScattering().at(0, 0))
        .isEqualTo(glass(1.5, 1e-4).at(0, 0));
    assertThat(metal(COLOR, 2, 1e-4).withMultipleScattering().at(0, 0))
        .isEqualTo(metal(COLOR, 2, 1e-4).at(0, 0));
    assertThat(glass(1.5, .4).withMultipleScattering().withRoughness(.2).multipleScattering())
        .isTrue();
  }

  @Test
  void scatteringIsReciprocalButForTheIndices() {
    for (double ior : new double[] {1 / 1.5, 1.5}) {
      for (Material material :
          List.of(
              glass(ior, .5).withMultipleScattering(),
              metal(COLOR, ior, .5).withMultipleScattering())) {
        Bsdf bsdf = material.at(0, 0);
        double inside = material instanceof Glass ? ior * ior : 1;
        for (int i = 0; i < 300; i++) {
          var a = direction(random);
          var b = direction(random);
          double there = bsdf.evaluate(a, b).f().g() / Math.abs(b.z());
          double back = bsdf.evaluate(b, a).f().g() / Math.abs(a.z());
          double scaledThere = there / (b.z() > 0 ? 1 : inside);
          double scaledBack = back / (a.z() > 0 ? 1 : inside);
          assertThat(Math.max(there, back) == 0 ? 0 : relative(scaledThere, scaledBack))
              .isLessThanOrEqualTo(256 * EPS);
        }
      }
    }
  }

  /** Many samples are absorbed, so that only a large number of samples has their fraction. */
  @Test
  void samplesFollowTheDensity() {
    for (Material material :
        List.of(
            glass(1.5, .49).withMultipleScattering(),
            metal(COLOR, CookTorrance.DEFAULT_IOR, .5).withMultipleScattering(),
            CookTorrance.of(Rgb.gray(.5), Rgb.gray(.4), .5).withMultipleScattering())) {
      Bsdf bsdf = material.at(0, 0);
      for (double cosine : new double[] {.9, -.6}) {
        BsdfLaws.assertSamplesFollowPdf(
            material, bsdf, direction(cosine), Effort.count(500_000, 2_000_000), 8, random);
      }
      BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(.3), 100, random, 1e-12);
      BsdfLaws.assertExtremesAreHarmless(bsdf);
    }
  }

  /** Extreme indices give usable numbers. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-300, 1e-6, 1 - 2e-8, 1 + 2e-8, 1e6})
  void extremeIndicesAreHarmless(double ior) {
    BsdfLaws.assertExtremesAreHarmless(glass(ior, .5).withMultipleScattering().at(0, 0));
    BsdfLaws.assertExtremesAreHarmless(metal(COLOR, ior, .5).withMultipleScattering().at(0, 0));
  }

  /** The quadrature with 20,000 points has an error below 1e-6. */
  @Test
  void meanReflectanceIsThatUnderUniformRadiance() {
    for (double ior : new double[] {1 / 3.0, 1 / 1.15, 1.05, 1.15, 1.33, 1.5, 2.4, 3, 10, 1e6}) {
      double sum = 0;
      int points = 20_000;
      for (int i = 0; i < points; i++) {
        sum += Fresnel.dielectric(Math.sqrt((i + .5) / points), ior) / points;
      }
      assertThat(MultipleScattering.meanReflectance(ior))
          .as("%s", ior)
          .isCloseTo(sum, within(.0065));
    }
  }

  @Test
  void beckmannHasNoTable() {
    CookTorrance metal =
        new CookTorrance(
            WHITE,
            WHITE,
            ScalarTexture.constant(.5),
            ScalarTexture.constant(2),
            MicrofacetDistribution.BECKMANN);
    assertThatThrownBy(metal::withMultipleScattering)
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("multipleScattering: expected the distribution GGX, found BECKMANN");
  }
}
