package io.github.lumbre.material;

import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** A bump in a normal map looks like a bump on every shape, with any transform and mapping. */
class NormalMappedTest {
  private static final double STEP = 1e-6;
  private static final double[] TRIANGLE = {-1, 0, 0, 1, 0, .2, -.3, .1, 1};
  private static final double[] TRIANGLE_NORMALS = {-.3, 1, 0, .2, 1, .1, 0, 1, .3};
  private static final double[] NO_NORMALS = {};

  private final SplittableRandom random = new SplittableRandom(61);

  private static Scene scene(Shape shape) {
    return Scene.builder()
        .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1))
        .add(shape, Matte.GRAY)
        .build();
  }

  private static Optional<SurfaceHit> hit(Scene scene, Vec3 origin, Vec3 direction) {
    Ray ray = new Ray(origin, direction.normalized());
    NearestHit hit = new NearestHit();
    return scene.intersect(ray, hit) ? Optional.of(scene.surfaceAt(hit)) : Optional.empty();
  }

  private static Vec3 normal(SurfaceHit hit, Rgb tilt, UvMapping mapping) {
    NormalMap map = new NormalMap(Texture.constant(tilt), mapping, 1);
    Frame unbent = hit.shading();
    new NormalMapped(Matte.GRAY, map).perturb(hit);
    Vec3 perturbed = hit.shading().normal();
    hit.shadeBy(unbent);
    return perturbed;
  }

  /** Returns the changes of u and v over a small step along a tangential direction. */
  private static double[] growth(Scene scene, SurfaceHit hit, Vec3 direction) {
    Vec3 along = direction.plus(-direction.dot(hit.geometricNormal()), hit.geometricNormal());
    Vec3 eye = hit.position().plus(STEP, along.normalized()).plus(1e-3, hit.geometricNormal());
    SurfaceHit next = hit(scene, eye, hit.geometricNormal().negated()).orElseThrow();
    double u = next.texture().u() - hit.texture().u();
    double v = next.texture().v() - hit.texture().v();
    return new double[] {u - Math.rint(u), v - Math.rint(v)};
  }

  private static void assertBumpsAreBumps(Scene scene, SurfaceHit hit) {
    Vec3 flat = normal(hit, new Rgb(0, 0, 1), UvMapping.IDENTITY);
    assertThat(flat).isEqualTo(hit.shading().normal());
    for (double tilt : new double[] {.3, -.3}) {
      Vec3 towardsU = normal(hit, new Rgb(tilt, 0, .9), UvMapping.IDENTITY).minus(flat);
      assertThat(growth(scene, hit, towardsU)[0] * tilt).isPositive();
      Vec3 towardsV = normal(hit, new Rgb(0, tilt, .9), UvMapping.IDENTITY).minus(flat);
      assertThat(growth(scene, hit, towardsV)[1] * tilt).isPositive();
      Vec3 mirrored = normal(hit, new Rgb(tilt, 0, .9), new UvMapping(0, 0, -2, 1)).minus(flat);
      assertThat(mirrored.dot(towardsU)).isNegative();
      // By the known angle.
      assertThat(flat.dot(flat.plus(towardsU))).isCloseTo(Math.sqrt(.9), within(1e-12));
    }
  }

  private List<Transform> placements() {
    List<Transform> placements = new ArrayList<>(List.of(Transform.IDENTITY));
    for (int i = 0; i < 16; i++) {
      Vec3 scale =
          new Vec3(
              random.nextDouble(.5, 2) * (i % 2 == 0 ? 1 : -1),
              random.nextDouble(.5, 2) * (i / 2 % 2 == 0 ? 1 : -1),
              random.nextDouble(.5, 2) * (i / 4 % 2 == 0 ? 1 : -1));
      placements.add(
          Transform.translation(inCube(random, 3))
              .times(Transform.rotationDegrees(inCube(random, 180)))
              .times(Transform.scale(scale)));
    }
    return placements;
  }

  private void assertBumpsAreBumps(Function<Transform, Shape> shape) {
    for (Transform placement : placements()) {
      Scene scene = scene(shape.apply(placement));
      int found = 0;
      for (int i = 0; i < 60; i++) {
        Vec3 eye = placement.point(inCube(random, 1).normalized().times(4));
        Vec3 target = placement.point(inCube(random, .4));
        Optional<SurfaceHit> hit = hit(scene, eye, target.minus(eye));
        if (hit.isPresent()) {
          assertBumpsAreBumps(scene, hit.get());
          found++;
        }
      }
      assertThat(found).isGreaterThan(5);
    }
  }

  @Test
  void onSpheres() {
    assertBumpsAreBumps(placement -> new Sphere(placement, 1));
  }

  @Test
  void onEveryFaceOfBoxes() {
    assertBumpsAreBumps(placement -> new Box(placement, 1.2, .9, 1.5));
    Scene scene = scene(new Box(Transform.IDENTITY, 1, 2, 3));
    for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
      for (double side : new double[] {-5, 5}) {
        Vec3 eye = axis.times(side).plus(.1, new Vec3(1, 2, 3));
        SurfaceHit hit = hit(scene, eye, axis.times(-side)).orElseThrow();
        assertThat(hit.geometricNormal().dot(axis) * side).isEqualTo(5);
        assertBumpsAreBumps(scene, hit);
      }
    }
  }

  @Test
  void onPlanesAndRectangles() {
    assertBumpsAreBumps(placement -> new Plane(placement, false));
    assertBumpsAreBumps(placement -> new Plane(placement, true));
    assertBumpsAreBumps(placement -> new Rectangle(placement, 2, 3, false));
    assertBumpsAreBumps(placement -> new Rectangle(placement, 2, 3, true));
  }

  @Test
  void onMeshesWhosePicturesAreMirroredTurnedOrSheared() {
    double[][] maps = {
      {}, {0, 0, 1, 0, 0, 1}, {1, 0, 0, 0, 1, 1}, {.2, .9, .4, .1, .8, .7}, {0, 5, .1, 5, 0, 4.9},
    };
    for (double[] uv : maps) {
      for (double[] normals : new double[][] {NO_NORMALS, TRIANGLE_NORMALS}) {
        TriangleMesh mesh = TriangleMesh.of(TRIANGLE, normals, uv, new int[] {0, 1, 2});
        assertBumpsAreBumps(placement -> Mesh.baked(mesh, placement));
        SharedMesh shared = new SharedMesh(mesh);
        assertBumpsAreBumps(placement -> new MeshInstance(shared, placement));
      }
    }
  }

  @Test
  void framesStayUsableWhereAPictureHasNoDirection() {
    Sphere sphere = new Sphere(Transform.IDENTITY, 1);
    for (double side : new double[] {-4, 4}) {
      assertUsable(hit(scene(sphere), new Vec3(0, side, 0), new Vec3(0, -side, 0)).orElseThrow());
    }
    for (double[] uv : new double[][] {{0, 0, 0, 0, 0, 0}, {0, 0, 1, 1, 2, 2}}) {
      TriangleMesh mesh = TriangleMesh.of(TRIANGLE, NO_NORMALS, uv, new int[] {0, 1, 2});
      Scene scene = scene(Mesh.baked(mesh, Transform.IDENTITY));
      assertUsable(hit(scene, new Vec3(-.1, 4, .3), new Vec3(0, -1, 0)).orElseThrow());
    }
  }

  /** A flat map over another keeps the normal that the other perturbed. */
  @Test
  void mapsOnMapsPerturbOneAfterTheOther() {
    Scene scene = scene(new Rectangle(Transform.IDENTITY, 2, 2, true));
    SurfaceHit hit = hit(scene, Vec3.Y, Vec3.Y.negated()).orElseThrow();
    Vec3 perturbed = normal(hit, new Rgb(.48, .36, .8), UvMapping.IDENTITY);
    NormalMap tilt = new NormalMap(Texture.constant(new Rgb(.48, .36, .8)), UvMapping.IDENTITY, 1);
    NormalMap flat = new NormalMap(Texture.constant(new Rgb(0, 0, 1)), UvMapping.IDENTITY, 1);
    new NormalMapped(new NormalMapped(Matte.GRAY, tilt), flat).perturb(hit);
    assertThat(hit.shading().normal()).isEqualTo(perturbed).isNotEqualTo(hit.geometricNormal());
  }

  private static void assertUsable(SurfaceHit hit) {
    Frame frame = hit.shading();
    assertThat(frame.tangent().length()).isCloseTo(1, within(1e-12));
    assertThat(frame.bitangent().length()).isCloseTo(1, within(1e-12));
    assertThat(frame.tangent().dot(frame.normal())).isCloseTo(0, within(1e-12));
    assertThat(frame.bitangent().dot(frame.normal())).isCloseTo(0, within(1e-12));
    Vec3 perturbed = normal(hit, new Rgb(.3, 0, .9), UvMapping.IDENTITY);
    assertThat(perturbed.dot(frame.normal())).isCloseTo(Math.sqrt(.9), within(1e-12));
  }

  @Test
  void closeToThePolesOfASphereBumpsAreBumps() {
    Scene scene = scene(new Sphere(Transform.IDENTITY, 1));
    for (double side : new double[] {-4, 4}) {
      for (int i = 0; i < 12; i++) {
        Vec3 eye = new Vec3(1e-3 * Math.cos(i), side, 1e-3 * Math.sin(i));
        assertBumpsAreBumps(scene, hit(scene, eye, new Vec3(0, -side, 0)).orElseThrow());
      }
    }
  }
}
