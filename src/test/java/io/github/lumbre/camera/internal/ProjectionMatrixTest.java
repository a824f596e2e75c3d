package io.github.lumbre.camera.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A point on the ray of a pixel position is mapped to this position, and to its depth. */
class ProjectionMatrixTest {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 400;
  private static final Vec3 EYE = new Vec3(1, -2, 3);
  private static final Frame AXES = Frame.around(new Vec3(.6, 0, .8));
  private static final Transform MIRROR = Transform.scale(new Vec3(1, 1, -1));

  /** The rounding of a dozen operations on pixel positions up to 1,000 is below 1e-11. */
  private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

  static Stream<Lens> lenses() {
    return Stream.of(
        Lens.pinhole(35),
        Lens.pinhole(179),
        Lens.pinhole(1),
        Lens.thinLens(50, 4, 0),
        Lens.orthographic(3),
        Lens.orthographic(1e-6),
        Lens.orthographic(1e9));
  }

  private static Camera camera(Lens lens) {
    return lens.camera(eye(lens), AXES, (double) WIDTH / HEIGHT);
  }

  /** Rounding of coordinates far larger than the frame would be visible. */
  private static Vec3 eye(Lens lens) {
    return lens instanceof Lens.Orthographic parallel ? EYE.times(parallel.height()) : EYE;
  }

  private static Projection projection(Lens lens) {
    return Projection.of(camera(lens), WIDTH, HEIGHT).orElseThrow();
  }

  @ParameterizedTest
  @MethodSource("lenses")
  void pointsOnRaysAreAtTheirPixels(Lens lens) {
    Projection projection = projection(lens);
    Projection mirrored = projection.from(MIRROR);
    Projection part = projection.cropped(100, 50);
    for (int i = 0; i < 100; i++) {
      double x = WIDTH * (i % 10) / 9.;
      double y = HEIGHT * (i / 10) / 9.;
      Point2 film = new Point2(x / WIDTH, y / HEIGHT);
      Ray ray = camera(lens).rayFor(film, new SobolSampler(1)).orElseThrow();
      Vec3 point = ray.origin().plus((2 + i) * eye(lens).length(), ray.direction());
      Vec3 found = projection.pixel(point);
      double depth = point.minus(eye(lens)).dot(AXES.normal());
      assertThat(found.x()).isCloseTo(x, ROUNDING);
      assertThat(found.y()).isCloseTo(y, ROUNDING);
      assertThat(found.z()).isCloseTo(depth, Offset.offset(1e-14 * (1 + point.maxAbs())));
      assertThat(mirrored.pixel(MIRROR.point(point)).minus(found).length())
          .isLessThan(1e-9 * (1 + point.maxAbs()));
      assertThat(part.pixel(point).plus(new Vec3(100, 50, 0)).minus(found).length())
          .isLessThan(1e-9 * (1 + point.maxAbs()));
      assertThat(byMatrix(projection.matrix(), point).minus(found).length())
          .isLessThan(1e-9 * (1 + point.maxAbs()));
    }
    assertThat(projection.isParallel()).isEqualTo(lens instanceof Lens.Orthographic);
    assertThat(mirrored.isParallel()).isEqualTo(projection.isParallel());
  }

  /** Does what the documentation of the JSON states. */
  private static Vec3 byMatrix(List<List<Double>> matrix, Vec3 p) {
    double[] product = new double[4];
    for (int row = 0; row < 4; row++) {
      List<Double> m = matrix.get(row);
      product[row] = m.get(0) * p.x() + m.get(1) * p.y() + m.get(2) * p.z() + m.get(3);
    }
    return new Vec3(product[0] / product[3], product[1] / product[3], product[2]);
  }

  @Test
  void depthIsMeasuredAlongTheViewAndOfPointsBehindNegative() {
    for (Lens lens : List.of(Lens.pinhole(35), Lens.orthographic(3))) {
      Vec3 beside = eye(lens).plus(5, AXES.normal()).plus(7, AXES.tangent());
      assertThat(projection(lens).pixel(beside).z()).isCloseTo(5, ROUNDING);
      assertThat(projection(lens).pixel(eye(lens).minus(AXES.normal())).z())
          .isCloseTo(-1, ROUNDING);
    }
  }

  @Test
  void camerasThatBendLinesHaveNoMatrix() {
    for (Lens lens :
        List.of(
            Lens.spherical(),
            Lens.cylindrical(.8),
            Lens.fishEye(1),
            Lens.fishEye(20),
            Lens.fishEye(120),
            Lens.fishEye(360))) {
      assertThat(Projection.of(camera(lens), WIDTH, HEIGHT)).as(lens.toString()).isEmpty();
    }
  }
}
