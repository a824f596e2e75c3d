package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.geometry.SurfaceSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.model.internal.ModelSurface;
import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which side of a glTF surface is its front, and the normals with which it is shaded. */
class GltfFrontTest {
  private static final int RINGS = 6;
  private static final int SECTORS = 8;

  /** Returns a file of a ball, wound outwards, whose normals are multiplied by a number. */
  private static GltfFile ball(double normal, String node) {
    return ball(normal, node, corners(RINGS));
  }

  /** Returns the corners of the triangles of the first rings. */
  private static int[] corners(int rings) {
    int[] corners = new int[6 * rings * SECTORS];
    for (int i = 0; i < rings * SECTORS; i++) {
      int next = i % SECTORS == SECTORS - 1 ? i - SECTORS + 1 : i + 1;
      int[] two = {i, i + SECTORS, next, next, i + SECTORS, next + SECTORS};
      System.arraycopy(two, 0, corners, 6 * i, 6);
    }
    return corners;
  }

  private static GltfFile ball(double normal, String node, int[] corners) {
    GltfFile file = new GltfFile();
    double[] positions = new double[3 * (RINGS + 1) * SECTORS];
    for (int i = 0; i < (RINGS + 1) * SECTORS; i++) {
      double polar = Math.PI * (i / SECTORS) / RINGS;
      double azimuth = 2 * Math.PI * (i % SECTORS) / SECTORS;
      positions[3 * i] = Math.sin(polar) * Math.sin(azimuth);
      positions[3 * i + 1] = Math.cos(polar);
      positions[3 * i + 2] = Math.sin(polar) * Math.cos(azimuth);
    }
    double[] normals = positions.clone();
    for (int i = 0; i < normals.length; i++) {
      normals[i] *= normal;
    }
    String attributes =
        "'POSITION': "
            + file.floats("VEC3", positions)
            + (normal == 0 ? "" : ", 'NORMAL': " + file.floats("VEC3", normals));
    double[] moves = new double[positions.length];
    for (int i = 0; i < moves.length; i += 3) {
      moves[i] = -2 * positions[i];
    }
    String targets = ", 'targets': [{'POSITION': " + file.floats("VEC3", moves) + "}]";
    int mesh = file.mesh(attributes, ", 'indices': " + file.ints("SCALAR", corners) + targets);
    file.set("scenes", "[{'nodes': [0]}]");
    file.set("nodes", "[" + node.replace("MESH", "'mesh': " + mesh) + "]");
    return file;
  }

  private static ModelSurface surface(GltfFile file, boolean shared)
      throws ModelFormatException, IOException {
    ModelScene scene =
        new ModelScene(file.read(), ModelScene.TO_LEFT_HANDED, Kernel.AUTO, Limits.NONE, shared);
    return scene.surfaces().get(0);
  }

  private static SurfaceHit hit(Shape shape, Ray ray) {
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    assertThat(shape.intersect(nearest)).isTrue();
    return shape.surfaceAt(nearest);
  }

  private static Ray inwards(Random random) {
    Vec3 to = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    return new Ray(to.normalized().times(9), to.normalized().negated());
  }

  /** A pose that mirrors a one-sided ball leaves its outside to be seen and to be lit. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 1, -1})
  void posesThatTurnMeshesInsideOutKeepTheFrontOfTheRest(double normal) throws Exception {
    Random random = new Random(7);
    for (double weight : new double[] {0, .4, .6, 1}) {
      GltfFile file = ball(normal, "{MESH, 'weights': [%s]}".formatted(weight));
      Model model = file.read();
      if (weight > .5) {
        assertThat(model.warnings()).singleElement().asString().contains("inside out");
      } else {
        assertThat(model.warnings()).isEmpty();
      }
      ModelSurface surface = surface(file, false);
      for (int i = 0; i < 20; i++) {
        SurfaceHit hit = hit(surface.shape(), inwards(random));
        assertThat(hit.isFrontal()).as("%s %s", weight, i).isTrue();
        assertThat(surface.material().transmittance(hit)).isEqualTo(Rgb.BLACK);
      }
    }
  }

  /**
   * One-sided bodies whose fronts are inside are named if they are open, if only at the pole, where
   * rounding leaves a gap: no light reaches what is seen of them. A cap has no inside.
   */
  @ParameterizedTest
  @CsvSource({
    "6, false, false", "6, true, true", "5, true, true", "5, false, false", "1, true, false"
  })
  void openBodiesThatAreInsideOutAreNamed(int rings, boolean turned, boolean named)
      throws Exception {
    int[] corners = corners(rings);
    for (int i = 0; turned && i < corners.length; i += 3) {
      int first = corners[i];
      corners[i] = corners[i + 1];
      corners[i + 1] = first;
    }
    GltfFile file = ball(1, "{MESH}", corners);
    ModelScene scene =
        new ModelScene(file.read(), ModelScene.TO_LEFT_HANDED, Kernel.AUTO, Limits.NONE, false);
    scene.surfaces();
    assertThat(scene.warnings())
        .hasSize(named ? 1 : 0)
        .allMatch(text -> text.matches("nodes\\[0].mesh.primitives\\[0]: .* inside out.*"));
  }

  /** Whatever the normals are, the outside is seen, emits, and is shaded as with right normals. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "{MESH}",
        "{MESH, 'scale': [-1, 1, 1]}",
        "{MESH, 'scale': [-1, -2, -1]}",
        "{'scale': [1, 1, -2], 'children': [1]}, {MESH, 'rotation': [0.6, 0, 0, 0.8]}",
        "{'scale': [1, -1, 1], 'children': [1]}, {MESH, 'scale': [1, 2, -1]}"
      })
  void windingDecides(String node) throws ModelFormatException, IOException {
    Random random = new Random(1);
    for (boolean shared : new boolean[] {false, true}) {
      Shape right = surface(ball(1, node), shared).shape();
      for (double normal : new double[] {1, 0, -1, -3}) {
        ModelSurface ball = surface(ball(normal, node), shared);
        for (int i = 0; i < 50; i++) {
          Ray ray = inwards(random);
          SurfaceHit hit = hit(ball.shape(), ray);
          assertThat(hit.isFrontal()).isTrue();
          assertThat(ball.material().transmittance(hit)).isEqualTo(Rgb.BLACK);
          if (normal != 0) {
            Vec3 expected = hit(right, ray).shadingNormal();
            assertThat(hit.shadingNormal().minus(expected).length()).isLessThan(1e-6);
          }
          SurfaceSample sample = new SurfaceSample();
          Vec3 eye = ray.origin();
          ball.shape().sample(eye.x(), eye.y(), eye.z(), random.nextDouble(), .3, sample);
          assertThat(sample.normal().dot(sample.position())).isPositive();
        }
      }
    }
  }

  /** A ball that is wound inwards is seen from inside, as a room. */
  @Test
  void insidesAreHidden() throws ModelFormatException, IOException {
    for (double normal : new double[] {1, 0, -1}) {
      ModelSurface ball = surface(ball(normal, "{MESH}"), false);
      Material material = ball.material();
      SurfaceHit hit = hit(ball.shape(), new Ray(new Vec3(.1, .2, .3), Vec3.X));
      assertThat(hit.isFrontal()).isFalse();
      assertThat(material.transmittance(hit)).isEqualTo(Rgb.WHITE);
    }
  }

  /** Normals of plants often point upwards, along the surface; rounding must not turn it. */
  @Test
  void normalsAlongTheSurfaceDoNotTurnIt() throws ModelFormatException, IOException {
    Random random = new Random(2);
    for (int i = 0; i < 200; i++) {
      double angle = 2 * Math.PI * random.nextDouble();
      double lean = i % 2 == 0 ? 0 : .3 * random.nextGaussian();
      double x = Math.cos(angle);
      double z = -Math.sin(angle);
      Vec3 across = new Vec3(x, 0, z);
      Vec3 front = new Vec3(-z, 0, x).plus(lean, Vec3.Y).normalized();
      Vec3 up = front.cross(across);
      GltfFile file = new GltfFile();
      int positions =
          file.floats(
              "VEC3", 0, 0, 0, x, 0, z, x + up.x(), up.y(), z + up.z(), up.x(), up.y(), up.z());
      int normals = file.floats("VEC3", 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0);
      file.meshNode(
          "'POSITION': " + positions + ", 'NORMAL': " + normals,
          ", 'indices': " + file.ints("SCALAR", 0, 1, 2, 0, 2, 3));
      ModelScene scene =
          new ModelScene(file.read(), Transform.IDENTITY, Kernel.AUTO, Limits.NONE, i % 3 == 0);
      Vec3 middle = across.plus(up).times(.5);
      Shape card = scene.surfaces().get(0).shape();
      SurfaceHit hit = hit(card, new Ray(middle.plus(front), front.negated()));
      assertThat(hit.isFrontal()).isTrue();
      assertThat(hit.geometricNormal().dot(front)).isGreaterThan(.999999);
      // Reflected at the card where they point to its back.
      Vec3 expected = Vec3.Y.plus(-2 * Math.min(0, front.y()), front);
      assertThat(hit.shadingNormal().minus(expected).length()).isLessThan(1e-5);
    }
  }
}
