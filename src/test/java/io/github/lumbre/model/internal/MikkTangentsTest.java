package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests vertex tangents on meshes whose tangents are known. */
class MikkTangentsTest {
  private static final double[] SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  private static final double[] UPWARD = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  private static final double[] PLAIN = {0, 0, 1, 0, 1, 1, 0, 1};
  private static final int[] TWO = {0, 1, 2, 0, 2, 3};

  private static double[] tangents(double[] positions, double[] normals, double[] uv, int... f) {
    double[] none = {};
    return MikkTangents.of(
        new ModelGeometry(positions, normals, none, none, none, new float[0], f), uv);
  }

  private static void assertTangent(double[] tangents, int vertex, Vec3 expected, double sign) {
    Vec3 found = new Vec3(tangents[4 * vertex], tangents[4 * vertex + 1], tangents[4 * vertex + 2]);
    assertThat(found.minus(expected).length()).as("%s", found).isCloseTo(0, within(1e-12));
    assertThat(tangents[4 * vertex + 3]).isEqualTo(sign);
  }

  @Test
  void tangentsOfAQuadPointAlongU() {
    double[] tangents = tangents(SQUARE, UPWARD, PLAIN, TWO);
    for (int i = 0; i < 4; i++) {
      assertTangent(tangents, i, Vec3.X, 1);
    }
  }

  @Test
  void tangentsOfATurnedTextureTurnWithIt() {
    double[] tangents = tangents(SQUARE, UPWARD, new double[] {0, 1, 0, 0, 1, 0, 1, 1}, TWO);
    for (int i = 0; i < 4; i++) {
      assertTangent(tangents, i, Vec3.Y, 1);
    }
  }

  /** The texture is mirrored: u grows towards -x. */
  @Test
  void mirroredTexturesHaveANegativeBitangentSign() {
    double[] tangents = tangents(SQUARE, UPWARD, new double[] {1, 0, 0, 0, 0, 1, 1, 1}, TWO);
    for (int i = 0; i < 4; i++) {
      assertTangent(tangents, i, Vec3.X.negated(), -1);
    }
  }

  @Test
  void tangentsLieInTheVertexPlane() {
    double[] slanted = UPWARD.clone();
    slanted[0] = .6;
    slanted[2] = .8;
    double[] tangents = tangents(SQUARE, slanted, PLAIN, TWO);
    assertTangent(tangents, 0, new Vec3(.8, 0, -.6), 1);
    assertTangent(tangents, 1, Vec3.X, 1);
  }

  /** Two triangles meet at a vertex, with tangents of different directions and different angles. */
  @Test
  void anglesWeightTheTriangles() {
    double[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 1, 0};
    double[] uv = {0, 0, 1, 0, 0, 1, -.5, .5};
    double[] tangents = tangents(positions, UPWARD, uv, 0, 1, 2, 0, 2, 3);
    // Right angle with the tangent x; half a right angle with du along (1, ...): solve both.
    Vec3 second = gradient(new Vec3(0, 1, 0), new Vec3(-1, 1, 0), 0, 1, -.5, .5);
    Vec3 mean = Vec3.X.times(2).plus(second.normalized()).normalized();
    assertTangent(tangents, 0, mean, 1);
  }

  private static Vec3 gradient(Vec3 e1, Vec3 e2, double du1, double dv1, double du2, double dv2) {
    return e1.times(dv2).plus(-dv1, e2).times(Math.signum(du1 * dv2 - du2 * dv1));
  }

  @Test
  void verticesWithTheSameDataShareTheirTangent() {
    double[] positions = new double[18];
    double[] normals = new double[18];
    double[] uv = new double[12];
    for (int i = 0; i < 6; i++) {
      System.arraycopy(SQUARE, 3 * TWO[i], positions, 3 * i, 3);
      System.arraycopy(UPWARD, 0, normals, 3 * i, 3);
      System.arraycopy(PLAIN, 2 * TWO[i], uv, 2 * i, 2);
    }
    double[] split = tangents(positions, normals, uv, 0, 1, 2, 3, 4, 5);
    for (int i = 0; i < 6; i++) {
      assertTangent(split, i, Vec3.X, 1);
    }
  }

  @Test
  void trianglesWithoutTextureAreaHaveSomeUnitTangent() {
    double[] tangents = tangents(SQUARE, UPWARD, new double[8], TWO);
    for (int i = 0; i < 4; i++) {
      assertTangent(tangents, i, Vec3.X, 1);
    }
  }
}
