package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares box hits with a reference, and tests edges and texture frames. */
class BoxTest {
  private static final Box BOX = new Box(Transform.IDENTITY, 2, 4, 6);

  /**
   * Tests all directions with components -1, 0 and 1, from origins inside, outside and on the
   * faces.
   */
  @Test
  void zeroDirectionsOfEitherSignAgree() {
    double[] places = {-1.5, -1, -.5, 0, .5, 1, 1.5};
    int hits = 0;
    for (int code = 0; code < 27; code++) {
      double[] d = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
      if (code == 13) {
        continue;
      }
      for (double x : places) {
        for (double y : places) {
          for (double z : places) {
            Vec3 origin = new Vec3(x, 2 * y, 3 * z);
            Double expected = Shapes.distance(BOX, new Ray(origin, new Vec3(d[0], d[1], d[2])));
            for (int signs = 1; signs < 8; signs++) {
              Vec3 other =
                  new Vec3(zero(d[0], signs), zero(d[1], signs >> 1), zero(d[2], signs >> 2));
              assertThat(Shapes.distance(BOX, new Ray(origin, other))).isEqualTo(expected);
            }
            assertThat(expected).isEqualTo((Double) reference(origin, d));
            hits += expected > 0 ? 1 : 0;
          }
        }
      }
    }
    assertThat(hits).isGreaterThan(1000);
  }

  /** Returns the number, or for 0 a zero whose sign is the lowest bit of {@code signs}. */
  private static double zero(double d, int signs) {
    return d != 0 ? d : (signs & 1) == 0 ? 0.0 : -0.0;
  }

  /** Returns the t of the first slab crossing at which the ray is on the box. */
  private static double reference(Vec3 origin, double[] d) {
    double[] half = {1, 2, 3};
    double best = Double.NaN;
    for (int axis = 0; axis < 3; axis++) {
      for (int side = -1; side <= 1 && d[axis] != 0; side += 2) {
        double t = (side * half[axis] - origin.get(axis)) / d[axis];
        boolean isOn = t > 0 && !(t >= best);
        for (int other = 0; other < 3; other++) {
          double p = origin.get(other) + t * d[other];
          isOn &= other == axis || Math.abs(p) <= half[other];
        }
        // A ray that only touches an edge enters and leaves there.
        best = isOn ? t : best;
      }
    }
    return best;
  }

  @Test
  void raysThatBeginOnAFaceMeetOnlyOtherFaces() {
    Vec3 onFace = new Vec3(1, .5, .5);
    assertThat(Shapes.distance(BOX, new Ray(onFace, Vec3.X))).isNaN();
    assertThat(Shapes.distance(BOX, new Ray(onFace, Vec3.X.negated()))).isEqualTo(2);
    assertThat(Shapes.distance(BOX, new Ray(onFace, Vec3.Y))).isEqualTo(1.5);
    Vec3 corner = new Vec3(1, 2, 3);
    assertThat(Shapes.distance(BOX, new Ray(corner, new Vec3(1, 1, 1)))).isNaN();
    assertThat(Shapes.distance(BOX, new Ray(corner, new Vec3(-1, -1, -1)))).isEqualTo(2);
  }

  @Test
  void edgesBelongToTheFirstAxis() {
    Box cube = new Box(Transform.IDENTITY, 2, 2, 2);
    Vec3 diagonal = new Vec3(-1, -1, -1);
    assertThat(normalAt(cube, new Vec3(3, 3, 3), diagonal).x()).isEqualTo(1);
    assertThat(normalAt(cube, new Vec3(0, 3, 3), new Vec3(0, -1, -1)).y()).isEqualTo(1);
    assertThat(normalAt(cube, new Vec3(0, 0, 0), diagonal).x()).isEqualTo(-1);
  }

  private static Vec3 normalAt(Box box, Vec3 origin, Vec3 direction) {
    return Shapes.hit(box, new Ray(origin, direction)).orElseThrow().geometricNormal();
  }

  @Test
  void framesFollowTheTextureOnEachFace() {
    Random random = new Random(1);
    for (Transform place :
        new Transform[] {
          Transform.IDENTITY,
          Shapes.placement(random, 1, 3),
          Shapes.placement(random, 1, 3).times(Transform.scale(new Vec3(1, 1, -1)))
        }) {
      Box box = new Box(place, 2, 4, 6);
      for (int i = 0; i < 500; i++) {
        Vec3 center = place.point(Vec3.ZERO);
        Vec3 from = Shapes.direction(random);
        Ray ray = new Ray(center.plus(50, from), from.negated());
        SurfaceHit hit = Shapes.hit(box, ray).orElseThrow();
        Frame frame = hit.shading();
        SphereTest.assertOrthonormal(frame);
        assertThat(hit.geometricNormal().dot(from)).isPositive();
        // A small step along a tangent must increase its texture coordinate.
        assertThat(moved(box, ray, frame.tangent()).texture().u()).isGreaterThan(hit.texture().u());
        assertThat(moved(box, ray, frame.bitangent()).texture().v())
            .isGreaterThan(hit.texture().v());
      }
    }
  }

  private static SurfaceHit moved(Box box, Ray ray, Vec3 along) {
    return Shapes.hit(box, new Ray(ray.origin().plus(1e-6, along), ray.direction())).orElseThrow();
  }
}
