package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.CompiledVectors;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneWriter;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of scenes in motion are the means of the pictures of their poses. */
class MotionTest {
  private static final int SIDE = 12;

  private static Scene ball(double x) {
    return Scene.builder()
        .seenBy(Lens.pinhole(60).camera(new Vec3(0, 0, -4), Frame.WORLD, 1))
        .add(new Sphere(Transform.translation(new Vec3(x, 0, 0)), .8), Matte.GRAY)
        .addBackground(Rgb.WHITE)
        .build();
  }

  private static List<Scene> poses(int count) {
    return IntStream.range(0, count).mapToObj(i -> ball(-1 + 2 * (i + .5) / count)).toList();
  }

  private static RenderSettings.Builder settings(int samples) {
    return RenderSettings.builder().size(SIDE, SIDE).samples(samples).threads(2).bucketSize(5);
  }

  private static Image render(Scene scene, RenderSettings settings) throws InterruptedException {
    return new PictureRenderer(settings).render(scene);
  }

  @ParameterizedTest
  @EnumSource(Guiding.class)
  void stillScenesKeepTheirBits(Guiding guiding) throws Exception {
    RenderSettings settings = settings(48).guiding(guiding).build();
    Scene still = ball(0);
    Scene moving = Scene.inMotion(Collections.nCopies(16, still));
    assertThat(render(moving, settings).rgb()).isEqualTo(render(still, settings).rgb());
  }

  @Test
  void sampleSeesThePoseOfItsNumber() throws Exception {
    List<Scene> poses = poses(4);
    RenderSettings settings = settings(12).build();
    Scene moving = Scene.inMotion(poses);
    Image picture = render(moving, settings);
    PixelReplay whole = new PixelReplay(moving, settings);
    List<PixelReplay> single = poses.stream().map(s -> new PixelReplay(s, settings)).toList();
    for (int y = 0; y < SIDE; y++) {
      for (int x = 0; x < SIDE; x++) {
        Film film = new Film(new RenderSettings.Crop(0, 0, 1, 1), false, 0);
        for (int i = 0; i < 12; i++) {
          PixelReplay.Sample sample = single.get(i % 4).sample(x, y, i);
          assertThat(whole.sample(x, y, i).film()).isEqualTo(sample.film());
          film.add(0, sample.film(), true);
        }
        assertThat(picture.pixel(x, y)).isEqualTo(film.develop().pixel(0, 0));
      }
    }
  }

  /**
   * The noise of the two sides is 4e-6 (measured); a picture that lacks 3 of the 64 poses differs
   * by 2e-5.
   */
  @Test
  void pictureConvergesToTheMeanOfItsPoses() throws Exception {
    int count = 64;
    List<Scene> poses = poses(count);
    RenderSettings settings = settings(16 * count).build();
    float[] sum = new float[3 * SIDE * SIDE];
    for (Scene pose : poses) {
      float[] rgb = render(pose, settings(64).seed(1).build()).rgb();
      for (int i = 0; i < sum.length; i++) {
        sum[i] += rgb[i] / count;
      }
    }
    Image mean = new Image(SIDE, SIDE, sum, new float[0]);
    FilmRenderer renderer = new FilmRenderer(settings, Scene.inMotion(poses));
    Film film = renderer.newFilm();
    new PassLoop(renderer, film).run(Progress.NONE);
    double error = PictureError.of(film.develop(), mean).relativeMse();
    double still = PictureError.of(render(poses.get(32), settings), mean).relativeMse();
    assertThat(error).isLessThan(1e-5);
    assertThat(still).isGreaterThan(1e-3);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 5, 33})
  void cancelledPassesEndWithWholePoses(int reports) throws Exception {
    FilmRenderer renderer = new FilmRenderer(settings(256).build(), Scene.inMotion(poses(32)));
    Film film = renderer.newFilm();
    AtomicInteger left = new AtomicInteger(reports);
    Progress cancelling = Progress.NONE.cancelledAlsoIf(() -> left.decrementAndGet() < 0);
    renderer.addSamples(film, 250, cancelling);
    for (int i = 0; i < SIDE * SIDE; i++) {
      assertThat(film.samples(i) % 32).isZero();
    }
    assertThat(film.fewestSamples()).isZero();
    renderer.addSamples(film, 250, Progress.NONE);
    assertThat(film.fewestSamples()).isEqualTo(256);
    assertThat(film.mostSamples()).isEqualTo(256);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 40, 200})
  void adaptivePixelsHaveWholePoses(int samples) throws Exception {
    RenderSettings settings = settings(samples).adaptive(true).build();
    FilmRenderer renderer = new FilmRenderer(settings, Scene.inMotion(poses(32)));
    Film film = renderer.newFilm();
    new PassLoop(renderer, film).run(Progress.NONE);
    assertThat(film.meanSamples()).isBetween(.7 * samples, samples + 31.);
    for (int i = 0; i < SIDE * SIDE; i++) {
      assertThat(film.samples(i) % 32).isZero();
    }
  }

  @Test
  void sharesBeginWithWholePoses() throws Exception {
    FilmRenderer renderer = new FilmRenderer(settings(64).build(), Scene.inMotion(poses(16)));
    Film first = renderer.newFilm();
    Film second = renderer.newFilm(32);
    renderer.addSamples(first, 32, Progress.NONE);
    renderer.addSamples(second, 32, Progress.NONE);
    first.addAll(second);
    Film whole = renderer.newFilm();
    renderer.addSamples(whole, 64, Progress.NONE);
    assertThat(first.develop().rgb()).isEqualTo(whole.develop().rgb());
    assertThat(first.developNoise()).isEqualTo(whole.developNoise());
    assertThatThrownBy(() -> renderer.newFilm(8))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("firstSample: expected a multiple of 16, found 8");
  }

  @Test
  void numbersOfPosesArePowersOfTwo() {
    assertThatThrownBy(() -> Scene.inMotion(poses(3)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("poses: expected a power of two from 1 to 256, found 3");
    RenderSettings settings = settings(100).set(Setting.POSES, 64).build();
    assertThat(settings.poses()).isEqualTo(1);
    assertThat(settings.withWholePoses()).isSameAs(settings);
    RenderSettings moving = settings.toBuilder().set(Setting.SHUTTER, .02).build();
    assertThat(moving.poses()).isEqualTo(64);
    assertThat(moving.withWholePoses().samples()).isEqualTo(128);
  }

  @Test
  void kernelsChangeInAllPoses() throws Exception {
    CompiledVectors.forget();
    List<Scene> poses = IntStream.range(0, 4).mapToObj(i -> balls(i)).toList();
    Scene moving = Scene.inMotion(poses);
    assertThat(poses).allMatch(Scene::mayChangeKernel);
    moving.changeKernel(() -> true);
    assertThat(poses).noneMatch(Scene::mayChangeKernel);
    assertThat(moving.mayChangeKernel()).isFalse();
    CompiledVectors.forget();
  }

  /** Returns as many balls as vectors need. */
  private static Scene balls(double y) {
    SceneBuilder scene = Scene.builder().seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1));
    for (int i = 0; i < 20; i++) {
      scene.add(new Sphere(Transform.translation(new Vec3(3 * i, y, 9)), 1), Matte.GRAY);
    }
    return scene.build();
  }

  @Test
  void camerasAreReplacedInAllPoses() throws Exception {
    RenderSettings settings = settings(8).build();
    Scene moving =
        Scene.inMotion(poses(4))
            .seenBy(Lens.pinhole(60).camera(new Vec3(0, 0, 40), Frame.WORLD, 1));
    assertThat(render(moving, settings).rgb()).containsOnly(1);
    assertThat(moving.poses()).hasSize(4);
    assertThatThrownBy(() -> SceneWriter.file(moving, settings))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("expected a scene that stands still, found one in motion");
    assertThat(ball(0).poses()).hasSize(1);
  }
}
