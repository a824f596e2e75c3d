package io.github.lumbre.render;

import static io.github.lumbre.testing.Renders.film;
import static io.github.lumbre.testing.TestScenes.glass;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.checkpoint.FilmFixture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.texture.Texture;
import java.nio.ByteBuffer;
import java.util.EnumSet;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests what films record besides the picture. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class FilmLayersTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;
  private static final Set<Layer> ALL = EnumSet.allOf(Layer.class);

  /** Turns a rectangle, whose normal is +y, to face +z. */
  private static final Transform UPRIGHT = Transform.rotationDegrees(new Vec3(90, 0, 0));

  private static final Rgb ORANGE = new Rgb(.8, .4, .1);
  private static final Material MATTE = new Matte(Texture.constant(ORANGE));

  private static RenderSettings.Builder settings(Set<Layer> layers) {
    return new RenderSettings.Builder()
        .size(WIDTH, HEIGHT)
        .samples(16)
        .threads(2)
        .bucketSize(7)
        .set(Setting.LAYERS, layers);
  }

  /** Returns a camera at z = -4 that looks along +z. */
  static SceneBuilder scene() {
    Vec3 eye = new Vec3(0, 0, -4);
    return Scene.builder()
        .seenBy(Lens.pinhole(50).camera(eye, Frame.WORLD, (double) WIDTH / HEIGHT));
  }

  /** Returns a scene with everything: mirror, glass, matte, lights in groups and without. */
  private static Scene mixed() {
    return scene()
        .add("wall", new Rectangle(Transform.translation(Vec3.Z).times(UPRIGHT), 3, 9, true), MATTE)
        .add("ball", sphere(-.8, 0, .5), glass(1.5))
        .add("bead", sphere(.8, 0, .4), new Mirror(Texture.constant(Rgb.gray(.9))))
        .lightGroup("lamp")
        .addAreaLight(sphere(0, 1.2, .2), new Emission(Texture.constant(Rgb.gray(9)), false))
        .lightGroup("sun")
        .add(new DirectionalLight(new Vec3(1, -1, 2).normalized(), new Rgb(1, .8, .6)))
        .lightGroup("")
        .addBackground(new Rgb(.1, .2, .4))
        .build();
  }

  private static Sphere sphere(double x, double y, double radius) {
    return new Sphere(Transform.translation(new Vec3(x, y, 0)), radius);
  }

  private static float[] pixel(Film film, Layer layer, int x, int y) {
    int channels = layer.channels().size();
    float[] pixel = new float[channels];
    System.arraycopy(film.develop(layer), (y * WIDTH + x) * channels, pixel, 0, channels);
    return pixel;
  }

  @ParameterizedTest
  @EnumSource(Mode.class)
  void layersDoNotChangeThePicture(Mode mode) throws InterruptedException {
    RenderSettings without = settings(Set.of()).mode(mode).build();
    Image expected = film(without, mixed()).develop();
    for (Set<Layer> layers : Set.of(ALL, Layer.FOR_DENOISING, Set.of(Layer.OBJECT))) {
      Film film = film(settings(layers).mode(mode).build(), mixed());
      assertThat(film.develop().rgb()).isEqualTo(expected.rgb());
    }
  }

  @Test
  void splitPathsHaveTheSamePictureWithLayers() throws InterruptedException {
    RenderSettings without = settings(Set.of()).set(Setting.SPLIT, 3).build();
    Film film = film(settings(ALL).set(Setting.SPLIT, 3).build(), mixed());
    assertThat(film.develop().rgb()).isEqualTo(film(without, mixed()).develop().rgb());
    assertSumsToPicture(film);
  }

  @Test
  void anyPassesThreadsAndBucketsGiveTheSameBits() throws InterruptedException {
    byte[] expected = FilmFixture.pixels(film(settings(ALL).build(), mixed()));
    Random random = new Random(7);
    for (int run = 0; run < 6; run++) {
      RenderSettings other =
          settings(ALL).threads(1 + random.nextInt(4)).bucketSize(1 + random.nextInt(30)).build();
      FilmRenderer renderer = new FilmRenderer(other, mixed());
      Film film = renderer.newFilm();
      for (int done = 0; done < 16; ) {
        done = Math.min(16, done + 1 + random.nextInt(6));
        renderer.addSamples(film, done, Progress.NONE);
      }
      assertThat(FilmFixture.pixels(film)).isEqualTo(expected);
    }
  }

  @Test
  void sharesAndCropsAddUpToTheSameBits() throws InterruptedException {
    byte[] expected = FilmFixture.pixels(film(settings(ALL).build(), mixed()));
    FilmRenderer renderer = new FilmRenderer(settings(ALL).build(), mixed());
    Film sum = renderer.newFilm();
    for (int first = 0; first < 16; first += 8) {
      for (Crop half : new Crop[] {new Crop(0, 0, 9, 16), new Crop(9, 0, 15, 16)}) {
        FilmRenderer part = new FilmRenderer(settings(ALL).crop(half).build(), mixed());
        Film film = part.newFilm(first);
        part.addSamples(film, 8, Progress.NONE);
        sum.addAll(film);
      }
    }
    assertThat(FilmFixture.pixels(sum)).isEqualTo(expected);
    assertThat(FilmFixture.pixels(sum.copy())).isEqualTo(expected);
  }

  @Test
  void pixelsSurviveEncoding() throws InterruptedException {
    Film film = film(settings(ALL).build(), mixed());
    byte[] bytes = FilmFixture.pixels(film);
    Film read = new Film(film.window(), film.hasAlpha(), 0, film.layers());
    ByteBuffer in = ByteBuffer.wrap(bytes);
    for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
      assertThat(film.encodedBytes(pixel)).isGreaterThan(0);
      read.decode(pixel, in);
    }
    assertThat(in.hasRemaining()).isFalse();
    assertThat(FilmFixture.pixels(read)).isEqualTo(bytes);
  }

  @Test
  void lightGroupsAndScatteringsAddUpToThePicture() throws InterruptedException {
    for (Mode mode : Mode.values()) {
      assertSumsToPicture(film(settings(ALL).mode(mode).build(), mixed()));
    }
  }

  /** Requires that direct and indirect light, and the light of all groups, add up. */
  private static void assertSumsToPicture(Film film) {
    float[] picture = film.develop().rgb();
    float[] direct = film.develop(Layer.DIRECT);
    float[] indirect = film.develop(Layer.INDIRECT);
    float[] lamp = film.developLightGroup(0);
    float[] sun = film.developLightGroup(1);
    float[] rest = film.developUngroupedLight();
    for (int i = 0; i < picture.length; i++) {
      assertThat(direct[i] + indirect[i]).isCloseTo(picture[i], within(1e-6f * (1 + picture[i])));
      assertThat(lamp[i] + sun[i] + rest[i])
          .isCloseTo(picture[i], within(1e-6f * (1 + picture[i])));
    }
    assertThat(sum(lamp)).isPositive();
    assertThat(sum(sun)).isPositive();
    assertThat(sum(rest)).isPositive();
    assertThat(sum(direct)).isPositive();
  }

  private static double sum(float[] values) {
    double sum = 0;
    for (float value : values) {
      sum += value;
    }
    return sum;
  }

  /** With all lights in groups, nothing is left: the groups have all light to rounding. */
  @ParameterizedTest
  @EnumSource(Mode.class)
  void nothingIsLeftIfAllLightsAreInGroups(Mode mode) throws InterruptedException {
    Scene scene =
        lit(scene()).lightGroup("sky").add(EnvironmentLight.uniform(new Rgb(.1, .2, .4))).build();
    Film film = film(settings(Set.of(Layer.LIGHTS)).mode(mode).samples(64).build(), scene);
    assertThat(SceneInside.of(scene).lightGroups().names()).containsExactly("left", "right", "sky");
    for (float rest : film.developUngroupedLight()) {
      assertThat(rest).isLessThan(1e-14f);
    }
  }

  /** Adds a matte wall and floor. */
  private static SceneBuilder room(SceneBuilder scene) {
    Transform floor = Transform.translation(new Vec3(0, -1.5, 0));
    return scene
        .add(new Rectangle(Transform.translation(Vec3.Z).times(UPRIGHT), 9, 9, true), MATTE)
        .add(new Rectangle(floor, 9, 9, true), MATTE);
  }

  /** Adds a room and two lights, each in its own group. */
  private static SceneBuilder lit(SceneBuilder scene) {
    return room(scene)
        .lightGroup("left")
        .addAreaLight(sphere(-2, 0, .5), new Emission(Texture.constant(Rgb.gray(5)), false))
        .lightGroup("right")
        .addAreaLight(sphere(2, 0, .5), new Emission(Texture.constant(Rgb.gray(2)), false));
  }

  /**
   * The light of a group has the mean of a picture with only that light. The largest difference of
   * the means that the noise of 256 samples allows is about 1 %, five standard errors.
   */
  @Test
  void aGroupHasTheLightOfItsLights() throws InterruptedException {
    Film both = film(settings(Set.of(Layer.LIGHTS)).samples(256).build(), lit(scene()).build());
    Scene black =
        room(scene())
            .addAreaLight(sphere(-2, 0, .5), new Emission(Texture.constant(Rgb.gray(5)), false))
            .add(sphere(2, 0, .5), new Matte(Texture.constant(Rgb.BLACK)))
            .build();
    double alone = sum(film(settings(Set.of()).samples(256).build(), black).develop().rgb());
    assertThat(sum(both.developLightGroup(0))).isCloseTo(alone, within(.01 * alone));
  }

  /** Light that was scattered at most once is all light of paths of depth 1. */
  @Test
  void directLightIsThatOfPathsOfDepthOne() throws InterruptedException {
    Set<Layer> layers = Set.of(Layer.DIRECT, Layer.INDIRECT);
    Film deep = film(settings(layers).samples(64).build(), lit(scene()).build());
    RenderSettings shallow = settings(layers).samples(64).maxTraceDepth(1).build();
    Film film = film(shallow, lit(scene()).build());
    assertThat(deep.develop(Layer.DIRECT)).isEqualTo(film.develop().rgb());
    assertThat(sum(film.develop(Layer.INDIRECT))).isLessThan(1e-10);
    assertThat(sum(deep.develop(Layer.INDIRECT))).isPositive();
  }

  @Test
  void surfacesHaveTheirKnownGeometry() throws InterruptedException {
    Scene scene =
        scene()
            .add(new Rectangle(Transform.translation(Vec3.Z).times(UPRIGHT), 2, 2, true), MATTE)
            .build();
    Film film = film(settings(ALL).build(), scene);
    int x = WIDTH / 2;
    int y = HEIGHT / 2;
    float[] at = pixel(film, Layer.POSITION, x, y);
    // The pixel right of and below the center of a frame with tan(25°) * 2 * 5 units of height.
    double side = 2 * 5 * Math.tan(Math.toRadians(25)) / HEIGHT;
    assertThat((double) at[0]).isCloseTo(.5 * side, within(.02));
    assertThat((double) at[1]).isCloseTo(-.5 * side, within(.02));
    assertThat((double) at[2]).isCloseTo(1, within(1e-6));
    assertThat((double) pixel(film, Layer.DEPTH, x, y)[0])
        .isCloseTo(Math.sqrt(25 + .5 * side * side), within(.01));
    assertThat(pixel(film, Layer.NORMAL, x, y)).containsExactly(0, 0, -1);
    assertThat(pixel(film, Layer.GEOMETRIC_NORMAL, x, y)).containsExactly(0, 0, -1);
    assertThat(pixel(film, Layer.DENOISING_NORMAL, x, y)).containsExactly(0, 0, -1);
    assertThat(pixel(film, Layer.ALBEDO, x, y)).containsExactly(.8f, .4f, .1f);
    assertThat(pixel(film, Layer.DENOISING_ALBEDO, x, y)).containsExactly(.8f, .4f, .1f);
    float[] uv = pixel(film, Layer.UV, x, y);
    assertThat((double) uv[0]).isCloseTo(.5, within(.5 * side));
    assertThat((double) uv[1]).isCloseTo(.5, within(.5 * side));
    assertThat(pixel(film, Layer.SAMPLES, x, y)).containsExactly(16);
    for (Layer layer : new Layer[] {Layer.POSITION, Layer.DEPTH, Layer.NORMAL, Layer.ALBEDO}) {
      assertThat(pixel(film, layer, 0, 0)).containsOnly(0);
    }
  }

  @Test
  void normalsAreOnTheSideOfTheCamera() throws InterruptedException {
    Scene scene = scene().add(new Sphere(Transform.IDENTITY, 20), MATTE).build();
    Film film = film(settings(ALL).build(), scene);
    assertThat(pixel(film, Layer.NORMAL, WIDTH / 2, HEIGHT / 2)[2]).isLessThan(-.99f);
    assertThat(pixel(film, Layer.GEOMETRIC_NORMAL, WIDTH / 2, HEIGHT / 2)[2]).isLessThan(-.99f);
  }

  /** Mirrors show the guides of what they reflect, clear glass those of what lies behind. */
  @Test
  void guidesAreSeenThroughMirrorsAndGlass() throws InterruptedException {
    Transform turned = Transform.rotationDegrees(new Vec3(0, 45, 0)).times(UPRIGHT);
    Material mirror = new Mirror(Texture.constant(new Rgb(.5, 1, 1)));
    Transform side =
        Transform.translation(new Vec3(-5, 0, 0))
            .times(Transform.rotationDegrees(new Vec3(0, 90, 0)))
            .times(UPRIGHT);
    Scene scene =
        scene()
            .add(new Rectangle(turned, 1, 1, true), mirror)
            .add(new Rectangle(side, 30, 30, true), MATTE)
            .add(
                new Rectangle(
                    Transform.translation(new Vec3(5, 0, 0))
                        .times(Transform.rotationDegrees(new Vec3(0, 90, 0)))
                        .times(UPRIGHT),
                    30,
                    30,
                    true),
                MATTE)
            .build();
    Film film = film(settings(ALL).build(), scene);
    float[] albedo = pixel(film, Layer.DENOISING_ALBEDO, WIDTH / 2, HEIGHT / 2);
    assertThat(albedo).containsExactly(.4f, .4f, .1f);
    float[] normal = pixel(film, Layer.DENOISING_NORMAL, WIDTH / 2, HEIGHT / 2);
    assertThat(Math.abs(normal[0])).isCloseTo(1, within(1e-6f));
    assertThat(pixel(film, Layer.ALBEDO, WIDTH / 2, HEIGHT / 2)).containsExactly(.5f, 1, 1);
    assertThat(Math.abs(pixel(film, Layer.NORMAL, WIDTH / 2, HEIGHT / 2)[0]))
        .isCloseTo((float) Math.sqrt(.5), within(1e-6f));
  }

  @Test
  void lightsAndBackgroundsHaveTheirColorAsGuide() throws InterruptedException {
    Scene scene =
        scene()
            .add(
                sphere(0, 0, .8),
                Unlit.INSTANCE,
                new Emission(Texture.constant(new Rgb(3, .5, 0)), false))
            .addBackground(new Rgb(.25, 2, 0))
            .build();
    Film film = film(settings(ALL).build(), scene);
    assertThat(pixel(film, Layer.DENOISING_ALBEDO, WIDTH / 2, HEIGHT / 2))
        .containsExactly(1, .5f, 0);
    assertThat(pixel(film, Layer.DENOISING_NORMAL, WIDTH / 2, HEIGHT / 2)[2]).isLessThan(-.9f);
    assertThat(pixel(film, Layer.ALBEDO, WIDTH / 2, HEIGHT / 2)).containsExactly(1, .5f, 0);
    assertThat(pixel(film, Layer.DENOISING_ALBEDO, 0, 0)).containsExactly(.25f, 1, 0);
    assertThat(pixel(film, Layer.DENOISING_NORMAL, 0, 0)).containsExactly(0, 0, 0);
    assertThat(pixel(film, Layer.ALBEDO, 0, 0)).containsExactly(0, 0, 0);
  }

  /** Each sample counts for the primitive that it hits; together they are the pixel's coverage. */
  @Test
  void allPrimitivesAreCounted() throws InterruptedException {
    Film film = film(settings(ALL).set(Setting.TRANSPARENT, true).build(), mixed());
    Image picture = film.develop();
    int several = 0;
    for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
      Map<Integer, Integer> counts = film.primitives(pixel);
      assertThat(counts.keySet()).allMatch(primitive -> 0 <= primitive && primitive <= 3);
      int all = counts.values().stream().mapToInt(Integer::intValue).sum();
      assertThat(all / 16f).isEqualTo(picture.alpha(pixel % WIDTH, pixel / WIDTH));
      several += counts.size() > 1 ? 1 : 0;
    }
    assertThat(several).isPositive();
    assertThat(SceneInside.of(mixed()).names().objects())
        .containsExactly("wall", "ball", "bead", "object 3");
  }

  @Test
  void clampedLightIsClampedInItsLayers() throws InterruptedException {
    RenderSettings settings =
        settings(Set.of(Layer.DIRECT, Layer.LIGHTS)).set(Setting.CLAMP, .5).build();
    Film film = film(settings, mixed());
    float[] picture = film.develop().rgb();
    float[] direct = film.develop(Layer.DIRECT);
    for (int i = 0; i < picture.length; i++) {
      assertThat(direct[i]).isLessThanOrEqualTo(picture[i] + 1e-6f);
    }
  }

  @Test
  void theVarianceIsThatOfTheHalves() throws InterruptedException {
    Film film = film(settings(Set.of(Layer.VARIANCE)).build(), mixed());
    float[] variance = film.develop(Layer.VARIANCE);
    PixelHalves halves = film.halves(12, 8).orElseThrow();
    double difference = halves.first().r() - halves.second().r();
    assertThat((double) variance[3 * (8 * WIDTH + 12)])
        .isCloseTo(difference * difference / 4, within(1e-6 * difference * difference));
    Film one = film(settings(Set.of(Layer.VARIANCE)).samples(1).build(), mixed());
    assertThat(one.develop(Layer.VARIANCE)).containsOnly(-1);
  }

  @Test
  void filmsWithOtherLayersAreRejected() throws InterruptedException {
    Film film = film(settings(Set.of(Layer.DEPTH)).build(), mixed());
    Film other = film(settings(Set.of(Layer.UV)).build(), mixed());
    assertThatThrownBy(() -> film.addAll(other))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("depth")
        .hasMessageContaining("uv");
    assertThatThrownBy(() -> film.set(other)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(
            () ->
                new FilmRenderer(settings(Set.of()).build(), mixed())
                    .addSamples(film, 20, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("depth");
    assertThatThrownBy(() -> film.develop(Layer.UV))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("uv: expected one of the film's layers [depth]");
    assertThatThrownBy(() -> film.primitives(0)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(film::developUngroupedLight).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void theBytesPerPixelAreStated() {
    assertThat(FilmLayers.NONE.bytesPerPixel()).isZero();
    assertThat(new FilmLayers(Layer.FOR_DENOISING, 0).bytesPerPixel()).isEqualTo(2 * 32 + 16);
    assertThat(new FilmLayers(Set.of(Layer.DEPTH), 0).bytesPerPixel()).isEqualTo(16 + 4);
    assertThat(new FilmLayers(Set.of(Layer.INDIRECT), 0).bytesPerPixel()).isEqualTo(48);
    assertThat(new FilmLayers(Set.of(Layer.LIGHTS), 2).bytesPerPixel()).isEqualTo(96);
    assertThat(new FilmLayers(Set.of(Layer.OBJECT), 0).bytesPerPixel()).isEqualTo(12);
    assertThat(new FilmLayers(Set.of(Layer.SAMPLES, Layer.VARIANCE), 0).bytesPerPixel()).isZero();
  }
}
