package io.github.lumbre.light;

import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the orientation, radiance and sampling of environment lights. */
class EnvironmentLightTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;

  private final SplittableRandom random = new SplittableRandom(40);

  /** Returns the texture coordinates as its value. */
  private static final Texture<Rgb> COORDINATES = (u, v) -> new Rgb(u, v, 1);

  private Vec3 direction() {
    double z = random.nextDouble(-1, 1);
    double phi = random.nextDouble(2 * Math.PI);
    double s = Math.sqrt(1 - z * z);
    return new Vec3(s * Math.cos(phi), s * Math.sin(phi), z);
  }

  /** An unfiltered image that repeats at the borders, as all textures do. */
  private static Texture<Rgb> image(double[][] rows) {
    return (u, v) -> {
      int row = Math.floorMod((int) Math.floor(v * rows.length), rows.length);
      int column = Math.floorMod((int) Math.floor(u * rows[0].length), rows[0].length);
      return Rgb.gray(rows[row][column]);
    };
  }

  private double[][] noise(int rows, int columns) {
    double[][] texels = new double[rows][columns];
    for (double[] row : texels) {
      for (int column = 0; column < columns; column++) {
        row[column] = Math.max(0, random.nextDouble(-.5, 1));
      }
    }
    return texels;
  }

  private static EnvironmentLight dome(Frame axes, double[][] texels) {
    return EnvironmentLight.image(axes, image(texels), texels[0].length, texels.length);
  }

  private static Frame turned() {
    Transform t = Transform.rotationDegrees(new Vec3(20, 130, -70));
    return new Frame(t.vector(Vec3.X), t.vector(Vec3.Y), t.vector(Vec3.Z));
  }

  private static LightSample sample(EnvironmentLight light, Point2 u) {
    return light.sample(Vec3.ZERO, u).orElseThrow();
  }

  @Test
  void imageIsSeenUprightAndUnmirroredFromInside() {
    EnvironmentLight light = EnvironmentLight.image(Frame.WORLD, COORDINATES, 8, 4);
    assertThat(light.from(Vec3.Z)).isEqualTo(new Rgb(.5, .5, 1));
    assertThat(light.from(Vec3.X).r()).isCloseTo(.75, within(EPS));
    assertThat(light.from(Vec3.X.negated()).r()).isCloseTo(.25, within(EPS));
    assertThat(light.from(new Vec3(0, .5, Math.sqrt(.75))).g()).isCloseTo(2 / 3.0, within(EPS));
    for (int i = 0; i < 10_000; i++) {
      Vec3 d = direction();
      Rgb seen = light.from(d);
      double u = .5 + StrictMath.atan2(d.x(), d.z()) / (2 * Math.PI);
      assertThat(seen.r()).isCloseTo(u, within(4 * EPS));
      if (Math.abs(d.y()) < .99) {
        assertThat(seen.g()).isCloseTo(.5 + StrictMath.asin(d.y()) / Math.PI, within(4 * EPS));
      }
    }
  }

  @Test
  void polesAndSeamStayInsideTheImage() {
    EnvironmentLight light = EnvironmentLight.image(Frame.WORLD, COORDINATES, 8, 4);
    for (double x : new double[] {0, -0.0, 1e-300, -1e-300, 1e-20, -1e-20}) {
      Rgb behind = light.from(new Vec3(x, 0, -1));
      assertThat(behind.r()).isBetween(0.0, LAST);
      assertThat(Math.min(behind.r(), 1 - behind.r())).isLessThan(1e-15);
      assertThat(light.from(new Vec3(x, 1, 0)).g()).isBetween(1 - 1e-15, LAST);
      assertThat(light.from(new Vec3(x, -1, 0)).g()).isBetween(0.0, 1e-15);
    }
    // The zenith shows the top texel and not, by repetition, the bottom one.
    EnvironmentLight sky = dome(Frame.WORLD, new double[][] {{1}, {2}});
    assertThat(sky.from(Vec3.Y)).isEqualTo(Rgb.gray(2));
    assertThat(sky.from(Vec3.Y.negated())).isEqualTo(Rgb.gray(1));
  }

  /**
   * In cells of longitude and latitude, four per texel, in which the density times cos is constant.
   */
  @Test
  void sampledDirectionsFollowPdf() {
    int rows = 24;
    int columns = 40;
    EnvironmentLight light = dome(Frame.WORLD, noise(rows / 2, columns / 2));
    int n = 300_000;
    long[] counts = new long[rows * columns];
    double[] expected = new double[counts.length];
    for (int i = 0; i < n; i++) {
      Vec3 wi = sample(light, inSquare(random)).wi();
      double v = .5 + Math.asin(wi.y()) / Math.PI;
      double u = .5 + Math.atan2(wi.x(), wi.z()) / (2 * Math.PI);
      counts[(int) (v * rows) * columns + (int) (u * columns)]++;
    }
    for (int i = 0; i < counts.length; i++) {
      double latitude = Math.PI * ((i / columns + .5) / rows - .5);
      double longitude = 2 * Math.PI * ((i % columns + .5) / columns - .5);
      double across = Math.cos(latitude);
      Vec3 d =
          new Vec3(across * Math.sin(longitude), Math.sin(latitude), across * Math.cos(longitude));
      expected[i] = n * light.pdf(d) * 2 * Math.PI * Math.PI * across / counts.length;
    }
    ChiSquare test = ChiSquare.of(counts, expected);
    assertThat(test.impossible()).isZero();
    assertThat(test.passes()).isTrue();
  }

  @Test
  void uniformDomeIsSampledEvenly() {
    EnvironmentLight light = EnvironmentLight.uniform(Rgb.WHITE);
    ChiSquare test =
        ChiSquare.ofDirections(
            300_000, () -> Optional.of(sample(light, inSquare(random)).wi()), light::pdf, 1);
    assertThat(test.passes()).isTrue();
  }

  @Test
  void densityOfASampleIsThatOfItsDirection() {
    for (Frame axes : new Frame[] {Frame.WORLD, turned()}) {
      EnvironmentLight light = dome(axes, noise(31, 64));
      for (int i = 0; i < 100_000; i++) {
        LightSample sample = sample(light, inSquare(random));
        double pdf = light.pdf(sample.wi());
        assertThat(sample.pdf()).isCloseTo(pdf, within(1e-9 * pdf));
        assertThat(sample.wi().length()).isCloseTo(1, within(8 * EPS));
        assertThat(sample.radiance()).isEqualTo(light.from(sample.wi()));
        assertThat(sample.radiance().isBlack()).isFalse();
      }
    }
  }

  @Test
  void densitiesNearThePolesKeepTheirDigits() {
    double[][] texels = new double[1024][1];
    texels[1023][0] = 1;
    EnvironmentLight light = dome(Frame.WORLD, texels);
    for (double v = 1e-12; v < 1; v *= 2) {
      LightSample sample = sample(light, new Point2(.3, 1 - v));
      assertThat(sample.wi().y()).isGreaterThan(.99999);
      assertThat(light.pdf(sample.wi())).isCloseTo(sample.pdf(), within(1e-9 * sample.pdf()));
    }
  }

  @Test
  void densityIntegratesToOne() {
    EnvironmentLight light = dome(turned(), noise(12, 20));
    Moments moments = new Moments();
    for (int i = 0; i < 300_000; i++) {
      moments.add(4 * Math.PI * light.pdf(direction()));
    }
    // The standard deviation is about 1: the test detects a bias of 1.4 %.
    assertThat(moments.variance()).isLessThan(1.2);
    assertThat(Statistics.deviation(moments.z(1))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void horizontalPlaneUnderAUniformDomeReceivesPi() {
    // Two forms of the same light; the standard deviation of 4π cos⁺ is 4.1: the test detects a
    // bias of 0.05.
    double[][] white = {{1, 1}, {1, 1}, {1, 1}};
    for (EnvironmentLight light :
        new EnvironmentLight[] {EnvironmentLight.uniform(Rgb.WHITE), dome(turned(), white)}) {
      Moments moments =
          Statistics.moments(Statistics.samplesToDetect(.05, 4.1), () -> estimate(light));
      assertThat(Statistics.deviation(moments.z(Math.PI))).isLessThan(Statistics.CRITICAL_Z);
    }
  }

  /** One sample of the irradiance of the plane with normal +y. */
  private double estimate(EnvironmentLight light) {
    LightSample sample = sample(light, inSquare(random));
    return sample.radiance().g() * Math.max(0, sample.wi().y()) / sample.pdf();
  }

  @Test
  void horizontalPlaneUnderACosineDomeReceivesItsIntegral() {
    // Radiance sin^n of the latitude: E = 2π/(n + 2), tabulated in fine rows.
    for (int n : new int[] {1, 2, 10}) {
      Texture<Rgb> sky = (u, v) -> Rgb.gray(Math.pow(Math.max(0, Math.sin(Math.PI * (v - .5))), n));
      EnvironmentLight light = EnvironmentLight.image(Frame.WORLD, sky, 4, 256);
      double exact = 2 * Math.PI / (n + 2);
      // Samples in proportion to the light vary by the cosine alone: for n = 1 by 0.354 E, and
      // slightly more because the table is coarser than the sky.
      int samples = Statistics.samplesToDetect(.005, .37);
      Moments moments = Statistics.moments(samples, () -> estimate(light));
      assertThat(Math.sqrt(moments.variance()) / exact).isLessThan(.37);
      assertThat(Statistics.deviation(moments.z(exact))).isLessThan(Statistics.CRITICAL_Z);
    }
  }

  @Test
  void singleBrightTexelIsFound() {
    double[][] texels = new double[64][128];
    texels[40][100] = 1e6;
    for (Frame axes : new Frame[] {Frame.WORLD, turned()}) {
      EnvironmentLight light = dome(axes, texels);
      Moments irradiance = new Moments();
      Vec3 normal = axes.toWorld(new Vec3(.6, .8, 0));
      for (int i = 0; i < 10_000; i++) {
        LightSample sample = sample(light, inSquare(random));
        assertThat(sample.radiance()).isEqualTo(Rgb.gray(1e6));
        irradiance.add(1e6 * Math.max(0, sample.wi().dot(normal)) / sample.pdf());
      }
      assertThat(Statistics.deviation(irradiance.z(1e6 * texelCosine())))
          .isLessThan(Statistics.CRITICAL_Z);
    }
  }

  /** Integrates the cosine with (.6, .8, 0) over texel (100, 40) of 128 by 64, by midpoints. */
  private static double texelCosine() {
    double sum = 0;
    int n = 200;
    for (int i = 0; i < n; i++) {
      double latitude = Math.PI * ((40 + (i + .5) / n) / 64 - .5);
      for (int j = 0; j < n; j++) {
        double longitude = 2 * Math.PI * ((100 + (j + .5) / n) / 128 - .5);
        double x = Math.cos(latitude) * Math.sin(longitude);
        double cosine = .6 * x + .8 * Math.sin(latitude);
        sum += cosine * Math.cos(latitude) * (Math.PI / 64 / n) * (Math.PI / 64 / n);
      }
    }
    return sum;
  }

  /** 4 by 2 texels, each bright only in the outermost hundredth of a side. */
  @Test
  void lightAtTheSidesOfTexelsIsFound() {
    for (double from : new double[] {0, .99}) {
      Texture<Rgb> columns = (u, v) -> Rgb.gray(isIn(u * 4, from) ? 1 : 0);
      Texture<Rgb> rows = (u, v) -> Rgb.gray(isIn(v * 2, from) ? 1 : 0);
      for (Texture<Rgb> lines : List.of(columns, rows)) {
        EnvironmentLight light = EnvironmentLight.image(Frame.WORLD, lines, 4, 2);
        assertThat(light.isBlack()).isFalse();
        assertThat(light.pdf(new Vec3(.6, .64, .48))).isPositive();
      }
    }
  }

  private static boolean isIn(double texel, double from) {
    double place = texel - Math.floor(texel);
    return place >= from && place < from + .01;
  }

  @Test
  void directionsNearTheCenterOfTheImageKeepTheirDigits() {
    EnvironmentLight light = dome(Frame.WORLD, new double[][] {{1}});
    for (double steps : new double[] {1, 3}) {
      double turns = steps * EPS / 2;
      Vec3 wi = sample(light, new Point2(.5 + turns, .5)).wi();
      assertThat(wi.x()).isCloseTo(2 * Math.PI * turns, within(1e-12 * turns));
    }
  }

  @Test
  void nothingIsSampledAtThePoleItselfInAUsedSample() {
    EnvironmentLight light = dome(Frame.WORLD, new double[][] {{1}});
    LightSample drawn = new LightSample();
    light.sample(0, 0, 0, .3, .4, drawn);
    assertThat(drawn.isEmpty()).isFalse();
    light.sample(0, 0, 0, .3, 0, drawn);
    assertThat(drawn.isEmpty()).isTrue();
  }

  @Test
  void turnedDomeShowsItsImageTurned() {
    double[][] texels = noise(8, 16);
    Frame axes = turned();
    EnvironmentLight straight = dome(Frame.WORLD, texels);
    EnvironmentLight light = dome(axes, texels);
    for (int i = 0; i < 1000; i++) {
      Vec3 d = direction();
      assertThat(light.from(axes.toWorld(d))).isEqualTo(straight.from(d));
      double pdf = straight.pdf(d);
      assertThat(light.pdf(axes.toWorld(d))).isCloseTo(pdf, within(1e-12 * pdf));
      Point2 u = inSquare(random);
      Vec3 expected = axes.toWorld(sample(straight, u).wi());
      assertThat(sample(light, u).wi().minus(expected).length()).isLessThan(8 * EPS);
    }
  }

  @Test
  void extremeNumbersGiveFiniteSamplesOrNone() {
    double[][] texels = noise(7, 49);
    double[][] oneTexel = new double[7][49];
    oneTexel[6][7] = 1e-300;
    double[] numbers = {0, 0x1p-53, .5, 1 - 0x1p-32, LAST};
    for (double[][] image : new double[][][] {texels, oneTexel, {{1}}}) {
      EnvironmentLight light = dome(Frame.WORLD, image);
      for (double x : numbers) {
        for (double y : numbers) {
          Optional<LightSample> sample = light.sample(Vec3.ZERO, new Point2(x, y));
          if (sample.isPresent()) {
            assertThat(sample.get().pdf()).isPositive().isFinite();
            assertThat(sample.get().wi().length()).isCloseTo(1, within(4 * EPS));
          }
        }
      }
    }
    assertThat(sample(EnvironmentLight.uniform(Rgb.WHITE), new Point2(LAST, 0)).pdf())
        .isCloseTo(1 / (4 * Math.PI), within(EPS));
  }

  @Test
  void domesWithoutLightAreBlack() {
    assertThat(EnvironmentLight.uniform(Rgb.BLACK).isBlack()).isTrue();
    assertThat(EnvironmentLight.uniform(Rgb.WHITE).isBlack()).isFalse();
    assertThat(dome(Frame.WORLD, new double[2][2]).isBlack()).isTrue();
    assertThat(dome(Frame.WORLD, new double[][] {{0, 1e-300}}).isBlack()).isFalse();
    assertThat(EnvironmentLight.uniform(Rgb.WHITE).isDelta()).isFalse();
  }

  @Test
  void lightOfTheDomeComesFromInfinity() {
    LightSample sample = sample(dome(turned(), noise(3, 3)), inSquare(random));
    assertThat(sample.target()).isEqualTo(LightSample.Target.INFINITY);
    assertThat(sample.isDelta()).isFalse();
  }

  /** Karlík et al. 2019: the density is proportional to the brightness above the mean. */
  @Test
  void besideBsdfSamplesOnlyWhatIsBrighterThanTheMean() {
    // Rows of equal solid angle: two of them, each a hemisphere.
    double[][] texels = {{1, 1, 1, 1}, {2, 4, 8, 4}};
    EnvironmentLight light = dome(turned(), texels);
    EnvironmentLight beside = light.besideBsdf();
    double mean = 22 / 8.;
    double above = (4 - mean) + (8 - mean) + (4 - mean);
    for (int i = 0; i < 10_000; i++) {
      Vec3 direction = direction();
      double excess = Math.max(0, light.from(direction).r() - mean);
      assertThat(beside.from(direction)).isEqualTo(light.from(direction));
      double height = turned().toLocal(direction).y();
      double texel = 2 * Math.PI * Math.PI * Math.sqrt(1 - height * height) / 8;
      assertThat(beside.pdf(direction)).isCloseTo(excess / above / texel, within(1e-9));
      LightSample sample = sample(beside, inSquare(random));
      assertThat(sample.r()).isGreaterThan(mean);
      assertThat(sample.pdf()).isCloseTo(beside.pdf(sample.wi()), within(1e-9 * sample.pdf()));
    }
    assertThat(light.besideBsdf()).isSameAs(beside);
    EnvironmentLight even = EnvironmentLight.uniform(Rgb.WHITE);
    assertThat(even.besideBsdf()).isSameAs(even);
  }
}
