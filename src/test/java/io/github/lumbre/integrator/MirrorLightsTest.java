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
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Compares the light of lamps that are sampled in mirrors with what scattered rays find alone, at a
 * point of a floor that is lit by way of mirrors only. Lamps are large and mirrors near, so that
 * scattered rays find them often.
 */
class MirrorLightsTest {
  private static final Mirror SILVER = Mirror.of(new Rgb(.9, .8, .7));

  private static SceneBuilder room() {
    return empty().add(floor(), matte(.5));
  }

  private static final Sphere BALL = sphere(3.1, 2.6, 0, 2.5);

  /** A wall of light, and a low screen that hides it from the point but not from the mirror. */
  private static SceneBuilder ballAndLamp() {
    return room()
        .add(BALL, SILVER)
        .addAreaLight(new Rectangle(at(-3, 1.8, 0).times(turned(0, 0, -90)), 3, 3, false), glow(4))
        .add(new Rectangle(at(-.2, .45, 0).times(turned(0, 0, -90)), .9, 1.2, true), matte(0));
  }

  private static Optional<MirrorLights> mirrorLights(Scene scene) {
    return MirrorLights.of(ScatteredLight.sampling(scene));
  }

  private static boolean isUsed(SceneBuilder scene) {
    return mirrorLights(scene.build()).isPresent();
  }

  @ParameterizedTest
  @CsvSource({"2", "3", "6"})
  void theMeanIsThatOfScatteredRays(int depth) {
    assertSameMean(ballAndLamp().build(), depth);
  }

  @Test
  void samplingInTheMirrorHasATenthOfTheVariance() {
    Scene scene =
        room()
            .add(sphere(1.5, 1, 0, .9), SILVER)
            .addAreaLight(ceilingLamp(.5, .5, 3), glow(40))
            .add(new Rectangle(at(0, 1.5, 0), .3, .3, true), matte(0))
            .build();
    Moments expected = scattered(scene, 2);
    Moments found = samples(scene, PathOptions.toDepth(2));
    assertThat(found.z(expected)).isBetween(-4.0, 4.0);
    assertThat(found.variance()).isLessThan(.1 * expected.variance());
    assertThat(samples(scene, PathOptions.toDepth(1)).mean()).isZero();
  }

  /** What hides the mirror from the floor, or the lamp from the mirror. */
  @ParameterizedTest
  @CsvSource({".3, .3, -45", "-.6, 2, 60", "9, 9, 0"})
  void shadowsFallOnTheFloorAndOnTheMirror(double x, double y, double turn) {
    Rectangle screen = new Rectangle(at(x, y, .2).times(turned(0, 0, turn)), .4, .4, true);
    Scene scene = ballAndLamp().add(screen, matte(0)).build();
    assertSameMean(scene, 2);
    Moments open = samples(ballAndLamp().build(), PathOptions.toDepth(2));
    double change = Math.abs(samples(scene, PathOptions.toDepth(2)).mean() / open.mean() - 1);
    assertThat(change > .02).isEqualTo(x < 9);
  }

  @Test
  void mirrorsAndLampsAreSelectedWithTheirProbabilities() {
    SceneBuilder scene = ballAndLamp();
    scene.add(sphere(-1.2, .6, .5, .55), Mirror.of(Rgb.WHITE));
    scene.add(sphere(0, .5, -1.6, .5), SILVER);
    scene.add(sphere(.2, -3, .4, 1), SILVER);
    scene.addAreaLight(sphere(-1, 2, -1.5, .6), glow(6));
    scene.addAreaLight(
        new Rectangle(at(2, 2.5, 1).times(turned(70, 20, 0)), 1, 2, false),
        new Emission(Texture.constant(Rgb.gray(3)), true));
    scene.addBackground(.3);
    assertSameMean(scene.build(), 4);
  }

  /** Lights without a surface are left to other ways; they only take a part of the samples. */
  @Test
  void pointLightsAreNotSeenInMirrors() {
    Scene scene = ballAndLamp().add(point(new Vec3(-2, 2, 0), 5)).build();
    assertSameMean(scene, 2);
    assertThat(isUsed(room().add(sphere(1.5, 1, 0, .9), SILVER).add(point(Vec3.Y, 1)))).isFalse();
  }

  /**
   * The plane of the lamp cuts the first mirror. Its center sees the lamp's front, and so does the
   * second mirror; the point sees the lamp's back in the first.
   */
  @ParameterizedTest
  @CsvSource({"false", "true"})
  void lampsShineFromTheirOwnSide(boolean twoSided) {
    Emission emission = new Emission(Texture.constant(Rgb.gray(4)), twoSided);
    Transform facingX = at(1.2, 1.5, 2.2).times(turned(0, 0, -90));
    Scene scene =
        room()
            .add(sphere(1.5, 1, 0, .9), SILVER)
            .add(sphere(5.5, 2, 2.2, 3.5), SILVER)
            .addAreaLight(new Rectangle(facingX, 2.4, 2.4, false), emission)
            .build();
    assertSameMean(scene, 2);
  }

  /** Mirrors in mirrors: only a single reflection is sampled. */
  @Test
  void lightOfTwoReflectionsIsLeftToScatteredRays() {
    Scene scene = ballAndLamp().add(sphere(-1.5, 1, 0, .9), SILVER).build();
    assertSameMean(scene, 4);
  }

  @Test
  void branchesShareTheSampledReflection() {
    Scene scene = ballAndLamp().build();
    Moments split = samples(scene, PathOptions.toDepth(3).splitInto(4));
    assertThat(split.z(scattered(scene, 3))).isBetween(-4.0, 4.0);
  }

  @Test
  void onlyWholeMirrorsThatAreSpheresAreUsed() {
    SceneBuilder lamp = room().addAreaLight(ceilingLamp(2, 1.5, 3), glow(4));
    Scene plain = lamp.build();
    assertThat(isUsed(plain.toBuilder())).isFalse();
    assertThat(isUsed(plain.toBuilder().add(BALL, SILVER))).isTrue();
    assertThat(isUsed(plain.toBuilder().add(BALL, matte(.5)))).isFalse();
    assertThat(isUsed(plain.toBuilder().add(BALL, Mirror.of(Rgb.BLACK)))).isFalse();
    assertThat(isUsed(plain.toBuilder().add(BALL, SILVER, glow(1)))).isFalse();
    Shape ellipsoid = BALL.transformed(Transform.scale(new Vec3(1, 2, 1)));
    assertThat(isUsed(plain.toBuilder().add(ellipsoid, SILVER))).isFalse();
    assertThat(isUsed(plain.toBuilder().add(new Rectangle(at(0, 1, 0), 1, 1, false), SILVER)))
        .isFalse();
    SceneBuilder catcher =
        plain.toBuilder().add(BALL, SILVER).add(sphere(9, 1, 0, 1), ShadowCatcher.of(Rgb.WHITE));
    assertThat(isUsed(catcher)).isFalse();
  }

  /** A wall between floor and mirror faces away from the mirror. */
  @Test
  void surfacesThatFaceAwaySampleNothing() {
    PathRecorder recorder = new PathRecorder();
    Scene scene = ballAndLamp().add(sphere(0, .2, 0, .1), matte(.5)).build();
    Ray ray = new Ray(new Vec3(-3, .2, 0), Vec3.X);
    samples(scene, PathOptions.toDepth(2), RenderContext.recordedBy(recorder), ray, 1);
    assertThat(recorder.vertices().get(0).contributions())
        .allSatisfy(c -> assertThat(c.lights().get(0).source()).isNotEqualTo(Source.MIRROR));
  }

  /** More mirrors than are sampled; the smallest are found by scattered rays alone. */
  @Test
  void thereMayBeManyMirrors() {
    SceneBuilder scene = ballAndLamp();
    for (int i = 0; i < 40; i++) {
      scene.add(sphere(i % 7 - 3.3, .3, Math.floorDiv(i, 7) - 2.6, .01 * i + .02), SILVER);
    }
    assertSameMean(scene.build(), 3);
  }

  @Test
  void recordedLightsAddUpToTheSample() {
    assertRecordedLightsAddUp(ballAndLamp().build(), Source.MIRROR, 300);
  }

  /** Light that a mirror reflects is scattered twice, and belongs to the lamp's group. */
  @Test
  void layersTellReflectedLightFromDirectLight() {
    Scene scene =
        room()
            .lightGroup("lamp")
            .addAreaLight(ceilingLamp(.5, .5, 3), glow(40))
            .add(sphere(1.5, 1, 0, .9), SILVER)
            .add(new Rectangle(at(0, 1.5, 0), .3, .3, true), matte(0))
            .build();
    assertIsIndirectLightOfTheGroup(scene);
  }

  /** Whatever the sizes, radiance is finite. */
  @ParameterizedTest
  @CsvSource({"1e-150", "1e-12", "1e-3", "1e6", "1e100"})
  void extremeMirrorsHaveFiniteRadiance(double radius) {
    for (double gap : new double[] {1e-12, .1, 3}) {
      Scene scene =
          ballAndLamp().add(sphere(0, radius * (1 + gap) + .06, 0, radius), SILVER).build();
      Moments found = samples(scene, PathOptions.toDepth(4));
      assertThat(found.mean()).isBetween(0.0, 4.0);
      assertThat(found.variance()).isFinite();
    }
  }

  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void lampsTouchingTheMirrorHaveFiniteRadiance(MisHeuristic heuristic) {
    Scene scene =
        room()
            .add(sphere(1.5, 1, 0, .9), SILVER)
            .addAreaLight(new Rectangle(at(1.5, 1.9, 0), 1, 1, false), glow(4))
            .addAreaLight(ceilingLamp(9, 9, 1), glow(1))
            .addAreaLight(sphere(1.5, 1, 0, 1), glow(1))
            .build();
    Moments found = samples(scene, PathOptions.toDepth(4).by(heuristic));
    assertThat(found.mean()).isBetween(0.0, 10.0);
    assertThat(found.variance()).isFinite();
  }
}
