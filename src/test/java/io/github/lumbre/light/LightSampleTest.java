package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;

/** Tests light samples and their shadow rays. */
class LightSampleTest {
  private static final Point2 U = new Point2(.25, .75);
  private static final Rgb RADIANCE = new Rgb(1, 2, 4);
  private static final double HEIGHT = 5;
  private static final Shape PANEL =
      new Rectangle(Transform.translation(new Vec3(0, HEIGHT, 0)), .2, .2, true);

  @Test
  void componentsAreThoseOfTheRadiance() {
    LightSample sample = new LightSample();
    sample.setInfinite(Vec3.Y, RADIANCE, 7);
    assertThat(new Rgb(sample.r(), sample.g(), sample.b()))
        .isEqualTo(RADIANCE)
        .isEqualTo(sample.radiance());
  }

  @Test
  void dimmedLightHasTheFactorInEachComponent() {
    LightSample sample = new LightSample();
    sample.setInfinite(Vec3.Y, RADIANCE, 7);
    sample.dim(.25);
    assertThat(sample.radiance()).isEqualTo(RADIANCE.times(.25));
    assertThat(sample.pdf()).isEqualTo(7);
    sample.dim(0);
    assertThat(sample.isEmpty()).isTrue();
  }

  /** Returns whether a shape blocks the light on its way to the origin. */
  private static boolean isBlocked(Light light, Shape shape) {
    SurfaceHit floor =
        new SurfaceHit().set(Vec3.ZERO, Vec3.Y, Frame.WORLD, new TexturePoint(0, 0), Vec3.Y, 0);
    LightSample sample = light.sample(Vec3.ZERO, U).orElseThrow();
    NearestHit shadow = new NearestHit();
    sample.aimShadowRay(floor, shadow);
    assertThat(shadow.origin().length()).isLessThan(1e-9);
    assertThat(shadow.direction().normalized().minus(sample.wi()).length())
        .isCloseTo(0, within(1e-9));
    return shape.intersect(shadow);
  }

  private static Shape ball(double height) {
    return new Sphere(Transform.translation(new Vec3(0, height, 0)), 1);
  }

  @Test
  void shadowRaysEndAtTheLight() {
    Light point = new PointLight(new Vec3(0, HEIGHT, 0), RADIANCE, Falloff.NONE);
    Light panel = new AreaLight(PANEL, new Emission(Texture.constant(RADIANCE), true));
    Light sun = new DirectionalLight(Vec3.Y.negated(), RADIANCE);
    for (Light light : new Light[] {point, panel, sun}) {
      assertThat(isBlocked(light, ball(3))).isTrue();
      assertThat(isBlocked(light, ball(9))).isEqualTo(light == sun);
    }
    assertThat(isBlocked(panel, PANEL)).isFalse();
  }
}
