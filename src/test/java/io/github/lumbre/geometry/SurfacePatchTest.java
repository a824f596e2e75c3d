package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class SurfacePatchTest {
  private static final double STEP = 1e-6;

  private final SplittableRandom random = new SplittableRandom(8);

  private Vec3 point(double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** A patch around the origin that faces up, more or less, with normals that vary a little. */
  private SurfacePatch patch() {
    Vec3 x = new Vec3(1, 0, 0).plus(point(.3));
    Vec3 y = new Vec3(0, 0, -1).plus(point(.3));
    Vec3 normal = x.cross(y).normalized().plus(point(.1)).times(random.nextDouble(.5, 2));
    return new SurfacePatch(point(.1), x, y, normal, point(.05), point(.05));
  }

  @Test
  void refractedDirectionsFollowSnellsLaw() {
    int found = 0;
    for (int i = 0; i < 20_000; i++) {
      SurfacePatch patch = patch();
      double side = random.nextBoolean() ? 1 : -1;
      Vec3 from = new Vec3(0, side * random.nextDouble(1, 5), 0).plus(point(1));
      Vec3 to = new Vec3(0, -side * random.nextDouble(1, 5), 0).plus(point(1));
      double eta = random.nextDouble(.7, 1.6);
      Optional<Point2> solution = patch.refraction(from, to, eta);
      if (solution.isEmpty()) {
        continue;
      }
      found++;
      Vec3 normal = patch.normalAt(solution.get());
      Vec3 in = from.minus(patch.at(solution.get())).normalized();
      Vec3 out = to.minus(patch.at(solution.get())).normalized();
      assertThat(in.dot(normal) * out.dot(normal)).isNegative();
      assertThat(in.cross(normal).plus(eta, out.cross(normal)).length()).isLessThan(1e-10);
    }
    assertThat(found).isGreaterThan(15_000);
  }

  @Test
  void thereIsNoRefractionOnOneSide() {
    SurfacePatch patch = SurfacePatch.flat(Vec3.ZERO, Vec3.X, new Vec3(0, 0, -1), Vec3.Y);
    assertThat(patch.refraction(new Vec3(1, 1, 0), new Vec3(-1, 2, 0), 1.5)).isEmpty();
    assertThat(patch.refraction(new Vec3(Double.NaN, 1, 0), new Vec3(0, -1, 0), 1.5)).isEmpty();
  }

  /** Compares the ratio with the directions to four nearby points. */
  @Test
  void beamsNarrowAsDifferencesOfDirections() {
    int compared = 0;
    for (int i = 0; i < 5_000; i++) {
      SurfacePatch patch = patch();
      Vec3 from = new Vec3(0, random.nextDouble(1, 3), 0).plus(point(.5));
      Vec3 to = new Vec3(0, -random.nextDouble(1, 3), 0).plus(point(.5));
      double eta = random.nextDouble(.7, 1.6);
      Vec3 normal = new Vec3(0, 1, 0).plus(point(.3)).normalized();
      Vec3 u = normal.cross(Vec3.X).normalized().times(STEP);
      Vec3 v = normal.cross(u);
      Optional<Point2> middle = patch.refraction(from, to, eta);
      Optional<Vec3> across = difference(patch, from, to, eta, u);
      Optional<Vec3> along = difference(patch, from, to, eta, v);
      if (middle.isEmpty() || across.isEmpty() || along.isEmpty()) {
        continue;
      }
      compared++;
      double expected = across.get().cross(along.get()).length() / (4 * STEP * STEP);
      double found = patch.solidAngle(from, to, eta, middle.get(), normal);
      assertThat(found / expected).isCloseTo(1, within(1e-5));
    }
    assertThat(compared).isGreaterThan(4_000);
  }

  private static Optional<Vec3> difference(
      SurfacePatch patch, Vec3 from, Vec3 to, double eta, Vec3 step) {
    Optional<Point2> a = patch.refraction(from, to.minus(step), eta);
    Optional<Point2> b = patch.refraction(from, to.plus(step), eta);
    return a.isEmpty() || b.isEmpty()
        ? Optional.empty()
        : Optional.of(
            patch
                .at(b.get())
                .minus(from)
                .normalized()
                .minus(patch.at(a.get()).minus(from).normalized()));
  }

  /** Patches begin at the hit and have its shading normal. */
  @Test
  void patchesOfShapesContainTheirHits() {
    TriangleMesh triangle =
        TriangleMesh.of(
            new double[] {-1, 0, -1, 2, .3, -1, 0, -.2, 2},
            new double[] {-.3, 1, 0, .2, 1, .1, 0, 1, .3},
            new double[0],
            new int[] {0, 2, 1});
    Transform placed =
        Transform.rotationDegrees(new Vec3(10, 20, 30));
    for (Shape shape :
        new Shape[] {
          Mesh.of(triangle, placed),
          new MeshInstance(new SharedMesh(triangle), placed),
          new Rectangle(placed, 2, 2, true),
          new Plane(placed, true)
        }) {
      NearestHit hit = new NearestHit();
      hit.aim(.1, 3, .05, 0, -1, 0, 10);
      assertThat(shape.intersect(hit)).isTrue();
      SurfacePatch patch = shape.patchAt(hit).orElseThrow();
      SurfaceHit surface = shape.surfaceAt(hit);
      Vec3 normal = patch.normalAt(new Point2(0, 0));
      assertThat(patch.origin().minus(surface.position()).length()).isLessThan(1e-14);
      assertThat(normal.minus(surface.shadingNormal()).length()).isLessThan(1e-14);
      assertThat(patch.x().dot(surface.geometricNormal())).isCloseTo(0, within(1e-14));
      assertThat(patch.y().dot(surface.geometricNormal())).isCloseTo(0, within(1e-14));
    }
    assertThat(Sphere.of(Vec3.ZERO, 1).patchAt(new NearestHit())).isEmpty();
  }
}
