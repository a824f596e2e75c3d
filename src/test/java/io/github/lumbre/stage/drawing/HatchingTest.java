package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.section.Hatch;
import org.junit.jupiter.api.Test;

class HatchingTest {
  /** Two areas of 2 x 1 above each other, in the plane z = 7; each is two triangles. */
  private static TriangleMesh mesh() {
    double[] positions = new double[24];
    double[] uvs = new double[16];
    for (int i = 0; i < 8; i++) {
      uvs[2 * i] = 2 * (i & 1);
      uvs[2 * i + 1] = (i >> 1 & 1) + 3 * (i >> 2);
      positions[3 * i] = uvs[2 * i] + 10;
      positions[3 * i + 1] = uvs[2 * i + 1];
      positions[3 * i + 2] = 7;
    }
    return TriangleMesh.of(
        positions, new double[0], uvs, new int[] {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6});
  }

  @Test
  void linesCrossTrianglesAndEndAtGaps() {
    Hatching hatching =
        Hatching.of(mesh(), new Hatch(Rgb.WHITE, Rgb.BLACK, 1, 0)).orElseThrow();
    assertThat(hatching.across()).isEqualTo(new Vec3(1, 0, 0));
    assertThat(hatching.ends()).hasSize(4);
    double half = Hatch.WIDTH / 2;
    double[][] expected = {{10, 0}, {10, 3}, {11, 0}, {11, 3}};
    for (int i = 0; i < 4; i++) {
      Vec3 from = hatching.ends().get(i)[0];
      Vec3 to = hatching.ends().get(i)[1];
      assertThat(from.x()).isCloseTo(expected[i][0] + half, within(1e-6));
      assertThat(from.y()).isCloseTo(expected[i][1], within(1e-6));
      assertThat(from.z()).isCloseTo(7, within(1e-6));
      assertThat(to.minus(from).length()).isCloseTo(1, within(1e-6));
    }
  }
}
