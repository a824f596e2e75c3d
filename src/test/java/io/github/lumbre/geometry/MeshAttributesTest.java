package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;

/** Tests vertex colors, a second set of texture coordinates and tangents of meshes. */
class MeshAttributesTest {
  private static final double[] CORNER = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  private static final double[] NORMALS = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  private static final double[] UVS = {0, 0, 1, 0, 0, 1};
  private static final int[] ONE = {0, 1, 2};
  private static final Ray RAY = new Ray(new Vec3(.25, .5, 3), Vec3.Z.negated());

  private static TriangleMesh mesh(MeshAttributes attributes) {
    return TriangleMesh.of(CORNER, NORMALS, UVS, ONE, attributes);
  }

  private static Shape[] placed(MeshAttributes attributes, Transform place) {
    TriangleMesh mesh = mesh(attributes);
    return new Shape[] {
      Mesh.baked(mesh, place), new MeshInstance(new SharedMesh(mesh), place),
    };
  }

  @Test
  void colorsAndSecondCoordinatesAreInterpolated() {
    MeshAttributes attributes =
        new MeshAttributes(
            new double[0],
            new double[] {10, 0, 20, 0, 10, 8},
            new float[] {1, 0, 0, 1, 0, 1, 0, .5f, 0, 0, 1, 0});
    for (Shape shape : placed(attributes, Transform.IDENTITY)) {
      SurfaceHit hit = Shapes.hit(shape, RAY).orElseThrow();
      // Barycentric weights 0.25, 0.25 and 0.5.
      assertThat(hit.vertexColor().r()).isCloseTo(.25, within(1e-12));
      assertThat(hit.vertexColor().g()).isCloseTo(.25, within(1e-12));
      assertThat(hit.vertexColor().b()).isCloseTo(.5, within(1e-12));
      assertThat(hit.vertexAlpha()).isCloseTo(.375, within(1e-12));
      assertThat(hit.u(1)).isCloseTo(12.5, within(1e-12));
      assertThat(hit.v(1)).isCloseTo(4, within(1e-12));
      assertThat(hit.u(0)).isCloseTo(.25, within(1e-12));
    }
  }

  @Test
  void surfacesWithoutAttributesAreWhiteAndHaveOneSet() {
    SurfaceHit hit = Shapes.hit(placed(MeshAttributes.NONE, Transform.IDENTITY)[0], RAY).get();
    assertThat(hit.vertexColor()).isEqualTo(Rgb.WHITE);
    assertThat(hit.vertexAlpha()).isEqualTo(1);
    assertThat(hit.u(1)).isEqualTo(hit.u(0));
    assertThat(hit.v(1)).isEqualTo(hit.v(0));
  }

  @Test
  void attributesDoNotOutliveTheirHit() {
    MeshAttributes red =
        new MeshAttributes(
            new double[0], new double[0], new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    SurfaceHit hit = Shapes.hit(placed(red, Transform.IDENTITY)[0], RAY).orElseThrow();
    assertThat(hit.vertexAlpha()).isZero();
    hit.set(Vec3.ZERO, Vec3.Z, Frame.WORLD, new TexturePoint(0, 0), Vec3.Z, 0);
    assertThat(hit.vertexAlpha()).isEqualTo(1);
    assertThat(hit.vertexColor()).isEqualTo(Rgb.WHITE);
  }

  /** Under a mirroring transform, the bitangent is the image of the bitangent. */
  @Test
  void tangentsMoveWithTheirMesh() {
    Vec3 tangent = new Vec3(.6, .8, 0);
    for (double sign : new double[] {1, -1}) {
      double[] tangents = {.6, .8, 0, sign, .6, .8, 0, sign, .6, .8, 0, sign};
      MeshAttributes attributes = new MeshAttributes(tangents, new double[0], new float[0]);
      for (Transform place :
          new Transform[] {
            Transform.IDENTITY,
            Transform.rotationDegrees(new Vec3(0, 0, 90)),
            Transform.scale(new Vec3(1, 1, -1)),
            Transform.scale(new Vec3(-1, 1, 1)),
          }) {
        Vec3 up = place.vector(Vec3.Z);
        Vec3 target = place.point(new Vec3(.25, .5, 0));
        Ray ray = new Ray(target.plus(3, up), up.negated());
        for (Shape shape : placed(attributes, place)) {
          SurfaceHit hit = Shapes.hit(shape, ray).orElseThrow();
          Vec3 expected = place.vector(tangent);
          Vec3 bitangent = place.vector(Vec3.Z.cross(tangent).times(sign));
          assertThat(hit.toWorld(Vec3.X).minus(expected).length()).isLessThan(1e-12);
          assertThat(hit.toWorld(Vec3.Y).minus(bitangent).length()).isLessThan(1e-12);
        }
      }
    }
  }
}
