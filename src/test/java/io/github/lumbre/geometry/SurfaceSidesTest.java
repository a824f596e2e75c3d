package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Sides of surfaces, texture coordinates of faces, and samples from inside and behind. */
class SurfaceSidesTest {
  @Test
  void hitsKnowTheirSide() {
    Random random = new Random(4);
    Sphere sphere = new Sphere(Transform.translation(new Vec3(1, 2, 3)), 2);
    for (int i = 0; i < 50; i++) {
      Vec3 way = Shapes.direction(random);
      Vec3 center = new Vec3(1, 2, 3);
      SurfaceHit out = Shapes.hit(sphere, new Ray(center.plus(-5, way), way)).orElseThrow();
      assertThat(out.isFrontal()).isTrue();
      SurfaceHit in = Shapes.hit(sphere, new Ray(center.plus(.5, way), way)).orElseThrow();
      assertThat(in.isFrontal()).isFalse();
    }
  }

  /** Seen from outside with v downward, u grows to the right: 0 to 1 over each face. */
  @Test
  void facesOfBoxesHaveTheUnitSquare() {
    Box box = new Box(Transform.IDENTITY, 2, 4, 6);
    Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
    Vec3 half = new Vec3(1, 2, 3);
    for (int axis = 0; axis < 3; axis++) {
      for (int side : new int[] {-1, 1}) {
        Vec3 normal = axes[axis].times(side);
        double sumU = 0;
        double sumV = 0;
        for (int corner = 0; corner < 4; corner++) {
          Vec3 p = normal.times(9);
          for (int other = 0, bit = 1; other < 3; other++) {
            if (other != axis) {
              p = p.plus((corner & bit) == 0 ? -.5 : .5, axes[other].times(half.get(other)));
              bit = 2;
            }
          }
          SurfaceHit hit = Shapes.hit(box, new Ray(p, normal.negated())).orElseThrow();
          // Each point is in the middle of a quarter of the face.
          assertThat(Math.abs(hit.u() - .5)).isCloseTo(.25, within(1e-12));
          assertThat(Math.abs(hit.v() - .5)).isCloseTo(.25, within(1e-12));
          sumU += hit.u();
          sumV += hit.v();
        }
        assertThat(sumU).isCloseTo(2, within(1e-12));
        assertThat(sumV).isCloseTo(2, within(1e-12));
      }
    }
  }

  /** From inside, directions are uniform; see {@link Sphere#sample}. */
  @Test
  void spheresAreSampledUniformlyByDirectionFromInside() {
    Random random = new Random(6);
    Sphere sphere = new Sphere(Transform.IDENTITY, 2);
    SurfaceSample sample = new SurfaceSample();
    for (int i = 0; i < 100; i++) {
      Vec3 inside = Shapes.direction(random).times(1.9 * random.nextDouble());
      Point2 u = Shapes.square(random);
      sphere.sample(inside.x(), inside.y(), inside.z(), u.x(), u.y(), sample);
      Vec3 way = sample.position().minus(inside).normalized();
      assertThat(way.minus(Warp.uniformSphere(u)).maxAbs()).isLessThan(1e-9);
      assertThat(sample.position().length()).isCloseTo(2, within(1e-12));
      assertThat(sample.pdf()).isCloseTo(1 / (4 * Math.PI), within(1e-9));
    }
  }

  /** A sample that cannot be seen leaves nothing of the sample before it. */
  @Test
  void samplesOfHiddenPointsAreEmpty() {
    TriangleMesh triangle =
        TriangleMesh.of(
            new double[] {-1, 0, -1, 0, 0, 1, 1, 0, -1},
            new double[0],
            new double[0],
            new int[] {0, 1, 2});
    List<Shape> shapes =
        List.of(
            new Rectangle(Transform.IDENTITY, 2, 2, false),
            Mesh.baked(triangle, Transform.IDENTITY),
            new Box(Transform.IDENTITY, 2, 2, 2),
            new Sphere(Transform.IDENTITY, 1));
    for (Shape shape : shapes) {
      SurfaceSample sample = new SurfaceSample();
      shape.sample(.1, 5, .2, .4, .6, sample);
      assertThat(sample.pdf()).isPositive();
      if (shape instanceof Rectangle) {
        shape.sample(.1, -5, .2, .4, .6, sample);
      } else if (shape instanceof Mesh) {
        // Seen from its edge.
        shape.sample(5, 0, 0, .4, .6, sample);
      } else {
        shape.sample(Double.NaN, 0, 0, .4, .6, sample);
      }
      assertThat(sample.pdf()).as("%s", shape.getClass()).isZero();
    }
  }

  @Test
  void rectanglesHaveOneNormal() {
    Transform turned = Transform.rotationDegrees(new Vec3(0, 0, 90));
    Vec3 normal = new Rectangle(turned, 1, 1, true).onlyNormal().orElseThrow();
    assertThat(normal.minus(Vec3.X.negated()).maxAbs()).isLessThan(1e-12);
    assertThat(new Sphere(turned, 1).onlyNormal()).isEmpty();
  }

  /** A transform can flatten a triangle to a line, whose points still have a unit normal. */
  @Test
  void normalsOfFlattenedTrianglesAreUnitVectors() {
    TriangleMesh sliver =
        TriangleMesh.of(
            new double[] {0, 0, 0, 1, 0, 0, 0, 1e-200, 0},
            new double[0],
            new double[0],
            new int[] {0, 1, 2});
    Transform flat = Transform.scale(new Vec3(1, 1e-200, 1));
    SurfaceSample sample = new SurfaceSample();
    Mesh mesh = Mesh.baked(sliver, flat);
    NearestHit hit = new NearestHit();
    hit.aim(new Ray(new Vec3(.25, 0, 3), Vec3.Z.negated()));
    hit.element = 0;
    hit.b1 = .25;
    hit.t = 3;
    SurfaceHit surface = mesh.surfaceAt(hit);
    assertThat(surface.geometricNormal().length()).isCloseTo(1, within(1e-12));
    assertThat(surface.geometricNormal().x()).isCloseTo(0, within(1e-12));
    mesh.sample(0, 0, 3, .5, .5, sample);
    assertThat(sample.pdf()).isZero();
  }

  @Test
  void sidesAreThoseOfObliqueRaysToo() {
    Random random = new Random(14);
    Vec3 center = new Vec3(1, 2, 3);
    Sphere sphere = new Sphere(Transform.translation(center), 2);
    for (int i = 0; i < 300; i++) {
      Vec3 inside = center.plus(1.8, Shapes.direction(random));
      Vec3 way = Shapes.direction(random);
      SurfaceHit in = Shapes.hit(sphere, new Ray(inside, way)).orElseThrow();
      assertThat(in.isFrontal()).isFalse();
      Ray back = new Ray(inside.plus(-9, way), way);
      SurfaceHit out = Shapes.hit(sphere, back).orElseThrow();
      assertThat(out.isFrontal()).isTrue();
    }
  }

  /** u grows around the axis, v downwards. */
  @Test
  void tangentsOfSpheresFollowTheTexture() {
    Random random = new Random(15);
    for (int i = 0; i < 200; i++) {
      Vec3 scale = new Vec3(i % 2 == 0 ? 1.5 : -1.5, 1.5, 1.5);
      Transform place =
          Transform.translation(Shapes.point(random, 3))
              .times(Shapes.rotation(random))
              .times(Transform.scale(scale));
      Vec3 any = Shapes.direction(random);
      Vec3 n = new Vec3(any.x(), .3 * any.y(), any.z()).normalized();
      Sphere sphere = new Sphere(place, 2);
      Vec3 origin = place.point(n.times(4));
      Ray ray = new Ray(origin, place.point(Vec3.ZERO).minus(origin).normalized());
      SurfaceHit hit = Shapes.hit(sphere, ray).orElseThrow();
      Vec3 around = place.vector(n.cross(Vec3.Y)).normalized();
      assertThat(hit.shading().tangent().minus(around).maxAbs()).isLessThan(1e-9);
      Vec3 down = place.vector(Vec3.Y.negated());
      assertThat(hit.shading().bitangent().dot(down)).isPositive();
    }
  }

  @Test
  void errorsOfRectanglesAreThoseOfTheirPoints() {
    Random random = new Random(16);
    for (int i = 0; i < 100; i++) {
      Transform place = Shapes.placement(random, 10, 3);
      Rectangle rectangle = new Rectangle(place, 200, 300, true);
      Vec3 local = new Vec3(200 * (random.nextDouble() - .5), 0, 300 * (random.nextDouble() - .5));
      Vec3 normal = place.normal(Vec3.Y);
      Ray ray = new Ray(place.point(local).plus(5, normal), normal.negated());
      SurfaceHit hit = Shapes.hit(rectangle, ray).orElseThrow();
      double expected = place.pointError(local, normal);
      assertThat(hit.error()).isCloseTo(expected, within(1e-6 * expected));
    }
  }

  /** Rays from far away have large errors in the space of an instance, and none in world space. */
  @Test
  void errorsOfSamplesOfInstancesGrowWithTheDistanceOfTheReference() {
    TriangleMesh ball = Shapes.closedBall(4, 5, 0, false);
    Transform place = Transform.rotationDegrees(new Vec3(10, 20, 30));
    SurfaceSample near = new SurfaceSample();
    SurfaceSample far = new SurfaceSample();
    Vec3 way = Shapes.direction(new Random(17));
    int compared = 0;
    for (int i = 0; i < 32; i++) {
      double u = (i + .5) / 32;
      Shape instance = new MeshInstance(new SharedMesh(ball), place);
      Shape baked = Mesh.baked(ball, place);
      for (Shape shape : new Shape[] {instance, baked}) {
        Vec3 close = way.times(10);
        Vec3 distant = way.times(1e6);
        shape.sample(close.x(), close.y(), close.z(), u, .5, near);
        shape.sample(distant.x(), distant.y(), distant.z(), u, .5, far);
        if (near.pdf() > 0 && far.pdf() > 0) {
          compared++;
          if (shape == instance) {
            assertThat(far.error()).isGreaterThan(1e3 * near.error());
          } else {
            assertThat(far.error()).isEqualTo(near.error());
          }
        }
      }
    }
    assertThat(compared).isGreaterThan(16);
  }
}
