package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.ScriptedSampler;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests properties of all cameras. */
class CameraTest {
  private static final double EPS = 0x1p-52;
  private static final double LAST = 1 - 0x1p-53;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(20));

  private static List<Camera> cameras(Vec3 position, Frame axes, double aspect) {
    List<Camera> cameras = new ArrayList<>(camerasWithoutLens(position, axes, aspect));
    cameras.add(new ThinLensCamera(position, axes, aspect, 60, 5, .2, Aperture.DISK));
    Aperture mask = Aperture.mask(new boolean[][] {{true, false}, {false, false}});
    cameras.add(new ThinLensCamera(position, axes, aspect, 60, 5, .2, mask));
    return cameras;
  }

  private static List<Camera> camerasWithoutLens(Vec3 position, Frame axes, double aspect) {
    return List.of(
        new PinholeCamera(position, axes, aspect, 60),
        new PinholeCamera(position, axes, aspect, 179.999999),
        new PinholeCamera(position, axes, aspect, 1e-12),
        new CylindricalCamera(position, axes, aspect, 2),
        new CylindricalCamera(position, axes, aspect, 1e150),
        new SphericalCamera(position, axes, aspect),
        new FishEyeCamera(position, axes, aspect, 180),
        new FishEyeCamera(position, axes, aspect, 360));
  }

  private static Ray ray(Camera camera, double u, double v) {
    ScriptedSampler middleOfLens = new ScriptedSampler().with(Sampler.LENS, .5, .5);
    middleOfLens.with(Sampler.MASK, .5, .5, .5);
    return camera.rayFor(new Point2(u, v), middleOfLens).orElseThrow();
  }

  @Test
  void centerOfTheFilmLooksForwardExactly() {
    for (Camera camera : camerasWithoutLens(Vec3.ZERO, Frame.WORLD, 1.5)) {
      assertThat(ray(camera, .5, .5)).isEqualTo(new Ray(Vec3.ZERO, Vec3.Z));
    }
    Camera lens = new ThinLensCamera(Vec3.ZERO, Frame.WORLD, 1.5, 60, 5, .2, Aperture.DISK);
    assertThat(ray(lens, .5, .5)).isEqualTo(new Ray(Vec3.ZERO, Vec3.Z));
  }

  @Test
  void rightOfTheFilmIsRightAndItsTopIsUp() {
    for (Camera camera : cameras(Vec3.ZERO, Frame.WORLD, 1.5)) {
      Ray middle = ray(camera, .5, .5);
      assertThat(ray(camera, .6, .5).direction().x()).isGreaterThan(middle.direction().x());
      assertThat(ray(camera, .4, .5).direction().x()).isLessThan(middle.direction().x());
      assertThat(ray(camera, .5, .4).direction().y()).isGreaterThan(middle.direction().y());
      assertThat(ray(camera, .5, .6).direction().y()).isLessThan(middle.direction().y());
    }
  }

  @Test
  void raysFromAnywhereOnTheFilmAreOfUnitLength() {
    SobolSampler sampler = new SobolSampler(1);
    double[] extremes = {0, LAST, .5, 0x1p-53, .5 + EPS};
    for (Camera camera : cameras(new Vec3(1, 2, 3), Frame.around(new Vec3(.6, 0, .8)), 1.7)) {
      for (int i = 0; i < Effort.count(100_000, 1_000_000); i++) {
        double u = i < 25 ? extremes[i % 5] : random.nextDouble();
        double v = i < 25 ? extremes[i / 5] : random.nextDouble();
        sampler.startSample(i, 0, i);
        Optional<Ray> ray = camera.rayFor(new Point2(u, v), sampler);
        if (ray.isEmpty()) {
          assertThat(camera.leavesBlanks()).isTrue();
          continue;
        }
        double length = ray.get().direction().length();
        if (!(Math.abs(length - 1) <= 4 * EPS) || !ray.get().origin().isFinite()) {
          assertThat(length).as("%s %s %s", camera, u, v).isCloseTo(1, within(4 * EPS));
          assertThat(ray.get().origin().isFinite()).isTrue();
        }
      }
    }
  }

  @Test
  void camerasWithoutLensAskForNoNumbers() {
    for (Camera camera : camerasWithoutLens(Vec3.ZERO, Frame.WORLD, 1)) {
      ScriptedSampler sampler = new ScriptedSampler();
      camera.rayFor(new Point2(.3, .4), sampler);
      assertThat(sampler.asked()).isEmpty();
    }
  }

  /** A reused ray keeps nothing of the previous film point. */
  @Test
  void raysAimedAgainAreThoseOfNewOnes() {
    Vec3 position = new Vec3(1, 2, 3);
    for (Camera camera : cameras(position, Frame.around(new Vec3(.6, 0, .8)), 1)) {
      CameraRay again = new CameraRay();
      for (double u : new double[] {.3, .5, .6}) {
        Ray expected = ray(camera, u, .5);
        ScriptedSampler middleOfLens = new ScriptedSampler().with(Sampler.LENS, .5, .5);
        middleOfLens.with(Sampler.MASK, .5, .5, .5);
        assertThat(camera.aim(u, .5, middleOfLens, again)).isTrue();
        assertThat(again.toRay()).isEqualTo(expected);
        assertThat(new Vec3(again.originX(), again.originY(), again.originZ()))
            .isEqualTo(expected.origin());
        assertThat(new Vec3(again.directionX(), again.directionY(), again.directionZ()))
            .isEqualTo(expected.direction());
      }
    }
  }

  @Test
  void onlyFishEyesLeaveBlanks() {
    for (Camera camera : cameras(Vec3.ZERO, Frame.WORLD, 1.5)) {
      assertThat(camera.leavesBlanks()).isEqualTo(camera instanceof FishEyeCamera);
    }
  }

  @Test
  void panoramasKeepTheDigitsOfAnglesNearTheCenter() {
    for (Camera camera :
        List.of(
            new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, 1),
            new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2))) {
      for (double steps : new double[] {-3, -1, 1, 3}) {
        double u = .5 + steps * EPS / 2;
        double expected = 2 * Math.PI * (u - .5);
        assertThat(ray(camera, u, .5).direction().x())
            .isCloseTo(expected, within(4 * EPS * Math.abs(expected)));
      }
    }
  }

  @Test
  void poseTurnsAndMovesTheRays() {
    Vec3 position = new Vec3(10, -20, 30);
    for (double angle = 0; angle < 360; angle += 15) {
      Transform pose = Transform.rotationDegrees(new Vec3(angle, 2 * angle, -angle));
      Frame axes = new Frame(pose.vector(Vec3.X), pose.vector(Vec3.Y), pose.vector(Vec3.Z));
      List<Camera> turned = cameras(position, axes, 1.2);
      List<Camera> straight = cameras(Vec3.ZERO, Frame.WORLD, 1.2);
      for (int i = 0; i < turned.size(); i++) {
        Ray ray = ray(turned.get(i), .4, .3);
        Ray local = ray(straight.get(i), .4, .3);
        Vec3 direction = pose.vector(local.direction());
        assertThat(ray.direction().minus(direction).length()).isLessThan(8 * EPS);
        Vec3 origin = position.plus(pose.vector(local.origin()));
        assertThat(ray.origin().minus(origin).length()).isLessThan(64 * EPS);
      }
    }
  }

  @Test
  void aCameraTurnedByQuartersLooksExactlyAlongTheAxes() {
    Transform down = Transform.rotationDegrees(new Vec3(90, 0, 0));
    Frame axes = new Frame(down.vector(Vec3.X), down.vector(Vec3.Y), down.vector(Vec3.Z));
    Camera camera = new PinholeCamera(Vec3.ZERO, axes, 1, 60);
    assertThat(ray(camera, .5, .5).direction().plus(Vec3.ZERO)).isEqualTo(new Vec3(0, -1, 0));
  }

  @Test
  void resolutionDoesNotMatter() {
    // Position 0.25 in pixel 17 of 64 is position 0.5 in pixel 34 of 128.
    for (Camera camera : camerasWithoutLens(Vec3.ZERO, Frame.WORLD, 1)) {
      Vec3 coarse = ray(camera, (17 + .25) / 64, (30 + .75) / 64).direction();
      Vec3 fine = ray(camera, (34 + .5) / 128, (61 + .5) / 128).direction();
      assertThat(fine.minus(coarse).length()).isLessThanOrEqualTo(2 * EPS);
    }
  }

  @Test
  void impossibleProportionsAreRefused() {
    for (double aspect : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> new SphericalCamera(Vec3.ZERO, Frame.WORLD, aspect))
          .hasMessageContaining("aspect: expected a finite number > 0, found " + aspect);
    }
  }

  @Test
  void sphericalPolesAndSeamAgreeFromAllSides() {
    Camera camera = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    for (double u = 0; u < 1; u += .01) {
      assertThat(ray(camera, u, 0).direction().minus(Vec3.Y).length()).isLessThan(2 * EPS);
      assertThat(ray(camera, u, 1).direction().plus(Vec3.Y).length()).isLessThan(2 * EPS);
      Vec3 left = ray(camera, 0, u).direction();
      assertThat(left.minus(ray(camera, 1, u).direction()).length()).isLessThan(4 * EPS * Math.PI);
      assertThat(left.x()).isCloseTo(0, within(EPS));
      assertThat(left.z()).isNotPositive();
    }
  }

  /** Panoramas continue where a pixel filter extends beyond the film. */
  @Test
  void panoramasContinueBeyondTheirSides() {
    Camera spherical = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    Camera cylindrical = new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, 1);
    for (double t = 0; t < .5; t += .01) {
      for (Camera camera : new Camera[] {spherical, cylindrical}) {
        assertThat(
                ray(camera, -t, .3).direction().minus(ray(camera, 1 - t, .3).direction()).length())
            .isLessThan(8 * EPS);
        assertThat(
                ray(camera, 1 + t, .3).direction().minus(ray(camera, t, .3).direction()).length())
            .isLessThan(8 * EPS);
      }
      // Across a pole, the film continues on the other side of the sphere.
      assertThat(
              ray(spherical, .2, -t).direction().minus(ray(spherical, .7, t).direction()).length())
          .isLessThan(8 * EPS);
      assertThat(
              ray(spherical, .2, 1 + t)
                  .direction()
                  .minus(ray(spherical, .7, 1 - t).direction())
                  .length())
          .isLessThan(8 * EPS);
    }
  }

  @Test
  void sphericalRaysFollowTheirAngles() {
    Camera camera = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    for (int i = 0; i < 1000; i++) {
      double u = random.nextDouble();
      double v = random.nextDouble();
      double phi = Math.PI * (2 * u - 1);
      double psi = Math.PI * (.5 - v);
      double c = StrictMath.cos(psi);
      Vec3 expected =
          new Vec3(c * StrictMath.sin(phi), StrictMath.sin(psi), c * StrictMath.cos(phi));
      assertThat(ray(camera, u, v).direction().minus(expected).length()).isLessThan(8 * EPS);
    }
  }

  /** The solid angles of the film's cells, computed from opposite corners, sum to 4π. */
  @Test
  void sphericalFilmCoversTheSphere() {
    Camera camera = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    double solidAngle = 0;
    int columns = 512;
    int rows = 256;
    for (int y = 0; y < rows; y++) {
      for (int x = 0; x < columns; x++) {
        solidAngle += cell(camera, x, y, columns, rows);
      }
    }
    assertThat(solidAngle).isCloseTo(4 * Math.PI, within(4 * Math.PI * 1e-4));
  }

  /**
   * The midpoint rule over the cosine of latitude has a closed form, close to 4π but not equal to
   * it.
   */
  @Test
  void sphericalRowsHaveTheWeightOfTheirLatitude() {
    Camera camera = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    for (int rows : new int[] {1, 2, 7, 256, 4096}) {
      double sum = 0;
      for (int y = 0; y < rows; y++) {
        Vec3 d = ray(camera, .37, (y + .5) / rows).direction();
        sum += Math.hypot(d.x(), d.z()) * 2 * Math.PI * Math.PI / rows;
      }
      double step = Math.PI / rows;
      double closed = 2 * Math.PI * step / Math.sin(step / 2);
      assertThat(sum / closed).isCloseTo(1, within(1e-12));
    }
  }

  /** Returns the area of the parallelogram that a cell's midlines span on the sphere. */
  static double cell(Camera camera, int x, int y, int columns, int rows) {
    double u = (x + .5) / columns;
    double v = (y + .5) / rows;
    Vec3 across =
        ray(camera, u + .5 / columns, v)
            .direction()
            .minus(ray(camera, u - .5 / columns, v).direction());
    Vec3 down =
        ray(camera, u, v + .5 / rows).direction().minus(ray(camera, u, v - .5 / rows).direction());
    return across.cross(down).length();
  }

  @Test
  void cylindricalRaysFollowTheirAngles() {
    Camera camera = new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, 3);
    for (int i = 0; i < 1000; i++) {
      double u = random.nextDouble();
      double v = random.nextDouble();
      double phi = Math.PI * (2 * u - 1);
      Vec3 d = ray(camera, u, v).direction();
      Vec3 expected = new Vec3(StrictMath.sin(phi), (1 - 2 * v) * 3, StrictMath.cos(phi));
      assertThat(d.minus(expected.normalized()).length()).isLessThan(8 * EPS);
    }
  }

  @Test
  void cylindricalFilmOfNoHeightIsTheHorizon() {
    Camera camera = new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, 0);
    for (double v : new double[] {0, .3, LAST}) {
      // Adding zero makes negative zeros positive.
      Vec3 d = ray(camera, .2, v).direction().plus(Vec3.ZERO);
      assertThat(d).isEqualTo(ray(camera, .2, .5).direction().plus(Vec3.ZERO));
      assertThat(d.y()).isZero();
    }
  }

  @Test
  void cylindricalFilmOfGreatHeightLooksUpAndDown() {
    Camera camera = new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, 1e9);
    for (int row = 0; row < 8; row++) {
      double y = ray(camera, .3, (row + .5) / 8).direction().y();
      assertThat(row < 4 ? y : -y).isBetween(1 - 1e-15, 1.0);
    }
    assertThat(ray(camera, .3, .5).direction().y()).isZero();
    for (double height : new double[] {-1, 1e200, Double.NaN}) {
      assertThatThrownBy(() -> new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, height))
          .hasMessageContaining("halfHeight: expected a number from 0 to 1e150, found " + height);
    }
  }

  @Test
  void pinholeRaysAreTheKnownOnes() {
    Camera camera = new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1, 90);
    // The center of the upper left of four pixels.
    Vec3 d = ray(camera, .25, .25).direction();
    assertThat(d.x()).isCloseTo(-.4082482904638631, within(4 * EPS));
    assertThat(d.y()).isCloseTo(.4082482904638631, within(4 * EPS));
    assertThat(d.z()).isCloseTo(.8164965809277261, within(4 * EPS));
    // The field of view is vertical; the horizontal one follows from the aspect ratio.
    Camera wide = new PinholeCamera(Vec3.ZERO, Frame.WORLD, 2, 60);
    Vec3 top = ray(wide, .5, 0).direction();
    assertThat(top.y() / top.z()).isCloseTo(Math.sqrt(1 / 3.0), within(4 * EPS));
    Vec3 left = ray(wide, 0, .5).direction();
    assertThat(left.x() / left.z()).isCloseTo(-2 * Math.sqrt(1 / 3.0), within(8 * EPS));
  }

  @Test
  void pinholeOfAlmostNoAngleLooksForward() {
    for (double fov : new double[] {1e-6, 1e-12}) {
      Camera camera = new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1, fov);
      double bound = StrictMath.tan(Math.toRadians(fov / 2)) * Math.sqrt(2) * (1 + 4 * EPS);
      for (int i = 0; i < 64 * 64; i++) {
        Vec3 d = ray(camera, (i % 64 + .5) / 64, (i / 64 + .5) / 64).direction();
        assertThat(d.minus(Vec3.Z).length()).isLessThanOrEqualTo(bound);
        assertThat(Math.signum(d.x())).isEqualTo(i % 64 < 32 ? -1 : 1);
      }
    }
    assertThat(PinholeCamera.halfHeight(1e-6)).isCloseTo(8.726646259971647e-9, within(1e-23));
  }

  @Test
  void pinholeOfAlmostAHalfTurnSeesSymmetrically() {
    assertThat(PinholeCamera.halfHeight(179)).isCloseTo(114.58865012931011, within(1e-7));
    assertThat(PinholeCamera.halfHeight(179.999999)).isCloseTo(114591557.768914, within(.1145));
    Camera camera = new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1.3, 179.999999);
    Vec3 one = ray(camera, 0, 0).direction();
    Vec3 other = ray(camera, 1, 1).direction();
    assertThat(other).isEqualTo(new Vec3(-one.x(), -one.y(), one.z()));
  }

  @Test
  void extremeProportionsGiveUnitRays() {
    for (double aspect : new double[] {1, 16384, 1.0 / 16384, 1e4, 65535}) {
      for (Camera camera : cameras(Vec3.ZERO, Frame.WORLD, aspect)) {
        if (!camera.leavesBlanks()) {
          assertThat(ray(camera, 0, LAST).direction().length()).isCloseTo(1, within(4 * EPS));
        }
      }
    }
  }

  @Test
  void anglesWithoutPictureAreRefused() {
    for (double fov : new double[] {0, 180, -5, 360, Double.NaN}) {
      assertThatThrownBy(() -> new PinholeCamera(Vec3.ZERO, Frame.WORLD, 1, fov))
          .hasMessageContaining("fovDegrees: expected a number in (0, 180), found " + fov);
    }
    assertThat(Elementary.tanDegrees(45)).isCloseTo(1, within(EPS));
  }
}
