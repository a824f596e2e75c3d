package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.LongAdder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that both traversal kernels find bit-identical hits. */
class KernelTest {
  private static final Bounds3 AROUND = new Bounds3(new Vec3(-6, -6, -6), new Vec3(6, 6, 6));
  private static final Vec3[] AXES = {Vec3.X, Vec3.Y, Vec3.Z};

  private final NearestHit byVectors = new NearestHit();
  private final NearestHit byPlainJava = new NearestHit();
  private final NearestHit counted = new NearestHit();

  private static void assumeVectors() {
    assumeTrue(Kernel.vectorObstacle().isEmpty(), () -> Kernel.vectorObstacle().orElseThrow());
  }

  /** The two hierarchies over the same shapes. */
  private record Pair(List<? extends Shape> shapes, Bvh vector, Bvh scalar) {
    static Pair over(List<? extends Shape> shapes) {
      assumeVectors();
      return new Pair(shapes, Bvh.over(shapes, Kernel.VECTOR), Bvh.over(shapes, Kernel.SCALAR));
    }
  }

  /** Checks that both kernels find the same hit, and returns whether there is one. */
  private boolean assertSame(Pair pair, Ray ray) {
    boolean isHit = pair.scalar.intersect(ray, byPlainJava);
    assertThat(pair.vector.intersect(ray, byVectors)).as("hit of %s", ray).isEqualTo(isHit);
    assertThat(byVectors.shape).as("shape of %s", ray).isEqualTo(byPlainJava.shape);
    if (isHit) {
      assertThat(byVectors.t).as("t of %s", ray).isEqualTo(byPlainJava.t);
      assertThat(byVectors.element).as("element of %s", ray).isEqualTo(byPlainJava.element);
      Shape shape = pair.shapes.get(byPlainJava.shape);
      if (shape instanceof Mesh || shape instanceof MeshInstance) {
        assertThat(byVectors.b1).isEqualTo(byPlainJava.b1);
        assertThat(byVectors.b2).isEqualTo(byPlainJava.b2);
      }
    }
    assertThat(pair.vector.isOccluded(ray, byVectors)).as("any hit of %s", ray).isEqualTo(isHit);
    return isHit;
  }

  /**
   * Tests a ray and rays derived from its hit: one that ends near it, one that continues from it,
   * and a reflected one.
   */
  private int assertSameAround(Pair pair, Ray ray, Random random) {
    if (!assertSame(pair, ray)) {
      return 0;
    }
    double t = byPlainJava.t;
    assertSame(pair, new Ray(ray.origin(), ray.direction(), t));
    assertSame(pair, new Ray(ray.origin(), ray.direction(), Math.nextUp(t)));
    Vec3 at = ray.at(t);
    assertSame(pair, new Ray(at, ray.direction()));
    assertSame(pair, new Ray(at, Shapes.direction(random)));
    assertSame(pair, new Ray(at, AXES[random.nextInt(3)].negated()));
    return 1;
  }

  @Test
  void hitsOfMixedShapesAreTheSame() {
    for (int seed = 0; seed < 6; seed++) {
      Random random = new Random(seed);
      Pair pair = Pair.over(Shapes.zoo(random, 4 + 30 * seed));
      int hits = 0;
      for (int i = 0; i < Effort.brief(5000); i++) {
        hits += assertSameAround(pair, Shapes.ray(random, AROUND), random);
      }
      assertThat(hits).isGreaterThan(Effort.brief(100));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {-300, -30, 0, 30, 300})
  void hitsOfMeshesAreTheSameAtEveryScale(int exponent) {
    Random random = new Random(exponent);
    double scale = Math.scalb(1.0, exponent);
    Mesh mesh =
        Mesh.baked(
            Shapes.closedBall(40, 60, .2, true), Transform.scale(new Vec3(scale, scale, scale)));
    Pair pair = Pair.over(List.of(mesh));
    int hits = 0;
    for (int i = 0; i < Effort.brief(3000); i++) {
      Vec3 origin = Shapes.point(random, 2 * scale);
      hits += assertSameAround(pair, new Ray(origin, Shapes.direction(random)), random);
    }
    assertThat(hits).isGreaterThan(Effort.brief(300));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.5, 4, 30, 1e3, 1e6, 1e9, 1e12, 1e15})
  void hitsOfRaysFromAfarAreTheSame(double distance) {
    Random random = new Random(1);
    Pair pair = Pair.over(List.of(ball(Transform.IDENTITY)));
    int hits = 0;
    for (int i = 0; i < Effort.brief(2000); i++) {
      Vec3 origin = Shapes.direction(random).times(distance);
      Vec3 direction = Shapes.point(random, .8).minus(origin);
      hits += assertSameAround(pair, new Ray(origin, direction), random);
      hits += assertSameAround(pair, new Ray(origin, direction.normalized()), random);
      assertSame(pair, new Ray(origin, Shapes.direction(random)));
      assertSame(pair, new Ray(Shapes.point(random, 1), direction, .5));
    }
    assertThat(hits).isGreaterThan(Effort.brief(1000));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e3, 1e6, 1e9, 1e12})
  void hitsOfMeshesFarFromTheOriginAreTheSame(double distance) {
    Random random = new Random(2);
    Vec3 center = Shapes.direction(random).times(distance);
    Pair pair = Pair.over(List.of(ball(Transform.translation(center))));
    int hits = 0;
    for (int i = 0; i < Effort.brief(3000); i++) {
      Vec3 origin = center.plus(Shapes.point(random, 2));
      hits += assertSameAround(pair, new Ray(origin, Shapes.direction(random)), random);
    }
    assertThat(hits).isGreaterThan(Effort.brief(300));
  }

  @ParameterizedTest
  @ValueSource(ints = {-1060, -1000, -500, -100, 100, 500, 1000})
  void hitsOfRaysWithVeryShortOrLongDirectionsAreTheSame(int exponent) {
    Random random = new Random(3);
    Pair pair = Pair.over(List.of(ball(Transform.IDENTITY)));
    for (int i = 0; i < Effort.brief(1000); i++) {
      Vec3 direction = Shapes.direction(random).times(Math.scalb(1.0, exponent));
      assertSame(pair, new Ray(Shapes.point(random, 2), direction));
      assertSame(pair, new Ray(Shapes.point(random, 2), direction, Math.scalb(1.0, -exponent)));
    }
  }

  @Test
  void hitsOfTinyMeshesInHugeRoomsAreTheSame() {
    Random random = new Random(4);
    double tiny = 1e-7;
    Mesh room = Mesh.baked(Shapes.closedBall(4, 4, 0, false), Transform.scale(new Vec3(9, 9, 9)));
    Transform place =
        Transform.translation(new Vec3(1, 2, 3)).times(Transform.scale(new Vec3(tiny, tiny, tiny)));
    Pair pair = Pair.over(List.of(room, ball(place)));
    for (int i = 0; i < Effort.brief(1000); i++) {
      Vec3 near = place.point(Shapes.point(random, 1));
      Vec3 origin = Shapes.point(random, 3);
      assertSameAround(pair, new Ray(near, Shapes.direction(random)), random);
      assertSameAround(pair, new Ray(origin, near.minus(origin).normalized()), random);
    }
  }

  @Test
  void hitsInFacesAndThroughEdgesAndVerticesAreTheSame() {
    Random random = new Random(5);
    double[] p = new double[3 * 17 * 17];
    List<Integer> f = new ArrayList<>();
    for (int i = 0; i < 17 * 17; i++) {
      p[3 * i] = i % 17 - 8;
      p[3 * i + 1] = i % 3 == 0 ? 1 : 0;
      p[3 * i + 2] = i / 17 - 8;
      if (i % 17 < 16 && i / 17 < 16) {
        f.addAll(List.of(i, i + 1, i + 17, i + 1, i + 18, i + 17));
      }
    }
    int[] indices = f.stream().mapToInt(Integer::intValue).toArray();
    TriangleMesh data = TriangleMesh.of(p, new double[0], new double[0], indices);
    Pair pair = Pair.over(List.of(Mesh.baked(data, Transform.IDENTITY)));
    int hits = 0;
    for (int i = 0; i < Effort.brief(5000); i++) {
      Vec3 a = data.position(random.nextInt(data.vertexCount()));
      Vec3 b = data.position(random.nextInt(data.vertexCount()));
      Vec3 axis = AXES[random.nextInt(3)];
      hits += assertSame(pair, new Ray(a.plus(-3, axis), axis)) ? 1 : 0;
      hits += assertSame(pair, new Ray(a, new Vec3(-0.0, 0, 0).minus(axis))) ? 1 : 0;
      if (a.minus(b).maxAbs() > 0) {
        hits += assertSameAround(pair, new Ray(b, a.minus(b), 1), random);
        hits += assertSameAround(pair, new Ray(b.plus(.5, Vec3.Y), a.minus(b)), random);
      }
    }
    assertThat(hits).isGreaterThan(Effort.brief(1000));
  }

  @Test
  void hitsOfNeedlesAndCoincidingTrianglesAreTheSame() {
    Random random = new Random(6);
    List<Shape> shapes = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      Vec3 a = Shapes.point(random, 1);
      Vec3 b = a.plus(Math.scalb(1.0, -random.nextInt(40)), Shapes.direction(random));
      Vec3 c = a.plus(Math.scalb(1.0, -random.nextInt(20)), Shapes.direction(random));
      TriangleMesh one = Shapes.triangle(a, b, c);
      shapes.add(Mesh.baked(one, Transform.IDENTITY));
      shapes.add(Mesh.baked(one, Transform.IDENTITY));
    }
    Pair pair = Pair.over(shapes);
    int hits = 0;
    for (int i = 0; i < Effort.brief(5000); i++) {
      Vec3 origin = Shapes.point(random, 2);
      Ray ray = new Ray(origin, Shapes.point(random, 1).minus(origin).normalized());
      hits += assertSameAround(pair, ray, random);
    }
    assertThat(hits).isGreaterThan(Effort.brief(300));
  }

  /**
   * For rays in the planes of triangles, where rounding decides, both kernels find the same hits,
   * and the hits are on the ray.
   */
  @Test
  void hitsOfTrianglesSeenEdgeOnAreTheSame() {
    Random random = new Random(Effort.seed(9));
    int hits = 0;
    int rounds = Effort.count(20, 20_000);
    for (int round = 0; round < rounds; round++) {
      TriangleMesh data = triangles(random, 60);
      Mesh mesh = Mesh.baked(data, Transform.IDENTITY);
      Pair pair = Pair.over(List.of(mesh));
      for (int i = 0; i < Effort.brief(5000); i++) {
        int triangle = random.nextInt(data.triangleCount());
        Vec3 origin = inPlane(data, triangle, 6 * random.nextDouble() - 3, 6 * random.nextDouble());
        Vec3 target = inPlane(data, triangle, random.nextDouble(), random.nextDouble());
        double length = Math.scalb(1.0, random.nextInt(19) - 9);
        Ray ray = new Ray(origin, target.minus(origin).normalized().times(length));
        if (assertSame(pair, ray)) {
          NearestHit hit = byPlainJava;
          Vec3 at = inPlane(data, hit.element, hit.b1, hit.b2);
          assertThat(at.minus(ray.at(hit.t)).maxAbs()).as("off by, %s", ray).isLessThan(1e-13);
          double end = Math.nextUp(hit.t);
          assertThat(assertSame(pair, new Ray(origin, ray.direction(), end))).isTrue();
          hits++;
        }
      }
    }
    assertThat(hits).isGreaterThan(Effort.brief(250) * rounds);
  }

  /** Returns triangles in a cube, with edges from 2^-40 to 1; most of them are slivers. */
  private static TriangleMesh triangles(Random random, int count) {
    double[] p = new double[9 * count];
    int[] indices = new int[3 * count];
    for (int vertex = 0; vertex < indices.length; vertex++) {
      indices[vertex] = vertex;
      double size = vertex % 3 == 0 ? 0 : Math.scalb(1.0, -random.nextInt(40));
      Vec3 step = vertex % 3 == 0 ? Shapes.point(random, 1) : Shapes.direction(random).times(size);
      for (int axis = 0; axis < 3; axis++) {
        int at = 3 * vertex + axis;
        p[at] = step.get(axis) + (vertex % 3 == 0 ? 0 : p[at - 3 * (vertex % 3)]);
      }
    }
    return TriangleMesh.of(p, new double[0], new double[0], indices);
  }

  private static Vec3 inPlane(TriangleMesh mesh, int triangle, double b1, double b2) {
    Vec3 a = mesh.position(mesh.vertex(triangle, 0));
    Vec3 b = mesh.position(mesh.vertex(triangle, 1));
    Vec3 c = mesh.position(mesh.vertex(triangle, 2));
    return a.plus(b1, b.minus(a)).plus(b2, c.minus(a));
  }

  /** One ray object meets two hierarchies in turn, whose scales differ by a factor of 2^20. */
  @Test
  void hitsInHierarchiesInTurnAreTheSame() {
    Random random = new Random(21);
    TriangleMesh ball = Shapes.closedBall(40, 60, .2, true);
    Transform small = Transform.scale(new Vec3(0x1p-20, 0x1p-20, 0x1p-20));
    Pair large = Pair.over(List.of(Mesh.baked(ball, Transform.IDENTITY)));
    Pair tiny = Pair.over(List.of(Mesh.baked(ball, small)));
    int hits = 0;
    for (int i = 0; i < 4000; i++) {
      Pair pair = i % 2 == 0 ? large : tiny;
      Vec3 center = pair.shapes.get(0).bounds().center();
      Vec3 extent = pair.shapes.get(0).bounds().max().minus(center);
      Vec3 from = center.plus(Shapes.direction(random).times(.5 * extent.maxAbs()));
      hits += assertSame(pair, new Ray(from, Shapes.direction(random))) ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(200);
  }

  /** The counting traversal finds the hits of plain Java with a plausible number of node visits. */
  @Test
  void countingFindsTheSameHitsAndFewNodes() {
    Random random = new Random(7);
    List<Shape> shapes = new ArrayList<>(Shapes.zoo(random, 60));
    shapes.add(ball(Transform.IDENTITY));
    LongAdder visits = new LongAdder();
    Bvh scalar = Bvh.over(shapes, Kernel.SCALAR);
    Bvh counting = Bvh.counting(shapes, visits);
    int hits = 0;
    for (int i = 0; i < Effort.brief(5000); i++) {
      Ray ray = Shapes.ray(random, AROUND);
      boolean isHit = scalar.intersect(ray, byPlainJava);
      assertThat(counting.intersect(ray, counted)).as("hit of %s", ray).isEqualTo(isHit);
      assertThat(counted.shape).isEqualTo(byPlainJava.shape);
      if (isHit) {
        assertThat(counted.t).isEqualTo(byPlainJava.t);
        assertThat(counted.element).isEqualTo(byPlainJava.element);
        hits++;
      }
      assertThat(counting.isOccluded(ray, counted)).isEqualTo(isHit);
    }
    assertThat(hits).isGreaterThan(Effort.brief(100));
    // For 2400 triangles and 60 shapes, a traversal visits a few dozen nodes.
    assertThat(visits.sum() / (2.0 * Effort.brief(5000))).isBetween(3.0, 60.0);
  }

  private static Mesh ball(Transform place) {
    return Mesh.baked(Shapes.closedBall(30, 40, .2, false), place);
  }

  @ParameterizedTest
  @EnumSource(Kernel.class)
  @DisabledIfSystemProperty(named = Effort.BRIEF, matches = "true")
  void searchingAllocatesNothing(Kernel kernel) throws ReflectiveOperationException {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    Random random = new Random(7);
    List<Shape> shapes = Shapes.zoo(random, 60);
    shapes.add(ball(Transform.IDENTITY));
    Bvh bvh = Bvh.over(shapes, kernel);
    Ray[] rays = new Ray[2000];
    for (int i = 0; i < rays.length; i++) {
      rays[i] = Shapes.ray(random, AROUND);
    }
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 100; round++) {
      long before = Allocation.ofThisThread();
      for (Ray ray : rays) {
        bvh.intersect(ray, byPlainJava);
        bvh.isOccluded(ray, byPlainJava);
      }
      least = Math.min(least, Allocation.ofThisThread() - before);
    }
    // The measurement itself allocates a little; one object per ray would be 100,000 bytes.
    assertThat(least).isLessThan(2000);
  }

  @Test
  @DisabledIfSystemProperty(named = Effort.BRIEF, matches = "true")
  void treesDoNotDependOnTheNumberOfThreads() {
    TriangleMesh data = Shapes.closedBall(160, 200, .2, false);
    List<Shape> shapes = new ArrayList<>(Shapes.zoo(new Random(8), 70));
    shapes.add(Mesh.baked(data, Transform.IDENTITY));
    for (LeafCost costs : List.of(WideTree.COSTS, BinaryTraversal.COSTS)) {
      WideTree expected = tree(1, costs, shapes);
      for (int threads = 2; threads < 6; threads++) {
        WideTree found = tree(threads, costs, shapes);
        assertThat(found.nodes()).isEqualTo(expected.nodes());
        assertThat(found.leaves()).isEqualTo(expected.leaves());
      }
    }
  }

  /**
   * Nodes are integers while a hierarchy is built, and boxes are computed when they are stored:
   * objects with boxes take 100 bytes more for each triangle, all at once.
   */
  @Test
  void buildingTakesLittleMemoryPerTriangle() throws ReflectiveOperationException {
    Mesh mesh = Mesh.baked(Shapes.closedBall(50, 70, .2, false), Transform.IDENTITY);
    Bvh.over(List.of(mesh), Kernel.SCALAR);
    long before = Allocation.ofThisThread();
    Bvh.over(List.of(mesh), Kernel.SCALAR);
    long bytes = Allocation.ofThisThread() - before;
    // Few enough for one thread.
    assertThat(mesh.triangles().triangleCount()).isBetween(6000, 8000);
    assertThat(bytes / mesh.triangles().triangleCount()).isLessThan(180);
  }

  private static WideTree tree(int threads, LeafCost costs, List<Shape> shapes) {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      BvhItems items = new BvhItems(shapes);
      BvhBuilder builder = new BvhBuilder(items, costs);
      return new WideTree(pool.submit(builder::build).join(), items, BvhBuilder.MAX_ITEMS);
    } finally {
      pool.shutdown();
    }
  }
}
