package io.github.lumbre.cli.view;

import io.github.lumbre.checkpoint.RecordedLayers;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.preview.Preview;
import io.github.lumbre.preview.PreviewListener;
import io.github.lumbre.preview.PreviewRenderer;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.SampleTarget;
import io.github.lumbre.render.Schedule;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.stopping.BudgetWatch;
import java.util.Optional;
import java.util.Set;

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
  private long drafted = -1;
  private Optional<Full> full = Optional.empty();

  /**
   * The full render of a generation.
   *
   * @param goal the largest number of samples, over all pixels
   */
  private record Full(
      long generation,
      PreviewRenderer renderer,
      Film film,
      Schedule schedule,
      RenderClock clock,
      Sink sink,
      BudgetWatch watch,
      long goal) {}

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
      session.show(job.generation(), preview, false, isLast);
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
          drafts.show(job.get());
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
    boolean isUrgent = session.viewers().isUrgent();
    if (full.isPresent() && isUrgent && full.get().generation() == drafted) {
      full.get().sink().showLast(full.get().renderer(), full.get().film());
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
      boolean isUsedUp = isUsedUp(now);
      Optional<SampleTarget> target = now.schedule().next(now.film());
      while (target.isPresent() && !isUsedUp && !session.mustPause(job)) {
        isUsedUp = addPass(now, target.get());
        target = now.schedule().next(now.film());
      }
      now.clock().stop();
      if (!session.isStale(job)) {
        now.sink().showLast(now.renderer(), now.film());
      }
      if (target.isEmpty() || isUsedUp) {
        session.finish(job.generation());
      }
    } finally {
      now.clock().stop();
    }
  }

  /** Adds a pass, or as much of it as there is time for. Returns whether the render is over. */
  private boolean addPass(Full now, SampleTarget target) throws InterruptedException {
    // Every pixel gets a sample, however long that takes.
    boolean isFirst = now.film().fewestSamples() == 0;
    Progress progress =
        isFirst ? now.clock() : now.clock().cancelledAlsoIf(() -> isOver(now.clock()));
    PassResult pass = now.renderer().addSamples(now.film(), target, progress);
    boolean isReached = pass.complete() && now.watch().isReachedBy(now.film());
    long pixels = (long) now.film().window().width() * now.film().window().height();
    now.watch()
        .forecast()
        .ifPresent(f -> now.clock().expect(Math.min(now.goal(), Math.round(pixels * f.likely()))));
    return isReached || isUsedUp(now);
  }

  private boolean isOver(RenderClock clock) {
    return limits.isOver(clock.seconds());
  }

  private boolean isUsedUp(Full now) {
    boolean isHopeless = limits.time().isEmpty() && now.watch().isHopeless(now.film());
    return isHopeless || now.film().fewestSamples() > 0 && isOver(now.clock());
  }

  private Full begin(ViewSession.Job job) {
    SceneFile file = job.file();
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    Sink sink = new Sink(job);
    PreviewRenderer previewed =
        new PreviewRenderer(renderer, RecordedLayers.of(file.settings(), file.scene()), sink);
    RenderClock clock = new RenderClock(() -> session.mustPause(job));
    limits.time().ifPresent(time -> clock.limit(time.toNanos() * 1e-9));
    sink.clock = clock;
    Crop window = file.settings().window();
    int samples = file.settings().samples();
    boolean isOpen = samples == RenderSettings.MAX_SAMPLES;
    long goal = isOpen ? Long.MAX_VALUE : (long) window.width() * window.height() * samples;
    clock.expect(goal);
    return new Full(
        job.generation(),
        previewed,
        renderer.newFilm(),
        previewed.schedule(),
        clock,
        sink,
        new BudgetWatch(limits.budget(file.settings())),
        goal);
  }
}
