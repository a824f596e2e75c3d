package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.texture.TexturePoint;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the samples of shapes and their densities. */
class ShapeSamplingTest {
  /** The critical number of standard errors, exceeded by chance once in two million cases. */
  private static final double Z = 5;

  private static final Transform SKEWED =
      Transform.translation(new Vec3(.3, -.2, .1))
          .times(Transform.scale(new Vec3(1, 2, .5)))
          .times(Transform.rotationDegrees(new Vec3(20, 30, 40)))
          .times(Transform.scale(new Vec3(1.5, .4, -1)));

  static List<Shape> shapes() {
    TriangleMesh ball = Shapes.closedBall(6, 8, .3, true);
    return List.of(
        new Sphere(Transform.IDENTITY, 1),
        new Sphere(SKEWED, .8),
        new Rectangle(Transform.IDENTITY, 2, 1, true),
        new Rectangle(SKEWED, 1, 2, false),
        new Box(Transform.IDENTITY, 1, .5, 1.5),
        new Box(SKEWED, 1, 1, 1),
        Mesh.baked(ball, SKEWED),
        new MeshInstance(new SharedMesh(ball), SKEWED),
        SphereCloudTest.cloud(new Random(3), 6, 2, .5),
        SphereCloudTest.cloud(new Random(4), 6, 2, .5).transformed(SKEWED));
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void densityIsWhatSamplesHave(Shape shape) {
    Random random = new Random(1);
    int compared = 0;
    for (int i = 0; i < 3000; i++) {
      Vec3 reference = Shapes.point(random, 3);
      SurfaceSample sample = shape.sample(reference, Shapes.square(random));
      if (sample.pdf() > 0 && isVisible(shape, reference, sample)) {
        Vec3 way = sample.position().minus(reference);
        Optional<SurfaceHit> hit = Shapes.hit(shape, new Ray(reference, way.normalized()));
        // Rounding moves grazing hits far along the surface.
        double cos = Math.abs(way.normalized().dot(sample.normal()));
        if (cos > 1e-3) {
          compared++;
          assertThat(hit).isPresent();
          assertThat(hit.get().position().minus(sample.position()).length()).isLessThan(1e-9);
          assertThat(hit.get().texture().u()).isCloseTo(sample.texture().u(), within(1e-6));
          assertThat(shape.pdf(reference, hit.get()) / sample.pdf()).isCloseTo(1, within(1e-6));
        }
      }
    }
    assertThat(compared).isGreaterThan(800);
  }

  /** Compares two estimates of a solid angle, and of the fraction of visible samples. */
  @ParameterizedTest
  @MethodSource("shapes")
  void samplesWeighLikeUniformDirections(Shape shape) {
    Random random = new Random(2);
    for (Vec3 reference :
        List.of(new Vec3(.2, 1.5, -.4), new Vec3(.31, -.19, .12), new Vec3(-2, 1, 1.5))) {
      Mean solidAngle = new Mean();
      Mean drawn = new Mean();
      Mean expectedSolidAngle = new Mean();
      Mean expectedDrawn = new Mean();
      for (int i = 0; i < Effort.brief(40_000); i++) {
        SurfaceSample sample = shape.sample(reference, Shapes.square(random));
        boolean isVisible = sample.pdf() > 0 && isVisible(shape, reference, sample);
        // The weights of points seen edge-on are unbounded; clamping them allows a test of the
        // rest.
        solidAngle.add(isVisible ? Math.min(1, .01 * sample.pdf()) / sample.pdf() : 0);
        drawn.add(isVisible ? Math.min(1, 1 / sample.pdf()) : 0);
        Ray ray = new Ray(reference, Shapes.direction(random));
        double pdf = Shapes.hit(shape, ray).map(hit -> shape.pdf(reference, hit)).orElse(0.0);
        expectedSolidAngle.add(4 * Math.PI * Math.min(1, .01 * pdf));
        expectedDrawn.add(4 * Math.PI * Math.min(pdf, 1));
      }
      solidAngle.assertAgrees(expectedSolidAngle);
      drawn.assertAgrees(expectedDrawn);
    }
  }

  private static boolean isVisible(Shape shape, Vec3 reference, SurfaceSample sample) {
    SurfaceHit from =
        new SurfaceHit().set(reference, Vec3.Z, Frame.WORLD, new TexturePoint(0, 0), Vec3.Z, 0);
    return !Shapes.hidesItself(shape, from, sample);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 0.752274688454107",
    "2, 2, 1, 1.74083950273421",
    "1, 1, 2, 0.230836797730171",
    "1, 1, 10, 0.00996678290640217",
    "1, 1, 100, 9.9996666783329e-5",
    "1e-6, 1e-6, 1, 9.99999999999667e-13",
    "1, .1, 1, 0.0862304220629105",
    "1.3, 1.05, 5.488, 0.0446324746681278",
  })
  void rectangleAboveGivesItsIrradiance(double a, double b, double h, double expected) {
    Transform facingDown =
        Transform.translation(new Vec3(0, h, 0))
            .times(Transform.rotationDegrees(new Vec3(180, 0, 0)));
    irradiance(new Rectangle(facingDown, a, b, false), Vec3.ZERO, Vec3.Y).assertIs(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 2, 0, .785398163397448",
    "1, 2, 30, .680174761587832",
    "1, 2, 60, .392699081698724",
    ".5, 3, 30, .0755749735097591",
    "1, 2, 90, .0905860737060795",
    "1, 1.000001, 0, 3.14158637041391",
    "1e-3, 1, 0, 3.14159265358979e-6",
    "1e-6, 1, 0, 3.14159265358979e-12",
  })
  void sphereGivesItsIrradiance(double radius, double distance, double tilt, double expected) {
    Vec3 normal = Transform.rotationDegrees(new Vec3(tilt, 0, 0)).vector(Vec3.Y);
    Sphere sphere = new Sphere(Transform.translation(new Vec3(0, distance, 0)), radius);
    irradiance(sphere, Vec3.ZERO, normal).assertIs(expected);
  }

  @Test
  void boxFaceGivesTheIrradianceOfItsRectangle() {
    Box box = new Box(Transform.translation(new Vec3(0, 1.5, 0)), 1, 1, 1);
    irradiance(box, Vec3.ZERO, Vec3.Y).assertIs(.752274688454107);
  }

  @Test
  void enclosingShapesGivePi() {
    Vec3 inside = new Vec3(.2, .1, -.3);
    irradiance(new Sphere(Transform.IDENTITY, 1), inside, Vec3.Y).assertIs(Math.PI);
    irradiance(new Sphere(SKEWED, 3), inside, Vec3.Y).assertIs(Math.PI);
    irradiance(new Box(SKEWED, 9, 9, 9), inside, Vec3.Y).assertIs(Math.PI);
    Shape ball = Mesh.baked(Shapes.closedBall(8, 8, 0, false), Transform.IDENTITY);
    irradiance(ball, inside, Vec3.Y).assertIs(Math.PI);
  }

  private static Mean irradiance(Shape shape, Vec3 reference, Vec3 normal) {
    Random random = new Random(3);
    Mean mean = new Mean();
    for (int i = 0; i < Effort.brief(20_000); i++) {
      SurfaceSample sample = shape.sample(reference, Shapes.square(random));
      double cos = sample.position().minus(reference).normalized().dot(normal);
      mean.add(sample.pdf() > 0 ? Math.max(0, cos) / sample.pdf() : 0);
    }
    return mean;
  }

  @Test
  void oneWayRectanglesDoNotShineBackwards() {
    Vec3 below = new Vec3(0, -1, 0);
    Point2 middle = new Point2(.5, .5);
    assertThat(new Rectangle(Transform.IDENTITY, 1, 1, false).sample(below, middle).pdf()).isZero();
    double solidAngle = 4 * Math.atan(1 / Math.sqrt(24));
    assertThat(new Rectangle(Transform.IDENTITY, 1, 1, true).sample(below, middle).pdf())
        .isCloseTo(1 / solidAngle, within(1e-14));
  }

  @Test
  void surfacesSeenEdgeOnHaveNoSamples() {
    Shape rectangle = new Rectangle(Transform.IDENTITY, 1, 1, true);
    Shape triangle = Mesh.baked(Shapes.triangle(Vec3.X, Vec3.Y, Vec3.ZERO), Transform.IDENTITY);
    Point2 u = new Point2(.3, .6);
    assertThat(rectangle.sample(new Vec3(2, 0, .1), u).pdf()).isZero();
    assertThat(triangle.sample(new Vec3(2, 3, 0), u).pdf()).isZero();
    assertThat(rectangle.sample(Vec3.ZERO, new Point2(.5, .5)).pdf()).isZero();
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void extremeRandomNumbersAndReferencesGiveFiniteSamples(Shape shape) {
    double[] ends = {0, 0x1p-53, .5, 1 - 0x1p-53};
    double[] distances = {0, 1e-300, 1e-6, 1, 1 + 1e-15, 1e6, 1e100};
    for (double x : ends) {
      for (double y : ends) {
        for (double distance : distances) {
          SurfaceSample sample = shape.sample(new Vec3(0, distance, 0), new Point2(x, y));
          assertThat(sample.pdf()).isBetween(0.0, Double.MAX_VALUE);
          assertThat(sample.position().isFinite()).isTrue();
          assertThat(sample.normal().length()).isCloseTo(1, within(1e-12));
        }
      }
    }
  }

  @Test
  void areasAreThoseOfGeometry() {
    assertThat(new Sphere(Transform.IDENTITY, 2).area()).isCloseTo(16 * Math.PI, within(1e-13));
    Transform prolate =
        Transform.rotationDegrees(new Vec3(10, 20, 30)).times(Transform.scale(new Vec3(1, 1, 2)));
    double e = Math.sqrt(.75);
    double expected = 2 * Math.PI * (1 + 2 / e * StrictMath.asin(e));
    assertThat(new Sphere(prolate, 1).area()).isCloseTo(expected, within(1e-12));
    Transform flat = Transform.scale(new Vec3(1, 1e-9, 1));
    assertThat(new Sphere(flat, 1).area()).isCloseTo(2 * Math.PI, within(1e-12));
    Transform doubled = Transform.scale(new Vec3(2, 2, 2));
    assertThat(new Rectangle(doubled, 3, 4, false).area()).isEqualTo(48);
    assertThat(new Box(doubled, 1, 2, 3).area()).isEqualTo(88);
    assertThat(Mesh.baked(Shapes.triangle(Vec3.X, Vec3.Y, Vec3.ZERO), doubled).area()).isEqualTo(2);
    assertThat(new Plane(doubled, true).area()).isInfinite();
  }

  /** The mean and variance of a series. */
  private static final class Mean {
    private int n;
    private double mean;
    private double squares;

    void add(double x) {
      n++;
      double delta = x - mean;
      mean += delta / n;
      squares += delta * (x - mean);
    }

    private double variance() {
      return squares / n / (n - 1);
    }

    void assertIs(double expected) {
      double tolerance = Z * Math.sqrt(variance()) + 1e-9 * expected;
      assertThat(mean).isCloseTo(expected, within(tolerance));
    }

    void assertAgrees(Mean other) {
      double tolerance = Z * Math.sqrt(variance() + other.variance()) + 1e-9 * mean;
      assertThat(mean).isCloseTo(other.mean, within(tolerance));
    }
  }
}
