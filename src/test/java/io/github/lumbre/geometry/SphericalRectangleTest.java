package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import io.github.lumbre.texture.TexturePoint;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares rectangles sampled by solid angle with closed forms of solid angles. */
class SphericalRectangleTest {
  private static final int CELLS = 16;

  /** Returns the signed solid angle of the rectangle between the foot of the point and (x, y). */
  private static double ofCorner(double x, double y, double z) {
    return Math.atan2(x * y, z * Math.sqrt(x * x + y * y + z * z));
  }

  /** Returns the solid angle as a sum of four rectangles with a corner below the point. */
  private static double expected(double x0, double x1, double y0, double y1, double z) {
    return ofCorner(x1, y1, z) - ofCorner(x0, y1, z) - ofCorner(x1, y0, z) + ofCorner(x0, y0, z);
  }

  @Test
  void solidAngleIsTheSumOfItsCorners() {
    Random random = new Random(11);
    for (int i = 0; i < Effort.brief(100_000); i++) {
      double x0 = random.nextGaussian();
      double y0 = random.nextGaussian();
      double x1 = x0 + 2 * random.nextDouble();
      double y1 = y0 + 2 * random.nextDouble();
      double z = Math.exp(-9 * random.nextDouble());
      double solidAngle = expected(x0, x1, y0, y1, z);

      SphericalRectangle seen = new SphericalRectangle(x0, x1, y0, y1, z);

      assertThat(seen.solidAngle()).isCloseTo(solidAngle, within(4e-15));
      assertThat(seen.isUsable()).isEqualTo(seen.solidAngle() >= 1e-6);
    }
  }

  /** Seen from just above, a rectangle fills half of all directions. */
  @Test
  void solidAngleOfANearRectangleIsHalfTheSphere() {
    for (double z : new double[] {1e-9, 1e-100, 1e-300}) {
      assertThat(new SphericalRectangle(-1, 2, -3, 1, z).solidAngle())
          .isCloseTo(2 * Math.PI, within(1e-8));
      assertThat(new SphericalRectangle(1, 2, -3, 1, z).isUsable()).isFalse();
    }
  }

  /**
   * Equal cells of the unit square map to equal solid angles, computed from each cell's corners.
   */
  @ParameterizedTest
  @CsvSource({
    "-1, 1, -1, 1, 1",
    "-1, 1, -1, 1, .01",
    "-1, 1, -1, 1, 20",
    "2, 3, -1, 1, 1",
    "2, 3, 4, 6, .5",
    "-3, -2.5, -.1, 5, .2",
    "0, 1, 0, 1, .3",
    "-.001, .001, -2, 2, .5",
    "1, 100, 1, 100, 1",
  })
  void sharesOfTheSquareAreSharesOfTheSolidAngle(
      double x0, double x1, double y0, double y1, double z) {
    SphericalRectangle seen = new SphericalRectangle(x0, x1, y0, y1, z);
    double cell = seen.solidAngle() / CELLS / CELLS;
    for (int i = 0; i < CELLS; i++) {
      double left = seen.at(new Point2((double) i / CELLS, .5)).x();
      double right = seen.at(new Point2((i + 1.0) / CELLS, .5)).x();
      assertThat(expected(left, right, y0, y1, z))
          .isCloseTo(cell * CELLS, within(1e-9 * cell * CELLS));
    }
    assertThat(seen.at(new Point2(0, 0)).x()).isCloseTo(x0, within(1e-9 * (x1 - x0)));
    assertThat(seen.at(new Point2(1, 0)).x()).isCloseTo(x1, within(1e-9 * (x1 - x0)));
    assertThat(seen.at(new Point2(.3, 0)).y()).isCloseTo(y0, within(1e-9 * (y1 - y0)));
    assertThat(seen.at(new Point2(.3, 1)).y()).isCloseTo(y1, within(1e-9 * (y1 - y0)));
  }

  @ParameterizedTest
  @CsvSource({"0, 1, 0", ".4, .1, -.3", "1, .5, 1", "1, .02, 2"})
  void directionsAreUniform(double x, double y, double z) {
    Transform placed =
        Transform.translation(new Vec3(.3, -.2, .1))
            .times(Transform.rotationDegrees(new Vec3(20, 30, 40)))
            .times(Transform.scale(new Vec3(2, -1, .5)));
    Rectangle rectangle = new Rectangle(placed, 1, 3, true);
    Vec3 reference = placed.point(new Vec3(x, y, z));
    Random random = new Random(12);
    long[] counts = new long[CELLS * CELLS];
    double[] shares = new double[counts.length];
    int samples = 100_000;
    for (int i = 0; i < samples; i++) {
      SurfaceSample sample = rectangle.sample(reference, Shapes.square(random));
      Vec3 local = placed.inversePoint(sample.position());
      int column = (int) Math.min((local.x() + .5) * CELLS, CELLS - 1);
      int row = (int) Math.min((local.z() / 3 + .5) * CELLS, CELLS - 1);
      counts[row * CELLS + column]++;
    }
    for (int cell = 0; cell < counts.length; cell++) {
      double left = (cell % CELLS) / (double) CELLS - .5;
      double low = 3 * ((double) Math.floorDiv(cell, CELLS) / CELLS - .5);
      // Local lengths are scaled by 2, 1 and ½.
      shares[cell] =
          expected(
              2 * (left - x),
              2 * (left + 1.0 / CELLS - x),
              .5 * (low - z),
              .5 * (low + 3.0 / CELLS - z),
              y);
    }
    double pdf = rectangle.sample(reference, new Point2(.5, .5)).pdf();
    for (int cell = 0; cell < counts.length; cell++) {
      shares[cell] *= pdf * samples;
    }
    assertThat(ChiSquare.of(counts, shares).passes()).isTrue();
  }

  /** The mean does not change at the distance at which the sampling method changes. */
  @Test
  void bothMapsHaveTheSameMean() {
    Rectangle rectangle = new Rectangle(Transform.IDENTITY, 3, 1, false);
    double farthest = 2 * Math.sqrt(2.5);
    Vec3 direction = new Vec3(.5, .6, -Math.sqrt(.39));
    double[] distances = {farthest * (1 - 1e-9), farthest * (1 + 1e-9)};
    Moments[] irradiances = new Moments[2];
    for (int side = 0; side < 2; side++) {
      Vec3 reference = direction.times(distances[side]);
      Random random = new Random(13 + side);
      irradiances[side] =
          Statistics.moments(
              20_000,
              () -> {
                SurfaceSample sample = rectangle.sample(reference, Shapes.square(random));
                Vec3 way = sample.position().minus(reference).normalized();
                return -way.dot(direction) / sample.pdf();
              });
    }
    // Where both means are equal, the standard deviation of the nearer case comes from the cosine
    // alone.
    assertThat(irradiances[0].variance()).isLessThan(.05 * irradiances[1].variance());
    assertThat(Statistics.deviation(irradiances[0].z(irradiances[1])))
        .isLessThan(Statistics.CRITICAL_Z);
  }

  /** A parallelogram is not a rectangle, so its points are sampled by area. */
  @Test
  void parallelogramsAreDrawnByArea() {
    Transform slanted =
        Transform.rotationDegrees(new Vec3(0, 45, 0)).times(Transform.scale(new Vec3(1, 1, 2)));
    slanted = slanted.times(Transform.rotationDegrees(new Vec3(0, 30, 0)));
    Rectangle rectangle = new Rectangle(slanted, 1, 1, false);
    Vec3 reference = new Vec3(.2, 1, .3);
    Point2 u = new Point2(.1, .9);

    SurfaceSample sample = rectangle.sample(reference, u);

    assertThat(sample.position()).isEqualTo(slanted.point(new Vec3(.1 - .5, 0, .9 - .5)));
    Vec3 way = reference.minus(sample.position());
    double pdf = way.lengthSquared() * way.length() / way.y() / 2;
    assertThat(sample.pdf()).isCloseTo(pdf, within(1e-12 * pdf));
    SurfaceHit hit =
        new SurfaceHit()
            .set(
                sample.position(),
                Vec3.Y,
                Frame.WORLD,
                new TexturePoint(0, 0),
                way.normalized(),
                sample.error());
    assertThat(rectangle.pdf(reference, hit)).isCloseTo(pdf, within(1e-12 * pdf));
  }
}
