package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests rendered pictures of a small bright sphere off the plane of focus. */
class DepthOfFieldTest {
  private static final int SIZE = 128;
  private static final double FOV_DEGREES = 10;
  private static final double FOCUS = 8;
  private static final double BALL = .06;

  /** The distribution of light in a picture, in pixels from its center, with x right and y up. */
  private record Spot(double x, double y, double meanSquare, double farthest) {}

  /**
   * At depth z, the blur disk has the radius a|z − f|/f, and its mean square is half of the squared
   * radius. Enough samples hit the sphere for a standard error of the mean square below 1 %.
   */
  @ParameterizedTest
  @CsvSource({".4, 16", ".2, 16", ".1, 16", ".4, 6", ".2, 6", ".1, 6"})
  void blurGrowsWithTheApertureAndTheDistanceFromFocus(double aperture, double depth)
      throws InterruptedException {
    Spot spot = spotOf(Aperture.DISK, aperture, depth);
    double disc = pixels(aperture * Math.abs(depth - FOCUS) / FOCUS, depth);
    double ball = pixels(BALL, depth);

    // The sphere's own disk and the square of a pixel add their mean squares.
    double expected = (disc * disc + ball * ball) / 2 + 1 / 6.0;
    assertThat(spot.meanSquare()).isCloseTo(expected, within(.04 * expected));
    assertThat(spot.farthest()).isLessThan((disc + ball) * 1.01 + 1);
    assertThat(spot.x()).isCloseTo(0, within(.05 * disc + .1));
    assertThat(spot.y()).isCloseTo(0, within(.05 * disc + .1));
  }

  @Test
  void maskIsUprightBehindTheFocusAndTurnedBeforeIt() throws InterruptedException {
    // The white part is the right quarter of the upper half of the lens, whose mean is (3/8, 1/4)
    // of its width.
    boolean[][] white = {{false, false, false, false}, {false, false, false, true}};
    Aperture mask = Aperture.mask(white);

    Spot behind = spotOf(mask, .4, 16);
    double shift = pixels(.4 * 8 / FOCUS, 16);
    assertThat(behind.x()).isCloseTo(.375 * shift, within(.03 * shift));
    assertThat(behind.y()).isCloseTo(.25 * shift, within(.03 * shift));

    Spot before = spotOf(mask, .4, 6);
    double turned = pixels(.4 * 2 / FOCUS, 6);
    assertThat(before.x()).isCloseTo(-.375 * turned, within(.03 * turned));
    assertThat(before.y()).isCloseTo(-.25 * turned, within(.03 * turned));
  }

  @Test
  void lensOfNoSizeTakesThePictureOfAPinhole() throws InterruptedException {
    Image pinhole = picture(Lens.pinhole(FOV_DEGREES).camera(Vec3.ZERO, Frame.WORLD, 1), 9, 4);
    Image lens =
        picture(
            new ThinLensCamera(Vec3.ZERO, Frame.WORLD, 1, FOV_DEGREES, FOCUS, 0, Aperture.DISK),
            9,
            4);

    assertThat(lens.rgb()).isEqualTo(pinhole.rgb());
    // Its border runs through pixels.
    int gray = 0;
    for (float value : lens.rgb()) {
      gray += value > 0 && value < 1 ? 1 : 0;
    }
    assertThat(gray).isPositive();
  }

  /** Returns a length at a depth in pixels of the film. */
  private static double pixels(double length, double depth) {
    return length / (depth * Math.tan(Math.toRadians(FOV_DEGREES / 2))) * SIZE / 2;
  }

  private static Spot spotOf(Aperture form, double aperture, double depth)
      throws InterruptedException {
    Camera camera =
        new ThinLensCamera(Vec3.ZERO, Frame.WORLD, 1, FOV_DEGREES, FOCUS, aperture, form);
    return spot(picture(camera, depth, 256));
  }

  /** Returns the picture of the ball at a depth. */
  private static Image picture(Camera camera, double depth, int samples)
      throws InterruptedException {
    Scene scene =
        Scene.builder()
            .seenBy(camera)
            .add(
                new Sphere(Transform.translation(new Vec3(0, 0, depth)), BALL),
                Unlit.INSTANCE,
                new Emission(Texture.constant(Rgb.WHITE), true))
            .build();
    RenderSettings settings =
        new RenderSettings.Builder().size(SIZE, SIZE).samples(samples).build();
    return new PictureRenderer(settings).render(scene);
  }

  private static Spot spot(Image image) {
    double light = 0;
    double sumX = 0;
    double sumY = 0;
    double squares = 0;
    double farthest = 0;
    for (int row = 0; row < SIZE; row++) {
      for (int column = 0; column < SIZE; column++) {
        double value = image.pixel(column, row).r();
        double x = column + .5 - SIZE / 2.0;
        double y = SIZE / 2.0 - row - .5;
        light += value;
        sumX += value * x;
        sumY += value * y;
        squares += value * (x * x + y * y);
        farthest = value > 0 ? Math.max(farthest, Math.hypot(x, y)) : farthest;
      }
    }
    return new Spot(sumX / light, sumY / light, squares / light, farthest);
  }
}
