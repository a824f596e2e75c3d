package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** A cloud is hit as its spheres are, one by one. */
class SphereCloudTest {
  private static final double[] NONE = {};

  /** A hit of a ray: which sphere of the cloud, and whether the ray leaves it. */
  private record Hit(double t, int sphere, int root) {}

  private static double[] centers(Random random, int count, double size) {
    return IntStream.range(0, 3 * count)
        .mapToDouble(i -> size * (2 * random.nextDouble() - 1))
        .toArray();
  }

  /** Returns spheres around random points of the cube [-size, size]³. */
  static Shape cloud(Random random, int count, double size, double radius) {
    return Sphere.cloud(
        centers(random, count, size), radius, NONE, MeshAttributes.NONE, Kernel.AUTO);
  }

  private static List<Shape> spheres(double[] centers, double radius) {
    List<Shape> spheres = new ArrayList<>();
    for (int i = 0; i < centers.length; i += 3) {
      spheres.add(Sphere.of(new Vec3(centers[i], centers[i + 1], centers[i + 2]), radius));
    }
    return spheres;
  }

  private static Shape cloud(double[] centers, double radius, Kernel kernel) {
    assumeTrue(kernel != Kernel.VECTOR || Kernel.vectorObstacle().isEmpty());
    return Sphere.cloud(centers, radius, NONE, MeshAttributes.NONE, kernel);
  }

  private static List<Hit> passing(Bvh bvh, Ray ray, int cloud) {
    List<Hit> hits = new ArrayList<>();
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    while (bvh.intersect(nearest)) {
      assertThat(nearest.shape()).isEqualTo(cloud);
      hits.add(new Hit(nearest.t(), nearest.element() >> 1, nearest.element() & 1));
      assertThat(hits.size()).isLessThan(10_000);
      nearest.pass();
    }
    assertThat(nearest.origin()).isEqualTo(ray.origin());
    assertThat(nearest.direction()).isEqualTo(ray.direction());
    return hits;
  }

  private static List<Hit> oneByOne(List<Shape> spheres, Ray ray) {
    List<Hit> hits = new ArrayList<>();
    NearestHit nearest = new NearestHit();
    for (int i = 0; i < spheres.size(); i++) {
      nearest.aim(ray);
      nearest.shape = 0;
      while (spheres.get(i).intersect(nearest)) {
        hits.add(new Hit(nearest.t(), i, nearest.element()));
        nearest.shape = 0;
        nearest.pass();
      }
    }
    hits.sort(
        Comparator.comparingDouble(Hit::t)
            .thenComparingInt(Hit::sphere)
            .thenComparingInt(Hit::root));
    return hits;
  }

  /** Some spheres coincide, more than a ray passes one by one. */
  @ParameterizedTest
  @EnumSource(Kernel.class)
  void raysMeetEachSphereTwiceInOrder(Kernel kernel) {
    int met = 0;
    for (int seed = 0; seed < Effort.count(4, 100); seed++) {
      Random random = new Random(Effort.seed(seed));
      double[] centers = centers(random, 60, 1);
      for (int i = 1; seed % 2 == 1 && i < 40; i++) {
        System.arraycopy(centers, 0, centers, 3 * (i + i % 2), 3);
      }
      List<Shape> spheres = spheres(centers, .4);
      Shape plane = new Rectangle(Transform.translation(new Vec3(0, 9, 0)), 1, 1, true);
      Bvh bvh = Bvh.over(List.of(plane, cloud(centers, .4, kernel)), kernel);
      for (int i = 0; i < 200; i++) {
        Vec3 origin = Shapes.point(random, 2);
        Vec3 target = new Vec3(centers[0], centers[1], centers[2]).plus(Shapes.point(random, .3));
        Ray ray = new Ray(origin, target.minus(origin));
        List<Hit> expected = oneByOne(spheres, ray);
        assertThat(passing(bvh, ray, 1)).isEqualTo(expected);
        assertThat(bvh.isOccluded(ray, new NearestHit())).isEqualTo(!expected.isEmpty());
        met += expected.size();
      }
    }
    assertThat(met).isGreaterThan(1000);
  }

  @Test
  void placedCloudsAreHitAsPlacedSpheres() {
    Random random = new Random(8);
    double[] centers = centers(random, 50, 1);
    Shape cloud = cloud(centers, .1, Kernel.AUTO);
    List<Shape> spheres = spheres(centers, .1);
    int hits = 0;
    for (int i = 0; i < 300; i++) {
      Transform place = Shapes.placement(random, 2, 3);
      Shape placed = cloud.transformed(place);
      List<Shape> each = spheres.stream().map(sphere -> sphere.transformed(place)).toList();
      Vec3 target = place.point(Shapes.point(random, 1));
      Vec3 origin = target.plus(5, Shapes.direction(random));
      Ray ray = new Ray(origin, target.minus(origin));
      NearestHit expected = new NearestHit();
      boolean isHit = Shapes.bruteForce(each, ray, expected);
      NearestHit found = new NearestHit();
      found.aim(ray);
      assertThat(placed.intersect(found)).isEqualTo(isHit);
      if (isHit) {
        hits++;
        assertThat(found.t()).isCloseTo(expected.t(), within(1e-12));
        SurfaceHit surface = placed.surfaceAt(found);
        SurfaceHit other = each.get(expected.shape()).surfaceAt(expected);
        assertThat(surface.position().minus(other.position()).length()).isLessThan(1e-11);
        assertThat(surface.geometricNormal().dot(other.geometricNormal())).isGreaterThan(1 - 1e-9);
        Vec3 before = surface.position().plus(-1e-9, ray.direction());
        assertThat(placed.bounds().meets(before, surface.position())).isTrue();
      }
    }
    assertThat(hits).isGreaterThan(50);
    Vec3 four = new Vec3(4, 4, 4);
    assertThat(cloud.transformed(Transform.scale(four)).area())
        .isCloseTo(16 * spheres.stream().mapToDouble(Shape::area).sum(), within(1e-9));
  }

  /** Rays that leave a sphere must not hit it at once. */
  @Test
  void raysLeaveTheSurfaceThatTheyStartOn() {
    Random random = new Random(5);
    double[] centers = centers(random, 30, 1e4);
    for (Transform place :
        List.of(Transform.IDENTITY, Transform.translation(new Vec3(1e6, -1e5, 3e5)))) {
      Shape cloud = cloud(centers, .01, Kernel.AUTO).transformed(place);
      for (int i = 0; i < 3000; i++) {
        int at = 3 * random.nextInt(30);
        Vec3 center = place.point(new Vec3(centers[at], centers[at + 1], centers[at + 2]));
        Vec3 origin = center.plus(1 + 1e3 * random.nextDouble(), Shapes.direction(random));
        NearestHit nearest = new NearestHit();
        nearest.aim(new Ray(origin, center.minus(origin).normalized()));
        assertThat(cloud.intersect(nearest)).isTrue();
        SurfaceHit hit = cloud.surfaceAt(nearest);
        assertThat(hit.isFrontal()).isTrue();
        Vec3 away = hit.geometricNormal().plus(.99, Shapes.direction(random)).normalized();
        nearest.aim(hit.spawn(away));
        assertThat(cloud.intersect(nearest)).isFalse();
      }
    }
  }

  @Test
  void spheresHaveTheAttributesOfTheirPoints() {
    float[] colors = {1, 0, 0, 1, .25f, .5f, .75f, .5f};
    MeshAttributes attributes = new MeshAttributes(NONE, new double[] {0, 0, .1, .2}, colors);
    double[] uvs = {0, 0, .6, .7};
    Shape cloud =
        Sphere.cloud(new double[] {-1, 0, 0, 1, 0, 0}, .5, uvs, attributes, Kernel.SCALAR);
    SurfaceHit hit = Shapes.hit(cloud, new Ray(new Vec3(1, .1, -9), Vec3.Z)).orElseThrow();
    assertThat(hit.texture()).isEqualTo(new TexturePoint(.6, .7));
    assertThat(hit.u(1)).isEqualTo(.1);
    assertThat(hit.v(1)).isEqualTo(.2);
    assertThat(hit.vertexColor()).isEqualTo(new Rgb(.25, .5, .75));
    assertThat(hit.vertexAlpha()).isEqualTo(.5);
    SurfaceSample sample = new SurfaceSample();
    cloud.sample(0, 9, 0, .9, .3, sample);
    assertThat(sample.vertexColor()).isEqualTo(new Rgb(.25, .5, .75));
    assertThat(sample.texture()).isEqualTo(new TexturePoint(.6, .7));
    cloud.sample(0, 9, 0, .1, .3, sample);
    assertThat(sample.vertexColor()).isEqualTo(new Rgb(1, 0, 0));
  }

  @Test
  void spheresWithoutUvsAreUniform() {
    SurfaceHit hit =
        Shapes.hit(
                cloud(new double[] {0, 0, 0}, 1, Kernel.AUTO), new Ray(new Vec3(.1, 0, -9), Vec3.Z))
            .orElseThrow();
    assertThat(hit.texture()).isEqualTo(new TexturePoint(0, 0));
    assertThat(hit.vertexColor()).isEqualTo(Rgb.WHITE);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "|1|centers: expected at least one, found none",
        "1 2|1|positions: expected a length divisible by 3, found 2",
        "1 2 NaN|1|positions[2]: expected a finite number, found NaN",
        "1 2 3|0|radius: expected a finite number > 0, found 0.0",
        "1 2 3|1e151|radius: expected a number <= 1e150, found 1.0E151",
      })
  void wrongArgumentsAreNamed(String numbers, double radius, String message) {
    double[] centers =
        numbers == null
            ? NONE
            : Arrays.stream(numbers.split(" ")).mapToDouble(Double::parseDouble).toArray();
    assertThatThrownBy(() -> cloud(centers, radius, Kernel.AUTO))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(message);
  }
}
