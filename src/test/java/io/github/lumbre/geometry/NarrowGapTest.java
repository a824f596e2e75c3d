package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A ray that leaves one of two close, parallel surfaces into their gap hits the other surface. */
class NarrowGapTest {
  /** The narrowest gap between flat shapes, in ulp of the largest coordinate. */
  private static final double FLAT = 64;

  /** The narrowest gap between triangles, whose error bound is larger. */
  private static final double TRIANGLES = 128;

  private static final int WAYS = 10;

  @ParameterizedTest
  @ValueSource(doubles = {1e-12, 1e-6, 1, 1e3, 1e8})
  void noRayLeaksOutOfAGap(double distance) {
    double size = 4 * distance;
    assertNoLeaks(distance, FLAT, place -> new Plane(place, true));
    assertNoLeaks(distance, FLAT, place -> new Rectangle(place, size, size, true));
    TriangleMesh quad = quad(.5 * size);
    assertNoLeaks(distance, TRIANGLES, place -> Mesh.baked(quad, place));
    SharedMesh shared = new SharedMesh(quad);
    assertNoLeaks(distance, TRIANGLES, place -> new MeshInstance(shared, place));
  }

  private static TriangleMesh quad(double half) {
    double[] p = {-half, 0, -half, half, 0, -half, half, 0, half, -half, 0, half};
    return TriangleMesh.of(p, new double[0], new double[0], new int[] {0, 1, 2, 0, 2, 3});
  }

  private static void assertNoLeaks(double distance, double ulps, Function<Transform, Shape> at) {
    Random random = new Random(Effort.seed(1));
    double narrowest = ulps * Math.ulp(4 * distance);
    int hits = 0;
    int leaks = 0;
    int gaps = Effort.count(400, 100_000);
    for (int i = 0; i < gaps; i++) {
      Transform turned = i % 4 == 0 ? Transform.IDENTITY : Shapes.rotation(random);
      double gap = narrowest * StrictMath.pow(1e9, random.nextDouble());
      Transform raised = turned.times(Transform.translation(new Vec3(0, gap, 0)));
      Bvh both = Bvh.over(List.of(at.apply(turned), at.apply(raised)));
      Vec3 origin = turned.point(new Vec3(-distance, gap * random.nextDouble(), 0));
      Vec3 target =
          turned.point(new Vec3(random.nextDouble(), 0, random.nextDouble()).times(distance));
      Ray ray = new Ray(origin, target.minus(origin).normalized());
      NearestHit nearest = new NearestHit();
      boolean isMet = both.intersect(ray, nearest) && nearest.shape() == 0;
      // Rounding may carry a ray far beyond its target, to coordinates for which the gap is too
      // narrow.
      if (isMet && nearest.t() <= 3 * distance) {
        SurfaceHit hit = at.apply(turned).surfaceAt(nearest);
        leaks += leaks(both, hit, turned.vector(Vec3.Y), distance, 2 * gap / distance, random);
        hits++;
      }
    }
    assertThat(hits).isGreaterThan(gaps / 2);
    assertThat(leaks).isZero();
  }

  /**
   * Counts the rays that leak from a gap, without those that may pass the border of the other
   * surface.
   */
  private static int leaks(
      Bvh both, SurfaceHit hit, Vec3 up, double distance, double leastCosine, Random random) {
    NearestHit scratch = new NearestHit();
    int leaks = 0;
    for (int way = 0; way < WAYS; way++) {
      Vec3 any = Shapes.direction(random);
      Vec3 direction = any.dot(up) < 0 ? any.negated() : any;
      if (direction.dot(up) > leastCosine) {
        Vec3 outside = hit.position().plus(distance, direction);
        leaks += both.isOccluded(hit.spawn(direction), scratch) ? 0 : 1;
        hit.spawnTowards(outside, scratch);
        leaks += both.isOccluded(scratch) ? 0 : 1;
      }
    }
    return leaks;
  }
}
