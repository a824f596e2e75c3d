package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EdgeKindTest {
  private static final double[] NONE = {};

  /** Returns the sides of a regular prism, with positions that are floats, as in most files. */
  private static MeshEdges prism(int sides, double height, Transform place) {
    double[] positions = new double[6 * sides];
    int[] indices = new int[6 * sides];
    for (int i = 0; i < sides; i++) {
      double angle = 2 * Math.PI * i / sides;
      int next = (i + 1) % sides;
      for (int end = 0; end < 2; end++) {
        Vec3 p = place.point(new Vec3(Math.cos(angle), end * height, Math.sin(angle)));
        for (int axis = 0; axis < 3; axis++) {
          positions[6 * i + 3 * end + axis] = (float) p.get(axis);
        }
      }
      int[] corners = {2 * i, 2 * i + 1, 2 * next, 2 * next, 2 * i + 1, 2 * next + 1};
      System.arraycopy(corners, 0, indices, 6 * i, 6);
    }
    return MeshEdges.of(List.of(TriangleMesh.of(positions, NONE, NONE, indices)));
  }

  /** Returns how many edges between the sides of a prism are lines. */
  private static long creases(MeshEdges edges, double creaseDegrees) {
    EdgeKind kind = new EdgeKind(edges, edges.positions(), creaseDegrees);
    long count = 0;
    for (int edge = 0; edge < edges.count(); edge++) {
      count += edges.triangles(edge) == 2 && kind.isFeature(edge) ? 1 : 0;
    }
    return count;
  }

  /** Each of these angles is a whole number of degrees, and a crease "from this angle on". */
  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 8, 9, 12, 24, 36, 72})
  void allEdgesAtExactlyTheCreaseAngleAreLinesAtAnyRotationAndScale(int sides) {
    Random random = new Random(7);
    double angle = 360. / sides;
    for (int i = 0; i < 200; i++) {
      double scale = Math.pow(10, 12 * random.nextDouble() - 6);
      Vec3 position = new Vec3(10 * random.nextGaussian(), 0, 1).times(scale);
      Vec3 degrees = new Vec3(random.nextInt(360), random.nextInt(360), random.nextInt(360));
      Transform place =
          Transform.placed(position, degrees).times(Transform.scale(new Vec3(scale, scale, scale)));
      MeshEdges edges = prism(sides, .5 + 3 * random.nextDouble(), place);
      assertThat(creases(edges, angle)).isEqualTo(sides);
      assertThat(creases(edges, angle - .2)).isEqualTo(sides);
      assertThat(creases(edges, angle + .2)).isZero();
      assertThat(creases(edges, 0)).as("no line within a flat side").isEqualTo(sides);
    }
  }
}
