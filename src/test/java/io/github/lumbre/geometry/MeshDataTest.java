package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The data of meshes: checks, parts, closed borders, interpolation, and vertex tangents. */
class MeshDataTest {
  private static final double[] NONE = {};
  private static final Transform MIRROR = Transform.scale(new Vec3(-1, 1, 1));

  /** Two triangles of the square from (0, 0, 0) to (2, 2, 0), with all attributes. */
  private static TriangleMesh square(double... tangentSigns) {
    double[] positions = {7, 7, 7, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    double[] normals = new double[15];
    double[] uvs = new double[10];
    double[] uv1 = new double[10];
    double[] tangents = new double[20];
    float[] colors = new float[20];
    for (int i = 0; i < 5; i++) {
      normals[3 * i + 2] = 1;
      // Affine in the position.
      double x = positions[3 * i];
      double y = positions[3 * i + 1];
      uvs[2 * i] = 3 + 2 * x - y;
      uvs[2 * i + 1] = 5 + x + 4 * y;
      uv1[2 * i] = -1 - 3 * x + y;
      uv1[2 * i + 1] = 2 + x - y;
      tangents[4 * i] = 1;
      tangents[4 * i + 3] = tangentSigns.length == 0 ? 1 : tangentSigns[i];
      colors[4 * i] = (float) (1 + x);
      colors[4 * i + 1] = (float) (2 + y);
      colors[4 * i + 2] = (float) (x + y);
      colors[4 * i + 3] = (float) (x / 4);
    }
    return TriangleMesh.of(
        positions,
        normals,
        uvs,
        new int[] {1, 2, 3, 1, 3, 4},
        new MeshAttributes(tangents, uv1, colors));
  }

  private static SurfaceHit hit(Shape shape, double x, double y) {
    return Shapes.hit(shape, new Ray(new Vec3(x, y, 3), Vec3.Z.negated())).orElseThrow();
  }

  @Test
  void attributesOfAllVerticesAreInterpolated() {
    Transform place = Transform.IDENTITY;
    for (Shape shape :
        new Shape[] {
          Mesh.baked(square(), place),
          new MeshInstance(new SharedMesh(square()), place),
          Mesh.baked(square().part(new int[] {1, 0}), place)
        }) {
      for (double[] at : new double[][] {{.5, .25}, {1.75, .5}, {.25, 1.5}, {1, 1.9}}) {
        double x = at[0];
        double y = at[1];
        SurfaceHit hit = hit(shape, x, y);
        assertThat(hit.u(0)).isCloseTo(3 + 2 * x - y, within(1e-12));
        assertThat(hit.v(0)).isCloseTo(5 + x + 4 * y, within(1e-12));
        assertThat(hit.u(1)).isCloseTo(-1 - 3 * x + y, within(1e-12));
        assertThat(hit.v(1)).isCloseTo(2 + x - y, within(1e-12));
        assertThat(hit.vertexColor().r()).isCloseTo(1 + x, within(1e-6));
        assertThat(hit.vertexColor().g()).isCloseTo(2 + y, within(1e-6));
        assertThat(hit.vertexColor().b()).isCloseTo(x + y, within(1e-6));
        assertThat(hit.vertexAlpha()).isCloseTo(x / 4, within(1e-6));
        assertThat(hit.shadingNormal()).isEqualTo(Vec3.Z);
      }
    }
  }

  /** With an affine texture, the frame's tangents are the projected directions of growing u, v. */
  @Test
  void framesFollowObliqueTextures() {
    double[] uvs = new double[10];
    for (int i = 0; i < 5; i++) {
      Vec3 p = square().position(i);
      uvs[2 * i] = 3 + p.x() * .8 + p.y() * .6;
      uvs[2 * i + 1] = 5 - p.x() * .6 + p.y() * .8;
    }
    TriangleMesh turned =
        TriangleMesh.of(
            new double[] {7, 7, 7, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0},
            NONE,
            uvs,
            new int[] {1, 2, 3, 1, 3, 4});
    for (double[] at : new double[][] {{1.5, .5}, {.5, 1.5}}) {
      SurfaceHit hit = hit(Mesh.baked(turned, Transform.IDENTITY), at[0], at[1]);
      Frame frame = hit.shading();
      assertThat(frame.tangent().minus(new Vec3(.8, .6, 0)).maxAbs()).isLessThan(1e-12);
      assertThat(frame.bitangent().minus(new Vec3(-.6, .8, 0)).maxAbs()).isLessThan(1e-12);
    }
  }

  /** The bitangent's side is that of most of a triangle's vertices. */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 1",
    "1, 1, -1, 1",
    "1, -1, 1, 1",
    "-1, 1, 1, 1",
    "-1, -1, 1, -1",
    "-1, 1, -1, -1",
    "1, -1, -1, -1",
    "-1, -1, -1, -1"
  })
  void signsOfTangentsDecideTheBitangent(double a, double b, double c, double expected) {
    TriangleMesh mesh = square(1, a, b, c, 1);
    for (Transform place : new Transform[] {Transform.IDENTITY, MIRROR}) {
      boolean isMirrored = place == MIRROR;
      for (Shape shape :
          new Shape[] {
            Mesh.baked(mesh, place), new MeshInstance(new SharedMesh(mesh), place),
          }) {
        SurfaceHit hit = hit(shape, isMirrored ? -1.5 : 1.5, .5);
        Frame frame = hit.shading();
        assertThat(frame.tangent().minus(isMirrored ? Vec3.X.negated() : Vec3.X).maxAbs())
            .isLessThan(1e-12);
        assertThat(frame.bitangent().minus(Vec3.Y.times(expected)).maxAbs()).isLessThan(1e-12);
      }
    }
  }

  @Test
  void tangentsOfLengthZeroStayFinite() {
    MeshAttributes zero = new MeshAttributes(new double[12], NONE, new float[0]);
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {0, 0, 0, 2, 0, 0, 0, 2, 0}, NONE, NONE, new int[] {0, 1, 2}, zero);
    SurfaceHit hit = hit(Mesh.baked(mesh, Transform.rotationDegrees(new Vec3(0, 0, 30))), 0, .5);
    assertThat(hit.shading().tangent().length()).isCloseTo(1, within(1e-12));
  }

  @Test
  void partsHaveTheirTrianglesAndVertices() {
    TriangleMesh part = square().part(new int[] {1});
    assertThat(part.triangleCount()).isEqualTo(1);
    assertThat(part.vertexCount()).isEqualTo(3);
    assertThat(part.droppedTriangles()).isZero();
    Vec3[] expected = {Vec3.ZERO, new Vec3(2, 2, 0), new Vec3(0, 2, 0)};
    TexturePoint[] points = {
      new TexturePoint(3, 5), new TexturePoint(5, 15), new TexturePoint(1, 13)
    };
    for (int corner = 0; corner < 3; corner++) {
      assertThat(part.position(part.vertex(0, corner))).isEqualTo(expected[corner]);
      assertThat(part.uv(0, corner)).isEqualTo(points[corner]);
      assertThat(part.normal(part.vertex(0, corner))).isEqualTo(Vec3.Z);
      assertThat(part.tangent(0, corner)).isEqualTo(Vec3.X);
    }
    assertThat(part.attributes().uv1()).containsExactly(-1, 2, -5, 2, 1, 0);
    assertThat(part.attributes().colors()).containsExactly(1, 2, 0, 0, 3, 4, 4, .5f, 1, 4, 2, 0);
  }

  @Test
  void partsOfPlainMeshesArePlain() {
    TriangleMesh plain =
        TriangleMesh.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, NONE, NONE, new int[] {2, 0, 1});
    TriangleMesh part = plain.part(new int[] {0});
    assertThat(part.hasNormals()).isFalse();
    assertThat(part.uv(0, 1)).isEqualTo(new TexturePoint(1, 0));
    assertThat(part.attributes().uv1()).isEmpty();
    assertThat(part.attributes().colors()).isEmpty();
    assertThat(part.attributes().tangents()).isEmpty();
    assertThat(plain.part(new int[0]).triangleCount()).isZero();
  }

  private static void assertRefused(Consumer<double[][]> change, String message) {
    double[][] parts = {new double[9], new double[9], new double[6], new double[12], new double[6]};
    parts[0][3] = 1;
    parts[0][7] = 1;
    change.accept(parts);
    assertThatThrownBy(
            () ->
                TriangleMesh.of(
                    parts[0],
                    parts[1],
                    parts[2],
                    new int[] {0, 1, 2},
                    new MeshAttributes(parts[3], parts[4], new float[12])))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(message);
  }

  @Test
  void brokenAttributesAreRefused() {
    assertRefused(p -> p[3] = new double[11], "tangents: expected a length of 0 or 12, found 11");
    assertRefused(p -> p[4] = new double[4], "uv1: expected a length of 0 or 6, found 4");
    assertRefused(p -> p[3][7] = Double.NaN, "tangents[7]: expected a finite number, found NaN");
    assertRefused(p -> p[4][2] = Double.POSITIVE_INFINITY, "uv1[2]: expected a finite number");
    assertRefused(p -> p[1] = new double[3], "normals: expected a length of 0 or 9, found 3");
    assertRefused(p -> p[2] = new double[8], "uvs: expected a length of 0 or 6, found 8");
    assertThatThrownBy(
            () ->
                TriangleMesh.of(
                    new double[9],
                    NONE,
                    NONE,
                    new int[] {0, 1, 2},
                    new MeshAttributes(NONE, NONE, new float[3])))
        .hasMessageStartingWith("colors: expected a length of 0 or 12, found 3");
  }

  @Test
  void droppedTrianglesAreCounted() {
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0},
            NONE,
            NONE,
            new int[] {0, 1, 3, 0, 1, 2, 0, 0, 1});
    assertThat(mesh.droppedTriangles()).isEqualTo(2);
    assertThat(mesh.triangleCount()).isEqualTo(1);
  }

  private static TriangleMesh tetrahedron(int... indices) {
    double[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -0.0, 1, -0.0};
    return TriangleMesh.of(positions, NONE, NONE, indices);
  }

  @Test
  void surfacesAreClosedIfEveryEdgeHasTwoSides() {
    int[] closed = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    // Vertex 4 is at the place of vertex 2.
    int[] repeated = {0, 1, 4, 0, 3, 1, 0, 2, 3, 1, 3, 4};
    int[] open = {0, 1, 2, 0, 3, 1, 0, 2, 3};
    for (int[] each : new int[][] {closed, repeated}) {
      assertThat(Mesh.baked(tetrahedron(each), MIRROR).isClosed()).isTrue();
      assertThat(new MeshInstance(new SharedMesh(tetrahedron(each)), MIRROR).isClosed()).isTrue();
    }
    assertThat(Mesh.baked(tetrahedron(open), MIRROR).isClosed()).isFalse();
    assertThat(new MeshInstance(new SharedMesh(tetrahedron(open)), MIRROR).isClosed()).isFalse();
    assertThat(new Sphere(MIRROR, 1).isClosed()).isTrue();
    assertThat(new Box(MIRROR, 1, 1, 1).isClosed()).isTrue();
    assertThat(new Rectangle(MIRROR, 1, 1, true).isClosed()).isFalse();
    assertThat(new Plane(MIRROR, true).isClosed()).isFalse();
  }

  @Test
  void placedMeshesHaveTheirAreaAndBounds() {
    TriangleMesh mesh = tetrahedron(0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2);
    Transform twice =
        Transform.translation(new Vec3(1, 2, 3)).times(Transform.scale(new Vec3(2, 2, 2)));
    double area = 4 * (1.5 + Math.sqrt(.75));
    for (Shape shape :
        new Shape[] {Mesh.baked(mesh, twice), new MeshInstance(new SharedMesh(mesh), twice)}) {
      assertThat(shape.area()).isCloseTo(area, within(1e-12));
      Bounds3 bounds = shape.bounds();
      assertThat(bounds.min().minus(new Vec3(1, 2, 3)).maxAbs()).isLessThan(1e-12);
      assertThat(bounds.max().minus(new Vec3(3, 4, 5)).maxAbs()).isLessThan(1e-12);
    }
  }

  /** Of all eight ways to lay the axes of a texture along those of a square. */
  @Test
  void framesFollowMirroredAndTurnedTextures() {
    for (int way = 0; way < 8; way++) {
      double[] uvs = new double[10];
      Vec3 alongU = ((way & 1) == 0 ? Vec3.X : Vec3.Y).times((way & 2) == 0 ? 1 : -1);
      Vec3 alongV = ((way & 1) == 0 ? Vec3.Y : Vec3.X).times((way & 4) == 0 ? 1 : -1);
      for (int i = 0; i < 5; i++) {
        uvs[2 * i] = 3 + square().position(i).dot(alongU);
        uvs[2 * i + 1] = 5 + square().position(i).dot(alongV);
      }
      TriangleMesh mesh =
          TriangleMesh.of(
              new double[] {7, 7, 7, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0},
              NONE,
              uvs,
              new int[] {1, 2, 3, 1, 3, 4});
      for (double[] at : new double[][] {{1.5, .5}, {.5, 1.5}}) {
        Frame frame = hit(Mesh.baked(mesh, Transform.IDENTITY), at[0], at[1]).shading();
        assertThat(frame.tangent().minus(alongU).maxAbs()).isLessThan(1e-12);
        assertThat(frame.bitangent().minus(alongV).maxAbs()).isLessThan(1e-12);
      }
    }
  }

  @Test
  void tangentsOfVerticesAreInterpolated() {
    double[] tangents = {1, 0, 0, 1, 0, 1, 0, 1, -.6, .8, 0, 1};
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {0, 0, 0, 2, 0, 0, 0, 2, 0},
            NONE,
            NONE,
            new int[] {0, 1, 2},
            new MeshAttributes(tangents, NONE, new float[0]));
    for (double[] at : new double[][] {{0.2, .3}, {1.2, .4}, {.3, 1.4}}) {
      double b1 = at[0] / 2;
      double b2 = at[1] / 2;
      Vec3 expected = new Vec3(1 - b1 - b2 - .6 * b2, b1 + .8 * b2, 0).normalized();
      Frame frame = hit(Mesh.baked(mesh, Transform.IDENTITY), at[0], at[1]).shading();
      assertThat(frame.tangent().minus(expected).maxAbs()).isLessThan(1e-12);
    }
  }

  @Test
  void bakedTangentsHaveLengthOne() {
    double[] mapped =
        new MeshAttributes(new double[] {.6, .8, 0, 1}, NONE, new float[0])
            .mapped(Transform.scale(new Vec3(5, 1, 2)))
            .tangents();
    double length = Math.sqrt(9 + .64);
    assertThat(mapped[0]).isCloseTo(3 / length, within(1e-12));
    assertThat(mapped[1]).isCloseTo(.8 / length, within(1e-12));
    assertThat(mapped[3]).isEqualTo(1);
  }

  @Test
  void theSecondSetIsTheFirstWhereAMeshHasOneOnly() {
    double[] uvs = {0, 0, 1, 0, 0, 1};
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {0, 0, 0, 2, 0, 0, 0, 2, 0},
            NONE,
            uvs,
            new int[] {0, 1, 2},
            new MeshAttributes(NONE, NONE, new float[] {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
    SurfaceHit hit = hit(Mesh.baked(mesh, Transform.IDENTITY), .5, .5);
    assertThat(hit.u(1)).isEqualTo(hit.u(0));
    assertThat(hit.v(1)).isEqualTo(hit.v(0));
  }

  @Test
  void numbersOfTheWrongRangeAreRefused() {
    double[] positions = {0, 0, 0, 2, 0, 0, 0, 2, 0};
    double[] normals = {0, 0, 1, 0, 0, Double.NaN, 0, 0, 1};
    assertThatThrownBy(() -> TriangleMesh.of(positions, normals, NONE, new int[] {0, 1, 2}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("normals");
    assertThatThrownBy(() -> TriangleMesh.of(positions, NONE, NONE, new int[] {0, 1, 3}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("indices[2]: expected 0 to 2, found 3");
  }
}
