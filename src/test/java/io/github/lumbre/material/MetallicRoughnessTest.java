package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.BsdfLaws.relative;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.InParallel;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the metallic-roughness material against known values and BSDF invariants. */
class MetallicRoughnessTest {
  private static final double[] BOTH_SIDES = {1, -1};

  /** The error of 4000 lattice points in the mean weight of a rough look. */
  private static final double LATTICE = 4e-3;

  private static final Rgb COLOR = new Rgb(.9, .5, .1);

  private final SplittableRandom random = new SplittableRandom(Effort.seed(61));

  /** The parameters of a material with a white base color. */
  private record Look(
      double metallic,
      double roughness,
      double transmission,
      double coat,
      double sheen,
      boolean isThin) {
    MetallicRoughness.Builder builder(Rgb color) {
      MetallicRoughness.Builder builder =
          MetallicRoughness.builder()
              .set(BASE_COLOR, ColorChannel.of(color))
              .set(METALLIC, ScalarChannel.of(metallic))
              .set(ROUGHNESS, ScalarChannel.of(roughness))
              .set(TRANSMISSION, ScalarChannel.of(transmission))
              .set(CLEARCOAT, ScalarChannel.of(coat))
              .set(CLEARCOAT_ROUGHNESS, ScalarChannel.of(.2))
              .set(SHEEN_COLOR, ColorChannel.of(Rgb.gray(sheen)))
              .set(SHEEN_ROUGHNESS, ScalarChannel.of(.4));
      return isThin ? builder : builder.set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY);
    }

    Bsdf bsdf(Rgb color) {
      return builder(color).build().at(0, 0);
    }

    /** Returns whether a layer covers rough glass. */
    boolean isCoveredGlass() {
      return coat + sheen > 0 && roughness > 0 && (1 - metallic) * transmission > 0;
    }

    /** Returns whether a delta lobe refracts. */
    boolean isSmoothGlass() {
      return !isThin && roughness == 0 && (1 - metallic) * transmission > 0;
    }
  }

  /** Returns looks that together use all lobes and layers, alone and mixed. */
  private static List<Look> looks(double... roughnesses) {
    List<Look> looks = new ArrayList<>();
    for (double metallic : new double[] {0, .4, 1}) {
      for (double roughness : roughnesses) {
        for (double transmission : new double[] {0, .7, 1}) {
          for (int layers = 0; layers < 4; layers++) {
            for (boolean isThin : new boolean[] {true, false}) {
              looks.add(
                  new Look(metallic, roughness, transmission, layers & 1, layers >> 1, isThin));
            }
          }
        }
      }
    }
    return looks;
  }

  private static SurfaceHit seenFrom(Vec3 wo) {
    return new SurfaceHit().set(Vec3.ZERO, Vec3.Z, Frame.WORLD, new TexturePoint(0, 0), wo, 0);
  }

  /**
   * In a uniform environment of radiance 1, a white surface returns at most that: what it scatters
   * and what passes straight through. Where a few points of a lattice give more, many decide; they
   * find an excess of 0.002 in any of these looks.
   */
  @Test
  void whiteFurnaceGainsNoEnergy() {
    // Looks with equal BSDFs, such as metals of any transmission, return the same.
    Map<Bsdf, Look> different = new HashMap<>();
    looks(0, .1, .4, 1).forEach(look -> different.putIfAbsent(look.bsdf(Rgb.WHITE), look));
    InParallel.forEach(
        different.values(),
        look -> {
          MetallicRoughness material = look.builder(Rgb.WHITE).build();
          for (double cos : COSINES) {
            for (double side : BOTH_SIDES) {
              Vec3 wo = direction(side * cos);
              double few = returned(material, wo, 4000);
              assertThat(few <= 1.0015 ? few : returned(material, wo, 40_000))
                  .as("%s, cosine %s", look, side * cos)
                  .isLessThanOrEqualTo(1.0015);
            }
          }
        });
  }

  private static double returned(MetallicRoughness material, Vec3 wo, int points) {
    return BsdfLaws.sampledAlbedo(material.at(0, 0), wo, points)
        + material.transmittance(seenFrom(wo)).max();
  }

  /**
   * Metal, thin glass and solid glass of any roughness and index, also below a clear coat, return
   * all light to within 1 %.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1.05, 1.33, 1.5, 2.4})
  void roughWhiteSurfacesKeepTheirLight(double ior) {
    for (double roughness : new double[] {.1, .3, .6, 1}) {
      for (Look look :
          List.of(
              new Look(1, roughness, 0, 0, 0, true),
              new Look(0, roughness, 1, 0, 0, true),
              new Look(0, roughness, 1, 1, 0, true),
              new Look(0, roughness, 1, 0, 0, false),
              new Look(0, roughness, 1, 1, 0, false))) {
        Bsdf bsdf = look.builder(Rgb.WHITE).set(IOR, ior).build().at(0, 0);
        for (double cos : COSINES) {
          for (double side : BOTH_SIDES) {
            assertThat(BsdfLaws.sampledAlbedo(bsdf, direction(side * cos), 4000))
                .as("%s, cosine %s", look, side * cos)
                .isBetween(.99 - LATTICE, 1 + LATTICE);
          }
        }
      }
    }
  }

  /**
   * Each reflection tints the light of a metal once more, so that rough metals are more colorful.
   */
  @Test
  void roughMetalsAreMoreSaturated() {
    Rgb once = SchlickReflection.meanFresnel(COLOR, 1, ThinFilm.NONE);
    double last = once.b() / once.r();
    for (double roughness : new double[] {.3, .6, 1}) {
      Bsdf metal = new Look(1, roughness, 0, 0, 0, true).bsdf(COLOR);
      Rgb sum = Rgb.BLACK;
      for (int i = 0; i < 20_000; i++) {
        Vec3 wo = direction(Math.sqrt((i + .5) / 20_000));
        sum = sum.plus(metal.sample(wo, random.nextDouble(), Draws.inSquare(random)).weight());
      }
      assertThat(sum.b() / sum.r()).as("%s", roughness).isLessThan(last);
      last = sum.b() / sum.r();
    }
  }

  /** Only layers lose light: each takes the minimum of two albedos. */
  @Test
  void smoothWhiteSurfacesKeepMostEnergy() {
    for (Look look : looks(0, .1)) {
      MetallicRoughness material = look.builder(Rgb.WHITE).build();
      for (double cos : new double[] {1, .5}) {
        Vec3 wo = direction(cos);
        double sum =
            BsdfLaws.sampledAlbedo(material.at(0, 0), wo, 4000)
                + material.transmittance(seenFrom(wo)).max();
        // Each layer's minimum of two albedos takes some of the light of the layers below.
        double least = look.coat() + look.sheen() == 0 ? .985 : .7;
        assertThat(sum).as("%s, cosine %s", look, cos).isGreaterThan(least);
      }
    }
  }

  /** What sheen and clear coat do not reflect crosses smooth glass, plain or dispersive. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 1})
  void layersOverSmoothGlassLoseNoLight(double dispersion) {
    for (int layers = 1; layers < 4; layers++) {
      Look look = new Look(0, 0, 1, layers & 1, layers >> 1, false);
      MetallicRoughness material =
          look.builder(Rgb.WHITE).set(MaterialParameter.DISPERSION, dispersion).build();
      for (double cos : COSINES) {
        for (double side : BOTH_SIDES) {
          assertThat(returned(material, direction(side * cos), 4000))
              .as("%s, cosine %s", look, side * cos)
              .isGreaterThan(.985);
        }
      }
    }
  }

  /**
   * Radiance divided by the squared index is invariant, as for rough glass. A layer above rough
   * glass keeps all light instead.
   */
  @Test
  void scatteringIsReciprocalButForTheIndices() {
    for (Look look : looks(.1, .4, 1)) {
      if (look.isCoveredGlass()) {
        continue;
      }
      Bsdf bsdf = look.bsdf(COLOR);
      double index = look.isThin() ? 1 : 1.5;
      for (int i = 0; i < 200; i++) {
        Vec3 a = direction(random);
        BsdfSample sample = bsdf.sample(a, random.nextDouble(), Draws.inSquare(random));
        Vec3 b = i % 2 == 0 || sample.pdf() == 0 ? direction(random) : sample.wi();
        double indexA = a.z() > 0 ? 1 : index;
        double indexB = b.z() > 0 ? 1 : index;
        double there = bsdf.evaluate(a, b).f().g() / (Math.abs(b.z()) * indexB * indexB);
        double back = bsdf.evaluate(b, a).f().g() / (Math.abs(a.z()) * indexA * indexA);
        if (Math.max(there, back) > 1e-290) {
          assertThat(relative(there, back))
              .as("%s %s %s", look, a, b)
              .isLessThanOrEqualTo(256 * EPS);
        }
      }
    }
  }

  @Test
  void weightIsEvalOverPdf() {
    for (Look look : looks(0, .1, 1)) {
      if (!look.isSmoothGlass()) {
        Bsdf bsdf = look.bsdf(COLOR);
        for (double cos : COSINES) {
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(cos), 40, random, 1e-12);
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(-cos), 40, random, 1e-12);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 0})
  void extremesAreHarmless(double ior) {
    for (Look look : looks(.1, 1)) {
      if (ior == 1 && !look.isThin()) {
        // A volume of the index of its surroundings scatters by a delta lobe.
        continue;
      }
      BsdfLaws.assertExtremesAreHarmless(look.builder(Rgb.WHITE).set(IOR, ior).build().at(0, 0));
    }
  }

  /**
   * Directions follow the density, which integrates to 1 minus the absorbed fraction. With 100,000
   * samples in about 3000 cells, a lobe that is drawn 5 % too often is found with a probability
   * above 0.99.
   */
  @Test
  void sampledDirectionsFollowPdf() {
    List<Look> rough =
        List.of(
            new Look(0, .7, 0, 0, 0, true),
            new Look(1, .6, 0, 0, 1, true),
            new Look(.4, .8, 0, 0, 0, true),
            new Look(0, .7, 1, 0, 0, true),
            new Look(.3, .7, .6, 0, 1, true),
            new Look(0, .7, 1, 0, 1, false),
            new Look(.3, .8, .6, 0, 0, false));
    int samples = Effort.count(100_000, 1_000_000);
    for (Look look : rough) {
      Bsdf bsdf = look.bsdf(COLOR);
      for (double cos : new double[] {.9, -.6}) {
        BsdfLaws.assertSamplesFollowPdf(look, bsdf, direction(cos), samples, 6, random);
      }
    }
    Bsdf coated =
        new Look(0, .7, .5, 1, 1, true)
            .builder(COLOR)
            .set(CLEARCOAT_ROUGHNESS, ScalarChannel.of(.8))
            .build()
            .at(0, 0);
    BsdfLaws.assertSamplesFollowPdf("coated", coated, direction(.7), samples, 6, random);
  }

  /** A delta lobe is drawn in proportion to its share, with the weight that remains. */
  @Test
  void smoothGlassUnderACoatRefractsByTheExactEquations() {
    Bsdf glass = new Look(0, 0, 1, 0, 0, false).bsdf(COLOR);
    assertThat(glass).isEqualTo(new Dielectric(Rgb.WHITE, COLOR, 1.5));
    Bsdf half = new Look(0, 0, .5, 0, 0, false).bsdf(COLOR);
    assertThat(half.isSpecular()).isFalse();
    // No light sample can arrive through a delta lobe.
    assertThat(half.isTransmissive()).isFalse();
    BsdfSample sample = half.sample(direction(.8), .4999, new Point2(.5, .5));
    assertThat(sample.isSpecular()).isTrue();
    assertThat(sample.wi().z()).isNegative();
  }

  @Test
  void dielectricsReflectFourPercentAtNormalIncidence() {
    Look plastic = new Look(0, .5, 0, 0, 0, true);
    Bsdf black = plastic.bsdf(Rgb.BLACK);
    // At the mirror direction f = F0 D / (4 cos²), D(0) = 1 / (π α²) and no masking.
    double facets = 1 / (Math.PI * Math.pow(.25, 2));
    assertThat(black.evaluate(Vec3.Z, Vec3.Z).f().g()).isCloseTo(.04 * facets / 4, within(1e-12));
    Bsdf metal = new Look(1, .5, 0, 0, 0, true).bsdf(COLOR);
    // What is reflected repeatedly adds to that.
    Rgb mean = SchlickReflection.meanFresnel(COLOR, 1, ThinFilm.NONE);
    double rest = MultipleScattering.reflected(mean, 1, .25).evaluate(Vec3.Z, Vec3.Z).f().r();
    assertThat(rest).isBetween(.01, .02);
    assertThat(metal.evaluate(Vec3.Z, Vec3.Z).f().r())
        .isCloseTo(.9 * facets / 4 + rest, within(1e-12));
    Bsdf smooth = new Look(0, 0, 0, 0, 0, true).bsdf(Rgb.BLACK);
    assertThat(BsdfLaws.sampledAlbedo(smooth, Vec3.Z, 2000)).isCloseTo(.04, within(1e-4));
    Bsdf diamond = plastic.builder(Rgb.BLACK).set(IOR, 2.4).build().at(0, 0);
    double f0 = Math.pow(1.4 / 3.4, 2);
    assertThat(diamond.evaluate(Vec3.Z, Vec3.Z).f().g()).isCloseTo(f0 * facets / 4, within(1e-12));
  }

  @Test
  void specularScalesTheDielectricReflectionAndNoMetal() {
    Look plastic = new Look(0, .5, 0, 0, 0, true);
    for (double specular : new double[] {0, .5, 1}) {
      Bsdf bsdf =
          plastic
              .builder(Rgb.BLACK)
              .set(SPECULAR, ScalarChannel.of(specular))
              .set(SPECULAR_COLOR, ColorChannel.of(new Rgb(1, .5, .25)))
              .build()
              .at(0, 0);
      Rgb full = plastic.bsdf(Rgb.BLACK).evaluate(Vec3.Z, Vec3.Z).f();
      Rgb found = bsdf.evaluate(Vec3.Z, Vec3.Z).f();
      assertThat(found.r()).isCloseTo(specular * full.r(), within(1e-12));
      assertThat(found.b()).isCloseTo(.25 * specular * full.r(), within(1e-12));
    }
    Bsdf metal =
        new Look(1, .5, 0, 0, 0, true)
            .builder(COLOR)
            .set(SPECULAR, ScalarChannel.of(0))
            .build()
            .at(0, 0);
    assertThat(metal).isEqualTo(new Look(1, .5, 0, 0, 0, true).bsdf(COLOR));
  }

  /** Without a dielectric reflection, what remains is the Lambertian BRDF. */
  @Test
  void surfacesWithoutReflectionAreLambertian() {
    Bsdf matte =
        new Look(0, 1, 0, 0, 0, true)
            .builder(COLOR)
            .set(SPECULAR, ScalarChannel.of(0))
            .build()
            .at(0, 0);
    Bsdf lambertian = new Lambertian(COLOR);
    for (double cos : COSINES) {
      Vec3 wi = direction(cos);
      assertThat(matte.evaluate(direction(.7), wi).f().g())
          .isCloseTo(lambertian.evaluate(direction(.7), wi).f().g(), within(1e-12));
    }
    assertThat(matte.diffuseAlbedo()).isEqualTo(COLOR);
  }

  /** The limit of a smooth gray metal of reflectance 1: a mirror. */
  @Test
  void smoothWhiteMetalReflectsAllLight() {
    Bsdf mirror = new Look(1, 0, 0, 0, 0, true).bsdf(Rgb.WHITE);
    for (double cos : new double[] {1, .9, .5, .1}) {
      assertThat(BsdfLaws.sampledAlbedo(mirror, direction(cos), 4000)).isCloseTo(1, within(2e-3));
    }
  }

  @Test
  void halfAMetalIsTheMeanOfBoth() {
    Bsdf half = new Look(.5, .6, 0, 0, 0, true).bsdf(COLOR);
    Bsdf plastic = new Look(0, .6, 0, 0, 0, true).bsdf(COLOR);
    Bsdf metal = new Look(1, .6, 0, 0, 0, true).bsdf(COLOR);
    for (int i = 0; i < 100; i++) {
      Vec3 wo = direction(random);
      Vec3 wi = direction(random);
      Rgb mean = plastic.evaluate(wo, wi).f().plus(metal.evaluate(wo, wi).f()).times(.5);
      assertThat(half.evaluate(wo, wi).f().b())
          .isCloseTo(mean.b(), within(1e-12 + 1e-12 * mean.b()));
    }
  }

  @Test
  void smoothThinGlassPassesWhatItDoesNotReflect() {
    MetallicRoughness glass = new Look(0, 0, 1, 0, 0, true).builder(COLOR).build();
    for (double cos : COSINES) {
      for (double side : BOTH_SIDES) {
        double reflected = .04 + .96 * Math.pow(1 - cos, 5);
        Rgb passed = glass.transmittance(seenFrom(direction(side * cos)));
        assertThat(passed.r()).isCloseTo(.9 * (1 - reflected), within(1e-12));
        assertThat(passed.b()).isCloseTo(.1 * (1 - reflected), within(1e-12));
      }
    }
    assertThat(glass.isOpaque()).isFalse();
    MetallicRoughness rough = new Look(0, .4, 1, 0, 0, true).builder(COLOR).build();
    assertThat(rough.transmittance(seenFrom(Vec3.Z)).isBlack()).isTrue();
  }

  @Test
  void opacityDividesLightBetweenScatteringAndPassing() {
    Look plastic = new Look(0, .5, 0, 0, 0, true);
    MetallicRoughness veil = plastic.builder(COLOR).set(OPACITY, ScalarChannel.of(.25)).build();
    assertThat(veil.transmittance(seenFrom(Vec3.Z))).isEqualTo(Rgb.gray(.75));
    Vec3 wo = direction(.7);
    Vec3 wi = direction(.3);
    assertThat(veil.at(0, 0).evaluate(wo, wi).f())
        .isEqualTo(plastic.bsdf(COLOR).evaluate(wo, wi).f().times(.25));
    assertThat(veil.at(0, 0).pdf(wo, wi)).isEqualTo(plastic.bsdf(COLOR).pdf(wo, wi));
    BsdfLaws.assertWeightIsEvalOverPdf(veil.at(0, 0), wo, 100, random, 1e-12);
  }

  @Test
  void backFacesOfSingleSidedSurfacesAreInvisible() {
    MetallicRoughness single = new Look(0, .5, 0, 0, 0, true).builder(COLOR).singleSided().build();
    assertThat(single.isOpaque()).isFalse();
    assertThat(single.transmittance(seenFrom(Vec3.Z))).isEqualTo(Rgb.BLACK);
    assertThat(single.transmittance(seenFrom(Vec3.Z.negated()))).isEqualTo(Rgb.WHITE);
  }

  @Test
  void absorptionGivesTheColorAtTheDistance() {
    MetallicRoughness.Builder medium =
        MetallicRoughness.builder().set(ATTENUATION_COLOR, new Rgb(1, .5, 0));
    Rgb sigma = medium.set(ATTENUATION_DISTANCE, 2).build().absorption();
    assertThat(sigma.r()).isZero();
    assertThat(Math.exp(-2 * sigma.g())).isCloseTo(.5, within(1e-12));
    assertThat(Math.exp(-2 * sigma.b())).isCloseTo(1e-9, within(1e-20));
    medium.set(ATTENUATION_COLOR, Rgb.BLACK).set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY);
    assertThat(medium.build().absorption().isBlack()).isTrue();
  }

  @Test
  void onlyConstantOpaqueMaterialsAreSimplified() {
    Look plastic = new Look(0, .5, 0, 0, 0, true);
    MetallicRoughness constant = plastic.builder(COLOR).build();
    assertThat(constant.isUniform()).isTrue();
    MetallicRoughness opaque =
        MetallicRoughness.builder().set(BASE_COLOR, ColorChannel.of(COLOR)).build();
    assertThat(opaque.simplified()).isEqualTo(new UniformMaterial(opaque.at(0, 0)));
    ColorChannel varying = hit -> COLOR;
    MetallicRoughness textured = MetallicRoughness.builder().set(BASE_COLOR, varying).build();
    assertThat(textured.isUniform()).isFalse();
    assertThat(textured.simplified()).isSameAs(textured);
    MetallicRoughness veil = MetallicRoughness.builder().set(OPACITY, ScalarChannel.of(.5)).build();
    assertThat(veil.simplified()).isSameAs(veil);
    assertThat(constant.simplified()).isSameAs(constant);
  }

  @Test
  void refractiveIndicesBelowOneAreRefused() {
    assertThatThrownBy(() -> MetallicRoughness.builder().set(IOR, .5))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("ior: expected 0 or 1 to 1e6, found 0.5");
  }
}
