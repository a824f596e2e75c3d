package io.github.lumbre.material;

import static io.github.lumbre.material.BsdfLaws.COSINES;
import static io.github.lumbre.material.BsdfLaws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Beckmann;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests mixtures of BSDFs. */
class MixtureTest {
  private static final Lambertian DIFFUSE = new Lambertian(new Rgb(.2, .5, .1));
  private static final Rgb SPECULAR = new Rgb(.8, .4, .9);
  private static final Lobe MIRROR = new FresnelMirror(SPECULAR, 1.5);
  private static final Lobe[] LOBES = {
    new PhongLobe(SPECULAR, 0),
    new PhongLobe(SPECULAR, 10),
    new PhongLobe(SPECULAR, 1e9),
    new MicrofacetReflection(SPECULAR, 1.5, new Beckmann(1e-3)),
    new MicrofacetReflection(SPECULAR, 3, new Ggx(.3)),
    new MicrofacetReflection(SPECULAR, 1, new Ggx(.3)),
  };

  private final SplittableRandom random = new SplittableRandom(53);

  @Test
  void weightIsEvalOverPdf() {
    for (Lobe lobe : LOBES) {
      for (double cos : COSINES) {
        BsdfLaws.assertWeightIsEvalOverPdf(
            new Mixture(DIFFUSE, lobe), direction(cos), 1000, random, 1e-12);
        BsdfLaws.assertWeightIsEvalOverPdf(
            new Mixture(DIFFUSE, lobe), direction(-cos), 1000, random, 1e-12);
      }
    }
  }

  @Test
  void albedoIsTheSumOfTheParts() {
    for (Lobe lobe : LOBES) {
      for (double cos : COSINES) {
        Vec3 wo = direction(cos);
        double sum = .5 + BsdfLaws.sampledAlbedo(lobe, wo, 5000);
        double both = BsdfLaws.sampledAlbedo(new Mixture(DIFFUSE, lobe), wo, 5000);
        assertThat(both).isCloseTo(sum, within(5e-3));
        assertThat(sum).isLessThanOrEqualTo(1);
      }
    }
  }

  @Test
  void sampledDirectionsFollowPdf() {
    for (Lobe lobe : new Lobe[] {LOBES[1], LOBES[4]}) {
      Mixture mixture = new Mixture(DIFFUSE, lobe);
      for (double cos : new double[] {.9, -.7}) {
        Vec3 wo = direction(cos);
        BsdfLaws.assertSamplesFollowPdf(lobe, mixture, wo, 60_000, 6, random);
      }
    }
  }

  @Test
  void extremesAreHarmless() {
    for (Lobe lobe : LOBES) {
      BsdfLaws.assertExtremesAreHarmless(new Mixture(DIFFUSE, lobe));
    }
  }

  @Test
  void mirrorIsDrawnAsOftenAsItMattersAndBothKeepTheirEnergy() {
    Mixture mixture = new Mixture(DIFFUSE, MIRROR);
    for (double cos : new double[] {1, .5, .1, -.5}) {
      Vec3 wo = direction(cos);
      double reflected = .4 * Fresnel.dielectric(Math.abs(cos), 1.5);
      assertThat(BsdfLaws.sampledAlbedo(mixture, wo, 20_000))
          .isCloseTo(.5 + reflected, within(1e-3));
      BsdfSample mirrored = mixture.sample(wo, BsdfLaws.LAST, new Point2(.5, .5));
      assertThat(mirrored.isSpecular()).isTrue();
      assertThat(mirrored.wi()).isEqualTo(new Vec3(-wo.x(), -wo.y(), wo.z()));
    }
    assertThat(mixture.isSpecular()).isFalse();
    assertThat(mixture.diffuseAlbedo()).isEqualTo(DIFFUSE.albedo());
  }

  @Test
  void mirrorIsDrawnInProportionToItsImportance() {
    Mixture mixture = new Mixture(DIFFUSE, MIRROR);
    for (double cos : new double[] {1, .3, .1, -.5}) {
      double mirrored = .9 * Fresnel.dielectric(Math.abs(cos), 1.5);
      int n = 10_000;
      int count = 0;
      for (int i = 0; i < n; i++) {
        BsdfSample sample = mixture.sample(direction(cos), (i + .5) / n, new Point2(.3, .6));
        count += sample.isSpecular() ? 1 : 0;
      }
      assertThat((double) count / n).isCloseTo(mirrored / (.5 + mirrored), within(1.0 / n));
    }
  }

  @Test
  void partWithoutImportanceIsNeverDrawn() {
    Lobe none = new FresnelMirror(SPECULAR, 1);
    for (Mixture mixture : new Mixture[] {new Mixture(none, DIFFUSE), new Mixture(DIFFUSE, none)}) {
      for (double uLobe : new double[] {0, .5, BsdfLaws.LAST}) {
        BsdfSample sample = mixture.sample(Vec3.Z, uLobe, new Point2(.3, .6));
        assertThat(sample.isSpecular()).isFalse();
        assertThat(sample.isAbsorbed()).isFalse();
      }
    }
  }

  /**
   * A direction that one part samples but does not scatter into still counts for the other part.
   */
  @Test
  void partThatScattersNothingTakesNoLightFromTheOther() {
    Lobe dark =
        new Lobe() {
          @Override
          public Rgb albedo() {
            return Rgb.WHITE;
          }

          private final Lambertian draws = new Lambertian(Rgb.WHITE);

          @Override
          public void evaluate(
              double woX,
              double woY,
              double woZ,
              double wiX,
              double wiY,
              double wiZ,
              BsdfValue result) {
            Vec3 wo = new Vec3(woX, woY, woZ);
            result.set(Rgb.BLACK, draws.pdf(wo, new Vec3(wiX, wiY, wiZ)));
          }

          @Override
          public void sample(
              double woX,
              double woY,
              double woZ,
              double uLobe,
              double u,
              double v,
              BsdfSample result) {
            draws.sample(woX, woY, woZ, uLobe, u, v, result);
            result.set(result.wi(), Rgb.BLACK, result.pdf());
          }

          @Override
          public double importance(double cosine) {
            return 1;
          }
        };
    assertThat(BsdfLaws.sampledAlbedo(new Mixture(DIFFUSE, dark), Vec3.Z, 1000))
        .isCloseTo(.5, within(1e-3));
  }
}
