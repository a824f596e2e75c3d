package io.github.lumbre.integrator;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.DISPERSION;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.sphere;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.TestScenes;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Light in a scene with dispersion is that of three scenes without it, one for each color, whose
 * glass has the index of refraction of that color.
 */
class DispersedLightTest {
  private static final double GLASS = 1.7;
  private static final double STRENGTH = 4;

  /** The index of refraction of each color: green's, and half of 0.7 · 4 / 20 to both sides. */
  private static final double[] INDICES = {1.63, 1.7, 1.77};

  private static final int REPLICATES = 200;

  /** Kinds of glass whose colors part. */
  private enum Kind {
    SMOOTH(MetallicRoughness.builder().set(ROUGHNESS, 0)),
    ROUGH(MetallicRoughness.builder().set(ROUGHNESS, .45)),
    TINTED(
        MetallicRoughness.builder()
            .set(ROUGHNESS, 0)
            .set(BASE_COLOR, new Rgb(.9, .5, .2))
            .set(ATTENUATION_COLOR, new Rgb(.3, .8, .6))),
    MIXED(MetallicRoughness.builder().set(ROUGHNESS, .3).set(METALLIC, .2)),
    COATED(MetallicRoughness.builder().set(ROUGHNESS, 0).set(CLEARCOAT, 1)),
    FADED(MetallicRoughness.builder().set(ROUGHNESS, 0).set(OPACITY, .9));

    private final MetallicRoughness.Builder glass;

    Kind(MetallicRoughness.Builder glass) {
      this.glass = glass;
    }

    private Material of(double ior, double dispersion) {
      if (this != MIXED) {
        glass.set(METALLIC, 0);
      }
      return glass
          .set(TRANSMISSION, 1)
          .set(ATTENUATION_DISTANCE, 2)
          .set(IOR, ior)
          .set(DISPERSION, dispersion)
          .build();
    }
  }

  /** A ball of glass between a large lamp and the ground, before a wall of another brightness. */
  private static Scene scene(Material glass) {
    return empty()
        .add(floor(), matte(.6))
        .add(Sphere.of(new Vec3(0, 1.2, 0), 1), glass)
        .add(sphere(1, 4.5, 0, 1), matte(0), glow(5))
        .build();
  }

  private static Moments[] light(Integrator integrator, Ray ray, int samples, long seed) {
    Moments[] colors = {new Moments(), new Moments(), new Moments()};
    Sampler sampler = new SobolSampler(seed);
    RenderContext context = new RenderContext();
    for (int replicate = 0; replicate < REPLICATES; replicate++) {
      Rgb sum = Rgb.BLACK;
      for (int i = 0; i < samples; i++) {
        sampler.startSample(replicate, 3, i);
        sum = sum.plus(integrator.radiance(ray, sampler, context));
      }
      colors[0].add(sum.r() / samples);
      colors[1].add(sum.g() / samples);
      colors[2].add(sum.b() / samples);
    }
    return colors;
  }

  /** Rays to the ground, through the ball to the lamp's edge, and to the ball's edge. */
  private static final Ray[] RAYS = {
    TestScenes.lookingDownAt(-.6, .05),
    TestScenes.lookingDownAt(0, .05),
    ray(new Vec3(0, .6, -5), new Vec3(-.1, .8, -1)),
    ray(new Vec3(0, 1.5, -5), new Vec3(.2, .5, -1))
  };

  private static Ray ray(Vec3 from, Vec3 to) {
    return new Ray(from, to.minus(from).normalized());
  }

  /**
   * Eight comparisons for each kind: 4.5 standard errors would be exceeded by chance once in 3000
   * runs of a kind; the numbers are fixed.
   */
  @ParameterizedTest
  @EnumSource(Kind.class)
  void colorsAreThoseOfThreeIndices(Kind kind) {
    int samples = 256;
    double difference = 0;
    for (Ray ray : RAYS) {
      PathOptions options = PathOptions.toDepth(8);
      Integrator dispersed = new PathTracer(scene(kind.of(GLASS, STRENGTH)), options);
      Moments[] found = light(dispersed, ray, samples, 1);
      for (int color = 0; color < 3; color++) {
        Integrator plain = new PathTracer(scene(kind.of(INDICES[color], 0)), options);
        Moments expected = light(plain, ray, samples, 2)[color];
        assertThat(found[color].z(expected)).as("%s %s", ray, color).isBetween(-4.5, 4.5);
      }
      difference = Math.max(difference, Math.abs(found[0].z(found[2])));
    }
    assertThat(difference).isGreaterThan(6);
  }

  /** Lamps are sampled through the clear ball, but not through the dispersive one before it. */
  @Test
  void clearGlassBesideKeepsTheMean() {
    Scene scene =
        empty()
            .add(floor(), matte(.6))
            .add(Sphere.of(new Vec3(0, 1.2, 0), 1), Kind.SMOOTH.of(GLASS, STRENGTH))
            .add(Sphere.of(new Vec3(.4, 2.7, 0), .5), TestScenes.glass(1.5))
            .add(sphere(1, 4.5, 0, 1), matte(0), glow(5))
            .build();
    PathOptions options = PathOptions.toDepth(8);
    PathOptions alone = options.by(MisHeuristic.BSDF).withoutSpecularLinks();
    for (Ray ray : new Ray[] {RAYS[0], RAYS[1]}) {
      Moments[] found = light(new PathTracer(scene, options), ray, 128, 1);
      Moments[] expected = light(new PathTracer(scene, alone), ray, 512, 2);
      for (int color = 0; color < 3; color++) {
        assertThat(found[color].z(expected[color])).as("%s %s", ray, color).isBetween(-4.5, 4.5);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Kind.class,
      names = {"SMOOTH", "ROUGH", "FADED"})
  void rayTracersDisperse(Kind kind) {
    for (Ray ray : new Ray[] {RAYS[2], RAYS[3]}) {
      Moments[] found = light(new RayTracer(scene(kind.of(GLASS, STRENGTH)), 4, 6), ray, 64, 1);
      for (int color = 0; color < 3; color++) {
        Integrator plain = new RayTracer(scene(kind.of(INDICES[color], 0)), 4, 6);
        Moments expected = light(plain, ray, 64, 2)[color];
        assertThat(found[color].z(expected)).as("%s %s", ray, color).isBetween(-4.5, 4.5);
      }
    }
  }

  /** Once dispersed, a path keeps its color: no sample is lost at the second surface. */
  @Test
  void pathsKeepTheirColor() {
    Scene scene =
        empty()
            .add(Sphere.of(Vec3.ZERO, 1), Kind.SMOOTH.of(GLASS, STRENGTH))
            .addBackground(Rgb.WHITE)
            .build();
    PathTracer tracer = new PathTracer(scene, 60);
    Sampler sampler = new SobolSampler(1);
    RenderContext context = new RenderContext();
    for (int i = 0; i < 2000; i++) {
      sampler.startSample(0, 0, i);
      Rgb light = tracer.radiance(RAYS[3], sampler, context);
      // Fresnel's equations give other fractions to each color at each surface.
      assertThat(light.r() + light.g() + light.b()).isBetween(2.7, 3.3);
    }
  }

  /** What denoisers see through dispersive glass is as bright as through other glass. */
  @Test
  void layersAreNotDarkened() {
    Set<Layer> layers = EnumSet.of(Layer.DENOISING_ALBEDO, Layer.ALBEDO);
    for (Ray ray : new Ray[] {RAYS[3], ray(new Vec3(0, 3, -5), new Vec3(0, 1.2, 0))}) {
      double[] sums = new double[2];
      for (int dispersive = 0; dispersive < 2; dispersive++) {
        Scene scene = scene(Kind.SMOOTH.of(GLASS, dispersive * .01));
        SampleLayers collector = new SampleLayers(layers, scene);
        RenderContext context = RenderContext.collecting(collector);
        PathTracer tracer = new PathTracer(scene, 8);
        Sampler sampler = new SobolSampler(3);
        for (int i = 0; i < 20_000; i++) {
          sampler.startSample(0, 0, i);
          context.startSample();
          collector.clear();
          tracer.radiance(ray, sampler, context);
          double[] albedo = collector.of(Layer.DENOISING_ALBEDO);
          sums[dispersive] += (albedo[0] + albedo[1] + albedo[2]) / 20_000;
        }
      }
      assertThat(sums[1]).isCloseTo(sums[0], within(.02));
    }
  }
}
