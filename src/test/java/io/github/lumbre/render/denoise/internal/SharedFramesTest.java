package io.github.lumbre.render.denoise.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Frames of a camera that looks down on a board with a post, which moves by {@link #STEP} pixels a
 * frame and is lit by a lamp.
 */
class SharedFramesTest {
  private static final int WIDTH = 48;
  private static final int HEIGHT = 36;
  private static final int FRAMES = 10;
  private static final int STEP = 2;
  private static final int REACH = SharedFrames.REACH;

  /** World units of a pixel. */
  private static final double PIXEL = 4. / HEIGHT;

  private static RenderSettings settings(int samples, long seed) {
    return new RenderSettings.Builder()
        .size(WIDTH, HEIGHT)
        .samples(samples)
        .seed(seed)
        .set(Setting.LAYERS, Layer.FOR_DENOISING)
        .build();
  }

  private static TriangleMesh box(double x, double y, double z) {
    double[] points = new double[24];
    for (int i = 0; i < 8; i++) {
      points[3 * i] = (i & 1) == 0 ? -x : x;
      points[3 * i + 1] = (i & 2) == 0 ? 0 : y;
      points[3 * i + 2] = (i & 4) == 0 ? -z : z;
    }
    int[] corners = {
      0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3, 0, 4, 5, 0, 5, 1, 2,
      3, 7, 2, 7, 6
    };
    return TriangleMesh.of(points, new double[0], new double[0], corners);
  }

  private static final MeshInstance BOARD = MeshInstance.of(box(1.6, .1, 1.2));
  private static final MeshInstance POST = MeshInstance.of(box(.15, .6, .15));
  private static final MeshInstance CRATE = MeshInstance.of(box(.5, .5, .5));

  private static SceneBuilder around(double moved) {
    Transform at = Transform.translation(new Vec3(moved, 0, 0));
    return Scene.builder()
        .lookingAt(new Vec3(0, 10, 0), Vec3.ZERO, Vec3.Z, Lens.orthographic(4))
        .add("board", BOARD.transformed(at), Matte.GRAY)
        .add("post", POST.transformed(at), Matte.GRAY)
        .addAreaLight("lamp", Sphere.of(new Vec3(3, 5, 2), .8), new Rgb(20, 18, 15))
        .addBackground(.3);
  }

  /** Returns a frame in which the board has moved to the right of the picture. */
  private static Scene moving(int frame) {
    return around(side() * STEP * PIXEL * (frame - FRAMES / 2)).build();
  }

  /** Returns the sign of the world's x axis to the right of the picture. */
  private static int side() {
    Scene scene = around(0).build().framed((double) WIDTH / HEIGHT);
    return scene.camera().project(Vec3.X).orElseThrow().x() > .5 ? 1 : -1;
  }

  /** A crate is on the board from the middle frame on. It is the first primitive. */
  private static Scene appearing(int frame) {
    Scene scene = around(0).build();
    if (frame < FRAMES / 2) {
      return scene;
    }
    return Scene.builder()
        .lookingAt(new Vec3(0, 10, 0), Vec3.ZERO, Vec3.Z, Lens.orthographic(4))
        .add("crate", CRATE.transformed(Transform.translation(new Vec3(-.7, 0, .5))), Matte.GRAY)
        .add("board", BOARD, Matte.GRAY)
        .add("post", POST, Matte.GRAY)
        .addAreaLight("lamp", Sphere.of(new Vec3(3, 5, 2), .8), new Rgb(20, 18, 15))
        .addBackground(.3)
        .build();
  }

  /** Frames that are denoised: each by itself, and mixed. */
  private record Sequence(List<Image> alone, List<Image> mixed) {
    static Sequence of(IntFunction<Scene> scenes, int threads) throws InterruptedException {
      List<SeenFrame> frames = new ArrayList<>();
      for (int i = 0; i < FRAMES; i++) {
        Film film = film(scenes.apply(i), settings(8, 1));
        NoisyPicture noisy = NoisyPicture.of(film);
        List<float[]> left = new ArrayList<>();
        Image image = BuiltInDenoiser.denoise(noisy, threads, left::add).image();
        Optional<SeenFrame> like =
            frames.isEmpty() ? Optional.empty() : Optional.of(frames.get(i - 1));
        frames.add(
            SeenFrame.of(
                scenes.apply(i), settings(8, 1), noisy, image, left.get(0), like, threads));
      }
      List<Image> mixed = new ArrayList<>();
      for (int i = 0; i < FRAMES; i++) {
        List<SeenFrame> before = new ArrayList<>();
        List<SeenFrame> after = new ArrayList<>();
        for (int k = 1; k <= REACH; k++) {
          if (i - k >= 0) {
            before.add(frames.get(i - k));
          }
          if (i + k < FRAMES) {
            after.add(frames.get(i + k));
          }
        }
        mixed.add(SharedFrames.mixed(frames.get(i), before, after, threads));
      }
      return new Sequence(frames.stream().map(frame -> frame.image).toList(), mixed);
    }
  }

  private static Film film(Scene scene, RenderSettings settings) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, settings.samples(), Progress.NONE);
    return film;
  }

  private static List<Image> references(IntFunction<Scene> scenes) throws InterruptedException {
    List<Image> references = new ArrayList<>();
    for (int i = 0; i < FRAMES; i++) {
      references.add(film(scenes.apply(i), settings(128, 2)).develop());
    }
    return references;
  }

  /** Returns the mean variance over time of the error of points of the board that move. */
  private static double variance(List<Image> frames, List<Image> references) {
    double variances = 0;
    int count = 0;
    int first = FRAMES / 2 - REACH;
    int last = FRAMES / 2 + REACH;
    for (int y = 8; y < HEIGHT - 8; y++) {
      for (int x = 18; x < WIDTH - 18; x++) {
        double sum = 0;
        double squares = 0;
        for (int i = first; i <= last; i++) {
          int at = 3 * (y * WIDTH + x + STEP * (i - FRAMES / 2)) + 1;
          double error = frames.get(i).rgb()[at] - references.get(i).rgb()[at];
          sum += error;
          squares += error * error;
        }
        int n = last - first + 1;
        variances += (squares - sum * sum / n) / (n - 1);
        count++;
      }
    }
    return variances / count;
  }

  /**
   * With weights of zero, both are equal. The means are over 240 points in 7 frames each, of
   * errors that hold together over some pixels: their ratio has a standard error of about 0.1.
   */
  @Test
  void movingSurfacesSimmerLess() throws InterruptedException {
    Sequence moved = Sequence.of(SharedFramesTest::moving, 2);
    List<Image> references = references(SharedFramesTest::moving);
    double alone = variance(moved.alone, references);
    assertThat(variance(moved.mixed, references)).isLessThan(.6 * alone);
  }

  /** A thing on the board, which moves with it. */
  private static IntFunction<Scene> thing(Material material) {
    return frame -> {
      double moved = side() * STEP * PIXEL * (frame - FRAMES / 2);
      Transform at = Transform.translation(new Vec3(moved, 0, 0));
      return around(moved).add("crate", CRATE.transformed(at), material).build();
    };
  }

  /** The board through a lens that is focused far above it. */
  private static Scene blurred(int frame) {
    double moved = side() * STEP * PIXEL * (frame - FRAMES / 2);
    return around(moved)
        .lookingAt(new Vec3(0, 10, 0), Vec3.ZERO, Vec3.Z, Lens.thinLens(23, 8, .5))
        .build();
  }

  /** The board while it moves by a pixel more in four poses. */
  private static Scene inMotion(int frame) {
    List<Scene> poses = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      poses.add(around(side() * PIXEL * (STEP * (frame - FRAMES / 2) + .25 * i)).build());
    }
    return Scene.inMotion(poses);
  }

  static Stream<Arguments> scenesOfSeveralSurfaces() {
    return Stream.of(
        Arguments.of("mirror", thing(Mirror.of(Rgb.gray(.9)))),
        Arguments.of("glass", thing(Glass.of(1.5))),
        Arguments.of("shadow alone", thing(ShadowCatcher.of(Rgb.gray(.5)))),
        Arguments.of("lens", (IntFunction<Scene>) SharedFramesTest::blurred),
        Arguments.of("motion", (IntFunction<Scene>) SharedFramesTest::inMotion));
  }

  /** Returns how many of 14 pixels of the thing in the middle frame, beside the post, are mixed. */
  private static long mixedInside(Material material) throws InterruptedException {
    Sequence sequence = Sequence.of(thing(material), 2);
    float[] alone = sequence.alone.get(FRAMES / 2).rgb();
    float[] mixed = sequence.mixed.get(FRAMES / 2).rgb();
    return IntStream.range(0, 14)
        .map(i -> 3 * ((HEIGHT / 2 - 4 + i / 7) * WIDTH + WIDTH / 2 - 3 + i % 7))
        .filter(i -> alone[i] != mixed[i])
        .count();
  }

  @Test
  void mirrorsGlassAndShadowsAreLeftToTheirFrame() throws InterruptedException {
    assertThat(mixedInside(Mirror.of(Rgb.gray(.9)))).isZero();
    assertThat(mixedInside(ShadowCatcher.of(Rgb.gray(.5)))).isZero();
    assertThat(mixedInside(Matte.GRAY)).isGreaterThan(10);
    assertThat(mixedInside(Glass.of(1.5))).isZero();
  }

  /** Whatever a pixel mixes, frames that are mixed have no larger error than frames alone. */
  @ParameterizedTest
  @MethodSource("scenesOfSeveralSurfaces")
  void pixelsOfSeveralSurfacesKeepTheirError(String name, IntFunction<Scene> scenes)
      throws InterruptedException {
    Sequence sequence = Sequence.of(scenes, 2);
    List<Image> references = references(scenes);
    boolean[] mask = new boolean[WIDTH * HEIGHT];
    Arrays.fill(mask, true);
    double alone = 0;
    double mixed = 0;
    for (int i = REACH; i < FRAMES - REACH; i++) {
      alone += squaredError(sequence.alone.get(i), references.get(i), mask);
      mixed += squaredError(sequence.mixed.get(i), references.get(i), mask);
    }
    assertThat(mixed).isLessThan(1.02 * alone);
  }

  private static double squaredError(Image image, Image reference, boolean[] mask) {
    double sum = 0;
    for (int i = 0; i < 3 * mask.length; i++) {
      double error = mask[i / 3] ? image.rgb()[i] - reference.rgb()[i] : 0;
      sum += error * error;
    }
    return sum;
  }

  /** Where a crate and its shadow appear, frames before show no trace of it, and none lags. */
  @Test
  void whatAppearsLeavesNoGhost() throws InterruptedException {
    Sequence sequence = Sequence.of(SharedFramesTest::appearing, 1);
    List<Image> references = references(SharedFramesTest::appearing);
    Image before = references.get(0);
    Image after = references.get(FRAMES - 1);
    boolean[] mask = new boolean[WIDTH * HEIGHT];
    int changed = 0;
    for (int i = 0; i < mask.length; i++) {
      double difference = before.rgb()[3 * i + 1] - after.rgb()[3 * i + 1];
      mask[i] = Math.abs(difference) > .08 * before.rgb()[3 * i + 1];
      changed += mask[i] ? 1 : 0;
    }
    assertThat(changed).isGreaterThan(40);
    double alone = 0;
    double mixed = 0;
    for (int i = FRAMES / 2 - REACH; i < FRAMES / 2 + REACH; i++) {
      alone += squaredError(sequence.alone.get(i), references.get(i), mask);
      mixed += squaredError(sequence.mixed.get(i), references.get(i), mask);
    }
    assertThat(mixed).isLessThan(1.02 * alone);
  }

  @Test
  void whatStandsStillDoesNotChange() throws InterruptedException {
    Sequence still = Sequence.of(frame -> around(0).build(), 2);
    for (int i = 0; i < FRAMES; i++) {
      assertThat(still.mixed.get(i).rgb()).isEqualTo(still.alone.get(0).rgb());
    }
  }

  @Test
  void threadsDoNotMatter() throws InterruptedException {
    List<Image> one = Sequence.of(SharedFramesTest::moving, 1).mixed;
    List<Image> three = Sequence.of(SharedFramesTest::moving, 3).mixed;
    for (int i = 0; i < FRAMES; i++) {
      assertThat(three.get(i).rgb()).isEqualTo(one.get(i).rgb());
    }
  }
}
