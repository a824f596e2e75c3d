package io.github.lumbre.material;

import static io.github.lumbre.testing.Draws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the directions and weights of smooth glass. */
class DielectricTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;
  private static final Point2 U = new Point2(.5, .5);

  private final SplittableRandom random = new SplittableRandom(13);

  private static Dielectric clear(double ior) {
    return new Dielectric(Rgb.WHITE, Rgb.WHITE, ior);
  }

  /** Returns the exact fraction of the uniform numbers that select reflection. */
  private static double reflectionProbability(Dielectric glass, Vec3 wo) {
    long low = 0;
    long high = 1L << 53;
    while (low < high) {
      long middle = (low + high) >>> 1;
      if (glass.sample(wo, middle * 0x1p-53, U).wi().z() * wo.z() > 0) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low * 0x1p-53;
  }

  @Test
  void weightsOfTheLobesAverageToWhatIsReflectedAndPasses() {
    Rgb tint = new Rgb(.9, .1, 0);
    Rgb pass = new Rgb(.2, .4, .8);
    for (int i = 0; i < 10_000; i++) {
      Dielectric glass = new Dielectric(tint, pass, random.nextDouble(.4, 3));
      Vec3 wo = direction(random);
      double share = glass.reflected(wo);
      double p = reflectionProbability(glass, wo);
      Rgb mean = Rgb.BLACK;
      if (p > 0) {
        mean = mean.plus(glass.sample(wo, 0, U).weight().times(p));
      }
      if (p < 1) {
        mean = mean.plus(glass.sample(wo, LAST, U).weight().times(1 - p));
      }
      Rgb expected = tint.times(share).plus(pass.times(1 - share));
      assertThat(mean.r()).isCloseTo(expected.r(), within(8 * EPS));
      assertThat(mean.g()).isCloseTo(expected.g(), within(8 * EPS));
      assertThat(mean.b()).isCloseTo(expected.b(), within(8 * EPS));
    }
  }

  @Test
  void untintedGlassKeepsAllLightInEverySample() {
    for (int i = 0; i < 100_000; i++) {
      BsdfSample sample =
          clear(random.nextDouble(.3, 4)).sample(direction(random), random.nextDouble(), U);
      assertThat(sample.weight().r()).isCloseTo(1, within(4 * EPS));
      assertThat(sample.isSpecular()).isTrue();
      assertThat(sample.wi().length()).isCloseTo(1, within(4 * EPS));
    }
  }

  @Test
  void sameMediumIsInvisible() {
    Dielectric air = new Dielectric(Rgb.WHITE, new Rgb(.3, .6, .9), 1);
    for (int i = 0; i < 1000; i++) {
      Vec3 wo = i == 0 ? Vec3.X : direction(random);
      for (double u : new double[] {0, .5, LAST}) {
        BsdfSample sample = air.sample(wo, u, U);
        assertThat(sample.wi()).isEqualTo(wo.negated());
        assertThat(sample.weight()).isEqualTo(new Rgb(.3, .6, .9));
      }
    }
  }

  @Test
  void almostTheSameMediumBarelyBends() {
    Dielectric glass = clear(1 + 1e-12);
    for (int i = 0; i < 10_000; i++) {
      Vec3 wo = direction(random);
      if (Math.abs(wo.z()) > .1) {
        assertThat(glass.refract(wo).plus(wo).length()).isLessThan(1e-11);
        assertThat(glass.reflected(wo)).isBetween(1e-25, 1e-20);
      }
    }
  }

  @Test
  void refractionFollowsSnellsLaw() {
    for (int i = 0; i < 10_000; i++) {
      double ior = random.nextDouble(1, 3);
      Vec3 wo = direction(random);
      double eta = wo.z() > 0 ? ior : 1 / ior;
      Dielectric glass = clear(ior);
      if (glass.reflected(wo) < 1) {
        Vec3 wi = glass.refract(wo);
        assertThat(wi.z() * wo.z()).isLessThanOrEqualTo(0);
        assertThat(eta * wi.x()).isCloseTo(-wo.x(), within(8 * EPS));
        assertThat(eta * wi.y()).isCloseTo(-wo.y(), within(8 * EPS));
      }
    }
  }

  @Test
  void slabChangesNoDirection() {
    for (int i = 0; i < 100_000; i++) {
      Vec3 d = direction(random);
      Vec3 wo = new Vec3(d.x(), d.y(), Math.abs(d.z()));
      Dielectric glass = clear(random.nextDouble(1.001, 3));
      Vec3 inside = glass.refract(wo);
      // The second surface is the first one upside down.
      Vec3 out = glass.refract(new Vec3(-inside.x(), -inside.y(), inside.z()));
      Vec3 leaving = new Vec3(out.x(), out.y(), -out.z());
      assertThat(leaving.plus(wo).length()).isLessThan(8 * EPS / wo.z());
    }
  }

  @Test
  void denseMediumRefractsAlongTheNormal() {
    Vec3 wi = clear(1e6).refract(new Vec3(.6, 0, .8));
    assertThat(wi.x()).isCloseTo(-.6e-6, within(1e-18));
    assertThat(wi.z()).isCloseTo(-1, within(1e-12));
    assertThat(clear(1e6).reflected(Vec3.Z)).isCloseTo(.999996000008, within(1e-12));
  }

  @Test
  void nothingPassesBeyondTheCriticalAngle() {
    Dielectric glass = new Dielectric(new Rgb(.5, .6, .7), Rgb.WHITE, .5);
    Vec3 wo = new Vec3(.6, 0, .8);
    for (double u : new double[] {0, .5, LAST}) {
      BsdfSample sample = glass.sample(wo, u, U);
      assertThat(sample.wi()).isEqualTo(new Vec3(-.6, -0.0, .8));
      assertThat(sample.weight()).isEqualTo(new Rgb(.5, .6, .7));
    }
  }

  /** The tints make the reflected and the transmitted light equal. */
  @Test
  void glassThatReflectsAsMuchAsPassesLosesNothing() {
    double fresnel = Fresnel.dielectric(1, 1.5);
    Dielectric glass = new Dielectric(Rgb.gray(1 - fresnel), Rgb.gray(fresnel), 1.5);
    double expected = 2 * fresnel * (1 - fresnel);
    assertThat(BsdfLaws.sampledAlbedo(glass, Vec3.Z, 1000)).isCloseTo(expected, within(1e-12));
    assertThat(glass.choosesLobe()).isTrue();
  }

  @Test
  void blackGlassAbsorbs() {
    Dielectric black = new Dielectric(Rgb.BLACK, Rgb.BLACK, 1.5);
    BsdfLaws.assertSamplesAlike(black, Vec3.Z, .5, U);
    assertThat(black.sample(Vec3.Z, .5, U).isAbsorbed()).isTrue();
    Dielectric onlyReflects = new Dielectric(Rgb.WHITE, Rgb.BLACK, 1.5);
    assertThat(onlyReflects.sample(Vec3.Z, LAST, U).wi().z()).isPositive();
    assertThat(onlyReflects.sample(Vec3.Z, LAST, U).weight().r()).isCloseTo(.04, within(EPS));
  }

  @Test
  void extremeAnglesAndMediaGiveFiniteSamples() {
    double[] cosines = {0, 1e-300, 1e-17, 1e-9, .5, LAST, 1};
    for (double ior : new double[] {1e-100, 1e-6, LAST, 1, 1 + EPS, 1.5, 1e6}) {
      for (double c : cosines) {
        for (double sign : new double[] {-1, 1}) {
          Vec3 wo = new Vec3(Math.sqrt(1 - c * c), 0, sign * c);
          for (double u : new double[] {0, .5, LAST}) {
            BsdfSample sample = clear(ior).sample(wo, u, U);
            assertThat(sample.weight().r()).isCloseTo(1, within(4 * EPS));
            assertThat(sample.wi().length()).isCloseTo(1, within(4 * EPS));
          }
        }
      }
    }
  }

  @Test
  void deltaLobesAreNeverMetByChance() {
    assertThat(clear(1.5).evaluate(Vec3.Z, Vec3.Z).f().isBlack()).isTrue();
    assertThat(clear(1.5).pdf(Vec3.Z, Vec3.Z)).isZero();
    assertThat(clear(1.5).isSpecular()).isTrue();
  }
}
