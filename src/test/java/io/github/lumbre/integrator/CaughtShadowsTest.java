package io.github.lumbre.integrator;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.testing.TestScenes.ceilingLamp;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Shadows on a floor that shows nothing else, against closed forms. An opacity has 16,384 samples:
 * its standard error is below 0.004.
 */
class CaughtShadowsTest {
  private static final int PIXELS = 256;
  private static final int SAMPLES = 64;

  /** The first pixels, in which the shadow is measured, too. */
  private static final int MEASURED = 64;

  private static final ShadowCatcher CATCHER = new ShadowCatcher(Texture.constant(Rgb.gray(.5)));

  private static SceneBuilder caught() {
    return empty().add(floor(), CATCHER);
  }

  private static Scene underSky(SceneBuilder scene) {
    return scene.add(EnvironmentLight.uniform(Rgb.WHITE)).build();
  }

  /**
   * Returns the fraction of camera rays that end at a surface. It is the same if the shadow is
   * measured for denoisers; the mean of what is measured is the same, and it has less noise.
   */
  private static double opacity(Integrator integrator, Ray ray) {
    SampleLayers layers = new SampleLayers(Set.of(Layer.DENOISING_ALPHA), empty().build());
    RenderContext measuring = RenderContext.collecting(layers);
    SobolSampler sampler = new SobolSampler(5);
    RenderContext context = new RenderContext();
    int opaque = 0;
    double sum = 0;
    double squares = 0;
    for (int pixel = 0; pixel < PIXELS; pixel++) {
      for (int sample = 0; sample < SAMPLES; sample++) {
        sampler.startSample(pixel, 3, sample);
        context.startSample();
        integrator.radiance(ray, sampler, context);
        opaque += context.hitSomething() ? 1 : 0;
        if (pixel < MEASURED) {
          measuring.startSample();
          layers.clear();
          integrator.radiance(ray, sampler, measuring);
          assertThat(measuring.hitSomething()).isEqualTo(context.hitSomething());
          layers.end(measuring.hitSomething());
          double alpha = layers.of(Layer.DENOISING_ALPHA)[0];
          sum += alpha;
          squares += alpha * alpha;
        }
      }
    }
    double opacity = (double) opaque / (PIXELS * SAMPLES);
    double mean = sum / (MEASURED * SAMPLES);
    assertThat(mean).isCloseTo(opacity, within(.015));
    double variance = squares / (MEASURED * SAMPLES) - mean * mean;
    assertThat(variance).isLessThanOrEqualTo(.2 * opacity * (1 - opacity));
    return opacity;
  }

  /**
   * Returns the fraction of a uniform sky that a square above its own middle hides from a floor
   * (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3, four quarters).
   */
  private static double hidden(double width, double height) {
    double a = .5 * width / height;
    double root = Math.sqrt(1 + a * a);
    return 4 * a / (Math.PI * root) * Math.atan(a / root);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "4, 1", "0.5, 2", "20, 1"})
  void opacityIsTheBlockedFractionOfTheSky(double width, double height) {
    Scene scene = underSky(caught().add(ceilingLamp(width, width, height), matte(.5)));
    double expected = hidden(width, height);
    for (Integrator each : List.of(new PathTracer(scene, 3), new RayTracer(scene, 2, 2))) {
      assertThat(opacity(each, lookingDownAt(0))).isCloseTo(expected, within(.02));
    }
  }

  @Test
  void pointLightsCastSharpShadows() {
    Scene scene =
        caught().add(ceilingLamp(1, 1, 1), matte(.5)).add(point(new Vec3(0, 2, 0), 3)).build();
    PathTracer tracer = new PathTracer(scene, 3);
    assertThat(opacity(tracer, lookingDownAt(.99))).isEqualTo(1);
    assertThat(opacity(tracer, lookingDownAt(1.01))).isZero();
  }

  @Test
  void lightsCountByTheirIrradiance() {
    Scene scene =
        caught()
            .add(ceilingLamp(.5, .5, 1), matte(.5))
            .add(point(new Vec3(0, 2, 0), 3))
            .add(point(new Vec3(2, 2, 0), 4))
            .build();
    // Irradiance 3 / 4 is blocked; 4 / 8 · cos 45° is not.
    double blocked = .75 / (.75 + .5 * Math.sqrt(.5));
    assertThat(opacity(new PathTracer(scene, 3), lookingDownAt(0))).isCloseTo(blocked, within(.02));
  }

  /** The sky, of irradiance π, is sampled by a density, the point light is not. */
  @Test
  void skiesAndPointLightsCountByTheirIrradiance() {
    Scene scene =
        underSky(caught().add(ceilingLamp(1, 1, 1), matte(.5)).add(point(new Vec3(0, 2, 0), 12)));
    double blocked = (3 + Math.PI * hidden(1, 1)) / (3 + Math.PI);
    assertThat(opacity(new PathTracer(scene, 3), lookingDownAt(0))).isCloseTo(blocked, within(.02));
  }

  @Test
  void panesCastShadowsThatTheirOpacityDims() {
    MetallicRoughness veil =
        MetallicRoughness.builder()
            .set(BASE_COLOR, ColorChannel.of(Rgb.gray(.5)))
            .set(OPACITY, ScalarChannel.of(.3))
            .build();
    Scene scene = caught().add(ceilingLamp(1, 1, 1), veil).add(point(new Vec3(0, 2, 0), 3)).build();
    assertThat(opacity(new PathTracer(scene, 3), lookingDownAt(0))).isCloseTo(.3, within(.02));
  }

  @Test
  void litFloorShowsTheSkyBehindIt() {
    Scene scene = underSky(caught());
    RenderContext context = new RenderContext();
    SobolSampler sampler = new SobolSampler(1);
    sampler.startSample(0, 0, 0);
    context.startSample();
    assertThat(new PathTracer(scene, 3).radiance(lookingDownAt(0), sampler, context))
        .isEqualTo(Rgb.WHITE);
  }

  @Test
  void shadowsAreBlackAndFloorsWithoutLightInvisible() {
    Scene scene =
        caught().add(ceilingLamp(1, 1, 1), matte(.5)).add(point(new Vec3(0, 2, 0), 3)).build();
    RenderContext context = new RenderContext();
    SobolSampler sampler = new SobolSampler(1);
    sampler.startSample(0, 0, 0);
    context.startSample();
    assertThat(new PathTracer(scene, 3).radiance(lookingDownAt(0), sampler, context).isBlack())
        .isTrue();
    assertThat(opacity(new PathTracer(caught().build(), 3), lookingDownAt(0))).isZero();
  }

  /** The other surfaces are lit as by a diffuse floor. */
  @Test
  void otherSurfacesSeeADiffuseFloor() {
    List<Double> means = new ArrayList<>();
    for (SceneBuilder floor : List.of(caught(), empty().add(floor(), CATCHER.surface()))) {
      Scene scene = underSky(floor.add(ceilingLamp(1, 1, 1), matte(.5)));
      PathTracer tracer = new PathTracer(scene, 3);
      SobolSampler sampler = new SobolSampler(5);
      RenderContext context = new RenderContext();
      double sum = 0;
      for (int sample = 0; sample < 4096; sample++) {
        sampler.startSample(0, 0, sample);
        context.startSample();
        sum += tracer.radiance(new Ray(new Vec3(.1, .5, 0), Vec3.Y), sampler, context).g();
      }
      means.add(sum / 4096);
    }
    assertThat(means.get(0)).isEqualTo(means.get(1));
    assertThat(means.get(0)).isGreaterThan(.1);
  }
}
