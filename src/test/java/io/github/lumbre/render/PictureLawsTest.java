package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Phong;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests changes of scenes whose effect on the picture is known. */
class PictureLawsTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 16;

  private static SceneBuilder empty() {
    return Scene.builder().seenBy(Lens.pinhole(50).camera(new Vec3(0, 1, -4), Frame.WORLD, 1.5));
  }

  /** Returns a scene with many bounces and saturated colors, modified by the given functions. */
  private static Scene colorful(UnaryOperator<Rgb> surfaces, UnaryOperator<Rgb> lights) {
    Texture<Rgb> red = Texture.constant(surfaces.apply(new Rgb(.95, .3, .1)));
    Texture<Rgb> blue = Texture.constant(surfaces.apply(new Rgb(.02, .2, .6)));
    Texture<Rgb> pale = Texture.constant(surfaces.apply(new Rgb(.8, .95, .7)));
    Transform lamp =
        Transform.translation(new Vec3(0, 3, 0))
            .times(Transform.rotationDegrees(new Vec3(180, 0, 0)));
    return empty()
        .add(new Rectangle(Transform.IDENTITY, 9, 9, false), new Matte(pale))
        .add(ball(-1.2, .6, .6), new Phong(red, blue, ScalarTexture.constant(20)))
        .add(ball(.2, .5, .5), new Matte(red))
        .add(
            ball(1.4, .6, .6),
            new Glass(pale, red, ScalarTexture.constant(1.5), ScalarTexture.constant(0)))
        .addAreaLight(
            new Rectangle(lamp, 1, 1, false),
            new Emission(Texture.constant(lights.apply(new Rgb(1, 4, 2))), false))
        .add(
            new PointLight(
                new Vec3(-2, 2, -1), lights.apply(new Rgb(3, .1, .5)), Falloff.INVERSE_SQUARE))
        .add(EnvironmentLight.uniform(lights.apply(new Rgb(.1, .2, .9))))
        .build();
  }

  private static Sphere ball(double x, double y, double radius) {
    return new Sphere(Transform.translation(new Vec3(x, y, 0)), radius);
  }

  private static Image picture(Scene scene, int samples, long seed) throws InterruptedException {
    RenderSettings settings =
        new RenderSettings.Builder()
            .size(WIDTH, HEIGHT)
            .samples(samples)
            .seed(seed)
            .maxTraceDepth(12)
            .build();
    return new PictureRenderer(settings).render(scene);
  }

  @Test
  void channelsDoNotKnowOfEachOther() throws InterruptedException {
    UnaryOperator<Rgb> turn = color -> new Rgb(color.g(), color.b(), color.r());
    Image picture = picture(colorful(c -> c, c -> c), 16, 1);
    Image turned = picture(colorful(turn, turn), 16, 1);

    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(turned.pixel(x, y)).isEqualTo(turn.apply(picture.pixel(x, y)));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {-8, 1, 10})
  void pictureIsProportionalToItsLights(int exponent) throws InterruptedException {
    double scale = Math.scalb(1.0, exponent);
    Image picture = picture(colorful(c -> c, c -> c), 16, 1);
    Image scaled = picture(colorful(c -> c, c -> c.times(scale)), 16, 1);

    for (int i = 0; i < picture.rgb().length; i++) {
      assertThat(scaled.rgb()[i]).isEqualTo((float) (picture.rgb()[i] * scale));
    }
  }

  @Test
  void seedsDifferAndAgreeOnTheMean() throws InterruptedException {
    Scene scene = colorful(c -> c, c -> c);
    int samples = Effort.count(64, 4096);
    float[] one = picture(scene, samples, Effort.seed(0)).rgb();
    for (long seed : new long[] {1, -1, Long.MAX_VALUE}) {
      float[] other = picture(scene, samples, Effort.seed(seed)).rgb();
      Moments differences = new Moments();
      for (int i = 0; i < one.length; i += 3) {
        differences.add((one[i] - other[i]) / (one[i] + other[i]));
      }
      assertThat(other).isNotEqualTo(one);
      assertThat(Statistics.deviation(differences.z(0))).isLessThan(Statistics.CRITICAL_Z);
    }
  }

  /**
   * The relative difference between the last rough picture and the first smooth one is below 1 %.
   */
  @ParameterizedTest
  @EnumSource(MicrofacetDistribution.class)
  void mirrorTakesOverFromFacetsWithoutAStep(MicrofacetDistribution kind)
      throws InterruptedException {
    float[] rough = shiny(CookTorrance.SMOOTH, kind);
    float[] smooth = shiny(Math.nextDown(CookTorrance.SMOOTH), kind);
    double sum = 0;
    for (int i = 0; i < rough.length; i++) {
      double difference = rough[i] - smooth[i];
      sum += difference * difference / (smooth[i] * smooth[i] + .01);
    }

    assertThat(sum / rough.length).isLessThan(.01);
    assertThat(rough).isNotEqualTo(smooth);
    assertThat(shiny(1e-6, kind)).isEqualTo(smooth);
  }

  private static float[] shiny(double roughness, MicrofacetDistribution kind)
      throws InterruptedException {
    CookTorrance material =
        new CookTorrance(
            Texture.constant(Rgb.gray(.2)),
            Texture.constant(Rgb.gray(.8)),
            ScalarTexture.constant(roughness),
            ScalarTexture.constant(CookTorrance.DEFAULT_IOR),
            kind);
    Scene scene =
        empty()
            .add(ball(0, 1, 1), material)
            .add(EnvironmentLight.image(Frame.WORLD, (u, v) -> new Rgb(u * (1 - u), v, .5), 32, 32))
            .build();
    return picture(scene, Effort.count(64, 4096), 1).rgb();
  }
}
