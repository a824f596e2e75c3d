package io.github.lumbre.render.preview;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PassRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.render.StopRule;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Previews show a render as it is, and change nothing. */
class PreviewsTest {
  private static SceneFile file;
  private static RenderSettings settings;

  /** A listener that keeps what it receives. */
  private static final class Keeper implements PreviewListener {
    private final List<Preview> shown = new ArrayList<>();
    private boolean isWatching = true;
    private boolean wantsNoise = true;
    private double elsewhere;

    @Override
    public void show(Preview preview) {
      shown.add(preview);
    }

    @Override
    public boolean isWatching() {
      return isWatching;
    }

    @Override
    public Set<Layer> layers() {
      return Layer.setOf(Layer.NORMAL, Layer.DEPTH);
    }

    @Override
    public boolean wantsNoise() {
      return wantsNoise;
    }

    @Override
    public double secondsElsewhere() {
      return elsewhere;
    }
  }

  @BeforeAll
  static void read() throws Exception {
    file = new SceneParser().parse(Path.of("scenes/cornell-box.json"));
    settings =
        file.settings().toBuilder()
            .size(48, 36)
            .samples(128)
            .set(Setting.LAYERS, Layer.setOf(Layer.NORMAL))
            .build();
  }

  private static Film plain() throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    renderer.addSamples(film, settings.samples(), Progress.NONE);
    return film;
  }

  private static Previews previews(PreviewListener listener) {
    return new Previews(RecordedLayers.of(settings, file.scene()), listener);
  }

  private static RenderStatistics render(
      PassRenderer renderer, Film film, PreviewListener listener, Progress progress)
      throws InterruptedException {
    Previews previews = previews(listener);
    PassResult passes = new PassLoop(renderer, film).run(StopRule.NONE, previews, progress);
    previews.showLast(film);
    return passes.statistics();
  }

  @Test
  void previewedRenderHasTheSameBitsAndCounts() throws Exception {
    Keeper keeper = new Keeper();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    RenderStatistics statistics = render(renderer, film, keeper, Progress.NONE);
    assertThat(film.develop().rgb()).isEqualTo(plain().develop().rgb());
    assertThat(statistics.samples()).isEqualTo(48L * 36 * 128).isEqualTo(film.totalSamples());
    assertThat(keeper.shown).hasSizeGreaterThan(1);
    Preview last = keeper.shown.get(keeper.shown.size() - 1);
    FilmPicture whole = FilmPicture.of(film, RecordedLayers.of(settings, file.scene()));
    assertThat(last.image().rgb()).isEqualTo(whole.image().rgb());
    assertThat(last.samples()).isEqualTo(128);
    assertThat(last.isEndOfPass()).isTrue();
    assertThat(last.layers()).hasSize(1);
    assertThat(last.layers().get(0).values()).isEqualTo(whole.layers().get(0).values());
    assertThat(keeper.shown.get(0).totalSamples()).isPositive();
  }

  @Test
  void longPassIsPaused() throws Exception {
    Keeper keeper = new Keeper();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    SampleTarget all = (x, y) -> settings.samples();
    Schedule once = f -> Optional.of(all).filter(t -> f.fewestSamples() < settings.samples());
    PassResult pass =
        new PassLoop(renderer, film, once).run(StopRule.NONE, previews(keeper), Progress.NONE);
    assertThat(pass.complete()).isTrue();
    assertThat(pass.statistics().samples()).isEqualTo(48L * 36 * 128);
    assertThat(film.develop().rgb()).isEqualTo(plain().develop().rgb());
    assertThat(keeper.shown.get(0).isEndOfPass()).isFalse();
    assertThat(keeper.shown.get(0).noise()).isEmpty();
  }

  @Test
  void cancelledPassStaysCancelled() throws Exception {
    AtomicLong done = new AtomicLong();
    Progress progress =
        new Progress() {
          @Override
          public void advanced(long samples) {
            done.addAndGet(samples);
          }

          @Override
          public boolean isCancelled() {
            return done.get() > 5000;
          }
        };
    Keeper keeper = new Keeper();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    Film film = renderer.newFilm();
    render(renderer, film, keeper, progress);
    assertThat(film.totalSamples()).isBetween(5000L, 48L * 36 * 100);
    Preview last = keeper.shown.get(keeper.shown.size() - 1);
    assertThat(last.totalSamples()).isEqualTo(film.totalSamples());
  }

  @Test
  void nothingIsDevelopedWhileNobodyWatches() throws Exception {
    Keeper keeper = new Keeper();
    keeper.isWatching = false;
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    AtomicLong passes = new AtomicLong();
    PassRenderer counting =
        new PassRenderer() {
          @Override
          public Schedule schedule() {
            return renderer.schedule();
          }

          @Override
          public PassResult addSamples(Film film, SampleTarget target, Progress progress)
              throws InterruptedException {
            passes.incrementAndGet();
            return renderer.addSamples(film, target, progress);
          }
        };
    render(counting, renderer.newFilm(), keeper, Progress.NONE);
    assertThat(keeper.shown).isEmpty();
    assertThat(passes).hasValue(8); // 1, 2, 4, ... 64, 128: none is divided
  }

  @Test
  void noiseIsEstimatedAtEndsOfPasses() throws Exception {
    Keeper keeper = new Keeper();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    render(renderer, renderer.newFilm(), keeper, Progress.NONE);
    assertThat(keeper.shown)
        .filteredOn(preview -> preview.noise().isPresent())
        .isNotEmpty()
        .allMatch(Preview::isEndOfPass);
  }

  @Test
  void workElsewhereMakesPreviewsRare() throws Exception {
    Keeper keeper = new Keeper();
    keeper.elsewhere = 3600;
    keeper.wantsNoise = false;
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    render(renderer, renderer.newFilm(), keeper, Progress.NONE);
    assertThat(keeper.shown).hasSizeLessThanOrEqualTo(3); // two to learn the cost, and the last
  }
}
