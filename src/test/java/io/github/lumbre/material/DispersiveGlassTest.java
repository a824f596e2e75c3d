package io.github.lumbre.material;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.DISPERSION;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Draws;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.InParallel;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests glass that refracts each color by its own index. */
class DispersiveGlassTest {
  /** White light, light of two colors, and light of one, as it leaves a dispersive surface. */
  private static final List<Rgb> CARRIED = List.of(Rgb.WHITE, new Rgb(.2, 0, 1), new Rgb(0, 3, 0));

  private static final double[] COSINES = {1, .8, .4, .1, -.1, -.7, -.8, -1};

  private final SplittableRandom random = new SplittableRandom(Effort.seed(61));

  private static MetallicRoughness.Builder glass(double roughness, double dispersion) {
    return MetallicRoughness.builder()
        .set(METALLIC, 0)
        .set(TRANSMISSION, 1)
        .set(ATTENUATION_DISTANCE, 1)
        .set(ROUGHNESS, roughness)
        .set(DISPERSION, dispersion);
  }

  private static double component(Rgb color, int i) {
    return i == 0 ? color.r() : i == 1 ? color.g() : color.b();
  }

  /** Abbe's number is (green - 1) / (blue - red): 36.4 for flint glass of 1.62. */
  @Test
  void eachColorHasTheAngleOfItsIndex() {
    Bsdf bsdf = glass(0, 20 / 36.4).set(IOR, 1.62).build().at(0, 0);
    double half = .62 / 36.4 / 2;
    double[] indices = {1.62 - half, 1.62, 1.62 + half};
    for (double cos : new double[] {.9, .5, .2}) {
      double sin = Math.sqrt(1 - cos * cos);
      boolean[] isFound = new boolean[3];
      for (int i = 0; i < 300; i++) {
        BsdfSample sample = bsdf.sample(new Vec3(sin, 0, cos), i / 300., Draws.inSquare(random));
        if (sample.wi().z() > 0) {
          continue;
        }
        int color = sample.r() > 0 ? 0 : sample.g() > 0 ? 1 : 2;
        isFound[color] = true;
        assertThat(-sample.wi().x() * indices[color]).isCloseTo(sin, within(1e-15));
        assertThat(component(sample.weight(), color)).isCloseTo(sample.weight().max(), within(0.));
        assertThat(sample.r() + sample.g() + sample.b()).isEqualTo(sample.weight().max());
      }
      assertThat(isFound).containsOnly(true);
    }
  }

  /** The mean weight of each color over all random numbers is what its own glass scatters: 1. */
  @Test
  void smoothGlassKeepsTheLightOfEachColor() {
    int numbers = 30_000;
    for (Rgb carried : CARRIED) {
      Bsdf bsdf = glass(0, 3).build().at(0, 0).narrowed(carried);
      for (double cos : COSINES) {
        Vec3 wo = BsdfLaws.direction(cos);
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < numbers; i++) {
          Rgb weight = bsdf.sample(wo, (i + .5) / numbers, Draws.inSquare(random)).weight();
          sum = sum.plus(weight.times(1. / numbers));
        }
        for (int color = 0; color < 3; color++) {
          if (component(carried, color) > 0) {
            // Each of four intervals of numbers is cut at most by one number at both ends; a
            // weight is at most the sum of the colors by one of them: 6.
            assertThat(component(sum, color)).isCloseTo(1, within(8 * 6. / numbers));
          }
        }
      }
    }
  }

  @Test
  void pathsOfOneColorKeepIt() {
    Rgb green = new Rgb(0, 2, 0);
    for (double roughness : new double[] {0, .4}) {
      Bsdf bsdf = glass(roughness, 3).build().at(0, 0).narrowed(green);
      Bsdf plain = glass(roughness, 0).build().at(0, 0);
      for (int i = 0; i < 1000; i++) {
        Vec3 wo = BsdfLaws.direction(random);
        double lobe = random.nextDouble();
        BsdfSample expected = plain.sample(wo, lobe, new Point2(.3, .6));
        BsdfSample found = bsdf.sample(wo, lobe, new Point2(.3, .6));
        assertThat(found.wi().minus(expected.wi()).length()).isLessThan(1e-12);
        assertThat(found.g()).isCloseTo(expected.g(), within(1e-12));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {.3, .6, 1})
  void roughGlassScattersEachColorByItsIndex(double roughness) {
    double[] indices = {1.5 - .0375, 1.5, 1.5 + .0375};
    for (Rgb carried : CARRIED) {
      Bsdf bsdf = glass(roughness, 3).build().at(0, 0).narrowed(carried);
      for (double cos : COSINES) {
        BsdfLaws.assertWeightIsEvalOverPdf(bsdf, BsdfLaws.direction(cos), 100, random, 1e-12);
      }
      for (int i = 0; i < 200; i++) {
        Vec3 wo = BsdfLaws.direction(random);
        Vec3 wi = BsdfLaws.direction(random);
        for (int color = 0; color < 3; color++) {
          Bsdf one = Compensated.glass(Rgb.WHITE, Rgb.WHITE, indices[color], roughness * roughness);
          assertThat(component(bsdf.evaluate(wo, wi).f(), color))
              .isCloseTo(one.evaluate(wo, wi).f().g(), within(1e-12));
        }
      }
    }
  }

  @Test
  void samplesFollowTheDensity() {
    InParallel.forEach(
        CARRIED,
        carried -> {
          SplittableRandom own = new SplittableRandom(Effort.seed(62 + CARRIED.indexOf(carried)));
          Bsdf bsdf = glass(.9, 8).build().at(0, 0).narrowed(carried);
          for (double cos : new double[] {.9, .5}) {
            Vec3 wo = BsdfLaws.direction(cos);
            BsdfLaws.assertSamplesFollowPdf(
                carried, bsdf, wo, Effort.count(300_000, 2_000_000), 24, own);
          }
        });
  }

  @Test
  void extremesAreHarmless() {
    for (double dispersion : new double[] {1e-12, 1, 1e9}) {
      for (double ior : new double[] {1 + 1e-7, 1.5, 1e6}) {
        Bsdf rough = glass(.5, dispersion).set(IOR, ior).build().at(0, 0);
        BsdfLaws.assertExtremesAreHarmless(rough);
        BsdfLaws.assertExtremesAreHarmless(rough.narrowed(new Rgb(1, 0, 0)));
        Bsdf smooth = glass(0, dispersion).set(IOR, ior).build().at(0, 0);
        for (double cos : new double[] {0, 1e-300, 1e-9, .5, 1}) {
          for (double lobe : new double[] {0, .5, BsdfLaws.LAST}) {
            BsdfSample sample =
                smooth.sample(BsdfLaws.direction(-cos), lobe, Draws.inSquare(random));
            assertThat(sample.weight().isFinite()).isTrue();
            assertThat(sample.wi().length()).isCloseTo(1, within(1e-12));
          }
        }
      }
    }
  }

  /** Without dispersion, and in thin panes and metals, nothing changes. */
  @Test
  void dispersionOfZeroIsPlainGlass() {
    assertThat(glass(0, 0).build().at(0, 0)).isInstanceOf(Dielectric.class);
    assertThat(glass(.5, 0).build().at(0, 0)).isInstanceOf(Compensated.class);
    assertThat(glass(0, 0).build().isDispersive()).isFalse();
    assertThat(glass(0, 1).set(IOR, 1).build().isDispersive()).isFalse();
    assertThat(glass(0, 1).set(IOR, 0).build().isDispersive()).isFalse();
    assertThat(glass(0, 1).build().isDispersive()).isTrue();
    MetallicRoughness thin =
        MetallicRoughness.builder().set(TRANSMISSION, 1).set(DISPERSION, 1).build();
    assertThat(thin.isDispersive()).isFalse();
  }
}
