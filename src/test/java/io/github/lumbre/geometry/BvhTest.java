package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Compares hits of the hierarchy with a test of every shape. */
class BvhTest {
  private static final Bounds3 AROUND = new Bounds3(new Vec3(-6, -6, -6), new Vec3(6, 6, 6));

  @ParameterizedTest
  @EnumSource(Kernel.class)
  void findsWhatAskingEveryShapeFinds(Kernel kernel) {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    for (int seed = 0; seed < 5; seed++) {
      Random random = new Random(Effort.seed(seed));
      List<Shape> shapes = Shapes.zoo(random, 10 + 20 * seed);
      int rays = Effort.brief(Effort.count(10_000, 200_000));
      assertSameAsBruteForce(kernel, shapes, random, rays, AROUND);
    }
  }

  private static void assertSameAsBruteForce(
      Kernel kernel, List<? extends Shape> shapes, Random random, int rays, Bounds3 around) {
    Bvh bvh = Bvh.over(shapes, kernel);
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
        Shape shape = shapes.get(found.shape());
        assertSameSurface(shape.surfaceAt(found), shape.surfaceAt(expected));
      }
    }
    assertThat(hits).isGreaterThan(rays / 20);
  }

  private static void assertSameSurface(SurfaceHit found, SurfaceHit expected) {
    assertThat(found.position()).isEqualTo(expected.position());
    assertThat(found.geometricNormal()).isEqualTo(expected.geometricNormal());
    assertThat(found.shading()).isEqualTo(expected.shading());
    assertThat(found.texture()).isEqualTo(expected.texture());
    assertThat(found.wo()).isEqualTo(expected.wo());
    assertThat(found.error()).isEqualTo(expected.error());
  }

  @ParameterizedTest
  @EnumSource(Kernel.class)
  void raysOnFacesAndThroughVerticesFindWhatAskingEveryTriangleFinds(Kernel kernel) {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    Mesh ball = Mesh.baked(Shapes.closedBall(8, 8, 0, false), Transform.IDENTITY);
    List<Mesh> triangles = Shapes.singly(ball);
    Bvh bvh = Bvh.over(triangles, kernel);
    TriangleMesh data = ball.triangles();
    Random random = new Random(1);
    NearestHit found = new NearestHit();
    NearestHit expected = new NearestHit();
    Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
    for (int i = 0; i < Effort.brief(5000); i++) {
      Vec3 a = data.position(random.nextInt(data.vertexCount()));
      Vec3 b = data.position(random.nextInt(data.vertexCount()));
      Vec3 axis = axes[random.nextInt(3)];
      Ray ray = i % 2 == 0 ? new Ray(a.plus(-2, axis), axis) : new Ray(b.times(2), a.minus(b), 5);
      if (ray.direction().maxAbs() > 0) {
        assertThat(bvh.intersect(ray, found))
            .isEqualTo(Shapes.bruteForce(triangles, ray, expected));
        assertThat(bvh.isOccluded(ray, new NearestHit())).isEqualTo(expected.isHit());
        assertThat(found.shape()).isEqualTo(expected.shape());
        assertThat(found.t()).isEqualTo(expected.t());
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Kernel.class)
  void axisAlignedRaysMeetFlatGrids(Kernel kernel) {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    List<Shape> tiles = new ArrayList<>();
    for (int i = 0; i < 64; i++) {
      Transform place = Transform.translation(new Vec3(i % 8, i % 3, i / 8));
      tiles.add(i % 2 == 0 ? new Rectangle(place, 1, 1, true) : tile(place));
    }
    Random random = new Random(2);
    Bvh bvh = Bvh.over(tiles, kernel);
    NearestHit found = new NearestHit();
    NearestHit expected = new NearestHit();
    for (int i = 0; i < Effort.brief(5000); i++) {
      // Half-integers are on borders, integers are in planes.
      Vec3 origin =
          new Vec3(.5 * random.nextInt(18) - 1, random.nextInt(5) - 1, .5 * random.nextInt(18) - 1);
      for (Vec3 direction :
          List.of(Vec3.X, Vec3.Y, Vec3.Z, new Vec3(-0.0, -1, -0.0), new Vec3(-1, -0.0, 0))) {
        Ray ray = new Ray(origin, direction);
        assertThat(bvh.intersect(ray, found)).isEqualTo(Shapes.bruteForce(tiles, ray, expected));
        assertThat(found.shape()).isEqualTo(expected.shape());
      }
    }
  }

  private static Shape tile(Transform place) {
    double[] p = {-.5, 0, -.5, .5, 0, -.5, .5, 0, .5, -.5, 0, .5};
    int[] f = {0, 1, 2, 0, 2, 3};
    return Mesh.baked(TriangleMesh.of(p, new double[0], new double[0], f), place);
  }

  @Test
  void tiesGoToTheLowestShapeAndElement() {
    Transform place = Shapes.rotation(new Random(3));
    List<Shape> shapes = new ArrayList<>();
    SharedMesh shared =
        new SharedMesh(Shapes.triangle(new Vec3(-1, 0, -1), new Vec3(1, 0, -1), new Vec3(0, 0, 1)));
    for (int i = 0; i < 40; i++) {
      shapes.add(
          switch (i % 4) {
            case 0 -> new MeshInstance(shared, place);
            case 1 -> new Rectangle(place, 2, 2, true);
            case 2 -> new Plane(place, true);
            default -> new Rectangle(place, 1 + i, 2, true);
          });
    }
    Random random = new Random(4);
    NearestHit found = new NearestHit();
    NearestHit expected = new NearestHit();
    for (int i = 0; i < 50; i++) {
      Collections.shuffle(shapes, random);
      Bvh bvh = Bvh.over(shapes);
      for (int k = 0; k < 100; k++) {
        Vec3 origin = Shapes.point(random, 2);
        Ray ray = new Ray(origin, Shapes.point(random, .5).minus(origin).normalized());
        assertThat(bvh.intersect(ray, found)).isEqualTo(Shapes.bruteForce(shapes, ray, expected));
        assertThat(found.shape()).isEqualTo(expected.shape());
      }
    }
    Mesh twice = Mesh.baked(doubled(shared.mesh()), place);
    NearestHit hit = new NearestHit();
    Vec3 above = place.point(Vec3.Y);
    Ray down = new Ray(above, above.negated());
    assertThat(Bvh.over(List.of(twice, twice, twice)).intersect(down, hit)).isTrue();
    assertThat(hit.shape()).isZero();
    assertThat(hit.element).isZero();
  }

  private static TriangleMesh doubled(TriangleMesh mesh) {
    double[] p = new double[9];
    mesh.copyVertices(0, p);
    int[] f = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2};
    return TriangleMesh.of(p, new double[0], new double[0], f);
  }

  @Test
  @DisabledIfSystemProperty(named = Effort.BRIEF, matches = "true")
  void identicalTrianglesMakeATreeOfBoundedDepth() {
    int[] f = new int[3 * 200_000];
    for (int i = 0; i < f.length; i++) {
      f[i] = i % 3;
    }
    double[] p = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
    TriangleMesh mesh = TriangleMesh.of(p, new double[0], new double[0], f);
    Bvh bvh = Bvh.over(List.of(Mesh.baked(mesh, Transform.IDENTITY)));
    NearestHit hit = new NearestHit();
    assertThat(bvh.intersect(new Ray(new Vec3(0, 0, -1), Vec3.Z), hit)).isTrue();
    assertThat(hit.element).isZero();
    assertThat(hit.t()).isEqualTo(1);
  }

  @Test
  void trianglesInGeometricProgressionMakeATreeOfBoundedDepth() {
    int n = 600;
    double[] p = new double[9 * n];
    int[] f = new int[3 * n];
    for (int i = 0; i < n; i++) {
      double size = Math.scalb(1.0, i - n / 2);
      double[] one = {size, 0, 0, size, size, 0, size, 0, size};
      System.arraycopy(one, 0, p, 9 * i, 9);
      for (int k = 0; k < 3; k++) {
        f[3 * i + k] = 3 * i + k;
      }
    }
    TriangleMesh mesh = TriangleMesh.of(p, new double[0], new double[0], f);
    Bvh bvh = Bvh.over(List.of(Mesh.baked(mesh, Transform.IDENTITY)));
    NearestHit hit = new NearestHit();
    assertThat(bvh.intersect(new Ray(new Vec3(-1, 0, 0), new Vec3(1, 1e-6, 1e-6)), hit)).isTrue();
    assertThat(hit.t()).isGreaterThan(0);
  }

  @Test
  void emptyHierarchiesAreNeverHit() {
    Bvh bvh = Bvh.over(List.of());
    assertThat(bvh.intersect(new Ray(Vec3.ZERO, Vec3.X), new NearestHit())).isFalse();
    assertThat(bvh.isOccluded(new Ray(Vec3.ZERO, Vec3.X), new NearestHit())).isFalse();
  }

  @Test
  void raysEndBeforeTheirEnd() {
    Bvh bvh = Bvh.over(List.of(tile(Transform.IDENTITY)));
    Ray touching = new Ray(new Vec3(.1, 2, .1), Vec3.Y.negated(), 2);
    Ray reaching = new Ray(new Vec3(.1, 2, .1), Vec3.Y.negated(), Math.nextUp(2.0));
    assertThat(bvh.isOccluded(touching, new NearestHit())).isFalse();
    assertThat(bvh.intersect(touching, new NearestHit())).isFalse();
    assertThat(bvh.isOccluded(reaching, new NearestHit())).isTrue();
    assertThat(bvh.intersect(reaching, new NearestHit())).isTrue();
  }

  @Test
  void flatBoxesAndBoxesOfOneCenterMakeATreeOfBoundedDepth() {
    int n = Effort.count(20_000, 1_000_000);
    double[] concentric = new double[9 * n];
    double[] flat = new double[9 * n];
    int[] f = new int[3 * n];
    Random random = new Random(Effort.seed(6));
    for (int i = 0; i < n; i++) {
      double size = 1 + (double) i / n;
      double[] around = {-size, -size, -size, size, -size, size, 0, size, 0};
      double x = random.nextInt(100);
      double[] tile = {x, 0, i % 100, x + 1, 0, i % 100, x, 0, i % 100 + 1};
      System.arraycopy(around, 0, concentric, 9 * i, 9);
      System.arraycopy(tile, 0, flat, 9 * i, 9);
      for (int k = 0; k < 3; k++) {
        f[3 * i + k] = 3 * i + k;
      }
    }
    NearestHit hit = new NearestHit();
    TriangleMesh nested = TriangleMesh.of(concentric, new double[0], new double[0], f);
    Bvh one = Bvh.over(List.of(Mesh.baked(nested, Transform.IDENTITY)));
    assertThat(one.intersect(new Ray(new Vec3(.1, .2, -9), Vec3.Z), hit)).isTrue();
    TriangleMesh tiles = TriangleMesh.of(flat, new double[0], new double[0], f);
    Bvh other = Bvh.over(List.of(Mesh.baked(tiles, Transform.IDENTITY)));
    assertThat(other.intersect(new Ray(new Vec3(50.2, 1, 50.3), Vec3.Y.negated()), hit)).isTrue();
    assertThat(hit.t()).isEqualTo(1);
  }

  /** A plane divided into triangles, whose corners, edges and rays are exact in doubles. */
  @Test
  void sharedEdgesBelongToTheLowestElement() {
    int side = 8;
    Random random = new Random(7);
    for (int order = 0; order < Math.max(1, Effort.brief(10)); order++) {
      Mesh grid = Mesh.baked(shuffledGrid(side, random), Transform.IDENTITY);
      List<Mesh> triangles = Shapes.singly(grid);
      for (Kernel kernel : Kernel.values()) {
        if (kernel == Kernel.VECTOR && Kernel.vectorObstacle().isPresent()) {
          continue;
        }
        Bvh bvh = Bvh.over(List.of(grid), kernel);
        NearestHit found = new NearestHit();
        for (int i = 0; i < 16 * side * side; i++) {
          Vec3 target = new Vec3(.25 * (i % (4 * side)), 0, .25 * (i / (4 * side)));
          Ray ray = new Ray(target.plus(new Vec3(2, 4, 1)), new Vec3(-2, -4, -1));
          NearestHit expected = new NearestHit();
          assertThat(bvh.intersect(ray, found)).isTrue();
          assertThat(Shapes.bruteForce(triangles, ray, expected)).isTrue();
          assertThat(found.t()).isEqualTo(1);
          assertThat(found.element).isEqualTo(expected.shape());
        }
      }
    }
  }

  private static TriangleMesh shuffledGrid(int side, Random random) {
    List<int[]> faces = new ArrayList<>();
    int row = side + 1;
    double[] p = new double[3 * row * row];
    for (int i = 0; i < row * row; i++) {
      p[3 * i] = i % row;
      p[3 * i + 2] = i / row;
      if (i % row < side && i / row < side) {
        faces.add(new int[] {i, i + 1, i + row});
        faces.add(new int[] {i + 1, i + row + 1, i + row});
      }
    }
    Collections.shuffle(faces, random);
    int[] f = faces.stream().flatMapToInt(Arrays::stream).toArray();
    return TriangleMesh.of(p, new double[0], new double[0], f);
  }

  /** A ray is occluded exactly if its nearest hit is before its end, to the last bit. */
  @Test
  void occlusionAgreesWithTheNearestHitAtItsVeryEnd() {
    Random random = new Random(Effort.seed(8));
    Bvh bvh = Bvh.over(Shapes.zoo(random, 60));
    NearestHit nearest = new NearestHit();
    NearestHit scratch = new NearestHit();
    for (int i = 0; i < Effort.brief(Effort.count(10_000, 1_000_000)); i++) {
      Ray ray = Shapes.ray(random, AROUND);
      if (bvh.intersect(ray, nearest)) {
        for (double end : new double[] {.5 * nearest.t(), nearest.t(), Math.nextUp(nearest.t())}) {
          Ray cut = new Ray(ray.origin(), ray.direction(), end);
          assertThat(bvh.isOccluded(cut, scratch)).isEqualTo(nearest.t() < end);
          assertThat(bvh.intersect(cut, scratch)).isEqualTo(nearest.t() < end);
        }
      }
    }
  }

  @Test
  void scenesScaledByAPowerOfTwoGiveTheSameBits() {
    Random random = new Random(5);
    SharedMesh ball = new SharedMesh(Shapes.closedBall(6, 8, .2, true));
    List<Transform> places = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      places.add(Shapes.placement(random, 5, 4));
    }
    for (int exponent : new int[] {-30, -1, 10, 30}) {
      double scale = Math.scalb(1.0, exponent);
      List<Shape> plain = zooAt(places, ball, 1);
      List<Shape> scaled = zooAt(places, ball, scale);
      Bvh plainBvh = Bvh.over(plain);
      Bvh scaledBvh = Bvh.over(scaled);
      NearestHit a = new NearestHit();
      NearestHit b = new NearestHit();
      for (int i = 0; i < Effort.brief(3000); i++) {
        Ray ray = new Ray(Shapes.point(random, 6), Shapes.direction(random));
        Ray scaledRay = new Ray(ray.origin().times(scale), ray.direction());
        assertThat(scaledBvh.intersect(scaledRay, b)).isEqualTo(plainBvh.intersect(ray, a));
        assertThat(b.shape()).isEqualTo(a.shape());
        if (a.isHit()) {
          assertThat(b.t()).isEqualTo(scale * a.t());
          SurfaceHit p = plain.get(a.shape()).surfaceAt(a);
          SurfaceHit q = scaled.get(b.shape()).surfaceAt(b);
          assertThat(q.position()).isEqualTo(p.position().times(scale));
          assertThat(q.error()).isEqualTo(p.error() * scale);
          assertThat(q.geometricNormal()).isEqualTo(p.geometricNormal());
          assertThat(q.shading()).isEqualTo(p.shading());
          assertThat(q.texture()).isEqualTo(p.texture());
        }
      }
    }
  }

  private static List<Shape> zooAt(List<Transform> places, SharedMesh ball, double scale) {
    List<Shape> shapes = new ArrayList<>();
    for (Transform place : places) {
      Transform scaled = Transform.scale(new Vec3(scale, scale, scale)).times(place);
      shapes.add(
          switch (shapes.size() % 6) {
            case 0 -> new Sphere(scaled, .5);
            case 1 -> new Rectangle(scaled, 1, 2, false);
            case 2 -> new Box(scaled, 1, .5, .7);
            case 3 -> Mesh.baked(ball.mesh(), scaled);
            case 4 -> new MeshInstance(ball, scaled);
            default -> new Rectangle(scaled, .3, 2, true);
          });
    }
    return shapes;
  }

  @Test
  void laterHierarchiesAreBuiltByTheFirstRay() {
    Random random = new Random(3);
    List<Shape> shapes = Shapes.zoo(random, 50);
    int[] builds = new int[1];
    Traversal late =
        new LateTraversal(
            () -> {
              builds[0]++;
              return Kernel.SCALAR.over(new BvhItems(shapes));
            });
    Bvh later = Bvh.later(shapes, Kernel.AUTO);
    assertThat(later.bounded()).isInstanceOf(LateTraversal.class);
    Bvh expected = Bvh.over(shapes, Kernel.SCALAR);
    NearestHit found = new NearestHit();
    NearestHit nearest = new NearestHit();
    assertThat(builds[0]).isZero();
    for (int i = 0; i < 500; i++) {
      Ray ray = Shapes.ray(random, AROUND);
      boolean isHit = expected.intersect(ray, nearest);
      assertThat(later.intersect(ray, found)).isEqualTo(isHit);
      assertThat(found.shape()).isEqualTo(nearest.shape());
      assertThat(found.t()).isEqualTo(nearest.t());
      Vec3 o = ray.origin();
      Vec3 d = ray.direction();
      found.aim(ray);
      late.traverse(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), found);
      assertThat(builds[0]).isEqualTo(1);
    }
  }
}
