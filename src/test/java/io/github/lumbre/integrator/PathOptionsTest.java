package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.TestScenes;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests the options of path tracers: their ranges, weights and probabilities. */
class PathOptionsTest {
  @Test
  void settingsDetermineTheIntegrator() {
    Scene scene = empty().build();
    RenderSettings settings =
        new RenderSettings.Builder().mode(Mode.PATH).maxTraceDepth(4).split(3).build();
    assertThat(PathOptions.of(settings)).isEqualTo(PathOptions.toDepth(4).splitInto(3));
    assertThat(Integrator.of(scene, settings)).isInstanceOf(PathTracer.class);
    RenderSettings ray = settings.toBuilder().mode(Mode.RAY).build();
    assertThat(Integrator.of(scene, ray)).isInstanceOf(RayTracer.class);
  }

  @Test
  void eachOptionIsSetAlone() {
    PathOptions plain =
        new PathOptions(
            9,
            MisHeuristic.BOTH,
            LightSamplerKind.PLACE,
            PathOptions.FIRST_ROULETTE,
            1,
            false,
            true);
    assertThat(PathOptions.toDepth(9)).isEqualTo(plain);
    PathOptions other =
        new PathOptions(9, MisHeuristic.LIGHT, LightSamplerKind.POWER, 5, 4, true, false);
    assertThat(
            plain
                .by(MisHeuristic.LIGHT)
                .by(LightSamplerKind.POWER)
                .rouletteFrom(5)
                .splitInto(4)
                .transparent(true)
                .withoutSpecularLinks())
        .isEqualTo(other);
    assertThat(other.by(MisHeuristic.LIGHT).splitInto(4).rouletteFrom(5)).isEqualTo(other);
    assertThat(other.by(LightSamplerKind.POWER)).isEqualTo(other);
  }

  @Test
  void optionsBelowTheirRangesAreRefused() {
    assertThat(PathOptions.toDepth(0).rouletteFrom(0).splitInto(1).maxDepth()).isZero();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> PathOptions.toDepth(-1))
        .withMessage("maxDepth, firstRoulette: expected at least 0, found -1, 1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> PathOptions.toDepth(1).rouletteFrom(-1))
        .withMessage("maxDepth, firstRoulette: expected at least 0, found 1, -1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> PathOptions.toDepth(1).splitInto(0))
        .withMessage("split: expected at least 1, found 0");
  }

  /** The weights of both techniques add up to 1 wherever both can find a light. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void weightsAddUpToOne(MisHeuristic heuristic) {
    for (double light = 1e-6; light < 1e7; light *= 10) {
      for (double bsdf = 1e-6; bsdf < 1e7; bsdf *= 10) {
        double lightWeight = heuristic.lightWeight(light, bsdf);
        double bsdfWeight = heuristic.bsdfWeight(bsdf, light);
        assertThat(lightWeight).isBetween(0.0, 1.0);
        assertThat(lightWeight + bsdfWeight).isCloseTo(1, within(1e-15));
        if (light == bsdf && heuristic.compareTo(MisHeuristic.LIGHT) < 0) {
          assertThat(lightWeight).isEqualTo(.5);
        }
      }
      assertThat(heuristic.bsdfWeight(light, 0)).isEqualTo(1);
    }
  }

  /** The power heuristic prefers the better technique more than the balance heuristic does. */
  @Test
  void heuristicsPreferTheHigherDensity() {
    assertThat(MisHeuristic.BALANCE.lightWeight(3, 1)).isCloseTo(.75, within(1e-15));
    assertThat(MisHeuristic.BALANCE.bsdfWeight(3, 1)).isCloseTo(.75, within(1e-15));
    assertThat(MisHeuristic.BOTH.lightWeight(3, 1)).isCloseTo(.9, within(1e-15));
    assertThat(MisHeuristic.BOTH.bsdfWeight(3, 1)).isCloseTo(.9, within(1e-15));
    assertThat(MisHeuristic.LIGHT.lightWeight(1, 3)).isEqualTo(1);
    assertThat(MisHeuristic.BSDF.bsdfWeight(1, 3)).isEqualTo(1);
  }

  /** Only BSDF sampling finds area lights by itself; no ray finds a point. */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void lightsAreSampledWhereThatCanHelp(MisHeuristic heuristic) {
    Scene area = empty().addAreaLight(ceilingLamp(1, 1, 2), glow(1)).build();
    Scene both = empty().addAreaLight(ceilingLamp(1, 1, 2), glow(1)).add(point(Vec3.Y, 1)).build();
    assertThat(heuristic.samplesLights(List.of())).isFalse();
    assertThat(heuristic.samplesLights(area.emitters())).isEqualTo(heuristic != MisHeuristic.BSDF);
    assertThat(heuristic.samplesLights(both.emitters())).isTrue();
  }

  private static double probability(LightSamplerKind kind, Scene scene, int emitter, Vec3 at) {
    LightSampler sampler = kind.over(scene);
    LightChoice choice = new LightChoice();
    choice.moveTo(at, Vec3.ZERO);
    sampler.choose(.5, choice);
    return sampler.probability(choice, emitter);
  }

  /** Of two lights, one is nearer and the other is stronger. */
  @Test
  void lightsAreSelectedEvenlyOrByPowerOrByPlace() {
    Scene scene = empty().add(point(Vec3.Y, 1)).add(point(new Vec3(0, 50, 0), 9)).build();
    assertThat(probability(LightSamplerKind.UNIFORM, scene, 0, Vec3.ZERO)).isEqualTo(.5);
    double byPower = probability(LightSamplerKind.POWER, scene, 1, Vec3.ZERO);
    assertThat(byPower).isGreaterThan(.6);
    assertThat(probability(LightSamplerKind.POWER, scene, 0, Vec3.ZERO))
        .isCloseTo(1 - byPower, within(1e-15));
    assertThat(probability(LightSamplerKind.PLACE, scene, 0, Vec3.ZERO)).isGreaterThan(.6);
  }

  @ParameterizedTest
  @EnumSource(LightSamplerKind.class)
  void scenesWithoutLightsHaveASampler(LightSamplerKind kind) {
    assertThat(kind.over(empty().add(sphere(0, 0, 0, 1), TestScenes.matte(1)).build())).isNotNull();
  }
}
