package io.github.lumbre.render.denoise.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames of one mesh: a thin floor, a shelf above its middle, and a wall on one side. */
class FrameTracksTest {
  private static final int SIZE = 32;
  private static final int PIXELS = SIZE * SIZE;
  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder()
          .size(SIZE, SIZE)
          .samples(16)
          .set(Setting.LAYERS, Layer.FOR_DENOISING)
          .build();

  private static final Mesh ROOM =
      Mesh.of(
          TriangleMesh.of(
              new double[] {
                -2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2, // floor
                -.5, 1, -.5, -.5, 1, .5, .5, 1, .5, .5, 1, -.5, // shelf
                -2, 0, -2, -2, 0, 2, -2, 2, 2, -2, 2, -2, // wall
                -2, -5e-4, -2, -2, -5e-4, 2, 2, -5e-4, 2, 2, -5e-4, -2 // under the floor
              },
              new int[] {
                0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 10, 9, 8, 11, 10, 12, 14, 13, 12, 15, 14
              }));

  private static Scene scene(Vec3 eye, Material material) {
    return Scene.builder()
        .lookingAt(eye, Vec3.ZERO, Vec3.Z, Lens.orthographic(5))
        .add("room", ROOM, material)
        .addBackground(1)
        .build();
  }

  private static SeenFrame seen(Scene scene, double light, double left)
      throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(SETTINGS, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, SETTINGS.samples(), Progress.NONE);
    float[] values = new float[3 * PIXELS];
    Arrays.fill(values, (float) light);
    float[] noise = new float[3 * PIXELS];
    Arrays.fill(noise, (float) left);
    Image image = new Image(SIZE, SIZE, values, new float[0]);
    return SeenFrame.of(
        scene, SETTINGS, NoisyPicture.of(film), image, noise, Optional.empty(), 1);
  }

  private static SeenFrame from(Vec3 eye) throws InterruptedException {
    return seen(scene(eye, Matte.GRAY), 1, 0);
  }

  /** Returns for how many pixels a test is true. */
  private static long count(IntPredicate test) {
    return IntStream.range(0, PIXELS).filter(test).count();
  }

  private static double height(SeenFrame frame, int pixel) {
    return frame.primitive(pixel) < 0
        ? Double.NaN
        : frame.point(pixel, frame.surfaces, frame.primitive(pixel)).y();
  }

  /** The shelf hides other points of the floor, which is of the same mesh and parallel to it. */
  @ParameterizedTest
  @ValueSource(doubles = {6.5, 7, 7.5, 8})
  void pointsBehindTheSameMeshAreNotFollowed(double up) throws InterruptedException {
    SeenFrame from = from(new Vec3(.01, 9, 0));
    SeenFrame to = from(new Vec3(7, up, 0));
    FrameTracks tracks = FrameTracks.of(from, FrameTracks.places(from), to, 1);
    // To the other camera, the shelf covers a square of the floor. Leave half a pixel of its edges.
    double middle = -7 / up;
    double half = .5 - .5 * 5 / SIZE * Math.hypot(7, up) / up;
    long hidden =
        count(
            i -> {
              boolean isFloor = height(from, i) == 0;
              Vec3 point = isFloor ? from.point(i, from.surfaces, 0) : Vec3.ZERO;
              return isFloor
                  && Math.abs(point.x() - middle) < half
                  && Math.abs(point.z()) < half
                  && tracks.isFollowed[i] > 0;
            });
    assertThat(hidden).isZero();
    assertThat(count(i -> tracks.isFollowed[i] > 0)).isGreaterThan(PIXELS / 4);
  }

  @Test
  void thinPlatesHaveTwoSides() throws InterruptedException {
    SeenFrame from = from(new Vec3(.01, 9, 0));
    SeenFrame to = from(new Vec3(.01, -9, 0));
    assertThat(count(i -> to.primitive(i) == 0)).isGreaterThan(PIXELS / 3);
    FrameTracks tracks = FrameTracks.of(from, FrameTracks.places(from), to, 1);
    assertThat(count(i -> tracks.isFollowed[i] > 0)).isZero();
  }

  /** Samples of such pixels hit the floor and the wall. */
  @Test
  void pixelsOfTwoSurfacesShowNone() throws InterruptedException {
    SeenFrame frame = from(new Vec3(7, 6.5, 0));
    assertThat(count(i -> frame.primitive(i) < 0 && isBetween(frame, i))).isPositive();
  }

  private static boolean isBetween(SeenFrame frame, int pixel) {
    int x = pixel % SIZE;
    return x > 0
        && x < SIZE - 1
        && frame.primitive(pixel - 1) >= 0
        && frame.primitive(pixel + 1) >= 0;
  }

  @Test
  void lightOfNoisyNeighborsWeighsLess() throws InterruptedException {
    Scene scene = scene(new Vec3(.01, 9, 0), Matte.GRAY);
    SeenFrame frame = seen(scene, 1, .1);
    double calm = mixed(frame, seen(scene, 1.01, .1));
    double noisy = mixed(frame, seen(scene, 1.01, 1));
    assertThat(calm).isGreaterThan(1.001);
    assertThat(noisy - 1).isPositive().isLessThan(.3 * (calm - 1));
  }

  private static double mixed(SeenFrame frame, SeenFrame other) throws InterruptedException {
    Image mixed = SharedFrames.mixed(frame, List.of(other), List.of(), 1);
    return mixed.rgb()[3 * (SIZE / 4 * SIZE + SIZE / 2)];
  }

  /** Reflections move unlike the surface that shows them. */
  @Test
  void metalHasToBeMoreAlike() throws InterruptedException {
    Scene matte = scene(new Vec3(.01, 9, 0), Matte.GRAY);
    Material metal =
        MetallicRoughness.builder()
            .set(MaterialParameter.METALLIC, 1)
            .set(MaterialParameter.ROUGHNESS, .4)
            .build();
    Scene shiny = scene(new Vec3(.01, 9, 0), metal);
    assertThat(mixed(seen(matte, 1, .1), seen(matte, 1.05, .1))).isGreaterThan(1.01);
    assertThat(mixed(seen(shiny, 1, .1), seen(shiny, 1.05, .1))).isLessThan(1.005);
  }
}
