package io.github.lumbre.camera;

import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.ScriptedSampler;
import io.github.lumbre.testing.Statistics;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests focus, blur and lens sampling of the thin lens camera. */
class ThinLensCameraTest {
  private static final double EPS = 0x1p-52;
  private static final double FOV = 60;
  private static final double INFINITY = Double.POSITIVE_INFINITY;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(23));

  private static ThinLensCamera camera(double focusDistance, double aperture) {
    return new ThinLensCamera(
        Vec3.ZERO, Frame.WORLD, 1.5, FOV, focusDistance, aperture, Aperture.DISK);
  }

  private static Ray ray(Camera camera, Point2 film, Point2 lens) {
    ScriptedSampler sampler = new ScriptedSampler().with(Sampler.LENS, lens.x(), lens.y());
    Ray ray = camera.rayFor(film, sampler).orElseThrow();
    assertThat(sampler.asked()).containsExactlyInAnyOrder(Sampler.LENS, Sampler.LENS + 1);
    return ray;
  }

  private static Vec3 pinhole(Point2 film) {
    Camera camera = new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1.5, FOV);
    return camera.rayFor(film, new ScriptedSampler()).orElseThrow().direction();
  }

  /** Returns the point where the ray through the lens center hits the plane at a depth. */
  private static Vec3 chief(Point2 film, double depth) {
    Vec3 d = PinholeCamera.direction(film.x(), film.y(), 1.5, PinholeCamera.halfHeight(FOV));
    return d.times(depth);
  }

  /** Returns the distance of a point from the line of a ray. */
  private static double distance(Ray ray, Vec3 p) {
    return p.minus(ray.origin()).cross(ray.direction()).length();
  }

  @Test
  void closedLensIsAPinhole() {
    for (double focus : new double[] {Double.MIN_VALUE, 1e-300, 1e-3, 5, 1e12, 1e300, INFINITY}) {
      for (int i = 0; i < 1000; i++) {
        Point2 film = inSquare(random);
        Ray ray = ray(camera(focus, 0), film, inSquare(random));
        assertThat(ray.origin().plus(Vec3.ZERO)).isEqualTo(Vec3.ZERO);
        assertThat(ray.direction().minus(pinhole(film)).length()).isLessThanOrEqualTo(4 * EPS);
      }
    }
  }

  @Test
  void tinyLensIsAlmostAPinhole() {
    for (double focus : new double[] {1, 5, 100}) {
      for (int i = 0; i < 1000; i++) {
        Point2 film = inSquare(random);
        Ray ray = ray(camera(focus, 1e-12), film, inSquare(random));
        assertThat(ray.direction().minus(pinhole(film)).length())
            .isLessThan(1e-12 * (1 / focus + 1));
      }
    }
  }

  @Test
  void everyRayPassesItsPointOfThePlaneOfFocus() {
    double[][] lenses = {{5, 1e6}, {.01, 1e6}, {1e3, .2}, {5, .2}, {1e-3, 1e-3}, {1e6, 1e3}};
    for (double[] lens : lenses) {
      ThinLensCamera camera = camera(lens[0], lens[1]);
      double size = Math.max(1, Math.max(lens[0], lens[1]));
      for (int i = 0; i < Effort.count(10_000, 300_000); i++) {
        Point2 film = inSquare(random);
        Ray ray = ray(camera, film, inSquare(random));
        assertThat(distance(ray, chief(film, lens[0]))).isLessThanOrEqualTo(16 * EPS * size);
      }
    }
  }

  @Test
  void lensIsADiscOfTheApertureAsRadius() {
    double most = 0;
    for (int i = 0; i < 10_000; i++) {
      Vec3 origin = ray(camera(5, .3), inSquare(random), inSquare(random)).origin();
      assertThat(origin.z()).isZero();
      most = Math.max(most, origin.length());
    }
    assertThat(most).isBetween(.299, .3 * (1 + 4 * EPS));
    Point2 film = new Point2(.5, .5);
    assertThat(ray(camera(5, .3), film, new Point2(1, .5)).origin()).isEqualTo(Vec3.X.times(.3));
    assertThat(ray(camera(5, .3), film, new Point2(.5, 1)).origin()).isEqualTo(Vec3.Y.times(.3));
  }

  @Test
  void blurOutOfFocusIsAUniformDiscOfTheRightSize() {
    double aperture = .2;
    double focus = 5;
    for (double depth : new double[] {2, 20}) {
      double radius = aperture * Math.abs(depth - focus) / focus;
      ThinLensCamera camera = camera(focus, aperture);
      Point2 film = new Point2(.3, .8);
      Vec3 center = chief(film, depth);
      // r²/R² is uniform with standard deviation 0.289: the test detects a bias of 0.005, or 0.002.
      Moments moments = new Moments();
      int n = Statistics.samplesToDetect(Effort.isExhaustive() ? .002 : .005, .289);
      for (int i = 0; i < n; i++) {
        Ray ray = ray(camera, film, inSquare(random));
        Vec3 hit = ray.at((depth - ray.origin().z()) / ray.direction().z());
        double r = hit.minus(center).length() / radius;
        if (r > 1 + 1e-12) {
          assertThat(r).isLessThanOrEqualTo(1 + 1e-12);
        }
        moments.add(r * r);
      }
      assertThat(Statistics.deviation(moments.z(.5))).isLessThan(Statistics.CRITICAL_Z);
    }
  }

  @Test
  void raysFocusedAtInfinityAreParallel() {
    for (double focus : new double[] {INFINITY, 1e300, 1.0001e12}) {
      ThinLensCamera camera = camera(focus, 1e6);
      for (int i = 0; i < 1000; i++) {
        Point2 film = inSquare(random);
        Vec3 direction = ray(camera, film, inSquare(random)).direction();
        assertThat(direction).isEqualTo(ray(camera, film, new Point2(.5, .5)).direction());
        assertThat(direction).isEqualTo(pinhole(film));
      }
    }
  }

  @Test
  void farthestFocusThatIsFiniteIsAtItsDistance() {
    Point2 center = new Point2(.5, .5);
    Ray ray = ray(camera(1e12, 1e12), center, new Point2(1, .5));
    // If the lens radius equals the focus distance, rays from its border to the focus come at 45°.
    assertThat(ray.direction().x()).isCloseTo(-Math.sqrt(.5), within(4 * EPS));
    assertThat(ray.direction().z()).isCloseTo(Math.sqrt(.5), within(4 * EPS));
  }

  @Test
  void extremeLensesGiveUnitRays() {
    double[] sizes = {Double.MIN_VALUE, 1e-300, 1e-9, 1, 1e9, 1e300, Double.MAX_VALUE};
    for (double focus : sizes) {
      for (double aperture : sizes) {
        for (int i = 0; i < 20; i++) {
          Ray ray = ray(camera(focus, aperture), inSquare(random), inSquare(random));
          assertThat(ray.direction().length()).isCloseTo(1, within(4 * EPS));
          assertThat(ray.origin().isFinite()).isTrue();
        }
      }
    }
  }

  @Test
  void pixelsAreAntialiasedWithALensToo() {
    // For one point of the lens, neighboring film points see different points in focus.
    Point2 lens = new Point2(.2, .9);
    Ray one = ray(camera(5, .2), new Point2(.5, .5), lens);
    Ray other = ray(camera(5, .2), new Point2(.501, .5), lens);
    assertThat(one.origin()).isEqualTo(other.origin());
    Vec3 step = other.at(5 / other.direction().z()).minus(one.at(5 / one.direction().z()));
    Vec3 expected = chief(new Point2(.501, .5), 5).minus(chief(new Point2(.5, .5), 5));
    assertThat(step.minus(expected).length()).isLessThan(1e-14);
  }

  /** A highlight behind the plane of focus forms an upright image of the lens on the film. */
  @Test
  void highlightBehindTheFocusShowsTheLensUprightAndOneBeforeItTurned() {
    Aperture upperRight = Aperture.mask(new boolean[][] {{false, false}, {false, true}});
    ThinLensCamera camera = new ThinLensCamera(Vec3.ZERO, Frame.WORLD, 1.5, FOV, 5, 1, upperRight);
    ScriptedSampler sampler = new ScriptedSampler().with(Sampler.LENS, .75, .75);
    Vec3 lens = camera.rayFor(new Point2(.5, .5), sampler).orElseThrow().origin();
    assertThat(lens).isEqualTo(new Vec3(.25, .25, 0));
    for (double depth : new double[] {20, 2}) {
      // Find the film point that sees (0, 0, depth) through this point of the lens.
      Vec3 towards = new Vec3(0, 0, depth).minus(lens);
      Vec3 inFocus = lens.plus(5 / depth, towards);
      Vec3 corner = chief(new Point2(1, 0), 5);
      Point2 film =
          new Point2(.5 + .5 * inFocus.x() / corner.x(), .5 - .5 * inFocus.y() / corner.y());
      assertThat(distance(camera.rayFor(film, sampler).orElseThrow(), new Vec3(0, 0, depth)))
          .isLessThan(1e-14);
      assertThat(film.x() > .5).isEqualTo(depth > 5);
      assertThat(film.y() < .5).isEqualTo(depth > 5);
    }
  }

  @Test
  void impossibleLensesAreRefused() {
    for (double focus : new double[] {0, -1, Double.NaN}) {
      assertThatThrownBy(() -> camera(focus, .2))
          .hasMessageContaining("focusDistance: expected a finite number > 0, found " + focus);
    }
    for (double aperture : new double[] {-1, Double.NaN, INFINITY}) {
      assertThatThrownBy(() -> camera(5, aperture))
          .hasMessageContaining("apertureSize: expected a finite number >= 0, found " + aperture);
    }
  }
}
