package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests that triangles in cells are hit as in one hierarchy. */
class CellTraversalTest {
  /** The squares on each side of a wavy sheet: 20,000 triangles, more than without cells. */
  private static final int SIDE = 100;

  private static final Bounds3 AROUND = new Bounds3(new Vec3(-6, -6, -6), new Vec3(6, 6, 6));

  private static TriangleMesh sheet() {
    double[] positions = new double[3 * (SIDE + 1) * (SIDE + 1)];
    for (int i = 0; i < positions.length / 3; i++) {
      double x = i % (SIDE + 1) / 10. - 5;
      double z = i / (SIDE + 1) / 10. - 5;
      positions[3 * i] = x;
      positions[3 * i + 1] = Math.sin(3 * x) * Math.sin(2 * z);
      positions[3 * i + 2] = z;
    }
    int[] indices = new int[6 * SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
      int corner = i / SIDE * (SIDE + 1) + i % SIDE;
      int[] square = {0, 1, SIDE + 1, 1, SIDE + 2, SIDE + 1};
      for (int k = 0; k < 6; k++) {
        indices[6 * i + k] = corner + square[k];
      }
    }
    return TriangleMesh.of(positions, indices);
  }

  private static Mesh placed(TriangleMesh mesh, Transform place) {
    return Mesh.baked(mesh, place);
  }

  /** Two sheets coincide, one is flat, and one crosses them; other shapes are among them. */
  private static List<Shape> shapes(Random random) {
    TriangleMesh sheet = sheet();
    List<Shape> shapes = new ArrayList<>(Shapes.zoo(random, 30));
    shapes.add(placed(sheet, Transform.IDENTITY));
    shapes.add(placed(sheet, Transform.IDENTITY));
    shapes.add(placed(sheet, Transform.scale(new Vec3(1, 1e-30, 1))));
    shapes.add(placed(sheet, Transform.scale(new Vec3(.5, 5, .5))));
    return shapes;
  }

  private static void assertSame(NearestHit found, NearestHit expected, List<Shape> shapes) {
    assertThat(found.shape()).isEqualTo(expected.shape());
    assertThat(found.element()).isEqualTo(expected.element());
    assertThat(found.t()).isEqualTo(expected.t());
    // Other shapes leave what triangles before them have stored.
    if (found.isHit() && shapes.get(found.shape()) instanceof Mesh) {
      assertThat(found.b1).isEqualTo(expected.b1);
      assertThat(found.b2).isEqualTo(expected.b2);
    }
  }

  @Test
  void cellsHaveTheHitsOfOneHierarchy() {
    Random random = new Random(4);
    List<Shape> shapes = shapes(random);
    Bvh expected = Bvh.over(shapes, Kernel.SCALAR);
    Bvh cells = Bvh.later(shapes, Kernel.AUTO);
    NearestHit nearest = new NearestHit();
    NearestHit found = new NearestHit();
    int passed = 0;
    for (int i = 0; i < 2000; i++) {
      Ray ray = i % 4 == 0 ? upright(random) : Shapes.ray(random, AROUND);
      assertThat(cells.isOccluded(ray, found)).isEqualTo(expected.isOccluded(ray, nearest));
      nearest.aim(ray);
      found.aim(ray);
      boolean isHit = true;
      while (isHit) {
        isHit = expected.intersect(nearest);
        assertThat(cells.intersect(found)).isEqualTo(isHit);
        assertSame(found, nearest, shapes);
        nearest.pass();
        found.pass();
        passed++;
      }
    }
    assertThat(passed).isGreaterThan(4000);
  }

  /** Returns a ray along an axis through a vertex of the sheets, on the border of several cells. */
  private static Ray upright(Random random) {
    double x = random.nextInt(SIDE + 1) / 10. - 5;
    double z = random.nextInt(SIDE + 1) / 10. - 5;
    return new Ray(new Vec3(x, 9, z), new Vec3(0, -1, 0));
  }

  @Test
  void fewTrianglesAreOneHierarchy() {
    assertThat(CellTraversal.LEAST_TRIANGLES).isLessThan(2 * SIDE * SIDE);
    List<Shape> none = List.of();
    assertThat(Bvh.later(none, Kernel.AUTO).isOccluded(upright(new Random(1)), new NearestHit()))
        .isFalse();
  }
}
