package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A ray that {@linkplain NearestHit#pass passes} each surface meets all of them once, in the order
 * of t, shape and part of the shape, also where surfaces coincide.
 */
class PassedHitsTest {
  private static final Bounds3 AROUND = new Bounds3(new Vec3(-3, -3, -3), new Vec3(3, 3, 3));
  private static final double[] NO_ATTRIBUTE = {};

  /** A hit, in the order in which a ray meets hits. */
  private record Hit(double t, int shape, int element) implements Comparable<Hit> {
    private static final Comparator<Hit> ORDER =
        Comparator.comparingLong((Hit hit) -> Double.doubleToRawLongBits(hit.t))
            .thenComparingInt(Hit::shape)
            .thenComparingInt(Hit::element);

    @Override
    public int compareTo(Hit o) {
      return ORDER.compare(this, o);
    }
  }

  /** Returns all hits along a ray, in the order in which a hierarchy finds them. */
  private static List<Hit> passing(Bvh bvh, Ray ray) {
    List<Hit> hits = new ArrayList<>();
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    while (bvh.intersect(nearest)) {
      hits.add(new Hit(nearest.t(), nearest.shape(), nearest.element()));
      if (hits.size() > 50_000) {
        throw new AssertionError("no end of hits of " + ray);
      }
      nearest.pass();
    }
    assertThat(nearest.isHit()).isFalse();
    assertThat(nearest.t()).isEqualTo(ray.tMax());
    assertThat(nearest.origin()).isEqualTo(ray.origin());
    assertThat(nearest.direction()).isEqualTo(ray.direction());
    return hits;
  }

  /** Shapes, and the triangles of those that are meshes, each on its own. */
  private record Parts(List<Shape> shapes, List<List<? extends Shape>> triangles) {
    static Parts of(List<Shape> shapes) {
      return new Parts(shapes, shapes.stream().<List<? extends Shape>>map(Parts::of).toList());
    }

    private static List<? extends Shape> of(Shape shape) {
      if (shape instanceof Mesh mesh) {
        return Shapes.singly(mesh);
      }
      if (shape instanceof MeshInstance instance) {
        TriangleMesh local = instance.shared().mesh();
        return IntStream.range(0, local.triangleCount())
            .mapToObj(i -> new SharedMesh(local.part(new int[] {i})))
            .map(one -> new MeshInstance(one, instance.toWorld()))
            .toList();
      }
      return List.of();
    }

    /** Returns all hits along a ray by a test of each shape and each triangle. */
    List<Hit> bruteForce(Ray ray) {
      List<Hit> hits = new ArrayList<>();
      for (int number = 0; number < shapes.size(); number++) {
        if (triangles.get(number).isEmpty()) {
          addRoots(shapes.get(number), number, ray, hits);
        } else {
          add(triangles.get(number), number, ray, hits);
        }
      }
      Collections.sort(hits);
      return hits;
    }
  }

  private static void add(List<? extends Shape> parts, int number, Ray ray, List<Hit> hits) {
    for (int element = 0; element < parts.size(); element++) {
      double t = Shapes.distance(parts.get(element), ray);
      if (t == t) {
        hits.add(new Hit(t, number, element));
      }
    }
  }

  private static void addRoots(Shape shape, int number, Ray ray, List<Hit> hits) {
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    nearest.shape = 0;
    for (int root = 0; shape.intersect(nearest); root++) {
      assertThat(root).isLessThan(2);
      hits.add(new Hit(nearest.t(), number, nearest.element()));
      nearest.shape = 0;
      nearest.pass();
    }
  }

  private static Mesh quad(Transform place) {
    double[] p = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    int[] f = {0, 2, 1, 0, 3, 2};
    return Mesh.baked(TriangleMesh.of(p, NO_ATTRIBUTE, NO_ATTRIBUTE, f), place);
  }

  /** Returns shapes of all kinds, many of which coincide with others wholly or in part. */
  private static List<Shape> coinciding(Random random, int places) {
    SharedMesh ball = new SharedMesh(Shapes.closedBall(5, 6, .2, false));
    List<Shape> shapes = new ArrayList<>();
    for (int i = 0; i < places; i++) {
      Transform place =
          i % 3 == 0
              ? Transform.translation(new Vec3(random.nextInt(3) - 1, random.nextInt(3) - 1, 0))
              : Shapes.placement(random, 2, 2);
      SharedMesh flat = new SharedMesh(quad(Transform.IDENTITY).triangles());
      List<Shape> here =
          List.of(
              quad(place),
              quad(place),
              new MeshInstance(flat, place),
              new MeshInstance(flat, place),
              new Rectangle(place, 2, 2, true),
              new Rectangle(place, 1, 1.5, i % 2 == 0),
              new Box(place, 2, 2, 2),
              new Box(place, 2, 2, 2),
              new Sphere(place, 1),
              new Sphere(place, 1),
              new MeshInstance(ball, place),
              Mesh.baked(ball.mesh(), place),
              new Plane(place, i % 2 == 0));
      here.stream().filter(shape -> random.nextInt(3) > 0).forEach(shapes::add);
    }
    Collections.shuffle(shapes, random);
    return shapes;
  }

  private static Bvh hierarchy(List<Shape> shapes, Kernel kernel) {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    return Bvh.over(shapes, kernel);
  }

  private static int assertAllAreMet(Bvh bvh, Parts parts, Ray ray) {
    List<Hit> expected = parts.bruteForce(ray);
    assertThat(passing(bvh, ray)).as("hits of %s", ray).isEqualTo(expected);
    return expected.size();
  }

  @ParameterizedTest
  @EnumSource(Kernel.class)
  void eachSurfaceIsMetOnceInOrder(Kernel kernel) {
    for (int seed = 0; seed < Effort.count(4, 200); seed++) {
      Random random = new Random(Effort.seed(seed));
      List<Shape> shapes = coinciding(random, 1 + 3 * seed % 12);
      Bvh bvh = hierarchy(shapes, kernel);
      Parts parts = Parts.of(shapes);
      long hits = 0;
      for (int i = 0; i < Effort.brief(300); i++) {
        Ray ray = Shapes.ray(random, AROUND);
        hits += assertAllAreMet(bvh, parts, ray);
        double factor = Math.scalb(1.0, random.nextInt(60) - 30);
        hits += assertAllAreMet(bvh, parts, new Ray(ray.origin(), ray.direction().times(factor)));
      }
      assertThat(hits).isGreaterThan(Effort.brief(600));
    }
  }

  @Test
  void theCountingTraversalMeetsEachSurfaceOnceInOrder() {
    Random random = new Random(9);
    List<Shape> shapes = coinciding(random, 5);
    Bvh bvh = Bvh.counting(shapes, new LongAdder());
    Parts parts = Parts.of(shapes);
    int hits = 0;
    for (int i = 0; i < 200; i++) {
      hits += assertAllAreMet(bvh, parts, Shapes.ray(random, AROUND));
    }
    assertThat(hits).isGreaterThan(400);
  }

  /** Rays in planes, along edges and through vertices, where slabs have no thickness. */
  @ParameterizedTest
  @EnumSource(Kernel.class)
  void eachSurfaceOfAGridIsMetOnce(Kernel kernel) {
    List<Shape> shapes = new ArrayList<>();
    for (int i = 0; i < 54; i++) {
      Transform place = Transform.translation(new Vec3(i % 3, i / 3 % 3, i / 9 % 3));
      shapes.add(i % 2 == 0 ? quad(place) : new Box(place, 1, 1, 1));
      Transform upright = place.times(Transform.rotationDegrees(new Vec3(90, 0, 0)));
      shapes.add(new Rectangle(upright, 1, 2, true));
    }
    Bvh bvh = hierarchy(shapes, kernel);
    Parts parts = Parts.of(shapes);
    Random random = new Random(2);
    int hits = 0;
    for (int i = 0; i < Effort.brief(1000); i++) {
      Vec3 origin =
          new Vec3(
              .5 * random.nextInt(12) - 2,
              .5 * random.nextInt(12) - 2,
              .5 * random.nextInt(12) - 2);
      Vec3 direction =
          new Vec3(random.nextInt(3) - 1, random.nextInt(3) - 1, random.nextInt(3) - 1);
      if (direction.maxAbs() > 0) {
        hits += assertAllAreMet(bvh, parts, new Ray(origin, direction));
      }
    }
    assertThat(hits).isGreaterThan(Effort.brief(1000));
  }

  /** From afar, the vector kernel moves origins, or looks at all boxes. */
  @ParameterizedTest
  @ValueSource(doubles = {10, 1e4, 1e7, 1e10, 1e14})
  void eachSurfaceIsMetOnceFromAfar(double distance) {
    Random random = new Random(3);
    List<Shape> shapes = coinciding(random, 6);
    Parts parts = Parts.of(shapes);
    for (Kernel kernel : List.of(Kernel.SCALAR, Kernel.VECTOR)) {
      Bvh bvh = hierarchy(shapes, kernel);
      for (int i = 0; i < Effort.brief(200); i++) {
        Vec3 origin = Shapes.direction(random).times(distance);
        Vec3 way = Shapes.point(random, 2).minus(origin);
        assertAllAreMet(bvh, parts, new Ray(origin, way));
        assertAllAreMet(bvh, parts, new Ray(origin, way.normalized(), distance));
      }
    }
  }

  /** Of surfaces at the same t, the first in the scene's order is hit, in any hierarchy. */
  @ParameterizedTest
  @EnumSource(Kernel.class)
  void theFirstOfCoincidingSurfacesIsHit(Kernel kernel) {
    Random random = new Random(4);
    for (int round = 0; round < 10; round++) {
      Transform place = Shapes.placement(random, 1, 1);
      List<Shape> others = coinciding(random, 2);
      List<Shape> shapes = new ArrayList<>(Collections.nCopies(3 + round, quad(place)));
      shapes.addAll(0, others);
      Bvh bvh = hierarchy(shapes, kernel);
      Parts parts = Parts.of(shapes);
      for (int i = 0; i < 50; i++) {
        Vec3 target = place.point(new Vec3(random.nextDouble(), 0, random.nextDouble()));
        Vec3 origin = target.plus(.01, Shapes.direction(random));
        Ray ray = new Ray(origin, target.minus(origin));
        NearestHit hit = new NearestHit();
        assertThat(bvh.intersect(ray, hit)).isTrue();
        assertThat(new Hit(hit.t(), hit.shape(), hit.element()))
            .isEqualTo(parts.bruteForce(ray).get(0));
        if (hit.shape() >= others.size()) {
          assertThat(hit.shape()).isEqualTo(others.size());
        }
      }
    }
  }

  @Test
  void raysMeetBothSidesOfSpheresAndBoxes() {
    Transform place = Transform.translation(new Vec3(0, 0, 5));
    for (Shape shape : List.of(new Sphere(place, 1), new Box(place, 2, 2, 2))) {
      List<Hit> hits = passing(Bvh.over(List.of(shape)), new Ray(Vec3.ZERO, Vec3.Z));
      assertThat(hits).extracting(Hit::t).containsExactly(4.0, 6.0);
      hits = passing(Bvh.over(List.of(shape)), new Ray(new Vec3(0, 0, 5), Vec3.Z));
      assertThat(hits).extracting(Hit::t).containsExactly(1.0);
      NearestHit nearest = new NearestHit();
      nearest.aim(new Ray(new Vec3(.1, .2, 0), Vec3.Z));
      Bvh bvh = Bvh.over(List.of(shape));
      assertThat(bvh.intersect(nearest)).isTrue();
      Vec3 front = shape.surfaceAt(nearest).position();
      nearest.pass();
      assertThat(bvh.intersect(nearest)).isTrue();
      Vec3 back = shape.surfaceAt(nearest).position();
      assertThat(front.x()).isCloseTo(.1, within(1e-12));
      assertThat(back.x()).isCloseTo(.1, within(1e-12));
      assertThat(front.z() + back.z()).isCloseTo(10, within(1e-12));
      assertThat(shape.surfaceAt(nearest).isFrontal()).isFalse();
    }
  }

  /** A ray that touches a sphere or the edge of a box meets its near and far side at the same t. */
  @Test
  void raysThatTouchMeetBothSidesOnce() {
    List<Shape> shapes =
        List.of(new Sphere(Transform.IDENTITY, 1), new Box(Transform.IDENTITY, 2, 2, 2));
    Ray touching = new Ray(new Vec3(-5, 1, 0), Vec3.X);
    assertThat(passing(Bvh.over(shapes.subList(0, 1)), touching))
        .containsExactly(new Hit(5, 0, 0), new Hit(5, 0, 1));
    Ray acrossEdge = new Ray(new Vec3(-2, 0, 0), new Vec3(1, 1, 0));
    for (Ray ray : List.of(acrossEdge, new Ray(new Vec3(0, -2, 0), new Vec3(1, 1, 0)))) {
      List<Hit> hits = passing(Bvh.over(shapes.subList(1, 2)), ray);
      assertThat(hits).extracting(Hit::t).containsExactly(1.0, 1.0);
      assertThat(hits).isSorted().doesNotHaveDuplicates();
    }
  }

  /** Layers one behind the other, and so many at one place that n² tests would take minutes. */
  @ParameterizedTest
  @EnumSource(Kernel.class)
  void stacksOfLayersAreMetInOrder(Kernel kernel) {
    for (double gap : new double[] {0, 1e-12, 1e-3}) {
      int layers = gap == 1e-12 ? 500 : 20_000;
      List<Shape> shapes =
          IntStream.range(0, layers)
              .<Shape>mapToObj(i -> quad(Transform.translation(new Vec3(0, gap * i, 0))))
              .toList();
      Ray up = new Ray(new Vec3(.1, -1, .2), Vec3.Y);
      assertThat(passing(hierarchy(shapes, kernel), up))
          .extracting(Hit::shape)
          .isEqualTo(IntStream.range(0, layers).boxed().toList());
    }
  }

  /** Many surfaces of all kinds at one place, before and behind others. */
  @ParameterizedTest
  @EnumSource(Kernel.class)
  void manySurfacesAtOnePlaceAreMetInOrder(Kernel kernel) {
    Random random = new Random(6);
    for (int round = 0; round < 3; round++) {
      List<Shape> shapes = new ArrayList<>();
      for (int i = 0; i < 12; i++) {
        shapes.addAll(coinciding(new Random(round), 2));
      }
      Mesh twice = quad(Transform.IDENTITY);
      shapes.addAll(Collections.nCopies(20, twice));
      shapes.addAll(Collections.nCopies(20, new Sphere(Transform.IDENTITY, 1)));
      Collections.shuffle(shapes, random);
      Bvh bvh = hierarchy(shapes, kernel);
      Parts parts = Parts.of(shapes);
      int hits = assertAllAreMet(bvh, parts, new Ray(new Vec3(-5, 1, 0), Vec3.X));
      for (int i = 0; i < 20; i++) {
        hits += assertAllAreMet(bvh, parts, Shapes.ray(random, AROUND));
      }
      assertThat(hits).isGreaterThan(500);
    }
  }
}
