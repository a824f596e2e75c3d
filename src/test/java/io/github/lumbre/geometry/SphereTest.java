package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests hits and texture frames of spheres of all sizes and transforms. */
class SphereTest {
  private static final Sphere UNIT = new Sphere(Transform.IDENTITY, 1);
  private static final double EPS = 0x1p-52;

  /**
   * Returns a random ray from a given distance that passes the origin at distance {@code impact}.
   */
  private static Ray passing(Random random, double distance, double impact) {
    Frame frame = Frame.around(Shapes.direction(random));
    Vec3 origin = frame.toWorld(new Vec3(impact, 0, -distance));
    return new Ray(origin, frame.normal());
  }

  @Test
  void raysFromInsideHitOnce() {
    Random random = new Random(Effort.seed(3));
    for (int i = 0; i < Effort.brief(Effort.count(50_000, 1_000_000)); i++) {
      Vec3 origin = Shapes.direction(random).times(random.nextDouble() * (1 - 1e-12));
      Ray ray = new Ray(origin, Shapes.direction(random));
      double t = Shapes.distance(UNIT, ray);
      assertThat(t).isPositive();
      assertThat(Math.abs(ray.at(t).length() - 1)).isLessThanOrEqualTo(8 * EPS * 2);
    }
  }

  @Test
  void segmentsThatEndInsideAreBlocked() {
    Ray toCenter = new Ray(new Vec3(0, 0, -5), new Vec3(0, 0, 5), 1);
    assertThat(Shapes.distance(UNIT, toCenter)).isCloseTo(.8, within(1e-15));
    assertThat(Shapes.distance(UNIT, new Ray(new Vec3(0, 0, -5), Vec3.Z, 4))).isNaN();
    assertThat(Shapes.distance(UNIT, new Ray(Vec3.ZERO, Vec3.Z, 1))).isNaN();
  }

  @Test
  void tangentRaysHitWithinAFewUlp() {
    for (double distance : new double[] {0, .5, 1, 10}) {
      for (int k = -64; k <= 64; k++) {
        Ray ray = new Ray(new Vec3(1 + k * EPS, 0, -distance), Vec3.Z);
        double t = Shapes.distance(UNIT, ray);
        if (k >= 8) {
          assertThat(t).isNaN();
        } else if (k <= -8 && distance > 0) {
          assertThat(t).isCloseTo(distance, within(1e-6));
        }
      }
    }
  }

  /** Rounding moves the ray by a few ulp of its distance from the sphere. */
  @ParameterizedTest
  @ValueSource(doubles = {0, .5, 1, 10, 1e3, 1e6})
  void tangentRaysOfAnyDirectionHitWithinTheUlpOfTheirDistance(double distance) {
    Random random = new Random(Effort.seed(11));
    double least = 16 * (1 + distance);
    for (int i = 0; i < Effort.brief(Effort.count(20_000, 1_000_000)); i++) {
      double ulp = least * (1 + 15 * random.nextDouble());
      assertThat(Shapes.distance(UNIT, passing(random, distance, 1 + ulp * EPS))).isNaN();
      double t = Shapes.distance(UNIT, passing(random, distance, 1 - ulp * EPS));
      if (distance > 0) {
        assertThat(t).isCloseTo(distance, within(1e-6 * (1 + Math.sqrt(distance))));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9})
  void spheresOfAnySizeAreHitLikeTheUnitSphere(double radius) {
    Random random = new Random(Effort.seed(12));
    Transform scaled = Transform.scale(new Vec3(radius, radius, radius));
    for (int i = 0; i < Effort.count(5000, 500_000); i++) {
      double distance = StrictMath.pow(10, 12 * random.nextDouble());
      Sphere sphere = i % 2 == 0 ? new Sphere(Transform.IDENTITY, radius) : new Sphere(scaled, 1);
      Ray ray = passing(random, distance * radius, radius * .999 * Math.sqrt(random.nextDouble()));
      double off = ray.at(Shapes.distance(sphere, ray)).length() - radius;
      assertThat(Math.abs(off)).isLessThanOrEqualTo(8 * EPS * radius * (distance + 1));
      double beyond = radius * (1.001 + .099 * random.nextDouble());
      assertThat(Shapes.distance(sphere, passing(random, distance * radius, beyond))).isNaN();
    }
  }

  @Test
  void ellipsoidsAreHitOnTheirQuadricWithItsGradient() {
    Transform squash = Transform.scale(new Vec3(1e-3, 1, 1e3));
    Sphere ellipsoid = new Sphere(squash, 1);
    Random random = new Random(4);
    for (int i = 0; i < 2000; i++) {
      Vec3 surface = squash.point(Shapes.direction(random));
      Vec3 target = surface.times(.9 * random.nextDouble());
      Vec3 origin = surface.times(1.5);
      SurfaceHit hit =
          Shapes.hit(ellipsoid, new Ray(origin, target.minus(origin).normalized())).orElseThrow();
      Vec3 unit = squash.inversePoint(hit.position());
      assertThat(Math.abs(unit.length() - 1)).isLessThan(8 * EPS);
      Vec3 p = hit.position();
      Vec3 gradient = new Vec3(p.x() * 1e6, p.y(), p.z() * 1e-6).normalized();
      assertThat(hit.geometricNormal().minus(gradient).length()).isLessThan(1e-12);
    }
  }

  @Test
  void framesAreOrthonormalAndFollowTheTexture() {
    Random random = new Random(Effort.seed(5));
    Transform place = Shapes.placement(random, 3, 4);
    for (Sphere sphere : new Sphere[] {UNIT, new Sphere(place, 2)}) {
      Vec3 center = sphere.bounds().center();
      for (int i = 0; i < Effort.brief(Effort.count(20_000, 1_000_000)); i++) {
        Vec3 from = Shapes.direction(random);
        Ray ray = new Ray(center.plus(20, from), from.negated());
        assertOrthonormal(Shapes.hit(sphere, ray).orElseThrow().shading());
      }
    }
    SurfaceHit front = Shapes.hit(UNIT, new Ray(new Vec3(3, 0, 0), Vec3.X.negated())).orElseThrow();
    assertThat(front.texture().u()).isEqualTo(.5);
    assertThat(front.texture().v()).isEqualTo(.5);
    assertThat(front.shading().tangent()).isEqualTo(Vec3.Z);
    assertThat(front.shading().bitangent().y()).isEqualTo(-1);
    SurfaceHit side = Shapes.hit(UNIT, new Ray(new Vec3(0, 0, 3), Vec3.Z.negated())).orElseThrow();
    assertThat(side.texture().u()).isEqualTo(.75);
  }

  @Test
  void polesHaveAFixedFrame() {
    SurfaceHit top = Shapes.hit(UNIT, new Ray(new Vec3(0, 5, 0), Vec3.Y.negated())).orElseThrow();
    SurfaceHit again = Shapes.hit(UNIT, new Ray(new Vec3(0, 3, 0), Vec3.Y.negated())).orElseThrow();
    SurfaceHit bottom = Shapes.hit(UNIT, new Ray(new Vec3(0, -5, 0), Vec3.Y)).orElseThrow();
    assertOrthonormal(top.shading());
    assertOrthonormal(bottom.shading());
    assertThat(again.shading()).isEqualTo(top.shading());
    assertThat(top.texture().v()).isEqualTo(0);
    assertThat(bottom.texture().v()).isEqualTo(1);
  }

  static void assertOrthonormal(Frame frame) {
    assertThat(frame.tangent().dot(frame.normal())).isCloseTo(0, within(1e-12));
    assertThat(frame.bitangent().dot(frame.normal())).isCloseTo(0, within(1e-12));
    assertThat(frame.tangent().dot(frame.bitangent())).isCloseTo(0, within(1e-12));
    assertThat(frame.tangent().length()).isCloseTo(1, within(1e-12));
    assertThat(frame.bitangent().length()).isCloseTo(1, within(1e-12));
    assertThat(frame.normal().length()).isCloseTo(1, within(1e-12));
  }

  @Test
  void chainsThatComposeToTheIdentityLeaveTheSphereInPlace() {
    int depth = 10_000;
    Random random = new Random(6);
    Transform chain = Transform.IDENTITY;
    for (int i = 0; i < depth; i++) {
      Vec3 offset = Shapes.point(random, 1);
      double angle = 360 * random.nextDouble();
      chain = chain.times(Transform.translation(offset));
      chain = chain.times(Transform.rotationDegrees(new Vec3(0, angle, 0)));
      chain = chain.times(Transform.rotationDegrees(new Vec3(0, -angle, 0)));
      chain = chain.times(Transform.translation(offset.negated()));
    }
    SurfaceHit hit =
        Shapes.hit(new Sphere(chain, 1), new Ray(new Vec3(0, 0, -5), Vec3.Z)).orElseThrow();
    double bound = depth * 8 * EPS * 4;
    assertThat(hit.position().minus(Vec3.Z.negated()).length()).isLessThan(bound);
    assertThat(hit.geometricNormal().minus(Vec3.Z.negated()).length()).isLessThan(bound);
  }

  @Test
  void impossibleSpheresAreRejected() {
    assertThatThrownBy(() -> new Sphere(Transform.IDENTITY, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("radius");
    assertThatThrownBy(() -> new Sphere(Transform.IDENTITY, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Sphere(Transform.scale(new Vec3(0, 1, 1)), 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("singular");
  }
}
