package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.PinholeCamera;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.Texture;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Tests what the pilot render of {@code --split auto} chooses, and that it is reproducible. */
class SplitPilotTest {
  private static SceneFile scene(String name) throws Exception {
    return new SceneParser()
        .overriding(
            s ->
                s.toBuilder()
                    .size(96, 72)
                    .samples(2)
                    .threads(2)
                    .split(RenderSettings.AUTO_SPLIT)
                    .build())
        .parse(Path.of("scenes", name + ".json"));
  }

  /** The gain of two branches is at least 1.2 in a closed room, and 0.5 in front of a figure. */
  @Test
  void pathsAreSplitWhereIndirectLightDominates() throws Exception {
    SceneFile room = scene("cornell-box");
    SplitReport split = SplitReport.of(room.settings(), room.scene());
    assertThat(split.branches()).isBetween(2, SplitPilot.MOST);
    assertThat(split.gain()).isGreaterThan(1.25);
    assertThat(split.text())
        .matches("paths are split into \\d branches: 1\\.\\d\\d times as efficient in .*");

    SceneFile knot = scene("torus-knot");
    SplitReport whole = SplitReport.of(knot.settings(), knot.scene());
    assertThat(whole.branches()).isOne();
    assertThat(whole.gain()).isOne();
    assertThat(whole.rays()).isPositive();
    assertThat(whole.text()).startsWith("paths are not split: more branches were not");
  }

  @Test
  void theChoiceDependsOnWhatSamplesDependOnAlone() throws Exception {
    SceneFile file = scene("cornell-box");
    Scene scene = file.scene();
    RenderSettings settings = file.settings();
    SplitReport here = SplitPilot.choose(settings, scene);
    for (int threads : new int[] {1, 3}) {
      assertThat(SplitPilot.choose(settings, scene, threads)).isEqualTo(here);
    }
    RenderSettings other =
        settings.toBuilder().crop(new Crop(3, 5, 7, 2)).samples(77).bucketSize(5).build();
    assertThat(SplitPilot.choose(other, scene)).isEqualTo(here);
    RenderSettings seeded = settings.toBuilder().seed(8).build();
    assertThat(SplitPilot.choose(seeded, scene).rays()).isNotEqualTo(here.rays());
  }

  /** The picture, a part of it and a replayed sample have the bits of the number that is chosen. */
  @Test
  void picturesAreThoseOfTheChosenNumber() throws Exception {
    SceneFile file = scene("cornell-box");
    RenderSettings auto = file.settings();
    RenderSettings chosen = SplitPilot.choose(auto, file.scene()).applyTo(auto);
    assertThat(chosen.split()).isGreaterThan(1);
    Image picture = new BucketRenderer(auto).render(file.scene());
    assertSame(picture, new BucketRenderer(chosen).render(file.scene()), 0, 0);

    RenderSettings part = auto.toBuilder().crop(new Crop(20, 10, 9, 8)).threads(1).build();
    assertSame(new BucketRenderer(part).render(file.scene()), picture, 20, 10);

    assertThat(new PixelReplay(file.scene(), auto).pixel(31, 40, 0).mean())
        .isEqualTo(picture.pixel(31, 40));
  }

  private static void assertSame(Image part, Image picture, int left, int top) {
    for (int y = 0; y < part.height(); y++) {
      for (int x = 0; x < part.width(); x++) {
        assertThat(part.pixel(x, y)).isEqualTo(picture.pixel(left + x, top + y));
      }
    }
  }

  @Test
  void theReportIsThereAfterTheFirstPass() throws Exception {
    SceneFile file = scene("cornell-box");
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    assertThat(renderer.splitting()).isEmpty();
    renderer.addSamples(renderer.newFilm(), 1, Progress.NONE);
    assertThat(renderer.splitting()).contains(SplitPilot.choose(file.settings(), file.scene()));
  }

  @Test
  void nothingIsRenderedWithoutLight() throws Exception {
    Scene plane =
        Scene.builder()
            .seenBy(new PinholeCamera(new Vec3(0, 1, 0), Frame.WORLD, 1, 60))
            .add(new Plane(Transform.IDENTITY, false), new Matte(Texture.constant(Rgb.WHITE)))
            .build();
    RenderSettings settings = scene("cornell-box").settings();
    SplitReport report = SplitPilot.choose(settings, plane);
    assertThat(report).isEqualTo(new SplitReport(1, 1, 0));
    assertThat(report.text()).isEqualTo("paths are not split: no light can reach a surface");
    RenderSettings blind = settings.toBuilder().maxTraceDepth(0).build();
    assertThat(SplitPilot.choose(blind, scene("cornell-box").scene())).isEqualTo(report);
  }

  /** The work is at most 16 samples in each of 1024 pixels for each number of branches. */
  @Test
  void theWorkIsLimited() throws Exception {
    SceneFile file = scene("torus-knot");
    RenderSettings large = file.settings().toBuilder().size(4096, 3072).maxTraceDepth(1).build();
    SplitReport report = SplitReport.of(large, file.scene());
    // A path of one scattering has at most 2 rays to vertices for each branch, and a shadow ray.
    assertThat(report.rays()).isLessThan(16L * SplitPilot.MOST_PIXELS * (3 + 4 + 6 + 10));
  }

  @Test
  void anInterruptEndsThePilot() throws Exception {
    SceneFile file = scene("cornell-box");
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> SplitPilot.choose(file.settings(), file.scene(), 2))
        .isInstanceOf(InterruptedException.class);
    assertThat(Thread.interrupted()).isFalse();
  }
}
