package io.github.lumbre.scene;

import static io.github.lumbre.testing.TestScenes.glow;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIndexOutOfBoundsException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.Specialization;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import org.junit.jupiter.api.Test;

class SceneTest {
  private static final Camera CAMERA = Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1);
  private static final Material PAINTED = new Matte((u, v) -> Rgb.gray(.5 + .5 * Math.sin(u)));
  private static final Plane FLOOR = new Plane(Transform.IDENTITY, false);

  private final NearestHit hit = new NearestHit();

  private static SceneBuilder empty() {
    return Scene.builder().seenBy(CAMERA);
  }

  private static Sphere sphere(double x) {
    return new Sphere(Transform.translation(new Vec3(x, 0, 0)), 1);
  }

  private static Light point(double intensity) {
    return new PointLight(Vec3.ZERO, Rgb.gray(intensity), Falloff.INVERSE_SQUARE);
  }

  /** Returns a ray towards +x that begins at some x. */
  private static Ray from(double x) {
    return new Ray(new Vec3(x, 0, 0), Vec3.X);
  }

  @Test
  void textsStateNumbersAndSizes() {
    assertThat(empty().build()).hasToString("Scene of 0 objects and 0 lights");
    assertThat(new Image(3, 2, new float[18], new float[6]))
        .hasToString("Image of 3x2 pixels with alpha");
    assertThat(Image.black(4, 5)).hasToString("Image of 4x5 pixels");
    assertThat(Pixels.of(2, 1, 3, new byte[6])).hasToString("Pixels: 2x1, 3 channels of 8 bits");
    double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    TriangleMesh mesh = TriangleMesh.of(corners, new double[0], new double[0], new int[] {0, 1, 2});
    assertThat(mesh).hasToString("TriangleMesh of 1 triangles and 3 vertices");
    assertThat(MeshInstance.of(mesh)).hasToString("MeshInstance of 1 triangles");
    assertThat(Mesh.of(mesh)).hasToString("Mesh of 1 triangles");
    assertThat(CAMERA).asString().startsWith("PinholeCamera at Vec3[");
    assertThat(empty().add(sphere(0), Matte.GRAY))
        .hasToString("SceneBuilder with 1 objects, groups, models and lights");
    assertThat(Transform.translation(Vec3.X))
        .hasToString("[[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]");
    assertThat(sphere(2)).hasToString("Sphere around Vec3[x=2.0, y=0.0, z=0.0]");
    assertThat(Plane.floor(1))
        .hasToString(
            "Plane through Vec3[x=0.0, y=1.0, z=0.0] with normal Vec3[x=0.0, y=1.0, z=0.0]");
  }

  @Test
  void primitivesHaveTheNamesOfTheirObjectsAndMaterials() {
    Scene scene =
        empty()
            .name(Matte.GRAY, "gray")
            .add("ball", sphere(0), Matte.GRAY)
            .add(sphere(3), Matte.of(.5, .4, .3))
            .build();
    assertThat(scene.objectName(0)).isEqualTo("ball");
    assertThat(scene.materialName(0)).isEqualTo("gray");
    assertThat(scene.objectName(1)).isNotEmpty().isNotEqualTo("ball");
    assertThatIndexOutOfBoundsException().isThrownBy(() -> scene.objectName(2));
    assertThatIndexOutOfBoundsException().isThrownBy(() -> scene.materialName(-1));
  }

  @Test
  void emptySceneHasNothing() {
    Scene scene = empty().build();
    assertThat(scene.camera()).isSameAs(CAMERA);
    assertThat(scene.primitives()).isEmpty();
    assertThat(scene.lights()).isEmpty();
    assertThat(scene.emitters()).isEmpty();
    assertThat(scene.environments()).isEmpty();
    assertThat(scene.radius()).isZero();
    assertThat(scene.ambient()).isEqualTo(Rgb.BLACK);
    assertThat(scene.background(Vec3.X)).isEqualTo(Rgb.BLACK);
    assertThat(scene.intersect(from(0), hit)).isFalse();
    hit.aim(from(0));
    assertThat(scene.isOccluded(hit)).isFalse();
    assertThatNullPointerException()
        .isThrownBy(() -> Scene.builder().seenBy(null))
        .withMessage("camera");
  }

  @Test
  void raysHitTheNearestPrimitive() {
    Scene scene = empty().add(sphere(5), Matte.GRAY).add(sphere(10), PAINTED).build();
    assertThat(scene.intersect(from(0), hit)).isTrue();
    assertThat(hit.t()).isCloseTo(4, within(1e-12));
    assertThat(scene.primitiveAt(hit).shape()).isSameAs(scene.primitives().get(0).shape());
    assertThat(scene.surfaceAt(hit).position().x()).isCloseTo(4, within(1e-12));
    hit.aim(from(7));
    assertThat(scene.intersect(hit)).isTrue();
    assertThat(scene.primitiveAt(hit).material()).isSameAs(PAINTED);
    assertThat(scene.surfaceAt(hit).position().x()).isCloseTo(9, within(1e-12));
    hit.aim(from(20));
    assertThat(scene.intersect(hit)).isFalse();
  }

  @Test
  void raysAreOccludedByWhatLiesOnThem() {
    Scene scene = empty().add(sphere(5), Matte.GRAY).build();
    for (double end : new double[] {3.9, 4.1}) {
      hit.aim(new Ray(Vec3.ZERO, Vec3.X, end));
      assertThat(scene.isOccluded(hit)).isEqualTo(end > 4);
    }
  }

  @Test
  void lightsAreEmittersToo() {
    Light first = point(1);
    Light dome = EnvironmentLight.uniform(Rgb.WHITE);
    Scene scene = empty().add(first).add(dome).build();
    assertThat(scene.lights()).containsExactly(first, dome);
    assertThat(scene.emitters()).containsExactly(first, dome);
    assertThat(scene.environments()).containsExactly((EnvironmentLight) dome);
  }

  @Test
  void areaLightsAreSurfacesLightsAndEmitters() {
    Sphere shape = sphere(5);
    Scene scene = empty().addAreaLight(shape, glow(2)).build();
    assertThat(scene.lights()).containsExactly(new AreaLight(shape, glow(2)));
    assertThat(scene.emitters()).isEqualTo(scene.lights());
    assertThat(scene.primitives())
        .containsExactly(new Primitive(shape, Unlit.INSTANCE, Optional.of(glow(2))));
  }

  @Test
  void emissiveSurfacesAreEmittersAndNoLights() {
    Sphere shape = sphere(5);
    Scene scene = empty().add(shape, Unlit.INSTANCE, glow(2)).addBackground(Rgb.WHITE).build();
    assertThat(scene.lights()).isEmpty();
    assertThat(scene.emitters()).hasSize(2).contains(new AreaLight(shape, glow(2)));
    assertThat(scene.environments()).hasSize(1);
  }

  /** Black lights are never sampled; their surfaces are still visible. */
  @Test
  void blackLightsAreLeftOut() {
    SceneBuilder builder =
        empty()
            .add(point(0))
            .addAreaLight(sphere(5), glow(0))
            .add(sphere(9), Unlit.INSTANCE, glow(0))
            .addBackground(Rgb.BLACK);
    Scene scene = builder.build();
    assertThat(scene.lights()).isEmpty();
    assertThat(scene.emitters()).isEmpty();
    assertThat(scene.primitives()).hasSize(2);
    assertThat(scene.intersect(from(0), hit)).isTrue();
    assertThat(scene.emitterAt(hit)).isEqualTo(-1);
  }

  /** An infinite plane cannot be sampled: it lights other things only when a ray hits it. */
  @Test
  void infiniteEmittersAreHitAndNotSampled() {
    Scene scene = empty().add(FLOOR, Unlit.INSTANCE, glow(2)).build();
    assertThat(scene.emitters()).isEmpty();
    hit.aim(new Ray(Vec3.Y, Vec3.Y.negated()));
    assertThat(scene.intersect(hit)).isTrue();
    assertThat(scene.primitiveAt(hit).emission()).contains(glow(2));
    assertThat(scene.emitterAt(hit)).isEqualTo(-1);
  }

  @Test
  void assemblyCountsWhatItHas() {
    SceneAssembly builder = new SceneAssembly(CAMERA);
    assertThat(builder.primitiveCount()).isZero();
    builder.add(sphere(0), Matte.GRAY).add(point(1)).add(sphere(5), Unlit.INSTANCE, glow(1));
    assertThat(builder.primitiveCount()).isEqualTo(2);
    assertThat(builder.emitterCount()).isEqualTo(2);
  }

  @Test
  void emittersAreFoundFromWhatIsHit() {
    Scene scene =
        new SceneAssembly(CAMERA)
            .add(sphere(3), Matte.GRAY)
            .add(point(1))
            .add(sphere(6), Unlit.INSTANCE, glow(1))
            .addAreaLight(sphere(9), glow(2))
            .build();
    int[] expected = {-1, 1, 2};
    for (int i = 0; i < expected.length; i++) {
      assertThat(scene.intersect(from(3 * i + 1.5), hit)).isTrue();
      assertThat(scene.emitterAt(hit)).isEqualTo(expected[i]);
    }
  }

  /** Equal lights are distinguished by their order. */
  @Test
  void emittersAreFoundFromLightsAndEnvironments() {
    Scene scene =
        new SceneAssembly(CAMERA)
            .add(sphere(3), Unlit.INSTANCE, glow(1))
            .add(point(1))
            .addBackground(Rgb.WHITE)
            .add(point(1))
            .addAreaLight(FLOOR, glow(1))
            .add(EnvironmentLight.uniform(Rgb.gray(2)))
            .add(point(1))
            .build();
    assertThat(scene.emitters()).hasSize(6);
    int[] ofLights = {1, 3, 4, 5}; // not the infinite plane, which cannot be sampled
    assertThat(scene.lights()).hasSize(ofLights.length);
    for (int i = 0; i < ofLights.length; i++) {
      assertThat(scene.emitterOfLight(i)).as("light %d", i).isEqualTo(ofLights[i]);
    }
    assertThat(scene.environments()).hasSize(2);
    assertThat(scene.emitterOfEnvironment(0)).isEqualTo(2);
    assertThat(scene.emitterOfEnvironment(1)).isEqualTo(4);
  }

  @Test
  void backgroundIsTheSumOfWhatComesFromAllAround() {
    Scene scene =
        empty()
            .addBackground(new Rgb(1, 2, 3))
            .add(EnvironmentLight.uniform(new Rgb(.5, 0, 1)))
            .add(point(9))
            .build();
    assertThat(scene.background(Vec3.Y)).isEqualTo(new Rgb(1.5, 2, 4));
  }

  @Test
  void ambientIrradianceAddsUp() {
    Scene scene = empty().addAmbient(new Rgb(1, 2, 3)).addAmbient(new Rgb(.5, 0, 1)).build();
    assertThat(scene.ambient()).isEqualTo(new Rgb(1.5, 2, 4));
    assertThat(scene.emitters()).isEmpty();
  }

  @Test
  void radiusIsThatOfEverythingFinite() {
    SceneBuilder builder = empty().add(FLOOR, Matte.GRAY);
    assertThat(builder.build().radius()).isZero();
    builder.add(sphere(-5), Matte.GRAY).add(sphere(5), Matte.GRAY);
    assertThat(builder.build().radius()).isCloseTo(new Vec3(6, 1, 1).length(), within(1e-6));
  }

  @Test
  void oneEmitterIsNotChosenAmongOthers() {
    assertThat(empty().build().takes(Specialization.ONE_EMITTER)).isFalse();
    assertThat(empty().add(point(1)).build().takes(Specialization.ONE_EMITTER)).isTrue();
    assertThat(empty().add(point(1)).add(point(2)).build().takes(Specialization.ONE_EMITTER))
        .isFalse();
  }

  @Test
  void uniformMaterialsScatterByTheSameBsdfEverywhere() {
    Scene painted = empty().add(sphere(5), PAINTED).build();
    assertThat(painted.takes(Specialization.UNIFORM_MATERIALS)).isFalse();
    Scene scene = empty().add(sphere(5), Matte.GRAY).add(sphere(10), PAINTED).build();
    assertThat(scene.takes(Specialization.UNIFORM_MATERIALS)).isTrue();
    Material uniform = materialAt(scene, 0);
    assertThat(uniform.at(0, 0)).isSameAs(uniform.at(.3, .7)).isEqualTo(Matte.GRAY.at(0, 0));
    assertThat(materialAt(scene, 7)).isSameAs(PAINTED);
    assertThat(scene.primitives().get(0).material()).isSameAs(Matte.GRAY);
  }

  private Material materialAt(Scene scene, double x) {
    assertThat(scene.intersect(from(x), hit)).isTrue();
    return scene.primitiveAt(hit).material();
  }

  private static SceneBuilder one() {
    return empty()
        .addAreaLight(sphere(5), glow(3))
        .add(sphere(10), Matte.GRAY)
        .addAmbient(Rgb.WHITE);
  }

  @Test
  void withoutAShortcutAllElseIsTheSame() {
    Scene scene = one().build();
    for (Specialization shortcut : Specialization.values()) {
      Scene without = scene.without(shortcut);
      for (Specialization each : Specialization.values()) {
        assertThat(scene.takes(each)).isTrue();
        assertThat(without.takes(each)).isEqualTo(each != shortcut);
      }
      assertSameContent(without, scene);
    }
    Scene general = scene.without(Specialization.UNIFORM_MATERIALS);
    assertThat(materialAt(general, 7)).isSameAs(Matte.GRAY);
  }

  private void assertSameContent(Scene scene, Scene expected) {
    assertThat(scene.camera()).isSameAs(expected.camera());
    assertThat(scene.primitives()).isEqualTo(expected.primitives());
    assertThat(scene.lights()).isEqualTo(expected.lights());
    assertThat(scene.emitters()).isEqualTo(expected.emitters());
    assertThat(scene.environments()).isEqualTo(expected.environments());
    assertThat(scene.ambient()).isEqualTo(expected.ambient());
    assertThat(scene.radius()).isEqualTo(expected.radius());
    assertThat(scene.emitterOfLight(0)).isEqualTo(expected.emitterOfLight(0));
    NearestHit other = new NearestHit();
    for (double x : new double[] {0, 5, 7, 10, 20}) {
      assertThat(scene.intersect(from(x), hit)).isEqualTo(expected.intersect(from(x), other));
      if (hit.isHit()) {
        assertThat(hit.t()).isEqualTo(other.t());
        assertThat(scene.emitterAt(hit)).isEqualTo(expected.emitterAt(other));
      }
    }
  }

  @Test
  void everyKernelFindsTheSameHits() {
    Scene scene = one().build();
    Scene scalar = scene.searchedBy(Kernel.SCALAR);
    assertSameContent(scalar, scene);
    assertThat(scalar.takes(Specialization.ONE_EMITTER)).isTrue();
  }

  @Test
  void countedSearchesFindTheSameHits() {
    LongAdder visits = new LongAdder();
    Scene scene = one().build();
    Scene counting = scene.counting(visits);
    assertSameContent(counting, scene);
    assertThat(counting.takes(Specialization.UNIFORM_MATERIALS)).isTrue();
    assertThat(visits.sum()).isPositive();
  }
}
