package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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

/** Tests error bounds, and the rays that leave a surface. */
class SurfaceHitTest {
  private static final TriangleMesh TRIANGLE =
      Shapes.triangle(new Vec3(-1, -.5, .3), new Vec3(1.2, -.7, -.2), new Vec3(.1, .9, .4));

  /** A ray that leaves a flat or convex surface cannot hit it again. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e-4, 1, 1e4, 1e8})
  void raysThatLeaveDoNotMeetTheSurfaceAgain(double size) {
    Random random = new Random(Effort.seed(7));
    Spawned spawned = new Spawned();
    for (int i = 0; i < Effort.brief(Effort.count(1200, 10_000)); i++) {
      double offset = size * StrictMath.pow(10, random.nextInt(7) - 2);
      Transform place = placed(random, size, offset);
      for (Shape shape : convexShapes(place, size)) {
        leave(shape, random, size, place.point(Vec3.ZERO), spawned);
      }
    }
    Figures.failures("re-hits of the surface that is left", spawned.rays, spawned.rehits);
    assertThat(spawned.hits).isGreaterThan(Effort.brief(3000));
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

  /**
   * Counts the rays that left surfaces, and describes the first ray that hit its own surface again.
   */
  private static final class Spawned {
    private int hits;
    private long rays;
    private long rehits;
    private String first = "";
  }

  private static void leave(Shape shape, Random random, double size, Vec3 center, Spawned spawned) {
    Vec3 target = center.plus(Shapes.point(random, .3 * size));
    Vec3 origin = center.plus(10 * size, Shapes.direction(random));
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
      Vec3 center = sphere.bounds().center();
      for (int i = 0; i < Effort.brief(Effort.count(300, 50_000)); i++) {
        Vec3 from = Shapes.direction(random);
        SurfaceHit hit =
            Shapes.hit(sphere, new Ray(center.plus(3 * scale, from), from.negated())).orElseThrow();
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
        Vec3 center = place.point(Vec3.ZERO);
        Vec3 origin = center.plus(10, Shapes.direction(random));
        Ray ray = new Ray(origin, center.minus(origin).normalized());
        Shapes.hit(shape, ray)
            .ifPresent(
                hit ->
                    assertThat(hit.error())
                        .isBetween(0.0, 64 * Math.sqrt(3) * Math.ulp(center.maxAbs() + 10)));
      }
    }
  }

  /** With a skewing transform, mapping to local space and back is less exact for longer rays. */
  @ParameterizedTest
  @ValueSource(doubles = {1e2, 1e4, 1e6})
  void shadowRaysEndBeforeSkewedSpheres(double distance) {
    Random random = new Random(Effort.seed(12));
    int sampled = 0;
    for (int i = 0; i < Effort.brief(Effort.count(5000, 500_000)); i++) {
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
    for (int i = 0; i < Effort.brief(Effort.count(2000, 200_000)); i++) {
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

  private static Frame frame(Random random) {
    Frame turned = Frame.around(Shapes.direction(random));
    return Frame.around(turned.normal(), Shapes.direction(random), Shapes.direction(random));
  }

  private static SurfaceHit surface(Random random, double error) {
    return new SurfaceHit()
        .set(
            Shapes.point(random, 5),
            Shapes.direction(random),
            frame(random),
            new TexturePoint(random.nextDouble(), random.nextDouble()),
            Shapes.direction(random),
            error);
  }

  @Test
  void hitsKeepWhatTheyAreTold() {
    Random random = new Random(20);
    Frame frame = frame(random);
    TexturePoint texture = new TexturePoint(.25, .75);
    SurfaceHit hit =
        new SurfaceHit().set(new Vec3(1, 2, 3), Vec3.Y, frame, texture, Vec3.Z.negated(), .5);
    assertThat(hit.position()).isEqualTo(new Vec3(1, 2, 3));
    assertThat(hit.geometricNormal()).isEqualTo(Vec3.Y);
    assertThat(hit.shading()).isEqualTo(frame);
    assertThat(hit.shadingNormal()).isEqualTo(frame.normal());
    assertThat(hit.texture()).isEqualTo(texture);
    assertThat(hit.u()).isEqualTo(.25);
    assertThat(hit.v()).isEqualTo(.75);
    assertThat(hit.wo()).isEqualTo(Vec3.Z.negated());
    assertThat(hit.error()).isEqualTo(.5);
  }

  @Test
  void directionsGoIntoTheFrameAndBack() {
    Random random = new Random(21);
    for (int i = 0; i < 100; i++) {
      SurfaceHit hit = surface(random, 0);
      Frame frame = hit.shading();
      Vec3 direction = Shapes.direction(random);
      Vec3 local = hit.toLocal(direction);
      assertThat(local.x()).isCloseTo(direction.dot(frame.tangent()), within(1e-15));
      assertThat(local.y()).isCloseTo(direction.dot(frame.bitangent()), within(1e-15));
      assertThat(local.z()).isCloseTo(direction.dot(frame.normal()), within(1e-15));
      Vec3 world = hit.toWorld(direction);
      assertThat(world.dot(frame.tangent())).isCloseTo(direction.x(), within(1e-14));
      assertThat(world.dot(frame.bitangent())).isCloseTo(direction.y(), within(1e-14));
      assertThat(world.dot(frame.normal())).isCloseTo(direction.z(), within(1e-14));
      assertThat(hit.toWorld(local).minus(direction).length()).isLessThan(1e-14);
    }
  }

  @Test
  void framesTurnToOtherNormals() {
    Random random = new Random(22);
    for (int i = 0; i < 100; i++) {
      SurfaceHit hit = surface(random, 0);
      Frame before = hit.shading();
      Vec3 normal = i % 10 == 0 ? before.tangent() : Shapes.direction(random);
      hit.perturb(normal);
      assertThat(hit.shading())
          .isEqualTo(Frame.around(normal, before.tangent(), before.bitangent()));
      hit.shadeFlat();
      assertThat(hit.shading()).isEqualTo(Frame.around(hit.geometricNormal()));
      hit.shadeBy(before);
      assertThat(hit.shading()).isEqualTo(before);
    }
  }

  /** Origins are offset by the error, to the side that the rays point to. */
  @Test
  void raysBeginOffTheSurfaceByItsError() {
    Random random = new Random(23);
    NearestHit next = new NearestHit();
    for (int i = 0; i < 200; i++) {
      SurfaceHit hit = surface(random, .125);
      Vec3 direction = Shapes.direction(random);
      Ray ray = hit.spawn(direction);
      double side = Math.signum(direction.dot(hit.geometricNormal()));
      Vec3 origin = hit.position().plus(.125 * side, hit.geometricNormal());
      assertThat(ray.origin().minus(origin).length()).isLessThan(1e-14);
      assertThat(ray.direction()).isEqualTo(direction);
      assertThat(ray.tMax()).isInfinite();
      hit.spawn(direction.x(), direction.y(), direction.z(), next);
      assertThat(next.origin().minus(origin).length()).isLessThan(1e-14);
      assertThat(next.direction()).isEqualTo(direction);
      assertThat(next.t()).isInfinite();
      Vec3 point = hit.position().plus(3, direction);
      hit.spawnTowards(point, next);
      assertThat(next.origin().minus(origin).length()).isLessThan(1e-14);
      assertThat(next.origin().plus(next.direction()).minus(point).length()).isLessThan(1e-14);
      assertThat(next.t()).isEqualTo(1);
    }
  }

  /** Both ends are offset by the errors of their surfaces, each towards the other surface. */
  @Test
  void shadowRaysEndOffTheOtherSurfaceByItsError() {
    Random random = new Random(24);
    NearestHit next = new NearestHit();
    SurfaceSample sample = new SurfaceSample();
    for (int i = 0; i < 200; i++) {
      SurfaceHit hit = surface(random, .125);
      Vec3 point = Shapes.point(random, 9);
      Vec3 normal = Shapes.direction(random);
      sample.set(point, normal, new TexturePoint(0, 0), .25, 1);
      Vec3 back = hit.position().minus(point);
      Vec3 end = point.plus(.25 * Math.signum(back.dot(normal)), normal);
      hit.spawnTowards(sample, next);
      assertThat(next.origin().plus(next.direction()).minus(end).length()).isLessThan(1e-13);
      Vec3 way = end.minus(hit.position());
      double side = Math.signum(way.dot(hit.geometricNormal()));
      Vec3 origin = hit.position().plus(.125 * side, hit.geometricNormal());
      assertThat(next.origin().minus(origin).length()).isLessThan(1e-13);
      assertThat(next.t()).isEqualTo(1);
    }
  }
}
