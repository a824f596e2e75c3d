package io.github.lumbre.spark;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Units cover what a pass lacks, each sample once, in an order that keeps the noise exact. */
class UnitsTest {
  private static void assertCover(Film film, int goal, long samplesPerUnit) {
    Crop window = film.window();
    int[][] counts = new int[window.height()][window.width()];
    for (int y = 0; y < window.height(); y++) {
      for (int x = 0; x < window.width(); x++) {
        counts[y][x] = film.samples(window.x() + x, window.y() + y);
      }
    }
    for (WorkUnit unit : Units.of(film, (x, y) -> goal, samplesPerUnit)) {
      for (int y = unit.y(); y < unit.y() + unit.height(); y++) {
        for (int x = unit.x(); x < unit.x() + unit.width(); x++) {
          int before = counts[y - window.y()][x - window.x()];
          assertThat(unit.first()).isEqualTo(film.firstSample() + before);
          int after = before + unit.count();
          int power = Integer.highestOneBit(after - 1);
          assertThat(before == 0 || power <= before).as(unit.toString()).isTrue();
          counts[y - window.y()][x - window.x()] = after;
        }
      }
    }
    for (int[] row : counts) {
      assertThat(row).containsOnly(goal);
    }
  }

  @Test
  void unitsCoverEachSampleOnce() {
    Crop window = new Crop(3, 5, 100, 41);
    for (long size : new long[] {1, 100, 3000, 1_000_000}) {
      assertCover(new Film(window, false, 0), 4, size);
      assertCover(new Film(window, true, 7), 100, size);
    }
  }

  @Test
  void raggedFilmsAreCompleted() throws InterruptedException {
    RenderSettings settings =
        new RenderSettings.Builder().size(48, 40).samples(9).threads(1).bucketSize(16).build();
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(50).camera(new Vec3(0, 1, -4), Frame.WORLD, 1.2))
            .addBackground(Rgb.WHITE)
            .build();
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm();
    renderer.addSamples(film, (x, y) -> (x / 5 + y / 9) % 3, Progress.NONE);
    assertCover(film, 9, 500);
  }

  @Test
  void resultsKeepTheirFilms() throws InterruptedException {
    WorkUnit unit = new WorkUnit(2, 3, 5, 4, 6, 3);
    RenderSettings settings =
        new RenderSettings.Builder().size(20, 20).threads(1).crop(unit.tile()).build();
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(50).camera(new Vec3(0, 1, -4), Frame.WORLD, 1))
            .addBackground(new Rgb(.1, 2, 3e5))
            .build();
    FilmRenderer renderer = new FilmRenderer(settings, scene);
    Film film = renderer.newFilm(6);
    var statistics = renderer.addSamples(film, 3, Progress.NONE).statistics();
    Film decoded = UnitResult.of(unit, film, statistics, 1).decoded(film.layers());
    assertThat(decoded.develop().rgb()).isEqualTo(film.develop().rgb());
    assertThat(decoded.firstSample()).isEqualTo(6);
    assertThat(List.of(decoded.samples(2, 3), decoded.samples(6, 6))).containsOnly(3);
  }
}
