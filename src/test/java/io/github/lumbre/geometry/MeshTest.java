package io.github.lumbre.geometry;

import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests triangle meshes: hits, normals, texture coordinates and degenerate data. */
class MeshTest {
  private static final double[] NONE = {};
  private static final double[] CORNER = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  private static final int[] ONE = {0, 1, 2};
  private static final Transform MIRROR = Transform.scale(new Vec3(-1, 1, 1));

  private static SurfaceHit hit(TriangleMesh mesh, Transform place, Vec3 origin, Vec3 direction) {
    return Shapes.hit(Mesh.baked(mesh, place), new Ray(origin, direction)).orElseThrow();
  }

  @Test
  void trianglesWithoutAreaAreDroppedAndCounted() {
    double[] p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 1e-160, 0, 0, 0, 1e-160, 0};
    int[] f = {0, 1, 2, 0, 1, 1, 0, 0, 0, 0, 1, 3, 0, 4, 5};
    TriangleMesh mesh = TriangleMesh.of(p, NONE, NONE, f);
    assertThat(mesh.triangleCount()).isEqualTo(2);
    assertThat(mesh.droppedTriangles()).isEqualTo(3);
    assertThat(mesh.bounds().max()).isEqualTo(new Vec3(1, 1, 0));
  }

  @Test
  void meshesWithoutTrianglesAreNeverHit() {
    TriangleMesh empty = TriangleMesh.of(NONE, NONE, NONE, new int[0]);
    Mesh mesh = Mesh.baked(empty, Transform.IDENTITY);
    MeshInstance instance = new MeshInstance(new SharedMesh(empty), Transform.IDENTITY);
    assertThat(mesh.area()).isZero();
    Bvh bvh = Bvh.over(List.of(mesh, instance));
    assertThat(bvh.intersect(new Ray(Vec3.ZERO, Vec3.Z), new NearestHit())).isFalse();
  }

  @Test
  void brokenDataIsRejected() {
    double[] nan = {0, 0, Double.NaN, 1, 0, 0, 0, 1, 0};
    assertRejected("positions[2]", nan, NONE, NONE, ONE);
    assertRejected("positions", new double[] {1, 2}, NONE, NONE, ONE);
    assertRejected("indices[2]", CORNER, NONE, NONE, new int[] {0, 1, 3});
    assertRejected("indices[0]", CORNER, NONE, NONE, new int[] {-1, 1, 2});
    assertRejected("indices", CORNER, NONE, NONE, new int[] {0, 1});
    assertRejected("normals", CORNER, new double[3], NONE, ONE);
    assertRejected("uvs", CORNER, NONE, new double[3], ONE);
    double[] infinite = {0, 0, 0, 0, 0, Double.POSITIVE_INFINITY};
    assertRejected("uvs[5]", CORNER, NONE, infinite, ONE);
  }

  private static void assertRejected(
      String what, double[] positions, double[] normals, double[] uvs, int[] indices) {
    assertThatThrownBy(() -> TriangleMesh.of(positions, normals, uvs, indices))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(what + ":");
  }

  @Test
  void geometricNormalIsTheCrossProductOnTheVertexNormalsSide() {
    Vec3 origin = new Vec3(.2, .2, -1);
    TriangleMesh plain = TriangleMesh.of(CORNER, NONE, NONE, ONE);
    assertThat(hit(plain, Transform.IDENTITY, origin, Vec3.Z).geometricNormal()).isEqualTo(Vec3.Z);
    double[] down = {0, 0, -1, 0, 0, -1, .1, 0, -1};
    TriangleMesh turned = TriangleMesh.of(CORNER, down, NONE, ONE);
    Vec3 normal = hit(turned, Transform.IDENTITY, origin, Vec3.Z).geometricNormal();
    assertThat(normal.z()).isEqualTo(-1);
  }

  /** Vertex normals on the back do not turn the triangle, but are moved to the front themselves. */
  @Test
  void frontMayBeThatOfTheWinding() {
    Vec3 up = Vec3.Z.negated();
    for (double[] n :
        new double[][] {
          {0, 0, 1, .6, 0, .8, 0, 0, 1},
          {0, 0, -1, -.6, 0, -.8, 0, 0, -1},
          {0, 0, 1, .6, 0, -.8, 0, 0, 1}
        }) {
      TriangleMesh mesh =
          TriangleMesh.of(CORNER, n, NONE, ONE, MeshAttributes.NONE, TriangleMesh.Front.WINDING);
      assertThat(mesh.isPlain()).isEqualTo(n[5] > 0);
      for (TriangleMesh each : List.of(mesh, mesh.part(new int[] {0}))) {
        SurfaceHit hit = hit(each, Transform.IDENTITY, new Vec3(.5, .25, 1), up);
        assertThat(hit.geometricNormal()).isEqualTo(Vec3.Z);
        assertNear(hit.shadingNormal(), new Vec3(.3, 0, .9).normalized(), 1e-14);
        SurfaceHit mirrored = hit(each, MIRROR, MIRROR.point(new Vec3(.5, .25, 1)), up);
        assertNear(mirrored.geometricNormal(), MIRROR.vector(hit.geometricNormal()), 1e-14);
        assertNear(mirrored.shadingNormal(), MIRROR.vector(hit.shadingNormal()), 1e-14);
      }
    }
    assertThat(TriangleMesh.of(CORNER, new double[] {0, 0, -1, 0, 0, -1, 0, 0, -1}, NONE, ONE))
        .matches(TriangleMesh::isPlain);
  }

  @Test
  void mirroredMeshesGiveMirroredHits() {
    TriangleMesh smooth = Shapes.closedBall(8, 12, .2, true);
    TriangleMesh facets = Shapes.closedBall(8, 12, .2, false);
    Random random = new Random(1);
    for (TriangleMesh data : List.of(smooth, facets)) {
      for (int i = 0; i < Effort.brief(500); i++) {
        Vec3 from = Shapes.direction(random);
        Vec3 to = Shapes.point(random, .3);
        Vec3 origin = from.times(3);
        Vec3 direction = to.minus(origin).normalized();
        Vec3 mirroredOrigin = MIRROR.point(origin);
        Vec3 mirroredDirection = MIRROR.vector(direction);
        SurfaceHit plain = hit(data, Transform.IDENTITY, origin, direction);
        SurfaceHit mirrored = hit(data, MIRROR, mirroredOrigin, mirroredDirection);
        assertThat(
                Shapes.distance(
                    Mesh.baked(data, MIRROR), new Ray(mirroredOrigin, mirroredDirection)))
            .isEqualTo(
                Shapes.distance(Mesh.baked(data, Transform.IDENTITY), new Ray(origin, direction)));
        assertNear(mirrored.position(), MIRROR.point(plain.position()), 1e-14);
        assertNear(mirrored.geometricNormal(), MIRROR.vector(plain.geometricNormal()), 1e-14);
        Frame frame = mirrored.shading();
        assertNear(frame.normal(), MIRROR.vector(plain.shading().normal()), 1e-14);
        assertNear(frame.tangent(), MIRROR.vector(plain.shading().tangent()), 1e-14);
        assertNear(frame.bitangent(), MIRROR.vector(plain.shading().bitangent()), 1e-14);
        assertThat(mirrored.texture()).isEqualTo(plain.texture());
      }
    }
  }

  @Test
  void bakedAndInstancedMeshesAgree() {
    TriangleMesh data = Shapes.closedBall(8, 12, .2, true);
    SharedMesh shared = new SharedMesh(data);
    Random random = new Random(2);
    int hits = 0;
    for (int i = 0; i < Effort.brief(3000); i++) {
      Transform place = Shapes.placement(random, 3, 4);
      place = i % 2 == 0 ? place : place.times(MIRROR);
      Vec3 origin = Shapes.point(random, 6);
      Vec3 target = place.point(Shapes.point(random, .5));
      Ray ray = new Ray(origin, target.minus(origin).normalized());
      NearestHit a = new NearestHit();
      NearestHit b = new NearestHit();
      Bvh baked = Bvh.over(List.of(Mesh.baked(data, place)));
      MeshInstance instance = new MeshInstance(shared, place);
      boolean isHit = baked.intersect(ray, a);
      assertThat(Bvh.over(List.of(instance)).intersect(ray, b)).isEqualTo(isHit);
      if (isHit) {
        hits++;
        assertThat(b.t / a.t).isCloseTo(1, within(1e-9));
        assertThat(b.element).isEqualTo(a.element);
        SurfaceHit expected = Mesh.baked(data, place).surfaceAt(a);
        SurfaceHit found = instance.surfaceAt(b);
        assertThat(found.position().minus(expected.position()).length()).isLessThan(1e-9);
        assertNear(found.geometricNormal(), expected.geometricNormal(), 1e-14);
        Vec3 bend = found.shading().normal().minus(expected.shading().normal());
        assertThat(bend.length()).isLessThan(1e-9);
      }
    }
    assertThat(hits).isGreaterThan(Effort.brief(2000));
  }

  @Test
  void shadingNormalIsInterpolatedButNeverBehindTheSurface() {
    double[] normals = {0, 0, 1, 1, 0, 0, 0, 0, 2};
    TriangleMesh mesh = TriangleMesh.of(CORNER, normals, NONE, ONE);
    SurfaceHit hit = hit(mesh, Transform.IDENTITY, new Vec3(.5, .25, 1), Vec3.Z.negated());
    Vec3 expected = new Vec3(.5, 0, .5).normalized();
    assertNear(hit.shading().normal(), expected, 1e-14);
    double[] against = {0, 0, 9, 0, 0, -1, 0, 0, -1};
    TriangleMesh wild = TriangleMesh.of(CORNER, against, NONE, ONE);
    SurfaceHit behind = hit(wild, Transform.IDENTITY, new Vec3(.9, .05, 1), Vec3.Z.negated());
    assertThat(behind.shading().normal()).isEqualTo(behind.geometricNormal());
    double[] zero = new double[9];
    TriangleMesh none = TriangleMesh.of(CORNER, zero, NONE, ONE);
    SurfaceHit flat = hit(none, Transform.IDENTITY, new Vec3(.2, .2, 1), Vec3.Z.negated());
    assertThat(flat.shading().normal()).isEqualTo(Vec3.Z);
  }

  @Test
  void tangentsFollowTheTexture() {
    double[] uvs = {0, 0, 0, 1, 2, 0};
    TriangleMesh mesh = TriangleMesh.of(CORNER, NONE, uvs, ONE);
    Vec3 origin = new Vec3(.25, .5, 1);
    SurfaceHit hit = hit(mesh, Transform.IDENTITY, origin, Vec3.Z.negated());
    assertThat(hit.texture().u()).isEqualTo(1);
    assertThat(hit.texture().v()).isEqualTo(.25);
    assertNear(hit.shading().tangent(), Vec3.Y, 1e-14);
    assertNear(hit.shading().bitangent(), Vec3.X, 1e-14);
  }

  @Test
  void missingTextureCoordinatesAreBarycentric() {
    TriangleMesh mesh = TriangleMesh.of(CORNER, NONE, NONE, ONE);
    SurfaceHit hit = hit(mesh, Transform.IDENTITY, new Vec3(.25, .5, 1), Vec3.Z.negated());
    assertThat(hit.texture().u()).isEqualTo(.25);
    assertThat(hit.texture().v()).isEqualTo(.5);
    assertNear(hit.shading().tangent(), Vec3.X, 1e-14);
    assertNear(hit.shading().bitangent(), Vec3.Y, 1e-14);
  }

  @Test
  void degenerateTextureCoordinatesFallBackToTheNormal() {
    for (double[] uvs : new double[][] {{1, 1, 1, 1, 1, 1}, {0, 0, .1, .1, .3, .3}}) {
      TriangleMesh mesh = TriangleMesh.of(CORNER, NONE, uvs, ONE);
      SurfaceHit hit = hit(mesh, Transform.IDENTITY, new Vec3(.2, .2, 1), Vec3.Z.negated());
      assertThat(hit.shading()).isEqualTo(Frame.around(Vec3.Z));
    }
  }

  /**
   * Rays farther from a border than the rounding error hit a sliver exactly if the exact ray does.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9, 1e-12})
  void sliversAreHitWhereExactArithmeticSaysSo(double width) {
    Random random = new Random(Effort.seed(3));
    int rays = Effort.brief(Effort.count(1500, 100_000));
    int hits = 0;
    int decided = 0;
    for (int i = 0; i < rays; i++) {
      Frame frame = Frame.around(Shapes.direction(random));
      Vec3 a = Shapes.point(random, 1);
      Vec3 b = a.plus(frame.tangent());
      Vec3 c = a.plus(random.nextDouble(), frame.tangent()).plus(width, frame.bitangent());
      Mesh sliver = Mesh.baked(Shapes.triangle(a, b, c), Transform.IDENTITY);
      Vec3 target =
          a.plus(random.nextDouble(), frame.tangent())
              .plus(width * random.nextDouble(-.5, 1), frame.bitangent());
      Vec3 origin = target.plus(random.nextDouble(-3, 3), Shapes.direction(random));
      Ray ray = new Ray(origin, target.minus(origin).normalized());
      Optional<SurfaceHit> hit = Shapes.hit(sliver, ray);
      hit.ifPresent(h -> assertThat(h.geometricNormal().isFinite()).isTrue());
      ExactTriangle exactly = new ExactTriangle(ray, a, b, c);
      if (exactly.distanceFromBorder() > 4 * Math.ulp(4.0)) {
        decided++;
        assertThat(hit.isPresent()).as("%s %s %s %s", ray, a, b, c).isEqualTo(exactly.isHit());
        hits += exactly.isHit() ? 1 : 0;
      }
    }
    assertThat(decided).isGreaterThan(width < 1e-9 ? rays / 2 : rays * 9 / 10);
    assertThat(hits).isGreaterThan(rays / 5);
  }

  /** An intersection test of a ray and a triangle in exact arithmetic. */
  private static final class ExactTriangle {
    private final BigDecimal[] edges = new BigDecimal[3];
    private final double[] distances = new double[3];
    private final int sideOfOrigin;
    private final int sideOfDirection;

    ExactTriangle(Ray ray, Vec3 a, Vec3 b, Vec3 c) {
      Vec3[] corners = {a, b, c};
      BigDecimal[] d = exact(ray.direction());
      for (int i = 0; i < 3; i++) {
        Vec3 p = corners[i];
        Vec3 q = corners[(i + 1) % 3];
        edges[i] = dot(d, cross(from(ray.origin(), p), from(ray.origin(), q)));
        double length = ray.direction().cross(q.minus(p)).length();
        distances[i] = Math.abs(edges[i].doubleValue()) / length;
      }
      BigDecimal[] normal = cross(from(a, b), from(a, c));
      sideOfOrigin = dot(normal, from(ray.origin(), a)).signum();
      sideOfDirection = dot(normal, d).signum();
    }

    boolean isHit() {
      int sum = edges[0].signum() + edges[1].signum() + edges[2].signum();
      return Math.abs(sum) == 3 && sideOfOrigin == sideOfDirection;
    }

    /** Returns the distance of the ray's line from the lines of the edges. */
    double distanceFromBorder() {
      return Math.min(distances[0], Math.min(distances[1], distances[2]));
    }

    private static BigDecimal[] exact(Vec3 v) {
      return new BigDecimal[] {new BigDecimal(v.x()), new BigDecimal(v.y()), new BigDecimal(v.z())};
    }

    private static BigDecimal[] from(Vec3 start, Vec3 end) {
      BigDecimal[] a = exact(start);
      BigDecimal[] b = exact(end);
      return new BigDecimal[] {b[0].subtract(a[0]), b[1].subtract(a[1]), b[2].subtract(a[2])};
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
      return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    private static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
      BigDecimal[] result = new BigDecimal[3];
      for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        result[i] = a[j].multiply(b[k]).subtract(a[k].multiply(b[j]));
      }
      return result;
    }
  }

  @Test
  void tinyAndLongTrianglesHaveNormals() {
    TriangleMesh tiny =
        TriangleMesh.of(new double[] {0, 0, 0, 1e-150, 0, 0, 0, 1e-150, 0}, NONE, NONE, ONE);
    assertThat(tiny.droppedTriangles()).isZero();
    Mesh mesh = Mesh.baked(tiny, Transform.IDENTITY);
    NearestHit nearest = new NearestHit();
    nearest.element = 0;
    nearest.b1 = .25;
    nearest.aim(new Ray(Vec3.Z, Vec3.Z.negated()));
    assertThat(mesh.surfaceAt(nearest).geometricNormal()).isEqualTo(Vec3.Z);
    TriangleMesh sliver =
        TriangleMesh.of(new double[] {0, 0, 0, 1e6, 0, 0, 5e5, 1e-6, 0}, NONE, NONE, ONE);
    SurfaceHit hit = hit(sliver, Transform.IDENTITY, new Vec3(5e5, 4e-7, 1), Vec3.Z.negated());
    assertThat(hit.geometricNormal()).isEqualTo(Vec3.Z);
    assertThat(hit.position().minus(new Vec3(5e5, 4e-7, 0)).length()).isLessThan(1e-9);
  }
}
