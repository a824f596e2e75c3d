package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.EPS;
import static io.github.lumbre.material.BsdfLaws.direction;
import static io.github.lumbre.material.MaterialParameter.ANISOTROPY;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION_COLOR;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.InParallel;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests diffuse transmission against the text of its extension and BSDF invariants. */
class TranslucentTest {
  private static final Rgb BASE = new Rgb(.9, .5, .1);
  private static final Rgb THROUGH = new Rgb(.2, .6, .8);
  private static final double[] STRENGTHS = {0, .25, .5, .9, 1};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(71));

  private static MetallicRoughness.Builder leaf(double strength) {
    return MetallicRoughness.builder()
        .set(METALLIC, 0)
        .set(ROUGHNESS, .5)
        .set(DIFFUSE_TRANSMISSION, strength);
  }

  private static MetallicRoughness.Builder colored(double strength) {
    return leaf(strength).set(BASE_COLOR, BASE).set(DIFFUSE_TRANSMISSION_COLOR, THROUGH);
  }

  private static Bsdf bsdf(MetallicRoughness.Builder builder) {
    return builder.build().at(0, 0);
  }

  /** Returns materials that have the lobe alone, beside others and below each layer. */
  private static List<MetallicRoughness.Builder> all(double strength, boolean isColored) {
    List<MetallicRoughness.Builder> all =
        List.of(
            leaf(strength),
            leaf(strength).set(SPECULAR, 0),
            leaf(strength).set(METALLIC, .4),
            leaf(strength).set(TRANSMISSION, .5),
            leaf(strength).set(ANISOTROPY, .8),
            leaf(strength).set(SHEEN_COLOR, Rgb.gray(.5)),
            leaf(strength).set(CLEARCOAT, 1),
            leaf(strength).set(BASE_COLOR, Rgb.BLACK));
    if (isColored) {
      all.forEach(b -> b.set(BASE_COLOR, BASE).set(DIFFUSE_TRANSMISSION_COLOR, THROUGH));
    }
    return all;
  }

  /** Without a reflection, both lobes are the ones that the extension's text states. */
  @Test
  void bothSidesAreLambertianWithoutReflection() {
    for (double strength : STRENGTHS) {
      Bsdf paper = bsdf(colored(strength).set(SPECULAR, 0));
      for (double side : new double[] {1, -1}) {
        for (double cosine : COSINES) {
          Vec3 wo = direction(side * .7);
          Rgb same = paper.evaluate(wo, direction(side * cosine)).f().times(Math.PI / cosine);
          Rgb other = paper.evaluate(wo, direction(-side * cosine)).f().times(Math.PI / cosine);
          assertThat(same.r()).isCloseTo((1 - strength) * .9, within(1e-12));
          assertThat(same.b()).isCloseTo((1 - strength) * .1, within(1e-12));
          assertThat(other.r()).isCloseTo(strength * .2, within(1e-12));
          assertThat(other.b()).isCloseTo(strength * .8, within(1e-12));
        }
      }
    }
  }

  @Test
  void withoutStrengthNothingChanges() {
    assertThat(bsdf(colored(0)))
        .isEqualTo(
            bsdf(
                MetallicRoughness.builder()
                    .set(METALLIC, 0)
                    .set(ROUGHNESS, .5)
                    .set(BASE_COLOR, BASE)));
  }

  @Test
  void metalsAndGlassTakePrecedence() {
    assertThat(bsdf(colored(.5).set(METALLIC, 1))).isEqualTo(bsdf(colored(0).set(METALLIC, 1)));
    assertThat(bsdf(colored(.5).set(TRANSMISSION, 1)))
        .isEqualTo(bsdf(colored(0).set(TRANSMISSION, 1)));
  }

  /** The reflection stays, and the strength mixes both diffuse lobes. */
  @Test
  void strengthMixesLinearly() {
    Bsdf none = bsdf(colored(0));
    Bsdf full = bsdf(colored(1));
    Bsdf mixed = bsdf(colored(.3));
    for (int i = 0; i < 200; i++) {
      Vec3 wo = direction(random);
      Vec3 wi = direction(random);
      double expected = .7 * none.evaluate(wo, wi).f().g() + .3 * full.evaluate(wo, wi).f().g();
      assertThat(mixed.evaluate(wo, wi).f().g())
          .isCloseTo(expected, within(1e-12 + 1e-12 * expected));
    }
  }

  /** What a white surface does not reflect, it transmits: the sum does not depend on the share. */
  @Test
  void whiteFurnaceKeepsTheEnergyOfThePlainSurface() {
    int samples = Effort.count(20_000, 200_000);
    InParallel.forEach(
        List.of(1., .5, .1, -.8),
        cosine -> {
          Vec3 wo = direction(cosine);
          double[] plain =
              all(0, false).stream()
                  .mapToDouble(builder -> BsdfLaws.sampledAlbedo(bsdf(builder), wo, samples))
                  .toArray();
          for (double strength : STRENGTHS) {
            List<MetallicRoughness.Builder> leaves = all(strength, false);
            // The last one is black without transmission.
            for (int i = 0; i < leaves.size() - 1; i++) {
              double found = BsdfLaws.sampledAlbedo(bsdf(leaves.get(i)), wo, samples);
              assertThat(found)
                  .as("%s, strength %s", i, strength)
                  .isLessThanOrEqualTo(1 + 3e-3)
                  .isCloseTo(plain[i], within(6e-3));
            }
          }
        });
  }

  @Test
  void scatteringIsReciprocal() {
    for (double strength : STRENGTHS) {
      for (MetallicRoughness.Builder builder : all(strength, true)) {
        Bsdf bsdf = bsdf(builder);
        for (int i = 0; i < 100; i++) {
          Vec3 a = direction(random);
          Vec3 b = direction(random);
          BsdfLaws.assertReciprocal(bsdf, a, b, 256 * EPS);
        }
      }
    }
  }

  /** Metal and leaf below one film are two surfaces side by side; a coat covers both. */
  @Test
  void coatsAboveFilmsAreReciprocal() {
    Bsdf bsdf = bsdf(colored(.5).set(METALLIC, .4).set(IRIDESCENCE, 1).set(CLEARCOAT, 1));
    for (int i = 0; i < 300; i++) {
      Vec3 a = direction(random);
      Vec3 b = direction(random);
      BsdfLaws.assertReciprocal(bsdf, a, b, 256 * EPS);
    }
  }

  @Test
  void weightIsEvalOverPdf() {
    for (double strength : STRENGTHS) {
      for (MetallicRoughness.Builder builder : all(strength, true)) {
        for (double cosine : COSINES) {
          Bsdf bsdf = bsdf(builder);
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(cosine), 40, random, 1e-12);
          BsdfLaws.assertWeightIsEvalOverPdf(bsdf, direction(-cosine), 40, random, 1e-12);
        }
      }
    }
  }

  @Test
  void extremesAreHarmless() {
    for (MetallicRoughness.Builder builder : all(.5, true)) {
      BsdfLaws.assertExtremesAreHarmless(bsdf(builder));
    }
  }

  /**
   * Directions follow the density. With 100,000 samples in about 3000 cells, a lobe that is drawn 5
   * % too often is found with a probability above 0.99.
   */
  @Test
  void sampledDirectionsFollowPdf() {
    for (MetallicRoughness.Builder builder :
        List.of(
            colored(.6).set(ROUGHNESS, .8),
            colored(1).set(SPECULAR, 0),
            colored(.5).set(ROUGHNESS, .8).set(SHEEN_COLOR, Rgb.gray(.5)))) {
      Bsdf bsdf = bsdf(builder);
      for (double cosine : new double[] {.9, -.6}) {
        Vec3 wo = direction(cosine);
        BsdfLaws.assertSamplesFollowPdf("", bsdf, wo, Effort.count(100_000, 1_000_000), 6, random);
      }
    }
  }

  /** Light sampling has to look behind the surface, whatever covers it. */
  @Test
  void lightFromBehindCanBeSampled() {
    for (MetallicRoughness.Builder builder : all(.5, true)) {
      MetallicRoughness material = builder.build();
      assertThat(material.at(0, 0).isTransmissive()).isTrue();
      // No light passes straight, but through the pane.
      assertThat(material.isOpaque()).isEqualTo(material.stated(TRANSMISSION).isEmpty());
      assertThat(bsdf(builder.set(OPACITY, .5)).isTransmissive()).isTrue();
    }
  }

  /** Ambient light and the layer of albedo have the colors of both sides. */
  @Test
  void albedoIsThatOfBothSides() {
    Rgb albedo = bsdf(colored(.25).set(SPECULAR, 0)).diffuseAlbedo();
    assertThat(albedo.r()).isCloseTo(.75 * .9 + .25 * .2, within(1e-12));
    assertThat(bsdf(colored(.25).set(SPECULAR, 0)).albedo()).isEqualTo(albedo);
  }
}
