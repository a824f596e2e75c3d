package io.github.lumbre.integrator;

import static io.github.lumbre.integrator.ScatteredLight.assertIsIndirectLightOfTheGroup;
import static io.github.lumbre.integrator.ScatteredLight.assertRecordedLightsAddUp;
import static io.github.lumbre.integrator.ScatteredLight.assertSameMean;
import static io.github.lumbre.integrator.ScatteredLight.samples;
import static io.github.lumbre.integrator.ScatteredLight.scattered;
import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glass;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares the light of lamps that are sampled through clear glass with what scattered rays find
 * alone, at a point on the ground. Lamps are large, so that scattered rays find them often.
 */
class RefractedLightsTest {
  private static final Glass WATER =
      new Glass(
          Texture.constant(new Rgb(.9, .7, .5)),
          Texture.constant(new Rgb(.6, .8, 1)),
          ScalarTexture.constant(1.33),
          ScalarTexture.constant(0));

  /** Air inside the water. */
  private static final Glass HOLLOW =
      new Glass(
          Texture.constant(Rgb.WHITE),
          Texture.constant(Rgb.WHITE),
          ScalarTexture.constant(1 / 1.33),
          ScalarTexture.constant(0));

  private static final int CELLS = 24;

  private static Rectangle lamp() {
    return ceilingLamp(1.5, 1, 2.5);
  }

  /** A lamp above the surface of water; the ground is inside the water. */
  private static SceneBuilder under(Shape surface) {
    return empty().add(floor(), matte(.5)).add(surface, WATER).addAreaLight(lamp(), glow(4));
  }

  private static Shape flat() {
    return new Rectangle(at(0, 1, 0), 8, 8, true);
  }

  /** Waves at a height of 1, with smooth normals, that bend light enough to cross. */
  private static TriangleMesh waves(double height, boolean areSmooth) {
    int side = CELLS + 1;
    double[] positions = new double[3 * side * side];
    double[] normals = new double[areSmooth ? positions.length : 0];
    for (int i = 0; i < side * side; i++) {
      double x = 4.0 * (i % side) / CELLS - 2;
      double z = 4.0 * Math.floorDiv(i, side) / CELLS - 2;
      set(positions, i, x, 1 + height * Math.sin(4 * x) * Math.cos(3 * z), z);
      if (areSmooth) {
        double dx = 4 * height * Math.cos(4 * x) * Math.cos(3 * z);
        double dz = -3 * height * Math.sin(4 * x) * Math.sin(3 * z);
        Vec3 normal = new Vec3(-dx, 1, -dz).normalized();
        set(normals, i, normal.x(), normal.y(), normal.z());
      }
    }
    int[] indices = new int[6 * CELLS * CELLS];
    for (int cell = 0; cell < CELLS * CELLS; cell++) {
      int a = Math.floorDiv(cell, CELLS) * side + cell % CELLS;
      int[] corners = {a, a + side, a + 1, a + 1, a + side, a + side + 1};
      System.arraycopy(corners, 0, indices, 6 * cell, 6);
    }
    return TriangleMesh.of(positions, normals, new double[0], indices);
  }

  private static void set(double[] array, int i, double x, double y, double z) {
    array[3 * i] = x;
    array[3 * i + 1] = y;
    array[3 * i + 2] = z;
  }

  private static boolean isUsed(Scene scene) {
    return RefractedLights.of(ScatteredLight.sampling(scene)).isPresent();
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 6})
  void theMeanIsThatOfScatteredRays(int depth) {
    assertSameMean(under(flat()).build(), depth);
  }

  /** Some points of the lamp are refracted to the ground by several places of the waves. */
  @ParameterizedTest
  @CsvSource({".02, true", ".1, true", ".25, true", ".1, false"})
  void wavesOfAnyHeightMayBendLight(double height, boolean areSmooth) {
    assertSameMean(under(Mesh.of(waves(height, areSmooth))).build(), 2);
  }

  @Test
  void placedMeshesBendLightAsOthersDo() {
    Transform placed =
        at(.1, -.3, 0).times(turned(5, 30, -8)).times(Transform.scale(new Vec3(1.2, 1.3, -.9)));
    SharedMesh shared = new SharedMesh(waves(.08, true));
    assertSameMean(under(new MeshInstance(shared, placed)).build(), 2);
  }

  /** The ground is outside the glass, and the lamp inside. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void lightLeavesTheWaterAsItEnters(boolean isInfinite) {
    Transform upsideDown = at(0, 1, 0).times(turned(180, 0, 0));
    Shape surface =
        isInfinite ? new Plane(upsideDown, true) : new Rectangle(upsideDown, 8, 8, true);
    assertSameMean(under(surface).build(), 2);
  }

  @Test
  void samplingThroughTheSurfaceHasATenthOfTheVariance() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(Mesh.of(waves(.02, true)), WATER)
            .addAreaLight(ceilingLamp(.4, .4, 2.5), glow(40))
            .build();
    Moments expected = scattered(scene, 2);
    Moments found = samples(scene, PathOptions.toDepth(2));
    assertThat(found.z(expected)).isBetween(-4.0, 4.0);
    assertThat(found.variance()).isLessThan(.1 * expected.variance());
    assertThat(samples(scene, PathOptions.toDepth(1)).mean()).isZero();
  }

  /** A screen in the water, one above it, and one that hides nothing. */
  @ParameterizedTest
  @CsvSource({".5, .45", "2, .5", "1.5, 9"})
  void screensBlockLightOnBothSides(double height, double x) {
    Rectangle screen = new Rectangle(at(x, height, .1), .8, .5, true);
    Scene scene = under(flat()).add(screen, matte(0)).build();
    assertSameMean(scene, 2);
    double open = samples(under(flat()).build(), PathOptions.toDepth(2)).mean();
    double change = Math.abs(samples(scene, PathOptions.toDepth(2)).mean() / open - 1);
    assertThat(change > .02).isEqualTo(x < 9);
  }

  /** Two lamps above the water, one in it, and one that is half in it. */
  @Test
  void lampsAreSelectedWithTheirProbabilities() {
    Scene scene =
        under(Mesh.of(waves(.05, true)))
            .addAreaLight(sphere(1.4, 2, .5, .5), glow(3))
            .addAreaLight(sphere(-1.2, .5, .5, .3), glow(1))
            .addAreaLight(sphere(-1, 1, -1, .4), glow(2))
            .addAreaLight(
                new Rectangle(at(0, 1.7, -1.5).times(turned(110, 0, 0)), 1, 1, false),
                new Emission(Texture.constant(Rgb.gray(3)), true))
            .addBackground(.2)
            .add(point(new Vec3(.5, 3, 0), 3))
            .build();
    assertSameMean(scene, 3);
  }

  @Test
  void lightMayPassTwoSurfaces() {
    Scene scene = under(flat()).add(new Rectangle(at(0, 1.4, 0), 8, 8, true), WATER).build();
    assertSameMean(scene, 4);
    assertThat(samples(scene, PathOptions.toDepth(2)).mean()).isZero();
  }

  /** Lenses of each kind of shape; some points of the lamp are seen through several places. */
  @ParameterizedTest
  @MethodSource("lenses")
  void lensesMayBendLight(Shape lens) {
    Scene scene =
        empty().add(floor(), matte(.5)).add(lens, WATER).addAreaLight(lamp(), glow(4)).build();
    assertSameMean(scene, 3);
  }

  static List<Shape> lenses() {
    Transform squeezed =
        at(.1, .9, 0).times(turned(5, 30, -8)).times(Transform.scale(new Vec3(1.4, .5, -.9)));
    return List.of(
        sphere(.1, 1, 0, .6),
        new Sphere(squeezed, .8),
        new Box(at(0, .8, 0).times(turned(10, 20, 5)), 1.5, .4, 1.2));
  }

  /** A glass ball with a hollow inside; light passes two surfaces or four. */
  @ParameterizedTest
  @ValueSource(ints = {5, 7})
  void hollowGlassMayBendLight(int depth) {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(sphere(0, 1, .2, .7), WATER)
            .add(sphere(0, 1, .2, .6), HOLLOW)
            .addAreaLight(lamp(), glow(4))
            .build();
    assertSameMean(scene, depth);
  }

  @Test
  void samplingThroughAWallHasAFifthOfTheVariance() {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(new Box(at(0, .8, 0), 2, .4, 2), WATER)
            .add(new Box(at(0, 1.6, 0), 2, .2, 2), WATER)
            .addAreaLight(ceilingLamp(.4, .4, 2.5), glow(40))
            .build();
    Moments expected = scattered(scene, 5);
    Moments found = samples(scene, PathOptions.toDepth(5));
    assertThat(found.z(expected)).isBetween(-4.0, 4.0);
    assertThat(found.variance()).isLessThan(.2 * expected.variance());
  }

  @Test
  void branchesShareTheSampledLight() {
    Scene scene = under(Mesh.of(waves(.05, true))).build();
    Moments split = samples(scene, PathOptions.toDepth(3).splitInto(4));
    assertThat(split.z(scattered(scene, 3))).isBetween(-4.0, 4.0);
  }

  /** Dark glass, through which few scattered rays pass. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, 1.001, 2.4})
  void anyIndexMayRefract(double ior) {
    Glass dark =
        new Glass(
            Texture.constant(Rgb.WHITE),
            Texture.constant(Rgb.gray(.2)),
            ScalarTexture.constant(ior),
            ScalarTexture.constant(0));
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(Mesh.of(waves(.03, true)), dark)
            .addAreaLight(ceilingLamp(3, 3, 2.5), glow(4))
            .build();
    assertSameMean(scene, 2);
  }

  /** The lamp is inside the glass and far aside: refracted rays are far from the straight line. */
  @Test
  void raysMayBendFarFromTheStraightLine() {
    Glass diamond =
        new Glass(
            Texture.constant(Rgb.WHITE),
            Texture.constant(Rgb.WHITE),
            ScalarTexture.constant(2.4),
            ScalarTexture.constant(0));
    Rectangle lamp = new Rectangle(at(3, 2.5, 0).times(turned(180, 0, 0)), 2, 4, false);
    Rectangle surface = new Rectangle(at(0, 1, 0).times(turned(180, 0, 0)), 20, 20, true);
    Scene scene =
        empty().add(floor(), matte(.5)).add(surface, diamond).addAreaLight(lamp, glow(4)).build();
    assertSameMean(scene, 2);
  }

  @Test
  void onlyClearGlassIsUsed() {
    assertThat(isUsed(under(flat()).build())).isTrue();
    assertThat(isUsed(under(Mesh.of(waves(.1, true))).build())).isTrue();
    assertThat(isUsed(under(sphere(0, 1, 0, .5)).build())).isTrue();
    NormalMap bumps = new NormalMap(Texture.constant(new Rgb(.5, .6, .9)), UvMapping.IDENTITY, 1);
    for (Material other :
        new Material[] {
          WATER.withRoughness(.3), new NormalMapped(WATER, bumps), matte(.5),
        }) {
      Scene scene =
          empty().add(flat(), other).addAreaLight(lamp(), glow(1)).add(floor(), matte(1)).build();
      assertThat(isUsed(scene)).isFalse();
    }
    SceneBuilder catcher = under(flat()).add(sphere(9, 1, 0, 1), ShadowCatcher.of(Rgb.WHITE));
    assertThat(isUsed(catcher.build())).isFalse();
  }

  @Test
  void recordedLightsAddUpToTheSample() {
    assertRecordedLightsAddUp(under(Mesh.of(waves(.05, true))).build(), Source.REFRACTION, 150);
  }

  /** Refracted light is scattered twice, and belongs to the lamp's group. */
  @Test
  void layersTellRefractedLightFromDirectLight() {
    Scene scene =
        empty()
            .lightGroup("lamp")
            .addAreaLight(lamp(), glow(4))
            .add(floor(), matte(.5))
            .add(flat(), WATER)
            .build();
    assertIsIndirectLightOfTheGroup(scene);
  }

  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void lampsAtTheSurfaceHaveFiniteRadiance(MisHeuristic heuristic) {
    Scene scene =
        empty()
            .add(floor(), matte(.5))
            .add(Mesh.of(waves(.3, true)), WATER)
            .add(new Plane(at(0, 1e-9, 0), true), glass(1.5))
            .addAreaLight(ceilingLamp(3, 3, 1), glow(1))
            .addAreaLight(sphere(1.5, 1, 0, 1), glow(1))
            .build();
    Moments found = samples(scene, PathOptions.toDepth(5).by(heuristic));
    assertThat(found.mean()).isBetween(0.0, 10.0);
    assertThat(found.variance()).isFinite();
  }
}
