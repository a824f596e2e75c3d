package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.RoughDielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests rough glass against quadratures and BSDF invariants. */
class RoughDielectricTest {
  private static final double[] ROUGHNESSES = {1e-3, .01, .05, .1, .3, .5, 1};
  private static final double[] BOTH_SIDES = {1, -1};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(47));

  private static RoughDielectric glass(double ior, double alpha) {
    return new RoughDielectric(Rgb.WHITE, Rgb.WHITE, ior, new Ggx(alpha));
  }

  /** Returns the index behind the surface divided by the index on the side of a direction. */
  private static double eta(RoughDielectric glass, Vec3 wo) {
    return wo.z() > 0 ? glass.ior() : 1 / glass.ior();
  }

  /** Returns the reflected or the transmitted fraction, by quadrature. */
  static double albedo(RoughDielectric glass, Vec3 wo, boolean passes, int n) {
    FacetMap map = new FacetMap(MicrofacetDistribution.GGX, ((Ggx) glass.facets()).alpha());
    double side = Math.signum(wo.z());
    return map.integral(
        new Vec3(wo.x(), wo.y(), Math.abs(wo.z())),
        passes ? eta(glass, wo) : 0,
        n,
        wi ->
            wi.z() < 0 == passes
                ? glass.evaluate(wo, new Vec3(wi.x(), wi.y(), side * wi.z())).f().g()
                : 0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {.5, 1.5, 1e6})
  void sampledWeightsAverageToTheAlbedoAndNeverExceedOne(double ior) {
    for (double alpha : ROUGHNESSES) {
      RoughDielectric glass = glass(ior, alpha);
      for (double cos : COSINES) {
        for (double side : BOTH_SIDES) {
          Vec3 wo = direction(side * cos);
          double albedo = albedo(glass, wo, false, 150) + albedo(glass, wo, true, 150);
          double sampled = BsdfLaws.sampledAlbedo(glass, wo, 20_000);
          assertThat(sampled).isLessThanOrEqualTo(1);
          assertThat(sampled).as("%s %s", glass, wo).isCloseTo(albedo, within(3e-3));
        }
      }
    }
  }

  @Test
  void tintsScaleWhatIsReflectedAndWhatPasses() {
    for (double alpha : new double[] {.1, .5}) {
      RoughDielectric tinted = new RoughDielectric(Rgb.gray(.9), Rgb.gray(.2), 1.5, new Ggx(alpha));
      for (double cos : new double[] {.9, -.9, .3, -.3}) {
        Vec3 wo = direction(cos);
        double reflected = albedo(glass(1.5, alpha), wo, false, 150);
        double passed = albedo(glass(1.5, alpha), wo, true, 150);
        assertThat(BsdfLaws.sampledAlbedo(tinted, wo, 40_000))
            .isCloseTo(.9 * reflected + .2 * passed, within(2e-3));
      }
    }
  }

  /** Radiance divided by the squared index is invariant, so eval / (|cos θi| ηi²) is symmetric. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1.5, 3})
  void scatteringIsReciprocalButForTheIndices(double ior) {
    for (double alpha : ROUGHNESSES) {
      RoughDielectric glass = glass(ior, alpha);
      for (int i = 0; i < 4000; i++) {
        Vec3 a = direction(random);
        BsdfSample sample = glass.sample(a, random.nextDouble(), Draws.inSquare(random));
        Vec3 b = i % 2 == 0 || sample.pdf() == 0 ? direction(random) : sample.wi();
        double indexA = a.z() > 0 ? 1 : ior;
        double indexB = b.z() > 0 ? 1 : ior;
        double there = glass.evaluate(a, b).f().g() / (Math.abs(b.z()) * indexB * indexB);
        double back = glass.evaluate(b, a).f().g() / (Math.abs(a.z()) * indexA * indexA);
        if (Math.max(there, back) > 1e-290) {
          assertThat(relative(there, back))
              .as("%s %s %s", glass, a, b)
              .isLessThanOrEqualTo(64 * EPS);
        }
      }
    }
  }

  @Test
  void sampledDirectionsFollowPdfAndThoseOnTheWrongSideAreRefused() {
    int samples = Effort.count(40_000, 1_000_000);
    for (double alpha : new double[] {1e-3, .1, .5, 1}) {
      for (double ior : new double[] {.6, 1.5}) {
        RoughDielectric glass =
            new RoughDielectric(Rgb.gray(.9), Rgb.gray(.4), ior, new Ggx(alpha));
        for (double cos : new double[] {1, -.9, .5, -.5, .1, -.1, .01, -.01}) {
          Vec3 wo = direction(cos);
          new FacetMap(MicrofacetDistribution.GGX, alpha)
              .assertSamplesFollowPdf(glass, wo, eta(glass, wo), samples, random);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {.5, 1 + 1e-7, 1.5, 1e6})
  void weightIsEvalOverPdf(double ior) {
    for (double alpha : ROUGHNESSES) {
      RoughDielectric glass =
          new RoughDielectric(new Rgb(.9, .5, .1), new Rgb(.2, .6, 1), ior, new Ggx(alpha));
      for (double cos : COSINES) {
        BsdfLaws.assertWeightIsEvalOverPdf(glass, direction(cos), 500, random, 1e-12);
        BsdfLaws.assertWeightIsEvalOverPdf(glass, direction(-cos), 500, random, 1e-12);
      }
    }
  }

  @Test
  void extremesAreHarmless() {
    for (double alpha : ROUGHNESSES) {
      for (double ior : new double[] {.5, 1 + 1e-7, 1.5, 1e6}) {
        BsdfLaws.assertExtremesAreHarmless(glass(ior, alpha));
      }
    }
  }

  @Test
  void nearlySmoothGlassReflectsAsSmoothGlass() {
    for (double ior : new double[] {.5, 1.5, 2.4}) {
      Dielectric smooth = new Dielectric(Rgb.WHITE, Rgb.WHITE, ior);
      for (double cos : new double[] {1, .8, .5, .2}) {
        for (double side : BOTH_SIDES) {
          Vec3 wo = direction(side * cos);
          double reflected = albedo(glass(ior, CookTorrance.SMOOTH), wo, false, 100);
          double passed = albedo(glass(ior, CookTorrance.SMOOTH), wo, true, 100);
          assertThat(reflected).isCloseTo(smooth.reflected(wo), within(.01 * reflected));
          assertThat(reflected + passed).isCloseTo(1, within(2e-3));
        }
      }
    }
  }

  @Test
  void nearlySmoothGlassRefractsBySnellsLaw() {
    RoughDielectric glass = glass(1.5, CookTorrance.SMOOTH);
    Vec3 wo = direction(.6);
    Vec3 straight = new Dielectric(Rgb.WHITE, Rgb.WHITE, 1.5).refract(wo);
    for (int i = 0; i < 1000; i++) {
      Vec3 wi = glass.sample(wo, .999, Draws.inSquare(random)).wi();
      // One facet in 10,000 is tilted by more than 100 times the roughness.
      assertThat(wi.minus(straight).length()).isLessThan(.1);
    }
  }

  @Test
  void nothingPassesFacetsBeyondTheCriticalAngle() {
    // From inside, 60° is beyond the critical angle of 41.8° for all but very steep facets.
    RoughDielectric glass = glass(1.5, CookTorrance.SMOOTH);
    Vec3 wo = direction(-.5);
    for (int i = 0; i < 1000; i++) {
      assertThat(glass.sample(wo, BsdfLaws.LAST, Draws.inSquare(random)).wi().z()).isNegative();
    }
    assertThat(albedo(glass, wo, false, 100)).isCloseTo(1, within(1e-3));
  }

  @Test
  void almostTheSameMediumIsAlmostInvisible() {
    RoughDielectric glass = glass(1 + 1e-7, .3);
    Vec3 wo = direction(.8);
    for (int i = 0; i < 1000; i++) {
      BsdfSample sample = glass.sample(wo, .5, Draws.inSquare(random));
      assertThat(sample.wi().plus(wo).length()).isLessThan(1e-5);
    }
    assertThat(BsdfLaws.sampledAlbedo(glass, wo, 1000)).isGreaterThan(.98);
  }

  @Test
  void blackGlassAbsorbs() {
    RoughDielectric black = new RoughDielectric(Rgb.BLACK, Rgb.BLACK, 1.5, new Ggx(.3));
    assertThat(BsdfLaws.sampledAlbedo(black, Vec3.Z, 100)).isZero();
    assertThat(black.evaluate(Vec3.Z, Vec3.Z).f().isBlack()).isTrue();
    assertThat(black.pdf(Vec3.Z, Vec3.Z)).isZero();
    assertThat(black.pdf(Vec3.Z, Vec3.Z.negated())).isZero();
    BsdfLaws.assertExtremesAreHarmless(black);
  }

  @Test
  void lobeWithoutTintIsNeverDrawn() {
    RoughDielectric passes = new RoughDielectric(Rgb.BLACK, Rgb.WHITE, 1.5, new Ggx(.3));
    RoughDielectric reflects = new RoughDielectric(Rgb.WHITE, Rgb.BLACK, 1.5, new Ggx(.3));
    for (int i = 0; i < 100; i++) {
      Point2 u = Draws.inSquare(random);
      assertThat(passes.sample(Vec3.Z, 0, u).wi().z()).isNegative();
      assertThat(reflects.sample(Vec3.Z, BsdfLaws.LAST, u).wi().z()).isPositive();
    }
  }

  @Test
  void whatLiesBehindShowsThroughGlassAlone() {
    assertThat(glass(1.5, .3).isTransmissive()).isTrue();
    assertThat(glass(1.5, .3).evaluate(Vec3.Z, Vec3.Z.negated()).f().isBlack()).isFalse();
    for (Bsdf opaque :
        new Bsdf[] {
          new Lambertian(Rgb.WHITE),
          new PhongLobe(Rgb.WHITE, 3),
          new MicrofacetReflection(Rgb.WHITE, 1.5, new Ggx(.3))
        }) {
      assertThat(opaque.isTransmissive()).isFalse();
      assertThat(opaque.evaluate(Vec3.Z, Vec3.Z.negated()).f().isBlack()).isTrue();
    }
  }
}
