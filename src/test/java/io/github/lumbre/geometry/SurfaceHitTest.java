package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Figures;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SurfaceHitTest {
  private static final TriangleMesh TRIANGLE =
      Shapes.triangle(new Vec3(-1, -.5, .3), new Vec3(1.2, -.7, -.2), new Vec3(.1, .9, .4));

  /** A flat or convex surface cannot be met again on the side that one leaves it to. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e-4, 1, 1e4, 1e8})
  void raysThatLeaveDoNotMeetTheSurfaceAgain(double size) {
    Random random = new Random(Effort.seed(7));
    Spawned spawned = new Spawned();
    for (int i = 0; i < Effort.count(1200, 10_000); i++) {
      double offset = size * StrictMath.pow(10, random.nextInt(7) - 2);
      Transform place = placed(random, size, offset);
      for (Shape shape : convexShapes(place, size)) {
        leave(shape, random, size, place.point(Vec3.ZERO), spawned);
      }
    }
    Figures.failures("re-hits of the surface that is left", spawned.rays, spawned.rehits);
    assertThat(spawned.hits).isGreaterThan(3000);
    assertThat(spawned.first).isEmpty();
  }

  private static Transform placed(Random random, double size, double offset) {
    Transform skew =
        random.nextBoolean()
            ? Transform.scale(new Vec3(1e-3, 1, 1e3))
            : Shapes.placement(random, 0, 8);
    return Transform.translation(Shapes.point(random, offset))
        .times(skew)
        .times(Shapes.rotation(random));
  }

  private static List<Shape> convexShapes(Transform place, double size) {
    Transform scaled = place.times(Transform.scale(new Vec3(size, size, size)));
    List<Shape> shapes = new ArrayList<>();
    shapes.add(new Sphere(place, size));
    shapes.add(new Box(place, size, 2 * size, .5 * size));
    shapes.add(new Rectangle(place, size, 2 * size, true));
    shapes.add(new Plane(place, true));
    shapes.add(Mesh.baked(TRIANGLE, scaled));
    shapes.add(new MeshInstance(new SharedMesh(TRIANGLE), scaled));
    return shapes;
  }

  /** Rays that left surfaces, and what is told of the first that met its own again. */
  private static final class Spawned {
    private int hits;
    private long rays;
    private long rehits;
    private String first = "";
  }

  private static void leave(Shape shape, Random random, double size, Vec3 centre, Spawned spawned) {
    Vec3 target = centre.plus(Shapes.point(random, .3 * size));
    Vec3 origin = centre.plus(10 * size, Shapes.direction(random));
    Ray ray = new Ray(origin, target.minus(origin).normalized());
    Optional<SurfaceHit> found = Shapes.hit(shape, ray);
    if (found.isEmpty()) {
      return;
    }
    spawned.hits++;
    SurfaceHit hit = found.get();
    boolean isClosed = shape instanceof Sphere || shape instanceof Box;
    for (int k = 0; k < Effort.count(8, 100); k++) {
      Vec3 direction = Shapes.direction(random);
      boolean isOutward = direction.dot(hit.geometricNormal()) > 0;
      if (!isClosed || isOutward) {
        spawned.rays++;
        if (!Double.isNaN(Shapes.distance(shape, hit.spawn(direction)))) {
          spawned.rehits++;
          spawned.first =
              spawned.first.isEmpty()
                  ? shape.getClass() + " hit at " + hit + " leaving along " + direction
                  : spawned.first;
        }
      }
    }
  }

  @Test
  void raysIntoSpheresMeetTheFarSide() {
    Random random = new Random(Effort.seed(8));
    for (double scale = 1e-8; scale < 1e9; scale *= 10) {
      Sphere sphere = new Sphere(Transform.translation(Shapes.point(random, 5 * scale)), scale);
      Vec3 centre = sphere.bounds().centre();
      for (int i = 0; i < Effort.count(300, 50_000); i++) {
        Vec3 from = Shapes.direction(random);
        SurfaceHit hit =
            Shapes.hit(sphere, new Ray(centre.plus(3 * scale, from), from.negated())).orElseThrow();
        Vec3 direction = Shapes.direction(random);
        double cos = direction.dot(hit.geometricNormal());
        double inward = cos > 0 ? -1 : 1;
        double t = Shapes.distance(sphere, hit.spawn(direction.times(inward)));
        double chord = 2 * scale * Math.abs(cos);
        assertThat(Math.abs(t - chord)).isLessThan(1e-12 * scale / Math.abs(cos));
      }
    }
  }

  @Test
  void errorStaysWithinSixtyFourUlpOfTheCoordinates() {
    Random random = new Random(9);
    for (int i = 0; i < 1000; i++) {
      Transform place = Shapes.placement(random, 100, 2);
      for (Shape shape : convexShapes(place, 1)) {
        Vec3 centre = place.point(Vec3.ZERO);
        Vec3 origin = centre.plus(10, Shapes.direction(random));
        Ray ray = new Ray(origin, centre.minus(origin).normalized());
        Shapes.hit(shape, ray)
            .ifPresent(
                hit ->
                    assertThat(hit.error())
                        .isBetween(0.0, 64 * Math.sqrt(3) * Math.ulp(centre.maxAbs() + 10)));
      }
    }
  }

  /** Where a map skews, the way into local space and back is the less exact the longer it is. */
  @ParameterizedTest
  @ValueSource(doubles = {1e2, 1e4, 1e6})
  void shadowRaysEndBeforeSkewedSpheres(double distance) {
    Random random = new Random(Effort.seed(12));
    int sampled = 0;
    for (int i = 0; i < Effort.count(5000, 500_000); i++) {
      Transform skew = Transform.scale(new Vec3(1e-3, 1, 1e3)).times(Shapes.rotation(random));
      Shape sphere = new Sphere(skew, 1);
      Vec3 normal = Shapes.direction(random);
      SurfaceHit hit = new SurfaceHit();
      Vec3 position = Shapes.direction(random).times(distance);
      hit.set(position, normal, Frame.around(normal), new TexturePoint(0, 0), normal, 0);
      SurfaceSample sample = sphere.sample(position, Shapes.square(random));
      Vec3 way = sample.position().minus(position).normalized();
      if (sample.pdf() > 0 && way.dot(sample.normal()) < -1e-3) {
        sampled++;
        assertThat(Shapes.hidesItself(sphere, hit, sample)).isFalse();
      }
    }
    assertThat(sampled).isPositive();
  }

  @Test
  void shadowRaysEndBeforeTheSampledSurface() {
    Random random = new Random(Effort.seed(10));
    for (int i = 0; i < Effort.count(2000, 200_000); i++) {
      Transform place = placed(random, 1, 1000);
      List<Shape> shapes = new ArrayList<>(convexShapes(place, 1));
      shapes.removeIf(Plane.class::isInstance);
      for (Shape shape : shapes) {
        Shape floor = new Rectangle(Shapes.placement(random, 1000, 2), 1, 1, true);
        SurfaceSample from = floor.sample(place.point(Vec3.Y), Shapes.square(random));
        Ray down = new Ray(from.position().plus(from.normal()), from.normal().negated());
        SurfaceHit hit = Shapes.hit(floor, down).orElseThrow();
        SurfaceSample sample = shape.sample(hit.position(), Shapes.square(random));
        Vec3 way = sample.position().minus(hit.position()).normalized();
        if (sample.pdf() > 0 && Math.abs(way.dot(sample.normal())) > 1e-6) {
          boolean isHidden = Shapes.hidesItself(shape, hit, sample);
          assertThat(isHidden).as("%s", shape.getClass()).isFalse();
        }
      }
    }
  }
}
