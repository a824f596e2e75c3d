package io.github.lumbre.light.internal;

import static io.github.lumbre.testing.Draws.inSquare;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests that {@link Facing} only passes over samples that would be black. */
class FacingTest {
  private static final Transform TILTED = Transform.placed(new Vec3(1, 2, -1), new Vec3(70, 20, 5));

  private static final List<Light> LIGHTS =
      List.of(
          new AreaLight(new Rectangle(TILTED, 3, 2, false), glow(false)),
          new AreaLight(new Rectangle(TILTED, 3, 2, true), glow(true)),
          new AreaLight(new Sphere(TILTED, .7), glow(false)),
          new PointLight(new Vec3(1, 2, -1), Rgb.WHITE, Falloff.INVERSE_SQUARE),
          EnvironmentLight.uniform(Rgb.WHITE),
          new DirectionalLight(Vec3.Y, Rgb.WHITE));

  private static Emission glow(boolean twoSided) {
    return new Emission(Texture.constant(Rgb.WHITE), twoSided);
  }

  /** Each light at finite distance is also passed over often, or the test would save nothing. */
  @Test
  void noPassedSampleLightsTheFront() {
    SplittableRandom random = new SplittableRandom(5);
    for (Light light : LIGHTS) {
      int passed = 0;
      for (int i = 0; i < 20_000; i++) {
        Vec3 point = inCube(random);
        Vec3 normal = Warp.uniformSphere(inSquare(random));
        if (!isAway(light, point, normal)) {
          continue;
        }
        passed++;
        Optional<LightSample> sample = light.sample(point, inSquare(random));
        assertThat(sample.filter(s -> s.wi().dot(normal) > 0)).isEmpty();
      }
      assertThat(passed > 2_000).isEqualTo(light.bounds().isPresent());
    }
  }

  @Test
  void flatLampDoesNotFaceTheCeilingAboveIt() {
    Light lamp = new AreaLight(Rectangle.facing(Vec3.ZERO, new Vec3(0, -1, 0), 2, 2), glow(false));
    assertThat(isAway(lamp, new Vec3(5, .01, 0), new Vec3(0, -1, 0))).isTrue();
    assertThat(isAway(lamp, new Vec3(5, -.01, 0), new Vec3(-1, 0, 0))).isFalse();
  }

  @Test
  void lampAcrossTheHorizonIsNotAway() {
    Light lamp = new AreaLight(Rectangle.facing(Vec3.ZERO, new Vec3(0, -1, 0), 2, 2), glow(false));
    assertThat(isAway(lamp, new Vec3(.99, -1, 0), Vec3.X)).isFalse();
    assertThat(isAway(lamp, new Vec3(1.01, -1, 0), Vec3.X)).isTrue();
  }

  @Test
  void openPointsReceiveLightFromBothSides() {
    Light bulb = new PointLight(Vec3.ZERO, Rgb.WHITE, Falloff.INVERSE_SQUARE);
    assertThat(isAway(bulb, Vec3.X, Vec3.X)).isTrue();
    assertThat(isAway(bulb, Vec3.X, Vec3.ZERO)).isFalse();
  }

  private static boolean isAway(Light light, Vec3 point, Vec3 normal) {
    LightChoice receiver = new LightChoice();
    receiver.moveTo(point, normal);
    return Facing.of(light).isAway(receiver);
  }

  private static Vec3 inCube(SplittableRandom random) {
    return new Vec3(random.nextDouble(-4, 4), random.nextDouble(-4, 4), random.nextDouble(-4, 4));
  }
}
