package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.ScriptedSampler;
import io.github.lumbre.testing.Statistics;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the equidistant projection and its image circle. */
class FishEyeCameraTest {
  private static final double EPS = 0x1p-52;
  private static final Sampler NO_NUMBERS = new ScriptedSampler();

  private static FishEyeCamera camera(double aspect, double angle) {
    return new FishEyeCamera(Vec3.ZERO, Frame.WORLD, aspect, angle);
  }

  private static Optional<Vec3> direction(Camera camera, double u, double v) {
    return camera.rayFor(new Point2(u, v), NO_NUMBERS).map(ray -> ray.direction());
  }

  @Test
  void directionsNearTheCenterAreForward() {
    for (double angle : new double[] {1e-9, 180, 360}) {
      assertThat(direction(camera(1, angle), .5, .5)).contains(Vec3.Z);
      Vec3 near = direction(camera(1, angle), .5 + EPS, .5).orElseThrow();
      // At distance 2 eps from the center of a circle of radius 1: half the angle times 2 eps.
      assertThat(near.x()).isCloseTo(Math.toRadians(angle) * EPS, within(1e-30));
    }
  }

  @Test
  void rimOfAHalfTurnIsTheHorizonAndBelongsToThePicture() {
    FishEyeCamera camera = camera(1, 180);
    assertThat(direction(camera, 1, .5)).isPresent();
    for (double u : new double[] {0, 0x1p-54, 1, 1 - 0x1p-53}) {
      Vec3 d = direction(camera, u, .5).orElseThrow();
      assertThat(d.z()).isBetween(-0.0, 4e-16);
      assertThat(d.x()).isCloseTo(u < .5 ? -1 : 1, within(EPS));
    }
    assertThat(direction(camera, .5, 0).orElseThrow().y()).isCloseTo(1, within(EPS));
  }

  @Test
  void nothingIsImagedOutsideTheCircle() {
    assertThat(direction(camera(1, 180), 1 + EPS, .5)).isEmpty();
    for (double u : new double[] {0, 1 - 0x1p-53}) {
      assertThat(direction(camera(1, 180), u, u)).isEmpty();
      assertThat(direction(camera(1, 360), u, 1 - u)).isEmpty();
    }
    assertThat(camera(1, 180).leavesBlanks()).isTrue();
  }

  @Test
  void circleTouchesTheShorterSides() {
    assertThat(direction(camera(2, 180), .5, 0)).isPresent();
    assertThat(direction(camera(2, 180), .25, .5).orElseThrow().x()).isEqualTo(-1);
    assertThat(direction(camera(2, 180), .24, .5)).isEmpty();
    assertThat(direction(camera(.5, 180), 0, .5)).isPresent();
    assertThat(direction(camera(.5, 180), .5, .25).orElseThrow().y()).isEqualTo(1);
    assertThat(direction(camera(.5, 180), .5, .24)).isEmpty();
  }

  @Test
  void angleFromTheAxisIsProportionalToTheRadius() {
    SplittableRandom random = new SplittableRandom(21);
    for (double angle : new double[] {10, 180, 220, 360}) {
      for (int i = 0; i < 1000; i++) {
        double r = random.nextDouble();
        double phi = random.nextDouble(2 * Math.PI);
        double x = r * Math.cos(phi);
        double y = r * Math.sin(phi);
        Vec3 d = direction(camera(1, angle), .5 + x / 2, .5 - y / 2).orElseThrow();
        double theta = r * Math.toRadians(angle / 2);
        double s = StrictMath.sin(theta);
        Vec3 expected = new Vec3(s * Math.cos(phi), s * Math.sin(phi), StrictMath.cos(theta));
        assertThat(d.minus(expected).length()).isLessThan(16 * EPS);
      }
    }
  }

  @Test
  void halfTurnCoversHalfTheSphere() {
    FishEyeCamera camera = camera(1, 180);
    double solidAngle = 0;
    int n = 512;
    for (int y = 0; y < n; y++) {
      for (int x = 0; x < n; x++) {
        if (direction(camera, (x + .5) / n, (y + .5) / n).isPresent()) {
          solidAngle += cell(camera, (x + .5) / n, (y + .5) / n, .25 / n);
        }
      }
    }
    assertThat(solidAngle).isCloseTo(2 * Math.PI, within(2 * Math.PI * 1e-3));
  }

  /** Returns the solid angle of a cell from differences over half its width, towards the center. */
  private static double cell(Camera camera, double u, double v, double quarter) {
    double h = u < .5 ? quarter : -quarter;
    double k = v < .5 ? quarter : -quarter;
    Vec3 middle = direction(camera, u, v).orElseThrow();
    Vec3 across = direction(camera, u + h, v).orElseThrow().minus(middle);
    Vec3 down = direction(camera, u, v + k).orElseThrow().minus(middle);
    return 16 * across.cross(down).length();
  }

  @Test
  void blankShareOfASquareIsOneLessQuarterPi() {
    SplittableRandom random = new SplittableRandom(22);
    FishEyeCamera camera = camera(1, 180);
    // A Bernoulli variable with mean 0.785 has the standard deviation 0.41: the test detects a bias
    // of 0.003.
    Moments imaged =
        Statistics.moments(
            Statistics.samplesToDetect(.003, .411),
            () -> direction(camera, random.nextDouble(), random.nextDouble()).isPresent() ? 1 : 0);
    assertThat(Statistics.deviation(imaged.z(Math.PI / 4))).isLessThan(Statistics.CRITICAL_Z);
  }

  @Test
  void impossibleAnglesAreRefused() {
    for (double angle : new double[] {0, -1, 360.001, Double.NaN}) {
      assertThatThrownBy(() -> camera(1, angle))
          .hasMessageContaining("angleDegrees: expected a number in (0, 360], found " + angle);
    }
  }
}
