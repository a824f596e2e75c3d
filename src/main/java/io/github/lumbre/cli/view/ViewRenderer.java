package io.github.lumbre.cli.view;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.render.preview.Preview;
import io.github.lumbre.render.preview.PreviewListener;
import io.github.lumbre.render.preview.Previews;
import io.github.lumbre.render.stopping.BudgetWatch;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.internal.PictureDrawing;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;

/**
 * Renders what a session wants: a draft of each new view at once, then the picture in passes. Used
 * by one thread; its film stays when the render is stopped.
 */
public final class ViewRenderer implements Runnable {
  /** How long a draft is shown if the first pass takes longer. */
  private static final long DRAFT_NANOS = 2_000_000_000;

  private final ViewSession session;
  private final ViewLimits limits;
  private final Drafts drafts;
  private final DenoisingPace pace = new DenoisingPace();
  private long drafted = -1;
  private Optional<Full> full = Optional.empty();

  /**
   * The full render of a generation.
   *
   * @param denoiser denoises the film while a page shows it denoised
   * @param goal the largest number of samples, over all pixels
   */
  private record Full(
      long generation,
      Previews previews,
      Film film,
      PassLoop loop,
      RenderClock clock,
      Sink sink,
      BudgetWatch watch,
      ViewDenoiser denoiser,
      long goal)
      implements PassListener {
    @Override
    public boolean isDue() {
      return previews.isDue();
    }

    @Override
    public void passed(Film film, PassResult soFar) {
      previews.passed(film, soFar);
      denoiser.passed(film);
      long pixels = film.window().pixels();
      watch
          .forecast()
          .ifPresent(f -> clock.expect(Math.min(goal, Math.round(pixels * f.likely()))));
    }

    void showLast() {
      sink.isLast = true;
      previews.showLast(film);
      sink.isLast = false;
      denoiser.show(film);
    }
  }

  /**
   * @param limits what ends a full render besides its samples
   */
  ViewRenderer(ViewSession session, ViewLimits limits) {
    this.session = session;
    this.limits = limits;
    drafts = new Drafts(session);
  }

  /** Passes previews of a generation to the session. */
  private final class Sink implements PreviewListener {
    private final ViewSession.Job job;
    private final PictureDrawing drawing;
    private boolean isLast;
    private final long start = System.nanoTime();
    private boolean hasShown;
    private RenderClock clock = new RenderClock(() -> false);

    Sink(ViewSession.Job job) {
      this.job = job;
      drawing = PictureDrawing.of(job.file().parsed(), note -> {});
    }

    @Override
    public boolean isWatching() {
      if (isLast) {
        return true;
      }
      // Until every pixel has a sample, the draft looks better.
      boolean hasAll = clock.samples() >= job.file().settings().window().pixels();
      if (!hasAll && System.nanoTime() - start < DRAFT_NANOS) {
        return false;
      }
      return !hasShown || session.viewers().areWatching();
    }

    @Override
    public boolean isUrgent() {
      return session.viewers().isUrgent();
    }

    @Override
    public Set<Layer> layers() {
      return session.viewers().layers();
    }

    @Override
    public boolean wantsNoise() {
      return true;
    }

    @Override
    public double secondsElsewhere() {
      return session.viewers().takeCost();
    }

    @Override
    public void show(Preview preview) {
      session.viewers().served();
      hasShown = true;
      Preview lined =
          new Preview(
              drawing.onLight(job.file().scene(), Optional.of(""), preview.image()),
              preview.layers(),
              preview.samples(),
              preview.totalSamples(),
              preview.isEndOfPass(),
              preview.noise(),
              preview.metadata());
      session.show(job.generation(), lined, false, isLast);
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
          drafts.show(job.get());
          drafted = job.get().generation();
        } else {
          render(job.get());
        }
      }
    } catch (InterruptedException | CancellationException e) {
      // The command ends.
      session.close();
    }
  }

  /** Shows the film again if a page wants a layer of it. */
  private void refresh() {
    boolean isUrgent = session.viewers().isUrgent();
    if (full.isPresent() && isUrgent && full.get().generation() == drafted) {
      full.get().showLast();
    }
  }

  private void render(ViewSession.Job job) throws InterruptedException {
    if (full.isEmpty() || full.get().generation() != job.generation()) {
      full = Optional.of(begin(job));
    }
    Full now = full.get();
    session.timedBy(job.generation(), now.clock());
    now.clock().start();
    try {
      boolean isComplete = now.loop().run(now.watch(), now, now.clock()).complete();
      now.clock().stop();
      if (!session.isStale(job)) {
        now.showLast();
      }
      if (isComplete) {
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
    RenderClock clock = new RenderClock(() -> session.mustPause(job));
    limits.time().ifPresent(time -> clock.limit(time.toNanos() * 1e-9));
    sink.clock = clock;
    int samples = file.settings().samples();
    boolean isOpen = samples == RenderSettings.MAX_SAMPLES;
    long goal = isOpen ? Long.MAX_VALUE : file.settings().window().pixels() * samples;
    clock.expect(goal);
    Film film = renderer.newFilm();
    return new Full(
        job.generation(),
        new Previews(RecordedLayers.of(file.settings(), file.scene()), sink),
        film,
        new PassLoop(renderer, film),
        clock,
        sink,
        new BudgetWatch(limits.budget(file.settings()), () -> limits.secondsLeft(clock.seconds())),
        new ViewDenoiser(session, job, clock, pace),
        goal);
  }
}
