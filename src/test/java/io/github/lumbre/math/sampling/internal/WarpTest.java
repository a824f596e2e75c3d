package io.github.lumbre.math.sampling.internal;

import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the maps from the unit square to disks, spheres, cones and triangles. */
class WarpTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;
  private static final int SAMPLES = Effort.count(300_000, 3_000_000);

  private final SplittableRandom random = new SplittableRandom(Effort.seed(8));

  /**
   * Returns the corners of the square, the midpoints of its sides, its center, and neighbors of
   * these.
   */
  private static List<Point2> extremes() {
    double[] values = {0, 0x1p-60, 0x1p-53, .5 - 0x1p-54, .5, .5 + 0x1p-53, 1 - 0x1p-32, LAST};
    List<Point2> points = new ArrayList<>();
    for (double x : values) {
      for (double y : values) {
        points.add(new Point2(x, y));
      }
    }
    return points;
  }

  private static double length(Point2 p) {
    return Math.sqrt(p.x() * p.x() + p.y() * p.y());
  }

  @Test
  void diskIsCoveredEvenly() {
    long[] cells = new long[256];
    for (int i = 0; i < SAMPLES; i++) {
      Point2 p = Warp.concentricDisk(inSquare(random));
      // Rings of equal area, and sectors.
      double ring = p.x() * p.x() + p.y() * p.y();
      double sector = Math.atan2(p.y(), p.x()) / (2 * Math.PI) + .5;
      cells[16 * (int) (16 * Math.min(ring, LAST)) + (int) (16 * Math.min(sector, LAST))]++;
    }
    assertThat(ChiSquare.uniform(cells).passes()).isTrue();
  }

  @Test
  void diskHasTheMomentsOfADisk() {
    // Standard deviations: 0.289 of r², 0.264 of |x|.
    int n = Statistics.samplesToDetect(.003, .289);
    Moments square = new Moments();
    Moments side = new Moments();
    Moments height = new Moments();
    for (int i = 0; i < n; i++) {
      Point2 p = Warp.concentricDisk(inSquare(random));
      square.add(p.x() * p.x() + p.y() * p.y());
      side.add(Math.abs(p.x()));
      height.add(Math.abs(p.y()));
    }
    assertThat(Statistics.deviation(square.z(.5))).isLessThan(Statistics.CRITICAL_Z);
    assertThat(Statistics.deviation(side.z(4 / (3 * Math.PI)))).isLessThan(Statistics.CRITICAL_Z);
    assertThat(Statistics.deviation(height.z(4 / (3 * Math.PI)))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void diskMapHasAConstantJacobian() {
    double h = 1e-6;
    for (int i = 0; i < 10_000; i++) {
      Point2 u = new Point2(random.nextDouble(.01, .99), random.nextDouble(.01, .99));
      if (Math.abs(Math.abs(u.x() - .5) - Math.abs(u.y() - .5)) < 1e-4) {
        continue; // The map has a kink on the diagonals.
      }
      Point2 p = Warp.concentricDisk(u);
      Point2 px = Warp.concentricDisk(new Point2(u.x() + h, u.y()));
      Point2 py = Warp.concentricDisk(new Point2(u.x(), u.y() + h));
      double cross = (px.x() - p.x()) * (py.y() - p.y()) - (px.y() - p.y()) * (py.x() - p.x());
      assertThat(cross / (h * h)).isCloseTo(Math.PI, within(1e-3));
    }
  }

  @Test
  void diskMapIsContinuous() {
    double h = 1e-9;
    for (int i = 0; i < 10_000; i++) {
      Point2 u = inSquare(random);
      // Half of the points near a diagonal, where the formula changes.
      double x = i % 4 == 0 ? u.y() : i % 4 == 1 ? 1 - u.y() : u.x();
      Point2 p = Warp.concentricDisk(new Point2(x, u.y()));
      Point2 q = Warp.concentricDisk(new Point2(x + h, u.y() - h));
      assertThat(length(new Point2(p.x() - q.x(), p.y() - q.y()))).isLessThan(8 * h);
    }
  }

  @Test
  void centerGoesToTheCenterAndAllElseIsInside() {
    assertThat(Warp.concentricDisk(new Point2(.5, .5))).isEqualTo(new Point2(0, 0));
    for (Point2 u : extremes()) {
      assertThat(length(Warp.concentricDisk(u))).isLessThanOrEqualTo(1 + 2 * EPS);
    }
    assertThat(length(Warp.concentricDisk(new Point2(0, 0)))).isCloseTo(1, within(2 * EPS));
  }

  @Test
  void diskMapKeepsRightAndUp() {
    assertThat(Warp.concentricDisk(new Point2(.75, .5))).isEqualTo(new Point2(.5, 0));
    assertThat(Warp.concentricDisk(new Point2(.5, .75))).isEqualTo(new Point2(0, .5));
    assertThat(Warp.concentricDisk(new Point2(0, .5))).isEqualTo(new Point2(-1, -0.0));
  }

  @Test
  void hemisphereFollowsTheCosine() {
    ChiSquare test =
        ChiSquare.ofDirections(
            SAMPLES,
            () -> Optional.of(Warp.cosineHemisphere(inSquare(random))),
            w -> Warp.cosineHemispherePdf(w.z()),
            8);
    assertThat(test.passes()).isTrue();
    assertThat(Warp.cosineHemispherePdf(-.5)).isZero();
  }

  @Test
  void sphereIsCoveredEvenly() {
    ChiSquare test =
        ChiSquare.ofDirections(
            SAMPLES,
            () -> Optional.of(Warp.uniformSphere(inSquare(random))),
            w -> Warp.INV_FOUR_PI,
            1);
    assertThat(test.passes()).isTrue();
  }

  @Test
  void wideConeFollowsItsDensity() {
    // The edge at z = -15/41 is a border of cells.
    double edge = 1 + 15 / 41.0;
    ChiSquare test =
        ChiSquare.ofDirections(
            SAMPLES,
            () -> Optional.of(Warp.uniformCone(inSquare(random), edge)),
            w -> 1 - w.z() <= edge + EPS ? Warp.uniformConePdf(edge) : 0,
            1);
    assertThat(test.passes()).isTrue();
  }

  @Test
  void narrowConeIsCoveredEvenlyAndNotLeft() {
    double edge = 1e-12;
    long[] cells = new long[256];
    for (int i = 0; i < SAMPLES; i++) {
      Vec3 w = Warp.uniformCone(inSquare(random), edge);
      // From the sine, because the cosine has lost precision: 1 - cos = sin²/(1 + cos).
      double ring = (w.x() * w.x() + w.y() * w.y()) / (1 + w.z()) / edge;
      assertThat(ring).isLessThanOrEqualTo(1 + 8 * EPS);
      double sector = Math.atan2(w.y(), w.x()) / (2 * Math.PI) + .5;
      cells[16 * (int) (16 * Math.min(ring, LAST)) + (int) (16 * Math.min(sector, LAST))]++;
    }
    assertThat(ChiSquare.uniform(cells).passes()).isTrue();
    assertThat(Warp.uniformConePdf(edge)).isCloseTo(1e12 / (2 * Math.PI), within(1.0));
  }

  @Test
  void fullConeIsTheSphere() {
    ChiSquare test =
        ChiSquare.ofDirections(
            SAMPLES,
            () -> Optional.of(Warp.uniformCone(inSquare(random), 2)),
            w -> Warp.uniformConePdf(2),
            1);
    assertThat(test.passes()).isTrue();
  }

  @Test
  void triangleIsCoveredEvenly() {
    long[] cells = new long[256];
    for (int i = 0; i < SAMPLES; i++) {
      Point2 b = Warp.uniformTriangle(inSquare(random));
      // Strips of equal area parallel to one side, each divided evenly.
      double strip = (1 - b.x()) * (1 - b.x());
      double along = b.y() / (1 - b.x());
      cells[16 * (int) (16 * Math.min(strip, LAST)) + (int) (16 * Math.min(along, LAST))]++;
    }
    assertThat(ChiSquare.uniform(cells).passes()).isTrue();
  }

  /** The maps are injective: a sampled point determines its random numbers. */
  @Test
  void mapsCanBeUndone() {
    for (int i = 0; i < Effort.count(20_000, 1_000_000); i++) {
      Point2 u = inSquare(random);
      assertSame(inverseDisk(Warp.concentricDisk(u)), u);
      Vec3 cosine = Warp.cosineHemisphere(u);
      assertSame(inverseDisk(new Point2(cosine.x(), cosine.y())), u);
      Vec3 sphere = Warp.uniformSphere(u);
      assertSame(new Point2((1 - sphere.z()) / 2, turns(sphere)), u);
      for (double edge : new double[] {1e-300, 1e-12, .5, 2}) {
        Vec3 cone = Warp.uniformCone(u, edge);
        double sine = cone.x() * cone.x() + cone.y() * cone.y();
        // 1 - cos, from the sine where the cosine has lost precision.
        double h = cone.z() > 0 ? sine / (1 + cone.z()) : 1 - cone.z();
        assertSame(new Point2(h / edge, turns(cone)), u);
      }
      Point2 b = Warp.uniformTriangle(u);
      double root = 1 - b.x();
      assertSame(new Point2(root * root, b.y() / root), u);
    }
  }

  private static void assertSame(Point2 found, Point2 expected) {
    double off = Math.max(Math.abs(found.x() - expected.x()), Math.abs(found.y() - expected.y()));
    if (!(off <= 1e-9)) {
      assertThat(found).isEqualTo(expected);
    }
  }

  private static double turns(Vec3 w) {
    double turns = Math.atan2(w.y(), w.x()) / (2 * Math.PI);
    return turns < 0 ? turns + 1 : turns;
  }

  private static Point2 inverseDisk(Point2 p) {
    double r = length(p);
    double eighths = Math.atan2(p.y(), p.x()) / (Math.PI / 4);
    double a;
    double b;
    if (Math.abs(p.x()) > Math.abs(p.y())) {
      a = Math.copySign(r, p.x());
      b = r * (p.x() > 0 ? eighths : Math.copySign(4, eighths) - eighths);
    } else {
      b = Math.copySign(r, p.y());
      a = r * (2 - Math.abs(eighths));
    }
    return new Point2((a + 1) / 2, (b + 1) / 2);
  }

  @Test
  void extremeNumbersGiveUnitVectorsAndInnerPoints() {
    for (Point2 u : extremes()) {
      assertThat(Warp.cosineHemisphere(u).length()).isCloseTo(1, within(4 * EPS));
      assertThat(Warp.cosineHemisphere(u).z()).isNotNegative();
      assertThat(Warp.uniformSphere(u).length()).isCloseTo(1, within(4 * EPS));
      for (double edge : new double[] {0, 1e-300, 1e-12, .5, 1, 2}) {
        assertThat(Warp.uniformCone(u, edge).length()).isCloseTo(1, within(4 * EPS));
      }
      Point2 b = Warp.uniformTriangle(u);
      assertThat(Math.min(b.x(), b.y())).isNotNegative();
      assertThat(b.x() + b.y()).isLessThanOrEqualTo(1);
    }
  }
}
