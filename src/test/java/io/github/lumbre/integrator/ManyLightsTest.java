package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** In scenes with many lights, all light samplers give the same mean. */
class ManyLightsTest {
  private static final Texture<Rgb> GRAY = Texture.constant(Rgb.gray(.5));

  /** Adds small lights of four kinds between the floor and a height of 4. */
  private static SceneBuilder lights(SceneBuilder scene, int count) {
    SplittableRandom random = new SplittableRandom(count);
    double side = 2 + Math.sqrt(count) / 4;
    for (int i = 0; i < count; i++) {
      double x = random.nextDouble(-side, side);
      double y = random.nextDouble(.5, 4);
      double z = random.nextDouble(-side, side);
      double strength = random.nextDouble(.1, 1);
      Vec3 turn = new Vec3(random.nextDouble(360), random.nextDouble(360), 0);
      switch (i % 4) {
        case 0 -> scene.add(point(new Vec3(x, y, z), .01 * strength));
        case 1 ->
            scene.add(
                new SpotLight(
                    point(new Vec3(x, y, z), .02 * strength),
                    turned(turn.x(), turn.y(), 0).vector(Vec3.Y),
                    40,
                    20));
        case 2 -> scene.addAreaLight(sphere(x, y, z, .05), glow(strength));
        default ->
            scene.addAreaLight(
                new Rectangle(at(x, y, z).times(turned(turn.x(), turn.y(), 0)), .2, .1, false),
                glow(strength));
      }
    }
    return scene;
  }

  private static LightSampler even(Scene scene) {
    return LightSampler.byPower(new double[scene.emitters().size()]);
  }

  /** Whitted ray tracing samples every light, so it is independent of light samplers. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 20, 100, 1000, 10_000})
  void choiceAtRandomHasTheMeanOfAllLights(int count) {
    Scene scene =
        lights(empty().add(floor(), matte(.5)).add(sphere(.4, .3, .1, .3), matte(.5)), count)
            .build();
    Ray ray = lookingDownAt(-.2);
    Estimate all = Estimate.of(new RayTracer(scene, 0, 0), ray, count > 100 ? 1 : 16, 1);

    Estimate chosen = Estimate.of(new PathTracer(scene, 1), ray, 128, 2);

    assertThat(all.error()).isLessThan(2e-3 * all.mean());
    assertThat(chosen.error()).isLessThan(1e-2 * all.mean());
    assertThat(chosen.z(all)).isLessThan(Estimate.CRITICAL);
  }

  /** Half of the lamps shine into a cone of 60 degrees, the others all around. */
  @ParameterizedTest
  @ValueSource(ints = {2, 6, 100})
  void lampsWithProfilesHaveTheMeanOfAllLights(int count) {
    SceneBuilder builder = empty().add(floor(), matte(.5)).add(sphere(.4, .3, .1, .3), matte(.5));
    SplittableRandom random = new SplittableRandom(count);
    for (int i = 0; i < count; i++) {
      Vec3 place = new Vec3(random.nextDouble(-3, 3), 2, random.nextDouble(-3, 3));
      double end = i % 2 == 0 ? 60 : 180;
      LightProfile lamp =
          new LightProfile(
              new double[] {0, end / 2, end},
              new double[] {0, 180, 360},
              new int[] {0, 1, 0},
              new double[] {.1, .4, 0, .1, .01, 0});
      builder.add(
          lamp.light(
              point(place, random.nextDouble(.1, 1)),
              turned(random.nextDouble(60, 120), random.nextDouble(360), 0)));
    }
    Scene scene = builder.build();
    Ray ray = lookingDownAt(-.2);
    Estimate all = Estimate.of(new RayTracer(scene, 0, 0), ray, 16, 1);

    Estimate chosen = Estimate.of(new PathTracer(scene, 1), ray, 256, 2);

    assertThat(all.error()).isLessThan(2e-3 * all.mean());
    assertThat(chosen.error()).isLessThan(1e-2 * all.mean());
    assertThat(chosen.z(all)).isLessThan(Estimate.CRITICAL);
  }

  @ParameterizedTest
  @CsvSource({"100, .5", "10000, .25"})
  void evenChoiceHasTheSameMeanAndMuchMoreNoise(int count, double ratio) {
    Scene scene = lights(empty().add(floor(), matte(.5)), count).build();
    Ray ray = lookingDownAt(-.2);

    Estimate even =
        Estimate.of(new PathTracer(scene, PathOptions.toDepth(1), even(scene)), ray, 64, 3);
    Estimate chosen = Estimate.of(new PathTracer(scene, 1), ray, 64, 4);

    assertThat(chosen.z(even)).isLessThan(Estimate.CRITICAL);
    assertThat(chosen.error()).isLessThan(ratio * even.error());
  }

  /** On glossy surfaces, BSDF sampling finds the lights about as often as light sampling. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void everyStrategyHasTheMeanOfEvenChoices(MisHeuristic strategy) {
    CookTorrance glossy =
        new CookTorrance(
            GRAY,
            GRAY,
            ScalarTexture.constant(.2),
            ScalarTexture.constant(CookTorrance.DEFAULT_IOR),
            MicrofacetDistribution.GGX);
    SceneBuilder builder = empty().add(floor(), glossy).add(EnvironmentLight.uniform(Rgb.gray(.1)));
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 6; i++) {
      Vec3 place = new Vec3(random.nextDouble(-2, 2), 1.5, random.nextDouble(-2, 2));
      builder.addAreaLight(
          new Rectangle(
              at(place.x(), place.y(), place.z()).times(turned(150 + 10 * i, 20, 0)),
              1,
              .5 + .1 * i,
              false),
          glow(1 + i));
    }
    Scene scene = builder.build();
    Ray ray = lookingDownAt(.1);
    Estimate even =
        Estimate.of(new PathTracer(scene, PathOptions.toDepth(2), even(scene)), ray, 256, 1);

    Estimate estimate =
        Estimate.of(new PathTracer(scene, PathOptions.toDepth(2).by(strategy)), ray, 512, 2);

    assertThat(even.error()).isLessThan(4e-3 * even.mean());
    assertThat(estimate.error()).isLessThan(1e-2 * even.mean());
    assertThat(estimate.z(even)).isLessThan(Estimate.CRITICAL);
  }

  @ParameterizedTest
  @EnumSource(LightSamplerKind.class)
  void everySelectionHasTheSameMean(LightSamplerKind selection) {
    Scene scene = lights(empty().add(floor(), matte(.5)), 40).build();
    Ray ray = lookingDownAt(-.2);
    Estimate chosen = Estimate.of(new PathTracer(scene, 2), ray, 256, 3);

    PathOptions options = PathOptions.toDepth(2).by(selection);
    Estimate estimate = Estimate.of(new PathTracer(scene, options), ray, 512, 4);

    assertThat(estimate.error()).isLessThan(1e-2 * chosen.mean());
    assertThat(estimate.z(chosen)).isLessThan(Estimate.CRITICAL);
  }

  @Test
  void groundGlassIsLitFromBehind() {
    Glass ground =
        new Glass(
            Texture.constant(Rgb.WHITE),
            Texture.constant(Rgb.WHITE),
            ScalarTexture.constant(1.5),
            ScalarTexture.constant(.5));
    Scene scene =
        empty()
            .add(new Rectangle(at(0, 0, 0), 4, 4, true), ground)
            .add(point(new Vec3(.3, -1, .2), 1))
            .add(point(new Vec3(-.5, -2, .1), 3))
            .add(point(new Vec3(.4, 2, .3), .2))
            .build();
    Ray ray = lookingDownAt(0);
    Estimate even =
        Estimate.of(new PathTracer(scene, PathOptions.toDepth(1), even(scene)), ray, 512, 1);

    Estimate chosen = Estimate.of(new PathTracer(scene, 1), ray, 512, 2);

    assertThat(even.mean()).isGreaterThan(.02);
    assertThat(even.error()).isLessThan(5e-3 * even.mean());
    assertThat(chosen.z(even)).isLessThan(Estimate.CRITICAL);
  }
}
