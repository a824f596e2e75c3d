package io.github.lumbre.cli.view;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.preview.Preview;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.Stage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Renders quick pictures of a view, with one sample per pixel and as many pixels as there is time
 * for. The very first one is small, and a larger one follows at once. Mutable, for one thread.
 */
final class Drafts {
  /** The time that a draft should take. */
  private static final double DRAFT_SECONDS = .08;

  /** The pixels of the very first draft, which mostly waits for classes and the JIT. */
  private static final double COLD_PIXELS = 3000;

  /** The pixels of the second draft, whose speed is not known yet. */
  private static final double FIRST_PIXELS = 12_000;

  /** The smallest and the largest number of pixels of later drafts. */
  private static final double LEAST_PIXELS = 3000;

  private static final double MOST_PIXELS = 300_000;
  private static final int LEAST_WIDTH = 64;

  private final ViewSession session;
  private double pixels = COLD_PIXELS;
  private boolean isFirst = true;

  Drafts(ViewSession session) {
    this.session = session;
  }

  void show(ViewSession.Job job) throws InterruptedException {
    if (job.file().settings().crop().isPresent()) {
      return;
    }
    boolean isCold = isFirst;
    isFirst = false;
    double fitting = showDraft(job);
    if (isCold && !session.isStale(job)) {
      pixels = FIRST_PIXELS;
      fitting = showDraft(job);
    }
    pixels = Math.max(LEAST_PIXELS, Math.min(Math.sqrt(fitting * pixels), MOST_PIXELS));
  }

  /** Shows a draft of the wanted size. Returns the number of pixels that takes the wanted time. */
  private double showDraft(ViewSession.Job job) throws InterruptedException {
    RenderSettings settings = job.file().settings();
    double all = (double) settings.width() * settings.height();
    double scale = Math.min(1, Math.sqrt(pixels / all));
    int width = Math.max(Math.min(LEAST_WIDTH, settings.width()), (int) (settings.width() * scale));
    int height = Math.max(1, Math.round((float) width * settings.height() / settings.width()));
    RenderSettings small =
        settings.toBuilder()
            .size(width, height)
            .samples(1)
            .split(Math.max(1, settings.split()))
            .set(Setting.LAYERS, Set.of())
            .adaptive(false)
            .build();
    SceneFile file = job.file();
    FilmRenderer renderer = new FilmRenderer(small, file.scene());
    Film film = renderer.newFilm();
    RenderClock clock = new RenderClock(() -> false);
    clock.start();
    renderer.addSamples(film, 1, clock);
    clock.stop();
    double seconds = Math.max(1e-4, clock.seconds());
    Preview preview =
        new Preview(
            Stage.withDrawing(file.with(small), film.develop()),
            List.of(),
            1,
            film.totalSamples(),
            true,
            Optional.empty(),
            Map.of());
    session.show(job.generation(), preview, true, false);
    return width * (double) height * DRAFT_SECONDS / seconds;
  }
}
