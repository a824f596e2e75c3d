package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class NormalGradientTest {
  private static final double STEP = 1e-5;

  static List<Shape> shapes() {
    TriangleMesh triangle =
        TriangleMesh.of(
            new double[] {-1, 0, -1, 2, .3, -1, 0, -.2, 2},
            new double[] {-.3, 1, 0, .2, 1, .1, 0, 1, .3},
            new double[0],
            new int[] {0, 2, 1});
    TriangleMesh even =
        TriangleMesh.of(
            new double[] {-1, 0, -1, 2, .3, -1, 0, -.2, 2},
            new double[0],
            new double[0],
            new int[] {0, 2, 1});
    TriangleMesh wound =
        TriangleMesh.of(
            new double[] {-1, 0, -1, 2, .3, -1, 0, -.2, 2},
            new double[] {-.3, 1, 0, .6, -.3, .1, 0, 1, .3},
            new double[0],
            new int[] {0, 2, 1},
            MeshAttributes.NONE,
            TriangleMesh.Front.WINDING);
    Transform placed =
        Transform.rotationDegrees(new Vec3(10, 20, 30))
            .times(Transform.scale(new Vec3(1.2, -.8, 1.1)));
    return List.of(
        Mesh.of(triangle, placed),
        Mesh.of(even, placed),
        Mesh.of(wound, placed),
        new MeshInstance(new SharedMesh(triangle), placed),
        new Rectangle(placed, 2, 2, true),
        new Plane(placed, true),
        new Box(placed, 2, 1, 2),
        Sphere.of(new Vec3(.1, .2, 0), 1.5),
        new Sphere(placed, .9));
  }

  /** Compares the gradient with the normals of nearby rays. */
  @ParameterizedTest
  @MethodSource("shapes")
  void normalsChangeByTheirGradient(Shape shape) {
    NearestHit hit = hit(shape, .1, .05);
    NormalGradient gradient = shape.normalGradientAt(hit);
    for (double[] step : new double[][] {{STEP, 0}, {0, STEP}, {STEP, -STEP}}) {
      SurfaceHit before = shape.surfaceAt(hit(shape, .1 - step[0], .05 - step[1]));
      SurfaceHit after = shape.surfaceAt(hit(shape, .1 + step[0], .05 + step[1]));
      Vec3 expected = after.shadingNormal().minus(before.shadingNormal());
      Vec3 found = gradient.change(after.position().minus(before.position()));
      assertThat(found.minus(expected).length()).isLessThan(1e-4 * STEP);
    }
  }

  private static NearestHit hit(Shape shape, double x, double z) {
    NearestHit hit = new NearestHit();
    hit.aim(x, 3, z, 0, -1, 0, 10);
    assertThat(shape.intersect(hit)).isTrue();
    return hit;
  }
}
