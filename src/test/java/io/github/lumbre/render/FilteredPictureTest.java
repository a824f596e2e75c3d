package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests pixel filters in rendered pictures. */
class FilteredPictureTest {
  private static final int SAMPLES = 4096;
  private static final Matte BLACK = new Matte(Texture.constant(Rgb.BLACK));

  /** A black half plane in front of white, with a vertical edge in the center of the picture. */
  private static Scene edge(Camera camera) {
    Transform right = Transform.translation(new Vec3(500, 0, 5));
    return Scene.builder()
        .seenBy(camera)
        .add(new Box(right, 1000, 1000, 1), BLACK)
        .addBackground(Rgb.WHITE)
        .build();
  }

  private static Image render(Scene scene, PixelFilter filter, int width, int height)
      throws InterruptedException {
    RenderSettings settings =
        new RenderSettings.Builder()
            .size(width, height)
            .samples(SAMPLES)
            .maxTraceDepth(1)
            .filter(filter)
            .build();
    return new PictureRenderer(settings).render(scene);
  }

  /** The profile across an edge is the filter's integral over its left side, which is white. */
  @ParameterizedTest
  @EnumSource
  void edgesHaveTheProfileOfTheFilter(PixelFilter filter) throws InterruptedException {
    Camera camera = Lens.pinhole(20).camera(Vec3.ZERO, Frame.WORLD, 4);
    Image image = render(edge(camera), filter, 8, 2);
    for (int x = 0; x < 8; x++) {
      assertThat(image.pixel(x, 1).g())
          .as("column %d", x)
          .isCloseTo(shareBelow(filter, 4 - x), within(4. / SAMPLES));
    }
  }

  /**
   * Returns the fraction of a pixel's samples left of a line, whose position is relative to the
   * pixel's left edge.
   */
  private static double shareBelow(PixelFilter filter, double line) {
    int count = 0;
    int all = 1 << 16;
    for (int i = 0; i < all; i++) {
      count += filter.sample((i + .5) / all) < line ? 1 : 0;
    }
    return (double) count / all;
  }

  /** Behind the viewer of a panorama, the left and right edges of the picture join. */
  @ParameterizedTest
  @EnumSource
  void panoramasAreFilteredAcrossTheirSeam(PixelFilter filter) throws InterruptedException {
    Frame back = new Frame(new Vec3(-1, 0, 0), Vec3.Y, new Vec3(0, 0, -1));
    Image ahead = render(edge(Lens.spherical().camera(Vec3.ZERO, Frame.WORLD, 2)), filter, 32, 16);
    Image behind = render(edge(Lens.spherical().camera(Vec3.ZERO, back, 2)), filter, 32, 16);
    // After half a turn, column x shows the content of column x + 16, and column 0 follows column
    // 31.
    for (int x = 12; x < 20; x++) {
      assertThat(behind.pixel((x + 16) % 32, 8).g())
          .as("column %d", x)
          .isCloseTo(ahead.pixel(x, 8).g(), within(12. / SAMPLES));
    }
  }

  /**
   * Across a pole, the panorama continues on the other side, so a uniform environment stays
   * uniform.
   */
  @ParameterizedTest
  @EnumSource
  void polesAreNeitherDarkNorBlank(PixelFilter filter) throws InterruptedException {
    Scene scene =
        Scene.builder()
            .seenBy(Lens.spherical().camera(Vec3.ZERO, Frame.WORLD, 2))
            .addBackground(Rgb.WHITE)
            .build();
    Image image = render(scene, filter, 8, 4);
    for (int x = 0; x < 8; x++) {
      assertThat(image.pixel(x, 0)).isEqualTo(Rgb.WHITE);
      assertThat(image.pixel(x, 3)).isEqualTo(Rgb.WHITE);
    }
  }

  /** At the rim of a fisheye image, alpha is the fraction of the filter inside the circle. */
  @Test
  void rimOfAFisheyeIsAsSoftAsTheFilterIsWide() throws InterruptedException {
    Scene scene =
        Scene.builder()
            .seenBy(Lens.fishEye(180).camera(Vec3.ZERO, Frame.WORLD, 1))
            .addBackground(Rgb.WHITE)
            .build();
    double before = 1;
    for (PixelFilter filter : new PixelFilter[] {PixelFilter.BOX, PixelFilter.GAUSSIAN}) {
      Image image = render(scene, filter, 16, 16);
      double rim = image.alpha(0, 8);
      // Nearly all of the box filter is inside the circle; a sixth of the Gaussian extends beyond
      // it.
      assertThat(rim).isLessThan(before);
      before = rim;
      assertThat(image.alpha(8, 8)).isEqualTo(1);
      assertThat(image.alpha(0, 0)).isZero();
    }
    assertThat(before).isBetween(.78, .9);
  }
}
