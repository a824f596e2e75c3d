package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ScriptedSampler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the field of view of cylindrical panoramas. */
class CylindricalCameraTest {
  private static Vec3 direction(Camera camera, double u, double v) {
    return camera.rayFor(new Point2(u, v), new ScriptedSampler()).orElseThrow().direction();
  }

  private static CylindricalCamera ofHeight(double height) {
    return new CylindricalCamera(Vec3.ZERO, Frame.WORLD, 2, height);
  }

  /** The elevations up to atan h cover the fraction h/√(1+h²) of the sphere. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 2, 10, 1000})
  void heightSaysHowMuchOfTheSphereIsSeen(double height) {
    double share = direction(ofHeight(height), .3, 0).y();

    assertThat(share).isCloseTo(height / Math.sqrt(1 + height * height), within(1e-14));
    assertThat(direction(ofHeight(height), .3, 1).y()).isCloseTo(-share, within(1e-14));
  }

  @Test
  void largeHeightSeesAlmostAsFarUpAndDownAsTheSphericalCamera() {
    Camera spherical = new SphericalCamera(Vec3.ZERO, Frame.WORLD, 2);
    for (double u = 0; u < 1; u += .05) {
      Vec3 high = direction(ofHeight(1000), u, 0);
      assertThat(high.minus(direction(spherical, u, 0)).length()).isLessThan(1.01e-3);
      Vec3 middle = direction(ofHeight(1000), u, .5);
      assertThat(middle.minus(direction(spherical, u, .5)).length()).isLessThan(1e-14);
    }
  }
}
