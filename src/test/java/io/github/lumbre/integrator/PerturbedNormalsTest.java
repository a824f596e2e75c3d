package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.glow;
import static io.github.lumbre.testing.TestScenes.lookingDownAt;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.sphere;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.Phong;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Surfaces with strongly perturbed normals do not create light or let it pass. */
class PerturbedNormalsTest {
  private static final Texture<Rgb> WHITE = Texture.constant(Rgb.WHITE);

  /** Returns a map of random normals, half of them below the surface. */
  private static NormalMap wild() {
    byte[] values = new byte[3 * 64 * 64];
    new SplittableRandom(67).nextBytes(values);
    Pixels pixels = Pixels.of(64, 64, 3, values);
    return new NormalMap(
        new ImageTexture(pixels, Role.NORMAL, Filter.NEAREST), new UvMapping(0, 0, 3, -2), 1);
  }

  static Stream<Material> opaque() {
    return Stream.of(
        matte(1),
        new Phong(WHITE, WHITE, ScalarTexture.constant(10)),
        rough(MicrofacetDistribution.BECKMANN, .3),
        rough(MicrofacetDistribution.GGX, .05),
        rough(MicrofacetDistribution.GGX, 0),
        new Mirror(WHITE));
  }

  private static CookTorrance rough(MicrofacetDistribution kind, double roughness) {
    return new CookTorrance(
        WHITE,
        WHITE,
        ScalarTexture.constant(roughness),
        ScalarTexture.constant(CookTorrance.DEFAULT_IOR),
        kind);
  }

  static Stream<Material> all() {
    return Stream.concat(
        opaque(),
        Stream.of(0., .3)
            .map(
                roughness ->
                    new Glass(
                        WHITE,
                        WHITE,
                        ScalarTexture.constant(1.5),
                        ScalarTexture.constant(roughness))));
  }

  @ParameterizedTest
  @MethodSource("all")
  void whiteFurnaceGetsNoBrighter(Material material) {
    Scene scene =
        empty()
            .add(sphere(0, 0, 5, 1), new NormalMapped(material, wild()))
            .addBackground(Rgb.WHITE)
            .build();
    PathTracer tracer = new PathTracer(scene, 20);
    double brightest = 0;
    for (int i = 0; i < 12; i++) {
      Vec3 target = new Vec3(.95 * Math.cos(i) * i / 12, .95 * Math.sin(i) * i / 12, 5);
      Estimate estimate = Estimate.of(tracer, new Ray(Vec3.ZERO, target.normalized()), 16, i);
      assertThat(estimate.mean()).isLessThan(1 + 1e-9 + Estimate.CRITICAL * estimate.error());
      brightest = Math.max(brightest, estimate.mean());
    }
    assertThat(brightest).isGreaterThan(.3);
  }

  @ParameterizedTest
  @MethodSource("opaque")
  void noLightComesThroughFromBehind(Material material) {
    Scene scene =
        empty()
            .add(floor(), new NormalMapped(material, wild()))
            .add(point(new Vec3(.2, -1, .1), 100))
            .addAreaLight(sphere(-1, -2, 0, 1), glow(100))
            .build();
    PathTracer tracer = new PathTracer(scene, 3);
    for (int i = 0; i < 40; i++) {
      assertThat(Estimate.of(tracer, lookingDownAt(.1 * i - 2), 1).mean()).isZero();
    }
  }

  @ParameterizedTest
  @MethodSource("opaque")
  void lightSamplingAndScatteringAgree(Material material) {
    Scene scene =
        empty()
            .add(floor(), new NormalMapped(material, wild()))
            .addAreaLight(sphere(.5, 2, .3, 1), glow(1))
            .build();
    PathTracer lights = new PathTracer(scene, PathOptions.toDepth(1).by(MisHeuristic.BOTH));
    PathTracer rays = new PathTracer(scene, PathOptions.toDepth(1).by(MisHeuristic.BSDF));
    for (int i = 0; i < 3; i++) {
      Ray ray = lookingDownAt(.9 * i - 1);
      Estimate both = Estimate.of(lights, ray, 32, i);
      Estimate scattered = Estimate.of(rays, ray, 64, 100 + i);
      assertThat(both.z(scattered)).isLessThan(Estimate.CRITICAL);
    }
  }
}
