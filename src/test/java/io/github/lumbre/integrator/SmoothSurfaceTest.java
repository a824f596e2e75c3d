package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the light of coarse meshes whose vertex normals are those of a smooth surface. */
class SmoothSurfaceTest {
  private static final double[] NONE = {};
  private static final int BANDS = 20;

  /** Returns a mesh of a unit sphere whose vertex normals are those of the sphere. */
  private static TriangleMesh ball(int rings, int sectors) {
    int row = sectors + 1;
    double[] points = new double[3 * (rings + 1) * row];
    for (int i = 0; i < (rings + 1) * row; i++) {
      double polar = Math.PI * (i / row) / rings;
      double azimuth = 2 * Math.PI * (i % row) / sectors;
      points[3 * i] = Math.sin(polar) * Math.sin(azimuth);
      points[3 * i + 1] = Math.cos(polar);
      points[3 * i + 2] = Math.sin(polar) * Math.cos(azimuth);
    }
    int[] corners = new int[6 * rings * sectors];
    for (int i = 0; i < rings * sectors; i++) {
      int a = i / sectors * row + i % sectors;
      int[] two = {a, a + row, a + 1, a + 1, a + row, a + row + 1};
      System.arraycopy(two, 0, corners, 6 * i, 6);
    }
    return TriangleMesh.of(points, points, NONE, corners);
  }

  private static Mesh coarse() {
    return Mesh.of(ball(8, 12));
  }

  /** Returns a closed box whose eight vertex normals are the means of three faces. */
  private static Mesh box(Vec3 center, Vec3 half) {
    double[] points = new double[24];
    double[] normals = new double[24];
    for (int i = 0; i < 8; i++) {
      double[] signs = {(i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1};
      points[3 * i] = center.x() + signs[0] * half.x();
      points[3 * i + 1] = center.y() + signs[1] * half.y();
      points[3 * i + 2] = center.z() + signs[2] * half.z();
      System.arraycopy(signs, 0, normals, 3 * i, 3);
    }
    int[] corners = {
      0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1,
      3, 5, 3, 7, 5
    };
    return Mesh.of(TriangleMesh.of(points, normals, NONE, corners));
  }

  private static Optional<SurfaceHit> hit(Shape shape, Ray ray) {
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    return shape.intersect(nearest) ? Optional.of(shape.surfaceAt(nearest)) : Optional.empty();
  }

  private static boolean hasLift(Shape shape) {
    return hit(shape, new Ray(new Vec3(.1, .2, 5), Vec3.Z.negated())).orElseThrow().hasLift();
  }

  /** Returns a ray at the unit sphere from a point that is far away. */
  private static Ray ray(Random random) {
    Vec3 towards = direction(random);
    return new Ray(towards.cross(direction(random)).plus(5, towards), towards.negated());
  }

  private static Vec3 direction(Random random) {
    return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .normalized();
  }

  private static double radiance(Integrator integrator, Ray ray, int sample) {
    SobolSampler sampler = new SobolSampler(1);
    sampler.startSample(sample, 7, 0);
    RenderContext context = new RenderContext();
    context.startSample();
    return integrator.radiance(ray, sampler, context).g();
  }

  /** Returns the mean light in bands of the angle between the shading normal and the light. */
  private static double[] bands(Shape ball, boolean isPath) {
    Vec3 toLight = new Vec3(.6, .3, .7).normalized();
    Scene scene =
        empty()
            .add(ball, matte(1))
            .add(new DirectionalLight(toLight.negated(), Rgb.gray(Math.PI)))
            .build();
    Integrator integrator = isPath ? new PathTracer(scene, 1) : new RayTracer(scene, 1, 1);
    double[] sums = new double[BANDS];
    int[] counts = new int[BANDS];
    Random random = new Random(4);
    for (int i = 0; i < 60_000; i++) {
      Ray ray = ray(random);
      Optional<SurfaceHit> hit = hit(ball, ray);
      if (hit.isPresent()) {
        double cosine = hit.get().shadingNormal().dot(toLight);
        int band = (int) (BANDS * Math.acos(cosine) / Math.PI);
        sums[band] += radiance(integrator, ray, i);
        counts[band]++;
      }
    }
    for (int i = 0; i < BANDS; i++) {
      assertThat(counts[i]).isGreaterThan(100);
      sums[i] /= counts[i];
    }
    return sums;
  }

  /** Full light is 1. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void terminatorOfCoarseMeshesIsSmooth(boolean isPath) {
    double[] fine = bands(Mesh.of(ball(256, 512)), isPath);
    double[] found = bands(coarse(), isPath);
    for (int i = 0; i < BANDS; i++) {
      assertThat(Math.abs(found[i] - fine[i])).as("band %s", i).isLessThan(.005);
    }
  }

  /** The radiance of a white convex surface under a white sky is 1; rays that end take from it. */
  @Test
  void whiteMeshesUnderAWhiteSkyAreNearlyWhite() {
    for (Material white : List.of(matte(1), new Mirror(Texture.constant(Rgb.WHITE)))) {
      for (Integrator integrator : integrators(white)) {
        Random random = new Random(5);
        double sum = 0;
        int hits = 0;
        for (int i = 0; i < 8000; i++) {
          Ray ray = ray(random);
          if (hit(coarse(), ray).isPresent()) {
            double found = radiance(integrator, ray, i);
            assertThat(found).isLessThanOrEqualTo(1 + 1e-9);
            sum += found;
            hits++;
          }
        }
        assertThat(sum / hits).isGreaterThan(.999);
      }
    }
  }

  private static List<Integrator> integrators(Material white) {
    Scene scene = empty().add(coarse(), white).add(EnvironmentLight.uniform(Rgb.WHITE)).build();
    PathOptions bsdf = PathOptions.toDepth(40).by(MisHeuristic.BSDF).rouletteFrom(50);
    return List.of(new PathTracer(scene, bsdf));
  }

  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void techniquesAgree(MisHeuristic heuristic) {
    Scene scene =
        empty()
            .add(coarse(), matte(.8))
            .add(Mesh.of(ball(6, 9), Transform.translation(new Vec3(1.2, 1.1, 0))), matte(.5))
            .add(Sphere.of(new Vec3(3, .5, 0), .8), Unlit.INSTANCE, glow(5))
            .add(EnvironmentLight.uniform(Rgb.gray(.3)))
            .build();
    Ray ray = new Ray(new Vec3(.25, .1, 5), new Vec3(0, 0, -1));
    PathTracer bsdf = new PathTracer(scene, PathOptions.toDepth(4).by(MisHeuristic.BSDF));
    Estimate expected = Estimate.of(bsdf, ray, 512, 1);
    PathTracer other = new PathTracer(scene, PathOptions.toDepth(4).by(heuristic));
    Estimate found = Estimate.of(other, ray, 256, 2);
    assertThat(found.z(expected)).as("%s %s", found, expected).isLessThan(Estimate.CRITICAL);
    assertThat(expected.error()).isLessThan(.005 * expected.mean());
  }

  /** Lights are inside closed boxes that touch: nothing of them is seen outside. */
  @Test
  void touchingBoxesLeakNothing() {
    Scene scene =
        empty()
            .add(box(new Vec3(0, .5, 0), new Vec3(.5, .5, .5)), matte(1))
            .add(box(new Vec3(.2, -1, 0), new Vec3(1.5, 1, 1.5)), matte(1))
            .add(box(new Vec3(1.1, .25, .1), new Vec3(.6, .25, .6)), matte(1))
            .add(point(new Vec3(0, .5, 0), 100))
            .add(point(new Vec3(0, -.2, 0), 100))
            .add(point(new Vec3(.8, -.01, .3), 100))
            .add(point(new Vec3(1, .2, .2), 100))
            .build();
    PathTracer path = new PathTracer(scene, 3);
    RayTracer ray = new RayTracer(scene, 1, 1);
    Random random = new Random(6);
    for (int i = 0; i < 20_000; i++) {
      Vec3 to =
          new Vec3(2 * random.nextDouble() - .7, random.nextDouble() - .3, random.nextDouble());
      Vec3 from = direction(random).times(9);
      Ray inwards = new Ray(from, to.minus(from).normalized());
      assertThat(radiance(path, inwards, i)).isZero();
      assertThat(radiance(ray, inwards, i)).isZero();
    }
  }

  /** A sheet whose normals bend outwards lies just below another one, in its shadow. */
  @Test
  void sheetsBelowOthersStayDark() {
    double[] points = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    double[] normals = {-1, 1, -1, 1, 1, -1, 1, 1, 1, -1, 1, 1};
    int[] corners = {0, 2, 1, 0, 3, 2};
    double[] above = new double[12];
    for (int i = 0; i < 12; i++) {
      above[i] = i % 3 == 1 ? .001 : 1.01 * points[i];
    }
    Scene scene =
        empty()
            .add(Mesh.of(TriangleMesh.of(points, normals, NONE, corners)), matte(1))
            .add(Mesh.of(TriangleMesh.of(above, normals, NONE, corners)), matte(1))
            .add(new DirectionalLight(new Vec3(.3, -1, .2).normalized(), Rgb.WHITE))
            .build();
    PathTracer path = new PathTracer(scene, 1);
    Random random = new Random(7);
    for (int i = 0; i < 5000; i++) {
      double x = 2 * random.nextDouble() - 1;
      double z = 2 * random.nextDouble() - 1;
      Ray down = new Ray(new Vec3(x, .0005, z), new Vec3(.1, -1, .1).normalized());
      assertThat(radiance(path, down, i)).isZero();
      Ray up = new Ray(new Vec3(x, -1, z), Vec3.Y);
      assertThat(radiance(path, up, i)).isZero();
    }
  }

  @Test
  void onlySmoothMeshesAreLifted() {
    assertThat(hasLift(coarse())).isTrue();
    assertThat(hasLift(Sphere.of(Vec3.ZERO, 1))).isFalse();
    double[] points = {-1, -1, .3, 1, -1, .2, .1, 1.2, .1};
    Vec3 face = new Vec3(2, 0, -.1).cross(new Vec3(1.1, 2.2, -.2)).normalized();
    double[] flat = new double[9];
    for (int i = 0; i < 9; i += 3) {
      flat[i] = face.x();
      flat[i + 1] = face.y();
      flat[i + 2] = face.z();
    }
    for (double[] normals : new double[][] {NONE, flat}) {
      assertThat(hasLift(Mesh.of(TriangleMesh.of(points, normals, NONE, new int[] {0, 1, 2}))))
          .isFalse();
    }
  }
}
