package io.github.lumbre.integrator;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION_COLOR;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.plastic;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static io.github.lumbre.testing.TestScenes.wall;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Light that passes surfaces diffusely, against closed forms. An estimate has 256 × 64 samples, and
 * eight times as many if no light is sampled; a standard error below 0.5 % of the value detects a
 * bias of 4 % with a probability above 0.99.
 */
class TranslucencyTest {
  private static final int SAMPLES = 64;
  private static final Ray FORWARD = new Ray(Vec3.ZERO, Vec3.Z);
  private static final double THROUGH = .8;

  private static MetallicRoughness.Builder paper(double strength) {
    return plastic(1)
        .set(DIFFUSE_TRANSMISSION, strength)
        .set(DIFFUSE_TRANSMISSION_COLOR, Rgb.gray(THROUGH));
  }

  private static void assertMean(Integrator integrator, double expected) {
    assertMean(integrator, SAMPLES, expected);
  }

  private static void assertMean(Scene scene, int depth, MisHeuristic heuristic, double expected) {
    int samples = heuristic == MisHeuristic.BSDF ? 8 * SAMPLES : SAMPLES;
    assertMean(new PathTracer(scene, PathOptions.toDepth(depth).by(heuristic)), samples, expected);
  }

  private static void assertMean(Integrator integrator, int samples, double expected) {
    Estimate estimate = Estimate.of(integrator, FORWARD, samples);
    assertThat(estimate.error()).isLessThan(.005 * expected);
    assertThat(estimate.z(expected))
        .as("%s, expected %s", estimate, expected)
        .isLessThan(Estimate.CRITICAL);
  }

  /** A point light at distance 1 behind a sheet, off the axis; its irradiance is cos / d². */
  @Test
  void pointLightBehindASheetShinesThrough() {
    Scene scene = empty().add(wall(2), paper(.6).build()).add(point(new Vec3(1, 0, 3), 1)).build();
    double expected = .6 * THROUGH / Math.PI * Math.sqrt(.5) / 2;
    assertMean(new PathTracer(scene, 1), expected);
    assertMean(new RayTracer(scene, 1, 4), expected);
  }

  /**
   * A sphere of radiance 1 above the horizon of a point at distance d gives the irradiance π (r/d)²
   * cos, and all ways to sample it agree.
   */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void sphereBehindASheetShinesThrough(MisHeuristic heuristic) {
    Scene scene =
        empty()
            .add(wall(2), paper(.6).build())
            .add(sphere(.8, 0, 4, 1), Unlit.INSTANCE, glow(1))
            .build();
    double square = .8 * .8 + 4;
    double expected = .6 * THROUGH / square * 2 / Math.sqrt(square);
    assertMean(scene, 1, heuristic, expected);
  }

  /**
   * A lamp in the middle of a spherical shade of radius 1: the shade reflects 1 - s of the light to
   * itself, except the fraction k = r² that the black lamp takes.
   */
  @ParameterizedTest
  @EnumSource(MisHeuristic.class)
  void lampShadeGlowsAsAnIntegratingSphere(MisHeuristic heuristic) {
    double k = .4 * .4;
    Scene scene =
        empty()
            .add(sphere(0, 0, 3, 1), paper(.6).build())
            .add(sphere(0, 0, 3, .4), Unlit.INSTANCE, glow(1))
            .build();
    double expected = .6 * THROUGH * k / (1 - .4 * (1 - k));
    assertMean(scene, 24, heuristic, expected);
  }

  /**
   * Light crosses an absorbing ball along chords of length 2 r cos θ, with cosine-distributed θ:
   * the mean of exp(-τ cos θ) with τ = 2 r σ is 2 (1 - (1 + τ) exp(-τ)) / τ².
   */
  @Test
  void volumesAbsorbLightBetweenTheirBoundaries() {
    Scene scene =
        empty()
            .add(
                sphere(0, 0, 3, 1),
                paper(1)
                    .set(ATTENUATION_COLOR, Rgb.gray(Math.exp(-1)))
                    .set(ATTENUATION_DISTANCE, 1)
                    .build())
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();
    double mean = 2 * (1 - 3 * Math.exp(-2)) / 4;
    assertThat(mean).isCloseTo(.297, within(1e-3));
    assertMean(new PathTracer(scene, 4), THROUGH * THROUGH * mean);
  }
}
