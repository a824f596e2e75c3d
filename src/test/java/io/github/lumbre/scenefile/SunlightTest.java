package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.PixelFilter;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.MisHeuristic;
import io.github.lumbre.integrator.PathOptions;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.texture.internal.ClearSky;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests renders of what the sun lights. */
class SunlightTest {
  /** Angle between the center and the edge of the sun, in degrees. */
  private static final double RADIUS = .266272;

  /** The albedo of {@link Matte#GRAY}. */
  private static final double ALBEDO = .5;

  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(32, 24).samples(16).maxTraceDepth(3).threads(1).build();

  private static EnvironmentLight sun(double elevation) {
    return TextureChange.NONE.sun(Frame.WORLD, Rgb.WHITE, new ClearSky(0, elevation));
  }

  private static EnvironmentLight sky(double elevation) {
    return TextureChange.NONE.clear(Frame.WORLD, Rgb.WHITE, new ClearSky(0, elevation));
  }

  private static SceneBuilder floor() {
    return Scene.builder()
        .lookingAt(new Vec3(0, 2, -4), Vec3.ZERO, 40)
        .add(Plane.floor(0), Matte.GRAY);
  }

  /** Returns the part of a disk on one side of a chord at a distance from its center, in radii. */
  private static double part(double distance) {
    double t = Math.max(-1, Math.min(1, distance));
    return .5 + (t * Math.sqrt(1 - t * t) + Math.asin(t)) / Math.PI;
  }

  /**
   * Below an edge, the light of a sun in the zenith falls from full to none over a width of its
   * diameter at the edge's distance, as the part of a disk beside a chord.
   */
  @Test
  void theEdgeOfAShadowIsAsWideAsTheSun() throws InterruptedException {
    double height = 10;
    double radius = height * Math.tan(Math.toRadians(RADIUS));
    int columns = 48;
    double step = 3. / columns;
    Scene scene =
        floor()
            .add(Box.of(new Vec3(-50, height, 0), new Vec3(100, 1e-3, 100)), Matte.GRAY)
            .add(sun(90))
            .lookingAt(
                new Vec3(0, height / 2, 0),
                Vec3.ZERO,
                new Vec3(0, 0, 1),
                Lens.orthographic(step * radius))
            .build();
    int samples = 4096;
    RenderSettings settings =
        SETTINGS.toBuilder()
            .maxTraceDepth(1)
            .size(columns, 1)
            .samples(samples)
            .filter(PixelFilter.BOX)
            .build();
    float[] rgb = new PictureRenderer(settings).render(scene).rgb();
    double full = new ClearSky(0, 90).sun().g() * ALBEDO / Math.PI;
    double width = 0;
    for (int i = 0; i < columns; i++) {
      double beside = step * (i + .5) - 1.5;
      double lit = rgb[3 * i + 1] / full;
      // Four standard errors of samples that see the sun or not.
      assertThat(lit).as("column " + i).isCloseTo(part(beside), within(2 / Math.sqrt(samples)));
      width += step * (beside < 0 ? lit : 1 - lit);
    }
    // The integral of the part that is missing or too much: 0.65 % is a standard error.
    assertThat(width).isCloseTo(4 / (3 * Math.PI), within(.02 * 4 / (3 * Math.PI)));
  }

  /** Returns the moments of single samples of the floor's light, by light and scattered rays. */
  private static Moments moments(EnvironmentLight... lights) {
    SceneBuilder scene = floor();
    for (EnvironmentLight light : lights) {
      scene.add(light);
    }
    PathTracer tracer = new PathTracer(scene.build(), PathOptions.toDepth(1).by(MisHeuristic.BOTH));
    SobolSampler sampler = new SobolSampler(Effort.seed(1));
    RenderContext context = new RenderContext();
    Ray down = new Ray(Vec3.Y, Vec3.Y.negated());
    Moments moments = new Moments();
    int samples = Effort.count(50_000, 1_000_000);
    for (int i = 0; i < samples; i++) {
      // Every sample has its own pixel, so the samples are independent.
      sampler.startSample(i & 0xffff, i >>> 16, 0);
      moments.add(tracer.radiance(down, sampler, context).g());
    }
    return moments;
  }

  /** Returns a picture of sun and sky: the sun is one of its texels. */
  private static EnvironmentLight picture(double elevation) {
    ClearSky clear = new ClearSky(0, elevation);
    int columns = 512;
    int rows = 256;
    Rgb[] texels = new Rgb[columns * rows];
    for (int i = 0; i < texels.length; i++) {
      texels[i] = clear.at((i % columns + .5) / columns, (i / columns + .5) / rows);
    }
    int row = (int) (rows * (.5 + elevation / 180));
    double latitude = Math.PI * ((row + .5) / rows - .5);
    double solidAngle = 2 * Math.PI / columns * Math.PI / rows * Math.cos(latitude);
    texels[row * columns] = texels[row * columns].plus(clear.sun().times(1 / solidAngle));
    return EnvironmentLight.image(
        Frame.WORLD,
        (u, v) ->
            texels[
                Math.min(rows - 1, (int) (v * rows)) * columns
                    + Math.min(columns - 1, (int) (u * columns))],
        columns,
        rows);
  }

  /**
   * Sun and sky have about the noise of one picture of both, and that of the sun's own samples: its
   * disk is sampled in 8 rows, with a relative variance of the weights of Σ 1 / (384 (i + ½)).
   */
  @ParameterizedTest
  @ValueSource(doubles = {5, 30, 60})
  void sunAndSkyAreSampledAsWellAsAPicture(double elevation) {
    Moments both = moments(sun(elevation), sky(elevation));
    Moments sun = moments(sun(elevation));
    Moments picture = moments(picture(elevation));
    // The picture's sun is up to half a texel lower or higher.
    assertThat(both.mean()).isCloseTo(picture.mean(), within(.03 * picture.mean()));
    assertThat(Math.sqrt(sun.variance()) / sun.mean()).isCloseTo(.1026, within(.005));
    assertThat(both.variance()).isLessThan(1.15 * (picture.variance() + sun.variance()));
  }

  /** The bits are the same with all versions of Java and numbers of threads. */
  @Test
  void rendersTheSameBitsEverywhere() throws InterruptedException {
    Scene scene =
        floor()
            .add(Sphere.of(new Vec3(0, .5, 0), .5), Matte.GRAY)
            .add(sun(30))
            .add(sky(30))
            .build();
    float[] one = new PictureRenderer(SETTINGS).render(scene).rgb();
    RenderSettings more = SETTINGS.toBuilder().threads(3).bucketSize(8).build();
    assertThat(new PictureRenderer(more).render(scene).rgb()).isEqualTo(one);
    assertThat(Arrays.hashCode(one)).isEqualTo(-1595596216);
  }
}
