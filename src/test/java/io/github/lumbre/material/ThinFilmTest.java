package io.github.lumbre.material;

import static io.github.lumbre.material.MaterialParameter.ANISOTROPY;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE_IOR;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE_THICKNESS;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE_THICKNESS_MAXIMUM;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE_THICKNESS_MINIMUM;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.InParallel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

/** Tests thin films against Airy's formula, and the laws of the materials that have them. */
class ThinFilmTest {
  private static final double[] THICKNESSES = {0, 100, 250, 400, 800, 5000};
  private static final double[] INDICES = {1, 1.3, 1.8, 2.5};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(83));

  private static MetallicRoughness.Builder film(double ior, double thickness) {
    return MetallicRoughness.builder()
        .set(METALLIC, 0)
        .set(IRIDESCENCE, 1)
        .set(IRIDESCENCE_IOR, ior)
        .set(IRIDESCENCE_THICKNESS_MAXIMUM, thickness);
  }

  /** Metal, plastic, both, thin panes, and volumes, smooth and rough, with a film. */
  private static List<MetallicRoughness.Builder> everything(double ior, double thickness) {
    List<MetallicRoughness.Builder> all = new ArrayList<>();
    for (double roughness : new double[] {.1, .4, .8}) {
      all.add(film(ior, thickness).set(ROUGHNESS, roughness));
      all.add(film(ior, thickness).set(ROUGHNESS, roughness).set(IOR, 2.4).set(ANISOTROPY, .7));
      all.add(film(ior, thickness).set(ROUGHNESS, roughness).set(METALLIC, 1));
      all.add(film(ior, thickness).set(ROUGHNESS, roughness).set(METALLIC, .5).set(SPECULAR, .4));
      all.add(film(ior, thickness).set(ROUGHNESS, roughness).set(TRANSMISSION, 1));
      all.add(film(ior, thickness).set(ROUGHNESS, roughness).set(CLEARCOAT, 1).set(METALLIC, .3));
    }
    return all;
  }

  private static MetallicRoughness.Builder volume(double roughness, double ior, double thickness) {
    return film(ior, thickness)
        .set(ROUGHNESS, roughness)
        .set(TRANSMISSION, 1)
        .set(ATTENUATION_DISTANCE, 1);
  }

  /**
   * The file has the integral of Airy's formula, for both polarizations, over wavelengths of 380 to
   * 780 nm in steps of 1 nm, times D65 and the CIE 1931 color matching functions, as linear sRGB. A
   * separate program computed it. The transform of the sensitivities is fitted to 0.02, and the
   * reflectances have at most that error. Colors outside of sRGB are clamped.
   */
  @ParameterizedTest
  @CsvFileSource(resources = "thin-films.csv", numLinesToSkip = 1)
  void reflectancesAreTheIntegralsOfAirysFormula(
      double ior, double base, double cosine, double thickness, double r, double g, double b) {
    ThinFilm film = new ThinFilm(1, ior, thickness, 1);
    Rgb found =
        new Rgb(
            film.over(0, cosine, true, base),
            film.over(1, cosine, true, base),
            film.over(2, cosine, true, base));
    Rgb expected =
        new Rgb(
            Math.max(0, Math.min(1, r)), Math.max(0, Math.min(1, g)), Math.max(0, Math.min(1, b)));
    assertNear(found, expected, thickness == 0 ? 1e-4 : .02);
  }

  /**
   * From the inside, glass reflects as from the outside, and all light beyond the critical angle.
   */
  @Test
  void bothSidesReflectTheSame() {
    ThinFilm film = new ThinFilm(1, 1.8, 300, 1);
    for (double cosine : new double[] {1, .7, .3, .05}) {
      double inside = Math.sqrt(1 - (1 - cosine * cosine) / 2.25);
      for (int color = 0; color < 3; color++) {
        assertThat(film.over(color, inside, false, 1.5))
            .isCloseTo(film.over(color, cosine, true, 1.5), within(1e-12));
        assertThat(film.over(color, .7, false, 1.5)).isEqualTo(1);
      }
    }
  }

  private static List<Vec3[]> pairs(SplittableRandom random) {
    List<Vec3[]> pairs = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      pairs.add(new Vec3[] {BsdfLaws.direction(random), BsdfLaws.direction(random)});
    }
    return pairs;
  }

  /** No film, one without thickness, and one with the index of air are the plain material. */
  @Test
  void limitsAreThePlainMaterial() {
    List<MetallicRoughness.Builder> plain = everything(1.3, 400);
    List<MetallicRoughness.Builder> none = everything(1.8, 0);
    List<MetallicRoughness.Builder> air = everything(1, 300);
    for (int i = 0; i < plain.size(); i++) {
      if (plain.get(i).build().stated(CLEARCOAT).isPresent()) {
        // The film lies in the coat, whose index differs from that of air.
        continue;
      }
      Bsdf expected = plain.get(i).set(IRIDESCENCE, 0).build().at(0, 0);
      for (Vec3[] pair : pairs(random)) {
        Rgb value = expected.evaluate(pair[0], pair[1]).f();
        // The series leaves out terms below 1e-6; lobes multiply that by their density.
        double error = 1e-5 * (1 + value.max());
        assertNear(none.get(i).build().at(0, 0).evaluate(pair[0], pair[1]).f(), value, error);
        assertNear(air.get(i).build().at(0, 0).evaluate(pair[0], pair[1]).f(), value, error);
      }
    }
  }

  @Test
  void strengthMixesBothReflectances() {
    Bsdf plain = film(1.8, 300).set(METALLIC, 1).set(IRIDESCENCE, 0).build().at(0, 0);
    Bsdf half = film(1.8, 300).set(METALLIC, 1).set(IRIDESCENCE, .25).build().at(0, 0);
    Bsdf full = film(1.8, 300).set(METALLIC, 1).build().at(0, 0);
    for (Vec3[] pair : pairs(random)) {
      Rgb expected =
          plain
              .evaluate(pair[0], pair[1])
              .f()
              .times(.75)
              .plus(full.evaluate(pair[0], pair[1]).f().times(.25));
      assertNear(half.evaluate(pair[0], pair[1]).f(), expected, 1e-12);
    }
  }

  @Test
  void thicknessIsBetweenMinimumAndMaximum() {
    Bsdf expected = film(1.8, 350).build().at(0, 0);
    MetallicRoughness.Builder quarter = film(1.8, 500).set(IRIDESCENCE_THICKNESS_MINIMUM, 300);
    Bsdf found = quarter.set(IRIDESCENCE_THICKNESS, .25).build().at(0, 0);
    for (Vec3[] pair : pairs(random)) {
      assertThat(found.evaluate(pair[0], pair[1]).f())
          .isEqualTo(expected.evaluate(pair[0], pair[1]).f());
    }
  }

  /** A film under a coat of its own index is invisible; the base reflects as inside the coat. */
  @Test
  void coatsAreTheOutsideOfFilms() {
    for (double cosine : new double[] {1, .6, .2}) {
      double thin = new ThinFilm(1, 1.5, 0, 1.5).over(1, cosine, true, 2.5);
      double thick = new ThinFilm(1, 1.5, 700, 1.5).over(1, cosine, true, 2.5);
      assertThat(thick).isCloseTo(thin, within(1e-12));
    }
    // The square of 1 / 4.
    assertThat(new ThinFilm(1, 1.8, 0, 1.5).over(0, 1, true, 2.5)).isCloseTo(1 / 16., within(1e-5));
  }

  @Test
  void filmsAreReciprocal() {
    for (double ior : INDICES) {
      for (MetallicRoughness.Builder each : everything(ior, 350)) {
        Bsdf bsdf = each.build().at(0, 0);
        for (Vec3[] pair : pairs(random)) {
          double there = bsdf.evaluate(pair[0], pair[1]).f().r() / Math.abs(pair[1].z());
          double back = bsdf.evaluate(pair[1], pair[0]).f().r() / Math.abs(pair[0].z());
          assertThat(there).isCloseTo(back, within(1e-12 * (1 + there)));
        }
      }
    }
  }

  /** As much as without films may be in excess: 0.3 %, and 0.002 for the noise of the samples. */
  @Test
  void whiteFurnaceGainsNoEnergy() {
    InParallel.forEach(
        Arrays.stream(INDICES).boxed().toList(),
        ior -> {
          for (double thickness : THICKNESSES) {
            for (MetallicRoughness.Builder each : everything(ior, thickness)) {
              Bsdf bsdf = each.build().at(0, 0);
              for (double cosine : new double[] {.95, .5, .15}) {
                Rgb sum = Rgb.BLACK;
                int samples = 1500;
                Vec3 wo = BsdfLaws.direction(cosine);
                for (int i = 0; i < samples; i++) {
                  double lobe = i * .41421356237309503 % 1;
                  double x = i * .7548776662466927 % 1;
                  double y = i * .5698402909980532 % 1;
                  BsdfSample s = bsdf.sample(wo, lobe, new Point2(x, y));
                  sum = sum.plus(s.weight().times(1. / samples));
                }
                assertThat(sum.max())
                    .as("%s %s %s", bsdf, thickness, cosine)
                    .isLessThan(1 + 3e-3 + 2e-3);
              }
            }
          }
        });
  }

  /** Smooth volumes reflect and refract all light of each color. */
  @Test
  void smoothVolumesLoseNothing() {
    for (double ior : INDICES) {
      Bsdf bsdf = volume(0, ior, 350).build().at(0, 0);
      for (double cosine : new double[] {1, .6, .1, -.9, -.5}) {
        Rgb sum = Rgb.BLACK;
        int samples = 2000;
        for (int i = 0; i < samples; i++) {
          BsdfSample s =
              bsdf.sample(BsdfLaws.direction(cosine), (i + .5) / samples, Draws.inSquare(random));
          sum = sum.plus(s.weight().times(1. / samples));
        }
        assertNear(sum, Rgb.WHITE, 4e-3);
      }
    }
  }

  @Test
  void samplesHaveTheWeightOfTheirDensity() {
    for (double thickness : new double[] {250, 900}) {
      List<MetallicRoughness.Builder> all = everything(1.8, thickness);
      all.add(volume(.5, 1.8, thickness));
      for (MetallicRoughness.Builder each : all) {
        Bsdf bsdf = each.build().at(0, 0);
        for (double cos : new double[] {.9, .3, -.6}) {
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, BsdfLaws.direction(cos), 30, random, 1e-9);
        }
        BsdfLaws.assertExtremesAreHarmless(bsdf);
      }
    }
  }

  @Test
  void samplesFollowTheDensity() {
    Bsdf bsdf = film(2, 300).set(ROUGHNESS, .7).set(METALLIC, .4).build().at(0, 0);
    for (double cos : new double[] {.9, .4}) {
      Vec3 wo = BsdfLaws.direction(cos);
      BsdfLaws.assertSamplesFollowPdf("", bsdf, wo, Effort.count(200_000, 2_000_000), 8, random);
    }
  }

  /** Without a film, no lobe is replaced and no bit changes. */
  @Test
  void strengthOfZeroChangesNoBit() {
    for (MetallicRoughness.Builder each : everything(1.8, 400)) {
      assertThat(each.set(IRIDESCENCE, 0).build().at(0, 0).toString())
          .doesNotContain("strength=1.0");
    }
    assertThat(volume(0, 1.8, 300).set(IRIDESCENCE, 0).build().at(0, 0))
        .isEqualTo(new Dielectric(Rgb.WHITE, Rgb.WHITE, 1.5));
    assertThat(volume(0, 1.8, 300).set(BASE_COLOR, Rgb.gray(.5)).build().at(0, 0).albedo())
        .isEqualTo(Rgb.gray(.5));
  }
}
