package io.github.lumbre.camera;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import java.util.Optional;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A point on the ray of a film point appears at that film point. */
class ProjectionTest {
  private static final Vec3 EYE = new Vec3(1, -2, 3);
  private static final Frame AXES = Frame.around(new Vec3(.6, 0, .8));
  private static final Offset<Double> NEAR = Offset.offset(1e-9);

  static Stream<Camera> cameras() {
    return Stream.of(
        new PinholeCamera(EYE, AXES, 1.5, 50),
        new ThinLensCamera(EYE, AXES, .7, 30, 4, 0, Aperture.DISK),
        new OrthographicCamera(EYE, AXES, 1.5, 3),
        new CylindricalCamera(EYE, AXES, 2, .8),
        new SphericalCamera(EYE, AXES, 2),
        new FishEyeCamera(EYE, AXES, 1.5, 360),
        new FishEyeCamera(EYE, AXES, .5, 120));
  }

  @ParameterizedTest
  @MethodSource("cameras")
  void projectionInvertsRays(Camera camera) {
    Camera moved = camera.movedTo(EYE.times(-2), Frame.WORLD);
    int seen = 0;
    for (int i = 0; i < 400; i++) {
      Point2 film = new Point2((i % 20 + .5) / 20, (i / 20 + .37) / 20);
      for (Camera each : new Camera[] {camera, moved}) {
        Optional<Ray> ray = each.rayFor(film, new SobolSampler(1));
        if (ray.isPresent()) {
          seen++;
          Vec3 point = ray.get().origin().plus(2 + i, ray.get().direction());
          Point2 found = each.project(point).orElseThrow();
          assertThat(found.x()).isCloseTo(film.x(), NEAR);
          assertThat(found.y()).isCloseTo(film.y(), NEAR);
        }
      }
    }
    assertThat(seen).isGreaterThan(200);
    assertThat(moved.position()).isEqualTo(EYE.times(-2));
    assertThat(moved.axes()).isEqualTo(Frame.WORLD);
  }

  @Test
  void pointsBehindAreNotSeen() {
    Vec3 behind = EYE.minus(AXES.normal());
    assertThat(new PinholeCamera(EYE, AXES, 1, 50).project(behind)).isEmpty();
    assertThat(new OrthographicCamera(EYE, AXES, 1, 3).project(behind)).isEmpty();
    assertThat(new FishEyeCamera(EYE, AXES, 1, 120).project(behind)).isEmpty();
    assertThat(new PinholeCamera(EYE, AXES, 1, 50).project(EYE)).isEmpty();
  }
}
