package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Figures;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** No ray passes between the triangles of a closed mesh. */
class WatertightTest {
  /** The number of targets: a third each are random points, on edges and at vertices. */
  private static final int TARGETS = Effort.brief(Effort.count(40_000, 30_000_000));

  private static final TriangleMesh BALL = Shapes.closedBall(16, 16, .2, false);

  /** Rays from inside must leave through the mesh, and rays from outside must enter it. */
  @ParameterizedTest
  @CsvSource({"1, 0", "1e-6, 0", "1e6, 0", "1, 1e4", "1, 1e8", "1e-6, 1e-2", "1e6, 1e14"})
  void noRayLeaksThroughAClosedMesh(double scale, double offset) {
    Random random = new Random(Effort.seed(1));
    Transform place =
        Transform.translation(new Vec3(offset, -offset, .7 * offset))
            .times(Shapes.rotation(random))
            .times(Transform.scale(new Vec3(scale, scale, scale)));
    Mesh mesh = Mesh.baked(BALL, place);
    TriangleMesh world = mesh.triangles();
    Bvh bvh = Bvh.over(List.of(mesh));
    NearestHit hit = new NearestHit();
    int leaks = 0;
    // The first position gets 10 million targets of each kind, the others 3 million.
    int targets = scale == 1 && offset == 0 ? TARGETS : Effort.count(TARGETS, 9_000_000);
    for (int i = 0; i < targets; i++) {
      Vec3 inside = place.point(Shapes.point(random, .2));
      Vec3 target = target(world, random, i % 3);
      Vec3 direction = target.minus(inside).normalized();
      leaks += bvh.intersect(new Ray(inside, direction), hit) ? 0 : 1;
      leaks += bvh.isOccluded(new Ray(inside, direction), hit) ? 0 : 1;
      Vec3 outside = inside.plus(5 * scale, Shapes.direction(random));
      Ray through = new Ray(outside, inside.minus(outside).normalized());
      leaks += bvh.intersect(through, hit) ? 0 : 1;
    }
    Figures.failures("leaks at edges, vertices and elsewhere", 3L * targets, leaks);
    assertThat(leaks).isZero();
  }

  /** Returns a random point of a triangle, a point of an edge up to rounding, or a vertex. */
  private static Vec3 target(TriangleMesh mesh, Random random, int kind) {
    int triangle = random.nextInt(mesh.triangleCount());
    Vec3 a = mesh.position(mesh.vertex(triangle, 0));
    Vec3 b = mesh.position(mesh.vertex(triangle, 1));
    Vec3 c = mesh.position(mesh.vertex(triangle, 2));
    double s = random.nextDouble();
    return switch (kind) {
      case 0 -> a.plus(s * .5, b.minus(a)).plus(random.nextDouble() * .5, c.minus(a));
      case 1 -> a.plus(s, b.minus(a));
      default -> a;
    };
  }
}
