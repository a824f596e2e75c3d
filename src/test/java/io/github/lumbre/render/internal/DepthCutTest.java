package io.github.lumbre.render.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;

/** Compares the energy lost to the path length limit with closed forms. */
class DepthCutTest {
  /** Inside a sphere, each bounce keeps half of the light, so depth n loses 2^-n of it. */
  @Test
  void closedSphereCutsAPowerOfItsReflectance() throws InterruptedException {
    Scene room =
        Scene.builder()
            .seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1))
            .add(new Sphere(Transform.IDENTITY, 1), new Matte(Texture.constant(Rgb.gray(.5))))
            .add(new PointLight(Vec3.ZERO, Rgb.WHITE, Falloff.INVERSE_SQUARE))
            .build();
    for (int depth = 1; depth < 5; depth++) {
      RenderSettings settings =
          new RenderSettings.Builder().size(10, 10).maxTraceDepth(depth).build();
      DepthCut cut = DepthCut.of(room, settings);
      assertThat(cut.standardError()).isLessThan(.02);
      assertThat(cut.share())
          .isCloseTo(Math.scalb(1, -depth), within(.005 + 4 * cut.standardError()));
      assertThat(DepthCut.of(room, settings)).isEqualTo(cut);
    }
  }

  @Test
  void darknessLacksNothing() throws InterruptedException {
    Scene empty =
        Scene.builder().seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1)).build();
    assertThat(DepthCut.of(empty, RenderSettings.DEFAULT)).isEqualTo(new DepthCut(0, 0));
  }

  private static Scene room(Camera camera, double reflectance) {
    return Scene.builder()
        .seenBy(camera)
        .add(new Sphere(Transform.IDENTITY, 1), new Matte(Texture.constant(Rgb.gray(reflectance))))
        .add(new PointLight(Vec3.ZERO, Rgb.WHITE, Falloff.INVERSE_SQUARE))
        .build();
  }

  @Test
  void deepestPathsLackNothing() throws InterruptedException {
    Scene room = room(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1), .5);
    RenderSettings deepest =
        new RenderSettings.Builder().maxTraceDepth(RenderSettings.MAX_DEPTH).build();
    assertThat(DepthCut.of(room, deepest)).isEqualTo(new DepthCut(0, 0));
  }

  /** The corners of a fish-eye picture are transparent. */
  @Test
  void pixelsWithoutAPictureLackNothing() throws InterruptedException {
    Camera fishEye = Lens.fishEye(170).camera(Vec3.ZERO, Frame.WORLD, 1);
    DepthCut cut =
        DepthCut.of(room(fishEye, .5), new RenderSettings.Builder().maxTraceDepth(2).build());
    assertThat(cut.share()).isCloseTo(.25, within(.005 + 4 * cut.standardError()));
  }

  /** Over different seeds, the shares vary about as much as the standard error. */
  @Test
  void standardErrorIsTheSpreadOverSeeds() throws InterruptedException {
    Scene room = room(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1), .7);
    int seeds = 24;
    double sum = 0;
    double squares = 0;
    double told = 0;
    for (int seed = 0; seed < seeds; seed++) {
      DepthCut cut =
          DepthCut.of(room, new RenderSettings.Builder().seed(seed).maxTraceDepth(2).build());
      sum += cut.share();
      squares += cut.share() * cut.share();
      told += cut.standardError() / seeds;
    }
    double spread = Math.sqrt((squares - sum * sum / seeds) / (seeds - 1));
    assertThat(spread / told).isBetween(.3, 1.6);
  }
}
