package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static io.github.lumbre.material.MaterialParameter.ANISOTROPY;
import static io.github.lumbre.material.MaterialParameter.ANISOTROPY_DIRECTION;
import static io.github.lumbre.material.MaterialParameter.ANISOTROPY_ROTATION;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.InParallel;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.Texture;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the anisotropy of KHR_materials_anisotropy against its formulas and BSDF invariants. */
class AnisotropicReflectionTest {
  private static final double[] STRENGTHS = {.1, .3, .6, 1};
  private static final double[] ALPHAS = {1e-3, .01, .1, .5, 1};
  private static final double[] TURNS = {0, 137};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(67));

  private static AnisotropicReflection mirror(double along, double across, double degrees) {
    double angle = Math.toRadians(degrees);
    return new AnisotropicReflection(
        Rgb.WHITE, 1, along, across, Math.cos(angle), Math.sin(angle), ThinFilm.NONE);
  }

  private static MetallicRoughness.Builder material(double metallic, double roughness) {
    return MetallicRoughness.builder().set(METALLIC, metallic).set(ROUGHNESS, roughness);
  }

  /** Returns a direction of some cosine, at an azimuth. */
  private static Vec3 at(double cos, double degrees) {
    double sin = Math.sqrt((1 - cos) * (1 + cos));
    double angle = Math.toRadians(degrees);
    return new Vec3(sin * Math.cos(angle), sin * Math.sin(angle), cos);
  }

  @Test
  void equalRoughnessIsIsotropic() {
    for (double alpha : ALPHAS) {
      Lobe isotropic = new SchlickReflection(Rgb.gray(.3), 1, new Ggx(alpha));
      Lobe found = new AnisotropicReflection(Rgb.gray(.3), 1, alpha, alpha, .6, .8, ThinFilm.NONE);
      for (int i = 0; i < 200; i++) {
        Vec3 wo = direction(random);
        BsdfSample sample = isotropic.sample(wo, .5, Draws.inSquare(random));
        Vec3 wi = sample.isAbsorbed() ? direction(random) : sample.wi();
        double tolerance = 1e-9 / alpha;
        assertThat(relative(found.pdf(wo, wi), isotropic.pdf(wo, wi))).isLessThan(tolerance);
        assertThat(relative(found.evaluate(wo, wi).f().r(), isotropic.evaluate(wo, wi).f().r()))
            .isLessThan(tolerance);
      }
    }
  }

  @Test
  void densityIsTheOneOfTheSpecification() {
    AnisotropicReflection lobe = mirror(.6, .2, 0);
    Vec3 wo = at(.8, 20);
    Vec3 wi = at(.7, 160);
    Vec3 m = wo.plus(wi).normalized();
    double x = m.x() / .6;
    double y = m.y() / .2;
    double t = x * x + y * y + m.z() * m.z();
    double d = 1 / (Math.PI * .6 * .2 * t * t);
    double o = Math.sqrt(Math.pow(.6 * wo.x(), 2) + Math.pow(.2 * wo.y(), 2) + wo.z() * wo.z());
    double i = Math.sqrt(Math.pow(.6 * wi.x(), 2) + Math.pow(.2 * wi.y(), 2) + wi.z() * wi.z());
    double visibility = .5 / (wi.z() * o + wo.z() * i);
    assertThat(lobe.evaluate(wo, wi).f().r()).isCloseTo(d * visibility * wi.z(), within(1e-12));
  }

  @Test
  void scatteringIsReciprocal() {
    for (double strength : STRENGTHS) {
      for (double metallic : new double[] {0, .4, 1}) {
        Bsdf bsdf =
            material(metallic, .4)
                .set(BASE_COLOR, new Rgb(.9, .5, .1))
                .set(ANISOTROPY, strength)
                .set(ANISOTROPY_ROTATION, 25)
                .build()
                .at(0, 0);
        for (int i = 0; i < 300; i++) {
          Vec3 a = direction(random);
          BsdfSample sample = bsdf.sample(a, random.nextDouble(), Draws.inSquare(random));
          Vec3 b = sample.isAbsorbed() ? direction(random) : sample.wi();
          BsdfLaws.assertReciprocal(bsdf, a, b, 256 * EPS);
        }
      }
    }
  }

  /** White metals and plastics, from glass to an index that reflects all light. */
  @Test
  void whiteFurnaceGainsNoEnergy() {
    InParallel.forEach(
        Arrays.stream(STRENGTHS).boxed().toList(),
        strength -> {
          for (double roughness : new double[] {0, .1, .3, .5, .7, 1}) {
            for (double ior : new double[] {1, 1.5, 3, 0}) {
              Bsdf bsdf =
                  material(0, roughness).set(IOR, ior).set(ANISOTROPY, strength).build().at(0, 0);
              for (double cos : COSINES) {
                for (double azimuth : new double[] {0, 45, 90}) {
                  int samples = Effort.count(4000, 50_000);
                  assertThat(BsdfLaws.sampledAlbedo(bsdf, at(cos, azimuth), samples))
                      .as("%s %s %s %s %s", strength, roughness, ior, cos, azimuth)
                      .isBetween(
                          strength * roughness < .1 && ior > 0 && cos > .4 ? .8 : 0, 1 + 3e-3);
                }
              }
            }
          }
        });
  }

  /**
   * White metals, which also reflect repeatedly. They return almost all light where both
   * roughnesses are alike, and lose up to the half of it at a large strength.
   */
  @Test
  void metalsGainNoEnergyAndKeepItAtSmallStrengths() {
    for (double strength : new double[] {.05, .15, .3, .6, 1}) {
      for (double roughness : new double[] {.05, .1, .2, .3, .5, .7, 1}) {
        Bsdf bsdf = material(1, roughness).set(ANISOTROPY, strength).build().at(0, 0);
        for (double cos : new double[] {1, .5, .1, .01}) {
          for (double azimuth : new double[] {0, 45, 90}) {
            int samples = Effort.count(4000, 50_000);
            assertThat(BsdfLaws.sampledAlbedo(bsdf, at(cos, azimuth), samples))
                .as("%s %s %s %s", strength, roughness, cos, azimuth)
                .isBetween(strength < .1 && roughness > .15 ? .97 : .5, 1 + 3e-3);
          }
        }
      }
    }
  }

  @ParameterizedTest
  @CsvSource({".3, .3, .9", ".1, .9, .5", ".6, .2, .2", "1, 1, .7", ".05, .05, .95"})
  void densityIntegratesToTheSampledFraction(double across, double strength, double cos) {
    double along = AnisotropicReflection.alphaAlong(across, strength);
    Bsdf bsdf = mirror(along, across, 35);
    Vec3 wo = at(cos, 10);
    int rows = 1600;
    double sum = 0;
    for (int i = 0; i < rows; i++) {
      double z = (i + .5) / rows;
      for (int j = 0; j < rows; j++) {
        sum += bsdf.pdf(wo, at(z, 360 * (j + .5) / rows));
      }
    }
    int absorbed = 0;
    int samples = 40_000;
    for (int i = 0; i < samples; i++) {
      absorbed += bsdf.sample(wo, .5, Draws.inSquare(random)).isAbsorbed() ? 1 : 0;
    }
    // Five standard deviations of the fraction, and the error of the quadrature.
    double fraction = 1 - (double) absorbed / samples;
    assertThat(sum * 2 * Math.PI / (rows * (double) rows))
        .isCloseTo(fraction, within(.0025 + 1e-3));
  }

  /** Absorbed samples are many here, so that only a large number of samples has their fraction. */
  @ParameterizedTest
  @ValueSource(doubles = {0, .5, 1})
  void samplesFollowTheDensity(double metallic) {
    for (double turn : TURNS) {
      Bsdf bsdf =
          material(metallic, .7)
              .set(ANISOTROPY, .7)
              .set(ANISOTROPY_ROTATION, turn)
              .build()
              .at(0, 0);
      for (Vec3 wo : new Vec3[] {at(.9, 50), at(.4, 200)}) {
        BsdfLaws.assertSamplesFollowPdf(
            turn, bsdf, wo, Effort.count(500_000, 2_000_000), 8, random);
      }
    }
  }

  @Test
  void samplesHaveTheWeightOfTheirDensity() {
    for (double alpha : ALPHAS) {
      for (double strength : STRENGTHS) {
        Bsdf bsdf = mirror(AnisotropicReflection.alphaAlong(alpha, strength), alpha, 25);
        for (double cos : COSINES) {
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(cos), 50, random, 1e-6);
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(-cos), 50, random, 1e-6);
        }
      }
    }
    BsdfLaws.assertExtremesAreHarmless(mirror(1, 1e-3, 25));
    BsdfLaws.assertExtremesAreHarmless(material(.5, 0).set(ANISOTROPY, 1).build().at(0, 0));
    BsdfLaws.assertExtremesAreHarmless(material(.5, 1).set(ANISOTROPY, 1).build().at(0, 0));
  }

  @Test
  void strengthOfZeroChangesNoBit() {
    for (double metallic : new double[] {0, .4, 1}) {
      for (double roughness : new double[] {0, .3, 1}) {
        Bsdf plain = material(metallic, roughness).build().at(0, 0);
        Bsdf found =
            material(metallic, roughness)
                .set(ANISOTROPY, 0)
                .set(ANISOTROPY_ROTATION, 40)
                .build()
                .at(0, 0);
        for (int i = 0; i < 100; i++) {
          Vec3 wo = direction(random);
          double lobe = random.nextDouble();
          Point2 u = Draws.inSquare(random);
          BsdfSample sample = plain.sample(wo, lobe, u);
          assertThat(found.sample(wo, lobe, u).wi()).isEqualTo(sample.wi());
          assertThat(found.sample(wo, lobe, u).weight()).isEqualTo(sample.weight());
          assertThat(found.evaluate(wo, sample.wi()).f())
              .isEqualTo(plain.evaluate(wo, sample.wi()).f());
        }
      }
    }
  }

  /** A vanishing strength is near none, so that a texture of strengths has no edges. */
  @Test
  void smallStrengthsChangeLittle() {
    for (double metallic : new double[] {0, .4, 1}) {
      Bsdf plain = material(metallic, .5).build().at(0, 0);
      Bsdf found = material(metallic, .5).set(ANISOTROPY, 1e-4).build().at(0, 0);
      for (int i = 0; i < 100; i++) {
        Vec3 wo = at(random.nextDouble(.1, 1), random.nextDouble(360));
        Vec3 wi = at(random.nextDouble(.1, 1), random.nextDouble(360));
        assertThat(relative(found.evaluate(wo, wi).f().r(), plain.evaluate(wo, wi).f().r()))
            .isLessThan(1e-3);
      }
    }
  }

  @Test
  void quarterTurnsSwapTheAxes() {
    Bsdf turned = mirror(.7, .2, 90);
    Bsdf swapped = mirror(.2, .7, 0);
    Bsdf material = material(1, .4).set(ANISOTROPY, .5).build().at(0, 0);
    Bsdf quarter =
        material(1, .4).set(ANISOTROPY, .5).set(ANISOTROPY_ROTATION, 90).build().at(0, 0);
    for (int i = 0; i < 100; i++) {
      Vec3 wo = at(random.nextDouble(), random.nextDouble(360));
      Vec3 wi = at(random.nextDouble(), random.nextDouble(360));
      assertThat(relative(turned.evaluate(wo, wi).f().r(), swapped.evaluate(wo, wi).f().r()))
          .isLessThan(1e-12);
      Vec3 o = new Vec3(-wo.y(), wo.x(), wo.z());
      Vec3 a = new Vec3(-wi.y(), wi.x(), wi.z());
      assertThat(relative(quarter.evaluate(o, a).f().r(), material.evaluate(wo, wi).f().r()))
          .isLessThan(1e-12);
    }
  }

  /** The map's direction, in red and green, has the same effect as a rotation to it. */
  @Test
  void directionsAreTurnedByTheRotation() {
    NormalMap map = new NormalMap(Texture.constant(new Rgb(.3, .3, .2)), 1);
    MetallicRoughness.Builder mapped =
        material(1, .4)
            .set(ANISOTROPY, .5)
            .set(ANISOTROPY_DIRECTION, new NormalChannel(map, 0))
            .set(ANISOTROPY_ROTATION, 20);
    Bsdf turned = material(1, .4).set(ANISOTROPY, .5).set(ANISOTROPY_ROTATION, 65).build().at(0, 0);
    Bsdf found = mapped.build().at(0, 0);
    for (int i = 0; i < 100; i++) {
      Vec3 wo = at(random.nextDouble(), random.nextDouble(360));
      Vec3 wi = at(random.nextDouble(), random.nextDouble(360));
      assertThat(relative(found.evaluate(wo, wi).f().r(), turned.evaluate(wo, wi).f().r()))
          .isLessThan(1e-10);
    }
  }

  /** The highlight is longer along the direction: its facets lean farther there. */
  @Test
  void highlightsAreStretchedAlongTheDirection() {
    Bsdf bsdf = material(1, .3).set(ANISOTROPY, .8).build().at(0, 0);
    double along = bsdf.evaluate(Vec3.Z, at(.8, 0)).f().r();
    double across = bsdf.evaluate(Vec3.Z, at(.8, 90)).f().r();
    assertThat(along).isGreaterThan(10 * across);
    Bsdf roughest = material(1, 1).set(ANISOTROPY, 1).build().at(0, 0);
    assertThat(roughest.evaluate(Vec3.Z, at(.8, 0)).f().r())
        .isCloseTo(roughest.evaluate(Vec3.Z, at(.8, 90)).f().r(), within(1e-12));
  }

  @Test
  void plasticsAreAnisotropicToo() {
    Bsdf bsdf = material(0, .3).set(BASE_COLOR, Rgb.BLACK).set(ANISOTROPY, .8).build().at(0, 0);
    assertThat(bsdf.evaluate(Vec3.Z, at(.8, 0)).f().r())
        .isGreaterThan(10 * bsdf.evaluate(Vec3.Z, at(.8, 90)).f().r());
  }
}
