package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.camera.PinholeCamera;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
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
                    .splitPilot(4096)
                    .build())
        .parse(Path.of("scenes", name + ".json"));
  }

  private static SplitReport choose(RenderSettings settings, Scene scene) throws Exception {
    return SplitPilot.choose(settings, scene.framed(settings.aspect()), PilotRows.HERE);
  }

  /** Four branches are 1.3 times as efficient in a closed room, and 0.6 under a bright dome. */
  @Test
  void pathsAreSplitWhereIndirectLightDominates() throws Exception {
    SceneFile room = scene("cornell-box");
    SplitReport split = SplitReport.of(room.settings(), room.scene());
    assertThat(split.branches()).isBetween(1.5, 8.);
    assertThat(split.gain()).isGreaterThan(1.15);
    assertThat(split.text())
        .matches("paths are split into .*: 1\\.\\d\\d times as efficient \\(at least 1.*");

    SceneFile dome = scene("cornell-box-dome");
    SplitReport whole = SplitReport.of(dome.settings(), dome.scene());
    assertThat(whole.branches()).isOne();
    assertThat(whole.gain()).isOne();
    assertThat(whole.rays()).isPositive();
    assertThat(whole.text()).startsWith("paths are not split: no more efficient for certain");
  }

  @Test
  void theChoiceDependsOnWhatSamplesDependOnAlone() throws Exception {
    SceneFile file = scene("cornell-box");
    RenderSettings settings = file.settings();
    Scene scene = file.scene().framed(settings.aspect());
    SplitReport here = choose(settings, scene);
    for (int threads : new int[] {1, 3}) {
      SplitReport there = SplitPilot.choose(settings, scene, new PilotRows(threads, () -> false));
      assertThat(there.values()).isEqualTo(here.values());
    }
    RenderSettings other =
        settings.toBuilder().crop(new Crop(3, 5, 7, 2)).samples(77).bucketSize(5).build();
    assertThat(choose(other, scene).values()).isEqualTo(here.values());
    RenderSettings seeded = settings.toBuilder().seed(1).build();
    assertThat(choose(seeded, scene).rays()).isNotEqualTo(here.rays());
  }

  /** The picture, a part of it and a replayed sample have the bits of the plan. */
  @Test
  void picturesFollowThePlan() throws Exception {
    SceneFile file = scene("cornell-box");
    RenderSettings auto = file.settings().toBuilder().samples(5).build();
    SplitPlan plan = choose(auto, file.scene()).plan();
    assertThat(plan.isEmpty()).isFalse();
    Image picture = new BucketRenderer(auto).render(file.scene());
    for (int exponent = 0; exponent <= SplitChoice.MOST; exponent++) {
      RenderSettings fixed = auto.toBuilder().split(1 << exponent).build();
      Image same = new BucketRenderer(fixed).render(file.scene());
      for (int y = 0; y < picture.height(); y++) {
        for (int x = 0; x < picture.width(); x++) {
          if (plan.branches(x, y) == 1 << exponent) {
            assertThat(picture.pixel(x, y)).isEqualTo(same.pixel(x, y));
          }
        }
      }
    }
    RenderSettings part = auto.toBuilder().crop(new Crop(20, 10, 9, 8)).threads(1).build();
    assertSame(new BucketRenderer(part).render(file.scene()), picture, 20, 10);
    assertThat(new PixelReplay(file.scene(), auto).pixel(31, 40, 0).mean())
        .isEqualTo(picture.pixel(31, 40));

    // Passes of one and of several samples have the same sums.
    FilmRenderer renderer = new FilmRenderer(auto, file.scene());
    Film film = renderer.newFilm();
    renderer.addSamples(film, 1, Progress.NONE);
    renderer.addSamples(film, 5, Progress.NONE);
    assertSame(film.develop(), picture, 0, 0);
    FilmRenderer window = renderer.in(new Crop(40, 30, 6, 5));
    Film small = window.newFilm();
    window.addSamples(small, 5, Progress.NONE);
    assertSame(small.develop(), picture, 40, 30);
    assertThat(window.splitting()).isEqualTo(renderer.splitting());
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
    assertThat(renderer.splitting().orElseThrow().values())
        .isEqualTo(choose(file.settings(), file.scene()).values());
  }

  private static SceneBuilder planeSeenFromAbove() {
    return Scene.builder()
        .seenBy(new PinholeCamera(new Vec3(0, 1, 0), Frame.WORLD, 1, 60))
        .add(new Plane(Transform.IDENTITY, false), new Matte(Texture.constant(Rgb.WHITE)));
  }

  @Test
  void nothingIsRenderedWithoutLight() throws Exception {
    RenderSettings settings = scene("cornell-box").settings();
    SplitReport report = choose(settings, planeSeenFromAbove().build());
    assertThat(report.rays()).isZero();
    assertThat(report.branches()).isOne();
    assertThat(report.text()).isEqualTo("paths are not split: no light can reach a surface");
    RenderSettings blind = settings.toBuilder().maxTraceDepth(0).build();
    assertThat(choose(blind, scene("cornell-box").scene()).text()).isEqualTo(report.text());
  }

  @Test
  void nothingIsRenderedForAShortRender() throws Exception {
    SceneFile file = scene("cornell-box");
    SplitReport report = choose(file.settings().toBuilder().splitPilot(0).build(), file.scene());
    assertThat(report.rays()).isZero();
    assertThat(report.text()).contains("too short for a pilot render");
  }

  /** A pilot has at most 2 % of the samples, and 192 samples for each pixel. */
  @Test
  void thePilotHasAShareOfTheSamples() {
    assertThat(SplitReport.pilotPixels(320 * 240, 127)).isZero();
    assertThat(SplitReport.pilotPixels(320 * 240, 129)).isEqualTo(1024);
    assertThat(SplitReport.pilotPixels(1920 * 1080, 64)).isEqualTo(4096);
    assertThat(SplitReport.pilotPixels(1 << 28, 7)).isZero();
    assertThat(SplitReport.pilotPixels(1 << 28, RenderSettings.MAX_SAMPLES - 1)).isEqualTo(4096);
    assertThat(SplitReport.pilotPixels(640 * 480, RenderSettings.MAX_SAMPLES)).isEqualTo(1024);
    for (int samples = 8; samples < 5000; samples += 7) {
      int pixels = SplitReport.pilotPixels(160 * 120, samples);
      assertThat(pixels * 192.).isLessThanOrEqualTo(.02 * 160 * 120 * samples);
    }
  }

  /** The lamp is black or a hundred thousand lamps shine from below the floor. */
  @Test
  void scenesWithoutNoiseAreNotSplit() throws Exception {
    RenderSettings settings = scene("cornell-box").settings();
    SceneBuilder many = planeSeenFromAbove();
    for (int i = 0; i < 100_000; i++) {
      many.add(PointLight.of(new Vec3(i % 300 - 150, -1, i / 300 - 150), Rgb.WHITE));
    }
    for (Scene scene :
        new Scene[] {
          many.build(),
          planeSeenFromAbove().add(PointLight.of(new Vec3(0, -1, 0), Rgb.WHITE)).build()
        }) {
      SplitReport report = choose(settings, scene);
      assertThat(report.branches()).isOne();
      assertThat(report.text()).startsWith("paths are not split");
    }
  }

  /** The work is at most 64 samples with 1 branch and 32 with 4 in each pixel. */
  @Test
  void theWorkIsLimited() throws Exception {
    SceneFile file = scene("torus-knot");
    RenderSettings large = file.settings().toBuilder().size(4096, 3072).maxTraceDepth(1).build();
    SplitReport report = SplitReport.of(large, file.scene());
    // A path of one scattering has at most 2 rays to vertices for each branch, and a shadow ray.
    assertThat(report.rays()).isLessThan(32L * 4096 * (2 * 3 + 6));
  }

  @Test
  void anInterruptEndsThePilot() throws Exception {
    SceneFile file = scene("cornell-box");
    Scene scene = file.scene().framed(file.settings().aspect());
    for (int threads : new int[] {0, 2}) {
      Thread.currentThread().interrupt();
      assertThatThrownBy(
              () -> SplitPilot.choose(file.settings(), scene, new PilotRows(threads, () -> false)))
          .isInstanceOf(InterruptedException.class);
      assertThat(Thread.interrupted()).isFalse();
    }
    // On a shared pool, too.
    Thread.currentThread().interrupt();
    FilmRenderer shared = new FilmRenderer(file.settings(), file.scene()).on(Runnable::run);
    assertThatThrownBy(() -> shared.addSamples(shared.newFilm(), 1, Progress.NONE))
        .isInstanceOf(InterruptedException.class);
    assertThat(Thread.interrupted()).isFalse();
  }

  @Test
  void aCancelledPilotLeavesTheFilmEmpty() throws Exception {
    SceneFile file = scene("cornell-box");
    for (FilmRenderer renderer :
        new FilmRenderer[] {
          new FilmRenderer(file.settings(), file.scene()),
          new FilmRenderer(file.settings(), file.scene()).on(Runnable::run)
        }) {
      Film film = renderer.newFilm();
      Progress cancelled = Progress.NONE.cancelledAlsoIf(() -> true);
      assertThat(renderer.addSamples(film, 1, cancelled).complete()).isFalse();
      assertThat(film.totalSamples()).isZero();
      assertThat(renderer.plan(cancelled)).isEmpty();
      // The next pass renders the pilot.
      assertThat(renderer.addSamples(film, 1, Progress.NONE).complete()).isTrue();
      assertThat(renderer.splitting()).isPresent();
    }
  }
}
