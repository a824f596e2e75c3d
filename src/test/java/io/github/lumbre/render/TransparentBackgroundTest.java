package io.github.lumbre.render;

import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.render.FilmLayersTest.scene;
import static io.github.lumbre.testing.Renders.film;
import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.plastic;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.texture.Texture;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that pixels with a transparent background contain the light of surfaces alone. */
class TransparentBackgroundTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;
  private static final Rgb COLOR = new Rgb(.25, .5, 1);
  private static final Rgb SKY = new Rgb(10, 20, 30);

  /** Turns a rectangle, whose normal is +y, to face the camera. */
  private static final Transform UPRIGHT = Transform.rotationDegrees(new Vec3(-90, 0, 0));

  /** Returns a black surface that lets a part of the rays pass. */
  private static Material veil(double opacity) {
    return plastic(0).set(OPACITY, opacity).build();
  }

  /** Returns surfaces of one color that no light changes: opaque, and with alpha before nothing. */
  private static SceneBuilder unlit() {
    return scene()
        .add(new Sphere(at(-.8, 0, 0), .6), Unlit.INSTANCE, glow(1))
        .add(new Rectangle(at(.9, 0, 0).times(UPRIGHT), 1.2, 2, true), veil(.5), glow(.5))
        .add(new Rectangle(at(.9, 0, .1).times(UPRIGHT), 1.5, 1, true), veil(.25), glow(.25));
  }

  /** Returns the emission of a surface whose color is that of the opaque ones times its opacity. */
  private static Emission glow(double opacity) {
    return new Emission(Texture.constant(COLOR.times(opacity)), true);
  }

  private static RenderSettings.Builder settings(Set<Layer> layers) {
    return new RenderSettings.Builder()
        .size(WIDTH, HEIGHT)
        .samples(16)
        .threads(1)
        .transparent(true)
        .set(Setting.LAYERS, layers);
  }

  /** The sums of the film decide everything else: layers, noise, and the denoised picture. */
  @ParameterizedTest
  @CsvSource({"PATH, 1", "PATH, 3", "RAY, 1"})
  void skiesDoNotChangePicturesOfUnlitSurfaces(Mode mode, int split) throws InterruptedException {
    RenderSettings settings =
        settings(EnumSet.allOf(Layer.class)).mode(mode).set(Setting.SPLIT, split).build();
    Film dark = film(settings, unlit().build());
    Film bright = film(settings, unlit().lightGroup("sky").addBackground(SKY).build());
    Film plate = film(settings, unlit().addBackground(SKY).backplate(SKY).build());
    assertThat(plate.develop().rgb()).isEqualTo(dark.develop().rgb());
    for (Layer layer : Set.of(Layer.DIRECT, Layer.VARIANCE, Layer.ALBEDO, Layer.DENOISING_ALBEDO)) {
      assertThat(bright.develop(layer)).as("%s", layer).isEqualTo(dark.develop(layer));
    }
    for (float light : bright.developLightGroup(0)) {
      assertThat(light).isZero();
    }
    Image image = bright.develop();
    int partial = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      float alpha = image.alpha(i % WIDTH, i / WIDTH);
      partial += alpha > 0 && alpha < 1 ? 1 : 0;
      assertThat(image.pixel(i % WIDTH, i / WIDTH)).isEqualTo(alpha == 0 ? Rgb.BLACK : COLOR);
    }
    assertThat(partial).isGreaterThan(60);
  }

  @ParameterizedTest
  @EnumSource(Mode.class)
  void mirrorsStillReceiveTheSky(Mode mode) throws InterruptedException {
    Scene scene =
        scene()
            .add(new Sphere(at(0, 0, 0), 1), new Mirror(Texture.constant(Rgb.gray(.5))))
            .addBackground(SKY)
            .build();
    Image image = film(settings(Set.of()).mode(mode).build(), scene).develop();
    assertThat(image.alpha(0, 0)).isZero();
    assertThat(image.pixel(0, 0)).isEqualTo(Rgb.BLACK);
    int covered = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      if (image.alpha(i % WIDTH, i / WIDTH) > 0) {
        covered++;
        assertThat(image.pixel(i % WIDTH, i / WIDTH)).isEqualTo(SKY.times(.5));
      }
    }
    assertThat(covered).isGreaterThan(50);
  }

  /** A floor that only catches shadows is black with alpha, whatever light falls on it. */
  @Test
  void caughtShadowsAreBlack() throws InterruptedException {
    Scene scene =
        scene()
            .add(new Rectangle(at(0, -1, 0), 9, 9, false), ShadowCatcher.of(Rgb.WHITE))
            .add(new Sphere(at(0, 9, 0), 4), Unlit.INSTANCE, Emission.of(COLOR))
            .add(new Sphere(at(0, -.5, 2), .3), new Mirror(Texture.constant(Rgb.BLACK)))
            .addBackground(SKY)
            .build();
    Image image = film(settings(Set.of()).build(), scene).develop();
    int partial = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      float alpha = image.alpha(i % WIDTH, i / WIDTH);
      partial += alpha > 0 && alpha < 1 ? 1 : 0;
      assertThat(image.pixel(i % WIDTH, i / WIDTH)).isEqualTo(Rgb.BLACK);
    }
    assertThat(partial).isGreaterThan(10);
  }
}
