package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.guiding.GuideSample;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.render.internal.GuideReport.Outcome;
import io.github.lumbre.render.internal.RendererInside;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.texture.Texture;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what the pilot render of {@code --guide} learns, and that it is reproducible. */
class GuidePilotTest {
  private static SceneFile scene(String name, Guiding guiding) throws Exception {
    return scene(name, guiding, 64);
  }

  private static SceneFile scene(String name, Guiding guiding, int width) throws Exception {
    return new SceneParser()
        .overriding(
            s ->
                s.toBuilder()
                    .size(width, width * 3 / 4)
                    .samples(2)
                    .threads(2)
                    .guiding(guiding)
                    .build())
        .parse(Path.of("scenes", name + ".json"));
  }

  private static GuidePilot.Learned learn(SceneFile file, int threads) throws Exception {
    RenderSettings settings = file.settings();
    return GuidePilot.learn(settings, file.scene().framed(settings.aspect()), crew(threads));
  }

  private static PilotRows crew(int threads) {
    return new PilotRows(threads, () -> false);
  }

  @Test
  void theGuideDependsOnWhatSamplesDependOnAlone() throws Exception {
    SceneFile file = scene("door-ajar", Guiding.ON);
    GuideReport here = learn(file, 0).report();
    assertThat(here.outcome()).isEqualTo(Outcome.GUIDED);
    assertThat(here.hash()).isNotZero();
    for (int threads : new int[] {1, 3}) {
      assertThat(learn(file, threads).report()).isEqualTo(here);
    }
    RenderSettings settings = file.settings();
    Scene scene = file.scene().framed(settings.aspect());
    RenderSettings other =
        settings.toBuilder().crop(new Crop(3, 5, 7, 2)).samples(77).bucketSize(5).build();
    assertThat(GuidePilot.learn(other, scene, PilotRows.HERE).report()).isEqualTo(here);
    RenderSettings seeded = settings.toBuilder().seed(8).build();
    assertThat(GuidePilot.learn(seeded, scene, PilotRows.HERE).report().hash())
        .isNotEqualTo(here.hash());
  }

  /** A part of the picture, another number of threads and a replayed sample have the same bits. */
  @Test
  void picturesHaveTheSameBitsHoweverTheyAreMade() throws Exception {
    SceneFile file = scene("door-ajar", Guiding.ON);
    RenderSettings guided = file.settings();
    Image picture = new PictureRenderer(guided).render(file.scene());
    RenderSettings part =
        guided.toBuilder().crop(new Crop(20, 10, 9, 8)).threads(1).bucketSize(3).build();
    Image crop = new PictureRenderer(part).render(file.scene());
    for (int y = 0; y < 8; y++) {
      for (int x = 0; x < 9; x++) {
        assertThat(crop.pixel(x, y)).isEqualTo(picture.pixel(20 + x, 10 + y));
      }
    }
    assertThat(new PixelReplay(file.scene(), guided).pixel(31, 40, 0).mean())
        .isEqualTo(picture.pixel(31, 40));
    FilmRenderer renderer = new FilmRenderer(guided, file.scene());
    assertThat(RendererInside.of(renderer).guiding()).isEmpty();
    Film film = renderer.newFilm();
    renderer.addSamples(film, 1, Progress.NONE);
    // Another renderer, such as that of another process, learns the same guide.
    new FilmRenderer(guided, file.scene()).addSamples(film, 2, Progress.NONE);
    assertThat(film.develop().pixel(31, 40)).isEqualTo(picture.pixel(31, 40));
    assertThat(RendererInside.of(renderer).guiding()).contains(learn(file, 0).report());
  }

  /**
   * The means of guided and unguided pictures of several seeds agree within 4 standard errors of
   * their difference: a false alarm has a probability of 0.01 %. Power: with 12 pictures of 48 x 36
   * pixels and 32 samples, the standard error is about 1 % in the Cornell box. A missing
   * probability changes the mean by much more than 5 %.
   */
  @ParameterizedTest
  @ValueSource(strings = {"cornell-box", "glasses-on-a-table", "glass-and-mirror", "lantern"})
  void guidedPicturesAreUnbiased(String name) throws Exception {
    double[] sum = new double[2];
    double[] squares = new double[2];
    int count = 12;
    SceneFile file =
        new SceneParser()
            .overriding(s -> s.toBuilder().size(48, 36).samples(32).threads(2).build())
            .parse(Path.of("scenes", name + ".json"));
    for (int seed = 0; seed < count; seed++) {
      for (int kind = 0; kind < 2; kind++) {
        Guiding guiding = kind == 0 ? Guiding.OFF : Guiding.ON;
        RenderSettings settings = file.settings().toBuilder().seed(seed).guiding(guiding).build();
        double mean = mean(new PictureRenderer(settings).render(file.scene()));
        sum[kind] += mean / count;
        squares[kind] += mean * mean / count;
      }
    }
    double variance = 0;
    for (int kind = 0; kind < 2; kind++) {
      variance += (squares[kind] - sum[kind] * sum[kind]) / (count - 1);
    }
    assertThat(Math.abs(sum[0] - sum[1])).as(name).isLessThan(4 * Math.sqrt(variance));
  }

  private static double mean(Image image) {
    double sum = 0;
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        Rgb c = image.pixel(x, y);
        sum += (c.r() + c.g() + c.b()) / 3;
      }
    }
    return sum / image.width() / image.height();
  }

  /** Behind the door, few paths find light by chance. */
  @Test
  void guidedPicturesHaveLessNoise() throws Exception {
    double off = squaredDifference(Guiding.OFF);
    double on = squaredDifference(Guiding.ON);
    assertThat(on).isLessThan(.8 * off);
  }

  /** Returns the squared difference of two pictures with different random numbers. */
  private static double squaredDifference(Guiding guiding) throws Exception {
    SceneFile file = scene("door-ajar", guiding, 256);
    Image a = new PictureRenderer(file.settings()).render(file.scene());
    RenderSettings other = file.settings().toBuilder().seed(1).build();
    Image b = new PictureRenderer(other).render(file.scene());
    double sum = 0;
    for (int y = 0; y < a.height(); y++) {
      for (int x = 0; x < a.width(); x++) {
        Rgb difference = a.pixel(x, y).plus(b.pixel(x, y).times(-1));
        sum += Math.min(1, difference.luminance() * difference.luminance());
      }
    }
    return sum / a.width() / a.height();
  }

  private static SceneBuilder seen() {
    return Scene.builder().seenBy(Lens.pinhole(60).camera(new Vec3(0, 1, 0), Frame.WORLD, 1));
  }

  @Test
  void nothingIsRenderedWithoutLight() throws Exception {
    Scene plane =
        seen()
            .add(new Plane(Transform.IDENTITY, false), new Matte(Texture.constant(Rgb.WHITE)))
            .build();
    RenderSettings settings = scene("cornell-box", Guiding.ON).settings();
    GuideReport report = GuidePilot.learn(settings, plane, PilotRows.HERE).report();
    assertThat(report.outcome()).isEqualTo(Outcome.NO_LIGHT);
    assertThat(report.rays()).isZero();
    assertThat(report.text()).isEqualTo("paths are not guided: no light can reach a surface");
  }

  /** Black surfaces reflect nothing: the first pass ends the pilot. */
  @Test
  void aBlackSceneEndsThePilotEarly() throws Exception {
    Scene black =
        seen()
            .add(new Plane(Transform.IDENTITY, false), new Matte(Texture.constant(Rgb.BLACK)))
            .addBackground(Rgb.WHITE)
            .build();
    RenderSettings settings = scene("cornell-box", Guiding.ON).settings();
    GuideReport report = GuidePilot.learn(settings, black, PilotRows.HERE).report();
    assertThat(report.outcome()).isEqualTo(Outcome.NOTHING_LEARNED);
    assertThat(report.rays()).isLessThan(64 * 48);
    assertThat(report.text()).startsWith("paths are not guided: nothing was learned in a pilot");
  }

  /**
   * A gray floor under a white sky scatters half of the radiance everywhere, however far, and all
   * light comes from above. A guide that learned nothing has no cells.
   */
  @Test
  void anInfinitePlaneIsLearned() throws Exception {
    Scene plane =
        seen()
            .add(new Plane(Transform.IDENTITY, false), new Matte(Texture.constant(Rgb.gray(.5))))
            .addBackground(Rgb.WHITE)
            .build();
    RenderSettings settings = scene("cornell-box", Guiding.ON).settings();
    GuidePilot.Learned learned = GuidePilot.learn(settings, plane, PilotRows.HERE);
    assertThat(learned.report().outcome()).isEqualTo(Outcome.GUIDED);
    Guide guide = learned.guide();
    for (double z : new double[] {1, 30, 1e6}) {
      int cell = guide.cell(0, 0, z, 0, 1, 0);
      assertThat(cell).as("cell at z = %s", z).isNotEqualTo(Guide.NO_CELL);
      assertThat(guide.mean(cell)).isCloseTo(.5, within(.025));
      SplittableRandom random = new SplittableRandom(17);
      GuideSample sample = new GuideSample();
      int fromAbove = 0;
      for (int i = 0; i < 1000; i++) {
        guide.sample(cell, random.nextDouble(), random.nextDouble(), sample);
        fromAbove += sample.y() > 0 ? 1 : 0;
      }
      assertThat(fromAbove).isGreaterThan(970);
    }
    assertThat(guide.cell(0, 0, 1, 0, -1, 0)).as("below the floor").isEqualTo(Guide.NO_CELL);
  }

  @Test
  void anInterruptEndsThePilot() throws Exception {
    SceneFile file = scene("cornell-box", Guiding.ON);
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> learn(file, 2)).isInstanceOf(InterruptedException.class);
    assertThat(Thread.interrupted()).isFalse();
  }
}
