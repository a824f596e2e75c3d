package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.ScriptedSampler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests parallel projection. */
class OrthographicCameraTest {
  private static final Vec3 POSITION = new Vec3(1, 2, 3);

  private static Ray ray(double u, double v) {
    Camera camera = new OrthographicCamera(POSITION, Frame.WORLD, 1.5, 4);
    return camera.rayFor(new Point2(u, v), new ScriptedSampler()).orElseThrow();
  }

  @Test
  void raysAreParallelAndStartOnTheFilm() {
    for (double u : new double[] {0, .25, .5, 1}) {
      for (double v : new double[] {0, .5, .75, 1}) {
        Vec3 expected = POSITION.plus(new Vec3((u - .5) * 6, (.5 - v) * 4, 0));
        assertThat(ray(u, v).direction()).isEqualTo(Vec3.Z);
        assertThat(ray(u, v).origin().minus(expected).length()).isCloseTo(0, within(1e-14));
      }
    }
  }

  @Test
  void filmTurnsWithTheCamera() {
    Frame axes = new Frame(Vec3.Z, Vec3.Y, Vec3.X.negated());
    Camera camera = new OrthographicCamera(POSITION, axes, 1, 2);
    Ray corner = camera.rayFor(new Point2(1, 0), new ScriptedSampler()).orElseThrow();
    assertThat(corner.direction().plus(Vec3.X).length()).isZero();
    assertThat(corner.origin().minus(new Vec3(1, 3, 4)).length()).isCloseTo(0, within(1e-14));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void heightsOutOfRangeAreRefused(double height) {
    assertThatThrownBy(() -> new OrthographicCamera(POSITION, Frame.WORLD, 1, height))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("height: expected a finite number > 0, found " + height);
  }
}
