package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens.Pinhole;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The camera sees a plain ground that changes from row to row, and nothing else does. */
class BackplateTest {
  private static final Rgb TOP = new Rgb(.75, .5, .25);
  private static final Rgb BOTTOM = new Rgb(.25, .25, .25);

  private static RenderSettings.Builder settings(Mode mode) {
    return new RenderSettings.Builder().size(16, 8).samples(4).threads(1).mode(mode);
  }

  private static SceneBuilder before(Backplate seen) {
    return Scene.builder()
        .lookingAt(new Vec3(0, 0, -5), Vec3.ZERO, Vec3.Y, new Pinhole(40))
        .add(EnvironmentLight.uniform(new Rgb(0, 0, 3)))
        .backplate(seen);
  }

  private static Image render(RenderSettings settings, Scene scene) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, settings.samples(), Progress.NONE);
    return film.develop();
  }

  @ParameterizedTest
  @EnumSource(Mode.class)
  void rowsHaveTheirPlaceBetweenTopAndBottom(Mode mode) throws InterruptedException {
    Image image = render(settings(mode).build(), before(new Backplate(TOP, BOTTOM)).build());
    for (int y = 0; y < 8; y++) {
      double part = (2 * y + 1) / 16.0;
      for (int x = 0; x < 16; x++) {
        Rgb seen = image.pixel(x, y);
        assertThat(seen.r()).isCloseTo(.75 - .5 * part, within(1e-6));
        assertThat(seen.g()).isCloseTo(.5 - .25 * part, within(1e-6));
        assertThat(seen.b()).isCloseTo(.25, within(1e-6));
      }
    }
  }

  @Test
  void partsOfAFrameHaveThePixelsOfTheWhole() throws InterruptedException {
    Scene scene = before(new Backplate(TOP, BOTTOM)).build();
    Image whole = render(settings(Mode.PATH).build(), scene);
    Image part = render(settings(Mode.PATH).crop(new Crop(3, 2, 5, 4)).build(), scene);
    for (int i = 0; i < 20; i++) {
      assertThat(part.pixel(i % 5, i / 5)).isEqualTo(whole.pixel(3 + i % 5, 2 + i / 5));
    }
  }

  /** A mirror before the camera shows the blue sky; a plain ball of glass bends it into view. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void mirrorsAndRefractionShowTheLight(boolean isGlass) throws InterruptedException {
    SceneBuilder scene = before(new Backplate(TOP, BOTTOM));
    if (isGlass) {
      scene.add(new Sphere(Transform.IDENTITY, 1), Glass.of(1.5));
    } else {
      Transform facing = Transform.rotationDegrees(new Vec3(-90, 0, 0));
      scene.add(new Rectangle(facing, 2, 2, true), new Mirror(Texture.constant(Rgb.WHITE)));
    }
    Rgb middle = render(settings(Mode.PATH).build(), scene.build()).pixel(8, 4);
    assertThat(middle.r()).isZero();
    assertThat(middle.b()).isGreaterThan(1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1e-300, Double.NaN, Double.POSITIVE_INFINITY})
  void componentsAreLight(double wrong) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Backplate(Rgb.WHITE, new Rgb(0, wrong, 0)))
        .withMessageStartingWith("bottom: expected finite components of at least 0, found");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Backplate.plain(Rgb.gray(wrong)))
        .withMessageStartingWith("top: ");
  }
}
