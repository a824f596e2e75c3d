package io.github.lumbre.material;

import static io.github.lumbre.testing.Draws.direction;
import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the invariants of the Lambertian BSDF. */
class LambertianTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;
  private static final Rgb ALBEDO = new Rgb(.25, .5, .75);

  private final SplittableRandom random = new SplittableRandom(Effort.seed(14));
  private final Lambertian bsdf = new Lambertian(ALBEDO);

  @Test
  void everySampleWeighsTheAlbedo() {
    for (int i = 0; i < 100_000; i++) {
      Vec3 wo = direction(random);
      BsdfSample sample = bsdf.sample(wo, .5, inSquare(random));
      assertThat(sample.weight()).isEqualTo(ALBEDO);
      // The weight agrees with eval and pdf, and the density with pdf.
      Rgb value = bsdf.evaluate(wo, sample.wi()).f();
      double pdf = bsdf.pdf(wo, sample.wi());
      assertThat(sample.pdf()).isEqualTo(pdf);
      assertThat(value.g() / pdf).isCloseTo(.5, within(4 * EPS));
      assertThat(value.b() / pdf).isCloseTo(.75, within(4 * EPS));
    }
  }

  @Test
  void sampledDirectionsFollowPdfOnBothSidesAndAtGrazingAngles() {
    for (double z : new double[] {1, .5, .01, -.01, -1}) {
      Vec3 wo = new Vec3(Math.sqrt(1 - z * z), 0, z);
      ChiSquare test =
          ChiSquare.ofDirections(
              Effort.count(200_000, 1_000_000),
              () -> Optional.of(bsdf.sample(wo, .5, inSquare(random)).wi()),
              wi -> bsdf.pdf(wo, wi),
              8);
      assertThat(test.passes()).isTrue();
    }
  }

  @Test
  void scatteringIsReciprocal() {
    for (int i = 0; i < 100_000; i++) {
      Vec3 a = direction(random);
      Vec3 b = direction(random);
      double there = bsdf.evaluate(a, b).f().g() / Math.abs(b.z());
      double back = bsdf.evaluate(b, a).f().g() / Math.abs(a.z());
      assertThat(there).isCloseTo(back, within(4 * EPS));
    }
  }

  @Test
  void whiteFurnaceKeepsTheAlbedo() {
    // f cos divided by a uniform sphere density: the mean is the albedo, the standard deviation
    // 0.65.
    int n = Statistics.samplesToDetect(.01, .65);
    Moments moments = new Moments();
    for (int i = 0; i < n; i++) {
      double z = random.nextDouble(-1, 1);
      Vec3 wi = new Vec3(Math.sqrt(1 - z * z), 0, z);
      moments.add(bsdf.evaluate(Vec3.Z, wi).f().g() * 4 * Math.PI);
    }
    assertThat(Statistics.deviation(moments.z(.5))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void nothingPassesThrough() {
    assertThat(bsdf.evaluate(Vec3.Z, new Vec3(.6, 0, -.8)).f().isBlack()).isTrue();
    assertThat(bsdf.pdf(new Vec3(.6, 0, -.8), Vec3.Z)).isZero();
    assertThat(bsdf.evaluate(Vec3.Z, Vec3.X).f().isBlack()).isTrue();
    assertThat(bsdf.evaluate(Vec3.X, Vec3.Z).f().isBlack()).isTrue();
    assertThat(bsdf.sample(Vec3.X, .5, inSquare(random)).isAbsorbed()).isTrue();
  }

  @Test
  void extremesAreHarmless() {
    BsdfLaws.assertExtremesAreHarmless(bsdf);
    assertThat(bsdf.diffuseAlbedo()).isEqualTo(bsdf.albedo());
    assertThat(bsdf.isSpecular()).isFalse();
  }

  @Test
  void extremeNumbersGiveASampleOrNone() {
    for (double x : new double[] {0, 0x1p-53, .5, LAST}) {
      for (double y : new double[] {0, 0x1p-53, .5, LAST}) {
        BsdfSample sample = bsdf.sample(Vec3.Z, LAST, new Point2(x, y));
        if (!sample.isAbsorbed()) {
          assertThat(sample.pdf()).isPositive().isLessThan(.4);
          assertThat(sample.wi().length()).isCloseTo(1, within(4 * EPS));
        }
      }
    }
  }
}
