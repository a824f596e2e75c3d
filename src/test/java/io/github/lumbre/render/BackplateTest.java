package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.Lens.Orthographic;
import io.github.lumbre.camera.Lens.Pinhole;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

  private static final Bounds3 CUBE = new Bounds3(new Vec3(-1, -1, -1), new Vec3(1, 1, 1));

  /** Returns a black cube without light before a white backplate; only its shadow is gray. */
  private static Image cube(Mode mode, Vec3 eye, Lens lens, boolean hasShadow) throws Exception {
    Backplate white = Backplate.plain(Rgb.WHITE);
    SceneBuilder scene =
        Scene.builder()
            .lookingAt(eye, Vec3.ZERO, eye.y() > 99 ? Vec3.Z : Vec3.Y, lens)
            .backplate(hasShadow ? white.withShadowOf(CUBE) : white);
    Matte black = Matte.of(Rgb.BLACK);
    for (Vec3 turn : List.of(Vec3.ZERO, new Vec3(90, 0, 0), new Vec3(0, 90, 0))) {
      for (double side : new double[] {-1, 1}) {
        Transform place =
            Transform.rotationDegrees(turn).times(Transform.translation(new Vec3(0, side, 0)));
        scene.add(new Rectangle(place, 2, 2, true), black);
      }
    }
    return render(
        new RenderSettings.Builder().size(48, 48).samples(64).threads(1).mode(mode).build(),
        scene.build());
  }

  /** Returns the light of each pixel. */
  private static double[] lights(Image image) {
    return IntStream.range(0, 48 * 48)
        .mapToDouble(i -> image.pixel(i % 48, i / 48).g())
        .toArray();
  }

  @ParameterizedTest
  @EnumSource(Mode.class)
  void whatStandsOnTheGroundHasAShadowFromAbove(Mode mode) throws Exception {
    Image image = cube(mode, new Vec3(0, 3, -8), new Pinhole(40), true);
    int foot = IntStream.range(0, 47).filter(y -> image.pixel(24, y).g() < .02).max().orElseThrow();
    // Half of the sky is behind the wall.
    assertThat(image.pixel(24, foot + 2).g()).isBetween(.55, .85);
    assertThat(image.pixel(24, foot + 5).g()).isBetween(image.pixel(24, foot + 2).g() + .05, 1.);
    for (int corner : new int[] {0, 47, 48 * 47, 48 * 48 - 1}) {
      assertThat(lights(image)[corner]).isEqualTo(1);
    }
  }

  @ParameterizedTest
  @CsvSource({"0, -8", "-3, -8", "200, 0"})
  void levelViewsAndPlansAndViewsFromBelowHaveNone(double y, double z) throws Exception {
    Vec3 eye = new Vec3(0, y, z);
    for (Lens lens : List.of(new Pinhole(40), new Orthographic(6))) {
      assertThat(lights(cube(Mode.PATH, eye, lens, true)))
          .isEqualTo(lights(cube(Mode.PATH, eye, lens, false)));
    }
  }

  @Test
  void boxesOfShadowsAreFinite() {
    Bounds3 endless = new Bounds3(Vec3.ZERO, new Vec3(1, Double.POSITIVE_INFINITY, 1));
    for (Bounds3 box : List.of(Bounds3.EMPTY, endless)) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> Backplate.plain(TOP).withShadowOf(box))
          .withMessageContaining("expected a finite box");
    }
  }
}
