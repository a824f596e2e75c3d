package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import org.assertj.core.data.Offset;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The camera turns around what it looks at. */
class OrbitTest {
  private static final Offset<Double> NEAR = Offset.offset(2e-3);

  @ParameterizedTest
  @ValueSource(strings = {"camera-pinhole", "camera-thin-lens", "cornell-box", "torus-knot"})
  void targetStaysInTheMiddle(String name) throws Exception {
    SceneFile file = new SceneParser().parse(Path.of("scenes", name + ".json"));
    Camera camera = file.scene().camera();
    Orbit orbit = Orbit.of(file.scene());
    Camera same = orbit.pose().place(camera);
    assertThat(same.position().minus(camera.position()).length())
        .isLessThan(1e-3 * orbit.distance());
    assertThat(same.axes().normal().dot(camera.axes().normal())).isGreaterThan(1 - 1e-6);
    for (int i = 0; i < 20; i++) {
      orbit = orbit.turned(37 * i, 13 * (i % 5) - 20).nearer(1 + .1 * (i % 3 - 1));
      Camera moved = orbit.pose().place(camera);
      Point2 middle = moved.project(orbit.target()).orElseThrow();
      assertThat(middle.x()).isCloseTo(.5, NEAR);
      assertThat(middle.y()).isCloseTo(.5, NEAR);
      assertThat(moved.position().minus(orbit.target()).length() / orbit.distance())
          .isCloseTo(1, NEAR);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1, 777, 1e6})
  void movesToTheRightAndUp(double distance) {
    Orbit orbit = new Orbit(Vec3.ZERO, distance, 0, 0, 0); // looks along z, from -z
    assertThat(orbit.turned(90, 0).pose().position().x() / distance).isCloseTo(1, NEAR);
    assertThat(orbit.turned(0, 45).pose().position().y() / distance).isCloseTo(.7071, NEAR);
    assertThat(orbit.moved(.5, 0).pose().position().x() / distance).isCloseTo(.5, NEAR);
    assertThat(orbit.moved(0, .5).pose().position().y() / distance).isCloseTo(.5, NEAR);
    assertThat(orbit.turned(0, 500).pitch()).isLessThan(90);
    assertThat(orbit.turned(720 + 30, 0).yaw()).isCloseTo(-30, NEAR);
  }
}
