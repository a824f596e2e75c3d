package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** A surface in front of the camera, inside an orange ball: what guides of denoisers show. */
class DenoisingGuidesTest {
  private static final Rgb ORANGE = new Rgb(.8, .4, .1);
  private static final Rgb PALE = Rgb.gray(.9);

  private static MetallicRoughness.Builder surface(double metallic, double roughness) {
    return MetallicRoughness.builder()
        .set(MaterialParameter.BASE_COLOR, PALE)
        .set(MaterialParameter.METALLIC, metallic)
        .set(MaterialParameter.ROUGHNESS, roughness);
  }

  private static Material glass(double alpha) {
    return new Glass(
        Texture.constant(Rgb.WHITE),
        Texture.constant(Rgb.WHITE),
        ScalarTexture.constant(1.5),
        ScalarTexture.constant(alpha));
  }

  /** Returns the guide of the pixel in the middle: albedo, then normal. */
  private static float[][] guides(Material material, RenderSettings.Builder settings)
      throws InterruptedException {
    Transform upright = Transform.rotationDegrees(new Vec3(90, 30, 0));
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(20).camera(new Vec3(0, 0, -4), Frame.WORLD, 1))
            .add(new Sphere(Transform.IDENTITY, 20), new Matte(Texture.constant(ORANGE)))
            .add(new Rectangle(upright, 3, 3, true), material)
            .build();
    FilmRenderer renderer =
        new FilmRenderer(
            settings.size(1, 1).samples(256).set(Setting.LAYERS, Layer.FOR_DENOISING).build(),
            scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, 256, Progress.NONE);
    return new float[][] {
      film.develop(Layer.DENOISING_ALBEDO), film.develop(Layer.DENOISING_NORMAL)
    };
  }

  private static float[] albedo(Material material) throws InterruptedException {
    return guides(material, new RenderSettings.Builder())[0];
  }

  /** Each with the least share of orange light that its guide has. */
  static Stream<Arguments> clear() {
    return Stream.of(
        Arguments.of("smooth metal", surface(1, 0).build(), .99),
        Arguments.of("metal of roughness .05", surface(1, .05).build(), .99),
        Arguments.of(
            "coated metal", surface(1, 0).set(MaterialParameter.CLEARCOAT, 1).build(), .95),
        Arguments.of(
            "metal under sheen",
            surface(1, .05).set(MaterialParameter.SHEEN_COLOR, Rgb.gray(.3)).build(),
            .7),
        Arguments.of(
            "brushed metal that is smooth",
            surface(1, .04).set(MaterialParameter.ANISOTROPY, .02).build(),
            .99),
        Arguments.of("mostly metal", surface(.85, 0).build(), .75),
        Arguments.of(
            "pane that is hardly rough",
            surface(0, .05).set(MaterialParameter.TRANSMISSION, 1).build(),
            .99),
        Arguments.of(
            "pane that is mostly clear",
            surface(0, .05).set(MaterialParameter.TRANSMISSION, .8).build(),
            .7),
        Arguments.of("glass that is hardly rough", glass(.003), .99),
        Arguments.of("smooth reflection", CookTorrance.of(Rgb.BLACK, Rgb.WHITE, 0), .99),
        Arguments.of("mirror of narrow facets", CookTorrance.of(Rgb.BLACK, Rgb.WHITE, .003), .99),
        Arguments.of("narrow lobe", Phong.of(Rgb.gray(.1), Rgb.gray(.8), 1e6), .8));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("clear")
  void guidesAreSeenThroughClearMixtures(String name, Material material, double share)
      throws InterruptedException {
    float[] albedo = albedo(material);
    // An orange guide has no more blue than an eighth of its red; surfaces are gray.
    double blue = 1 - share + share / 8;
    assertThat(albedo[2] / albedo[0]).isLessThan((float) (blue * 1.02));
    assertThat(albedo[0]).isPositive();
  }

  static Stream<Arguments> blurred() {
    return Stream.of(
        Arguments.of("smooth plastic", surface(0, 0).build()),
        Arguments.of("metal of roughness .2", surface(1, .2).build()),
        Arguments.of(
            "brushed metal", surface(1, .04).set(MaterialParameter.ANISOTROPY, .5).build()),
        Arguments.of(
            "coated plastic", surface(0, .5).set(MaterialParameter.CLEARCOAT, 1).build()),
        Arguments.of("half metal, half plastic", surface(.4, 0).build()),
        Arguments.of("rough glass", glass(.1)),
        Arguments.of("wide lobe", Phong.of(Rgb.gray(.1), Rgb.gray(.8), 100)));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("blurred")
  void otherSurfacesAreGuidesThemselves(String name, Material material)
      throws InterruptedException {
    float[] albedo = albedo(material);
    assertThat(albedo[2]).isCloseTo(albedo[0], within(1e-6f));
  }

  /** A split path leaves the mirror by its first branch; ray mode follows no mirror with facets. */
  @Test
  void splitPathsAndRayModeHaveGuides() throws InterruptedException {
    Material metal = surface(1, .05).build();
    float[] split = guides(metal, new RenderSettings.Builder().set(Setting.SPLIT, 3))[0];
    assertThat(split[2] / split[0]).isCloseTo(.125f, within(.01f));
    float[][] inRayMode = guides(metal, new RenderSettings.Builder().mode(Mode.RAY));
    assertThat(inRayMode[0]).containsExactly(.9f, .9f, .9f);
    assertThat(inRayMode[1][2]).isCloseTo((float) -Math.cos(Math.toRadians(30)), within(1e-5f));
  }

  /** A ground that shows only its shadow is a flat guide, in the shadow and beside it. */
  @ParameterizedTest
  @EnumSource(Mode.class)
  void groundsOfShadowsHaveTheirNormal(Mode mode) throws InterruptedException {
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(60).camera(new Vec3(0, 1, -4), Frame.WORLD, .25))
            .add(new Rectangle(Transform.IDENTITY, 200, 200, true), ShadowCatcher.of(PALE))
            .add(
                new Sphere(Transform.translation(new Vec3(0, 3, -1)), 1.5),
                new Matte(Texture.constant(ORANGE)))
            .add(EnvironmentLight.uniform(Rgb.WHITE))
            .build();
    RenderSettings.Builder settings = new RenderSettings.Builder().size(1, 4).samples(64);
    settings.mode(mode).set(Setting.TRANSPARENT, true).set(Setting.LAYERS, Layer.FOR_DENOISING);
    FilmRenderer renderer = new FilmRenderer(settings.build(), scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, 64, Progress.NONE);
    float[] normal = film.develop(Layer.DENOISING_NORMAL);
    assertThat(film.develop().alpha(0, 3)).isBetween(.05f, .95f);
    assertThat(normal[9]).isZero();
    assertThat(normal[10]).isEqualTo(1);
    assertThat(normal[11]).isZero();
    assertThat(film.develop(Layer.DENOISING_ALBEDO)[10]).isZero();
  }
}
