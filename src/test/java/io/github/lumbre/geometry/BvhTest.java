package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BvhTest {
  private static final Bounds3 AROUND = new Bounds3(new Vec3(-6, -6, -6), new Vec3(6, 6, 6));

  @Test
  void findsWhatAskingEveryShapeFinds() {
    for (int seed = 0; seed < 5; seed++) {
      Random random = new Random(seed);
      List<Shape> shapes = Shapes.zoo(random, 10 + 20 * seed);
      assertSameAsBruteForce(shapes, random, 20_000, AROUND);
    }
  }

  private static void assertSameAsBruteForce(
      List<? extends Shape> shapes, Random random, int rays, Bounds3 around) {
    Bvh bvh = Bvh.over(shapes);
    NearestHit found = new NearestHit();
    NearestHit expected = new NearestHit();
    int hits = 0;
    for (int i = 0; i < rays; i++) {
      Ray ray = Shapes.ray(random, around);
      boolean isHit = Shapes.bruteForce(shapes, ray, expected);
      assertThat(bvh.isOccluded(ray, found)).as("any hit of %s", ray).isEqualTo(isHit);
      assertThat(bvh.intersect(ray, found)).as("hit of %s", ray).isEqualTo(isHit);
      assertThat(found.shape()).as("shape of %s", ray).isEqualTo(expected.shape());
      if (isHit) {
        hits++;
        assertThat(found.t()).isEqualTo(expected.t());
        assertThat(found.element).isEqualTo(expected.element);
        SurfaceHit surface = shapes.get(found.shape()).surfaceAt(ray, found);
        assertThat(surface).isEqualTo(shapes.get(found.shape()).surfaceAt(ray, expected));
      }
    }
    assertThat(hits).isGreaterThan(rays / 20);
  }
}
