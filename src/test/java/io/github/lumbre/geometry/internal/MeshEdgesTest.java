package io.github.lumbre.geometry.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.TriangleMesh;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class MeshEdgesTest {
  private static final double[] NONE = {};

  /** Returns two triangles of a unit square with vertices of their own. */
  private static TriangleMesh square(double[] normals) {
    return TriangleMesh.of(
        new double[] {0, 0, 0, 1, 0, 0, 1, 1, 0, -0., 0, 0, 1, 1, 0, 0, 1, 0},
        normals,
        NONE,
        new int[] {0, 1, 2, 3, 4, 5});
  }

  @Test
  void verticesAtOnePlaceAreOne() {
    MeshEdges edges = MeshEdges.of(List.of(square(NONE)));
    assertThat(edges.positions()).hasSize(12);
    assertThat(edges.count()).isEqualTo(5);
    assertThat(IntStream.range(0, 5).map(edges::triangles).sorted()).containsExactly(1, 1, 1, 1, 2);
  }

  @Test
  void anEdgeKnowsItsTriangles() {
    MeshEdges edges = MeshEdges.of(List.of(square(NONE)));
    int diagonal = IntStream.range(0, 5).filter(e -> edges.triangles(e) == 2).sum();
    assertThat(edges.from(diagonal)).isEqualTo(0);
    assertThat(edges.to(diagonal)).isEqualTo(2);
    assertThat(edges.triangle(diagonal, 0)).isEqualTo(0);
    assertThat(edges.opposite(diagonal, 0)).isEqualTo(1);
    assertThat(edges.triangle(diagonal, 1)).isEqualTo(1);
    assertThat(edges.opposite(diagonal, 1)).isEqualTo(3);
  }

  @Test
  void meshesShareTheirEdges() {
    TriangleMesh left = square(NONE).part(new int[] {0});
    TriangleMesh right = square(NONE).part(new int[] {1});
    MeshEdges edges = MeshEdges.of(List.of(left, right));
    assertThat(edges.count()).isEqualTo(5);
    int diagonal = IntStream.range(0, 5).filter(e -> edges.triangles(e) == 2).sum();
    assertThat(edges.triangle(diagonal, 1)).isEqualTo(1);
  }

  @Test
  void edgesAreSmoothIfTheNormalsOfTheirTrianglesAre() {
    double[] up = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 1};
    double[] turned = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, .1, 1, 0, 0, 1, 0, 0, 1};
    for (int edge = 0; edge < 5; edge++) {
      MeshEdges smooth = MeshEdges.of(List.of(square(up)));
      assertThat(smooth.isSmooth(edge)).isEqualTo(smooth.triangles(edge) == 2);
      assertThat(MeshEdges.of(List.of(square(turned))).isSmooth(edge)).isFalse();
      assertThat(MeshEdges.of(List.of(square(NONE))).isSmooth(edge)).isFalse();
    }
  }

  @Test
  void emptyMeshHasNoEdges() {
    TriangleMesh empty = TriangleMesh.of(new double[] {1, 2, 3}, NONE, NONE, new int[] {0, 0, 0});
    assertThat(MeshEdges.of(List.of(empty)).count()).isZero();
    assertThat(MeshEdges.of(List.of()).count()).isZero();
  }

  /** Some edges have none, some three or four triangles. */
  @Test
  void meshesAreClosedIfTheirEdgesHaveEvenNumbersOfTriangles() {
    double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, -0.};
    int[][] faces = {{0, 1, 2}, {0, 3, 1}, {5, 2, 3}, {1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
    int closed = 0;
    for (int chosen = 1; chosen < 1 << faces.length; chosen++) {
      int some = chosen;
      int[] indices =
          IntStream.range(0, faces.length)
              .filter(face -> (some >> face & 1) != 0)
              .flatMap(face -> IntStream.of(faces[face]))
              .toArray();
      TriangleMesh mesh = TriangleMesh.of(corners, indices);
      MeshEdges edges = MeshEdges.of(List.of(mesh));
      boolean isClosed =
          IntStream.range(0, edges.count()).allMatch(edge -> edges.triangles(edge) % 2 == 0);
      assertThat(MeshEdges.isClosed(mesh)).as("%s", chosen).isEqualTo(isClosed);
      closed += isClosed ? 1 : 0;
    }
    // Both tetrahedra, and their hull.
    assertThat(closed).isEqualTo(3);
  }
}
