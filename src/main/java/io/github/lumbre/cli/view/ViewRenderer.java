package io.github.lumbre.cli.view;

import io.github.lumbre.checkpoint.RecordedLayers;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.preview.Preview;
import io.github.lumbre.preview.PreviewListener;
import io.github.lumbre.preview.PreviewRenderer;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Setting;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Renders what a session wants: a draft of each new view at once, then the picture in passes. Used
 * by one thread; its film stays when the render is stopped.
 */
public final class ViewRenderer implements Runnable {
  /** The time that a draft should take. */
  private static final double DRAFT_SECONDS = .08;

  /** The pixels of the very first draft, which mostly waits for classes and the JIT. */
  private static final double COLD_PIXELS = 3000;

  /** The pixels of the next draft, whose speed is not known yet. */
  private static final double FIRST_PIXELS = 12_000;

  private static final int LEAST_WIDTH = 64;

  /** How long a draft is shown if the first pass takes longer. */
  private static final long DRAFT_NANOS = 2_000_000_000;

  private final ViewSession session;
  private final PreviewListener also;
  private double draftPixels = COLD_PIXELS;
  private long drafted = -1;
  private Optional<Full> full = Optional.empty();

  /** The full render of a generation. */
  private record Full(
      long generation,
      PreviewRenderer renderer,
      Film film,
      Schedule schedule,
      RenderClock clock,
      Sink sink) {}

  /**
   * @param also receives the previews of full renders besides the session
   */
  public ViewRenderer(ViewSession session, PreviewListener also) {
    this.session = session;
    this.also = also;
  }

  /** Passes previews of a generation to the session. */
  private final class Sink implements PreviewListener {
    private final ViewSession.Job job;
    private boolean isLast;
    private final long start = System.nanoTime();
    private boolean hasShown;
    private RenderClock clock = new RenderClock(() -> false);

    Sink(ViewSession.Job job) {
      this.job = job;
    }

    @Override
    public boolean isWatching() {
      if (isLast) {
        return true;
      }
      // Until every pixel has a sample, the draft looks better.
      Crop window = job.file().settings().window();
      boolean hasAll = clock.samples() >= (long) window.width() * window.height();
      if (!hasAll && System.nanoTime() - start < DRAFT_NANOS) {
        return false;
      }
      return !hasShown || session.viewers().areWatching() || also.isWatching();
    }

    @Override
    public boolean isUrgent() {
      return session.viewers().isUrgent();
    }

    @Override
    public Set<Layer> layers() {
      Set<Layer> layers = session.viewers().layers();
      layers.addAll(also.layers());
      return layers;
    }

    @Override
    public boolean wantsNoise() {
      return true;
    }

    @Override
    public double secondsElsewhere() {
      return session.viewers().takeCost() + also.secondsElsewhere();
    }

    @Override
    public void show(Preview preview) {
      session.viewers().served();
      hasShown = true;
      session.show(job.generation(), preview, false, isLast);
      if (also.isWatching()) {
        also.show(preview);
      }
    }

    void showLast(PreviewRenderer renderer, Film film) {
      isLast = true;
      renderer.touch(film);
      renderer.finish();
      isLast = false;
    }
  }

  @Override
  public void run() {
    try {
      while (!session.isClosed()) {
        Optional<ViewSession.Job> job = session.next(drafted);
        if (job.isEmpty()) {
          refresh();
        } else if (job.get().isDraft()) {
          draft(job.get());
          drafted = job.get().generation();
        } else {
          render(job.get());
        }
      }
    } catch (InterruptedException e) {
      // The command ends.
      session.close();
    }
  }

  /** Shows the film again if a page wants a layer of it. */
  private void refresh() {
    if (full.isPresent() && session.viewers().isUrgent() && full.get().generation() == drafted) {
      full.get().sink().showLast(full.get().renderer(), full.get().film());
    }
  }

  /** Renders a quick picture with fewer pixels; the first time, an even quicker one before it. */
  private void draft(ViewSession.Job job) throws InterruptedException {
    if (job.file().settings().crop().isPresent()) {
      return;
    }
    boolean isCold = drafted < 0;
    double fitting = showDraft(job);
    if (isCold && !session.isStale(job)) {
      draftPixels = FIRST_PIXELS;
      fitting = showDraft(job);
    }
    draftPixels = Math.max(3000, Math.min(Math.sqrt(fitting * draftPixels), 300_000));
  }

  /** Shows a draft of the wanted size. Returns the number of pixels that takes the wanted time. */
  private double showDraft(ViewSession.Job job) throws InterruptedException {
    RenderSettings settings = job.file().settings();
    double pixels = (double) settings.width() * settings.height();
    double scale = Math.min(1, Math.sqrt(draftPixels / pixels));
    int width = Math.max(Math.min(LEAST_WIDTH, settings.width()), (int) (settings.width() * scale));
    int height = Math.max(1, Math.round((float) width * settings.height() / settings.width()));
    RenderSettings small =
        settings.toBuilder()
            .size(width, height)
            .samples(1)
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
            film.develop(), List.of(), 1, film.totalSamples(), true, Optional.empty(), Map.of());
    session.show(job.generation(), preview, true, false);
    return width * (double) height * DRAFT_SECONDS / seconds;
  }

  private void render(ViewSession.Job job) throws InterruptedException {
    if (full.isEmpty() || full.get().generation() != job.generation()) {
      full = Optional.of(begin(job));
    }
    Full now = full.get();
    session.timedBy(job.generation(), now.clock());
    now.clock().start();
    try {
      Optional<SampleTarget> target = now.schedule().next(now.film());
      while (target.isPresent() && !session.mustPause(job)) {
        now.renderer().addSamples(now.film(), target.get(), now.clock());
        target = now.schedule().next(now.film());
      }
      now.clock().stop();
      if (!session.isStale(job)) {
        now.sink().showLast(now.renderer(), now.film());
      }
      if (target.isEmpty()) {
        session.finish(job.generation());
      }
    } finally {
      now.clock().stop();
    }
  }

  private Full begin(ViewSession.Job job) {
    SceneFile file = job.file();
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    Sink sink = new Sink(job);
    PreviewRenderer previewed =
        new PreviewRenderer(renderer, RecordedLayers.of(file.settings(), file.scene()), sink);
    RenderClock clock = new RenderClock(() -> session.mustPause(job));
    sink.clock = clock;
    return new Full(
        job.generation(), previewed, renderer.newFilm(), previewed.schedule(), clock, sink);
  }
}
