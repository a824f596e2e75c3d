package io.github.lumbre.render;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.render.internal.RendererInside;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.function.UnaryOperator;

/**
 * Adds samples of one scene to films, one pass at a time. Between passes, the caller can inspect or
 * save the film, stop, or choose a different number of samples for each pixel. Each pass divides
 * the film into buckets, which threads take from a queue.
 *
 * <p>A long render may change the scene's traversal kernel; see {@link
 * io.github.lumbre.geometry.KernelChange}.
 *
 * <p>Immutable; several threads may use one instance at once, each with its own film. A sample is a
 * function of the scene, the seed, the pixel and the sample number, and films add exactly. The sums
 * are therefore bit-identical for any passes, threads and buckets.
 */
public final class FilmRenderer extends OpenRenderer implements PassRenderer {
  /**
   * The revision of sample values. It increases whenever a change of the program changes any bit of
   * any sample for the same scene, settings and seed. Films of other revisions cannot be resumed.
   */
  public static final int REVISION = 14;

  /**
   * The samples per pixel of an adaptive render's pilot, which gives all pixels the same number.
   */
  public static final int ADAPTIVE_PILOT = AdaptiveSchedule.PILOT;

  private final RenderSettings settings;
  private final Scene scene;
  private final IntegratorSource integrators;
  private final LongFunction<Sampler> samplers;
  private final UnaryOperator<List<Crop>> order;
  private final Crew crew;
  private final boolean hasAlpha;
  private final FilmLayers layers;

  /**
   * Creates a renderer with the integrator of the settings.
   *
   * @param settings the settings; their number of samples is used by {@link #schedule()}, and tells
   *     whether a render is long
   */
  public FilmRenderer(RenderSettings settings, Scene scene) {
    this(
        settings,
        scene,
        IntegratorSource.of(settings, scene.framed(settings.aspect())),
        SobolSampler::new,
        UnaryOperator.identity(),
        new OwnThreads());
  }

  FilmRenderer(RenderSettings settings, Scene scene, Integrator integrator) {
    this(
        settings,
        scene,
        IntegratorSource.of(settings, scene, pose -> integrator),
        SobolSampler::new,
        UnaryOperator.identity(),
        new OwnThreads());
  }

  private FilmRenderer(
      RenderSettings settings,
      Scene scene,
      IntegratorSource integrators,
      LongFunction<Sampler> samplers,
      UnaryOperator<List<Crop>> order,
      Crew crew) {
    this.samplers = Objects.requireNonNull(samplers, "samplers");
    this.order = order;
    this.crew = crew;
    this.settings = Objects.requireNonNull(settings, "settings");
    this.scene = scene.framed(settings.aspect());
    this.integrators = integrators;
    layers = FilmLayers.of(settings, this.scene);
    hasAlpha = settings.countsCoverage() || this.scene.camera().leavesBlanks();
  }

  /**
   * Returns the same renderer with another order in which threads take the buckets of a pass. The
   * default is row by row from the top.
   */
  FilmRenderer inOrder(UnaryOperator<List<Crop>> newOrder) {
    return new FilmRenderer(settings, scene, integrators, samplers, newOrder, crew);
  }

  /**
   * Returns the same renderer on the threads of an executor, such as the pool of a server. The
   * default starts threads for each pass. The calling thread renders, too, and up to one thread
   * less than {@link RenderSettings#threads} of the executor helps it; no pass waits for a thread
   * that is not free. The bits of the film do not depend on it. {@link Progress#stalled} is not
   * called.
   *
   * @param executor runs tasks that end with the pass; it may reject them
   */
  public FilmRenderer on(Executor executor) {
    Crew shared = new SharedThreads(Objects.requireNonNull(executor, "executor"));
    return new FilmRenderer(settings, scene, integrators, samplers, order, shared);
  }

  /**
   * Returns the same renderer with another window. It shares the pilot render.
   *
   * @param window in the full frame
   */
  public FilmRenderer in(RenderSettings.Crop window) {
    RenderSettings changed = settings.toBuilder().crop(window).build();
    return new FilmRenderer(changed, scene, integrators, samplers, order, crew);
  }

  private PilotRows pilot(Progress progress) {
    return new PilotRows(crew.pilotThreads(threads()), progress::isCancelled);
  }

  /** Returns an empty film with the settings' window. */
  public Film newFilm() {
    return newFilm(0);
  }

  /**
   * Returns an empty film with the settings' window and a given first sample number. Films of the
   * same window with disjoint sample numbers can be merged.
   *
   * @param firstSample at least 0, and a multiple of the number of the scene's poses
   */
  public Film newFilm(int firstSample) {
    int poses = scene.poses().size();
    return new Film(
        settings.window(), hasAlpha, firstSample, layers, poses, settings.background());
  }

  /** Returns the schedule of passes for a new film or a resumed one. */
  @Override
  public Schedule schedule() {
    return schedule(settings.samples());
  }

  /**
   * Returns the schedule of passes for a new film or a resumed one, with another number of samples
   * than the settings.
   *
   * @param goal samples per pixel; the mean if the settings are adaptive
   */
  public Schedule schedule(int goal) {
    return settings.adaptive()
        ? new AdaptiveSchedule(goal, scene.poses().size())
        : Schedule.even(goal, Passes::next);
  }

  /**
   * Adds samples until each pixel has the given number; see {@link #addSamples(Film, SampleTarget,
   * Progress)}.
   */
  public PassResult addSamples(Film film, int samples, Progress progress)
      throws InterruptedException {
    return addSamples(film, (x, y) -> samples, progress);
  }

  /**
   * Adds samples until each pixel has its target number; pixels that have more keep them. The new
   * samples of a pixel continue its sample numbers. After a cancelled pass, another pass with the
   * same target therefore adds the missing samples.
   *
   * <p>In a {@linkplain Scene#inMotion scene in motion}, targets are rounded up so that a pixel has
   * equally many samples of each pose, and a cancelled pass completes the poses of the pixels that
   * it has begun.
   *
   * @param film a film as {@link #newFilm} makes it; no other thread may use it during the pass
   * @param progress receives all events except {@link Progress#started}
   * @throws IllegalArgumentException if the film has another window, alpha or other layers
   * @throws InterruptedException if the calling thread is interrupted; all workers have then ended,
   *     and the film holds their samples
   * @throws RenderException if a worker failed
   */
  @Override
  public PassResult addSamples(Film film, SampleTarget target, Progress progress)
      throws InterruptedException {
    requireOwn(film);
    List<TracedPose> poses;
    try {
      poses = integrators.get(pilot(progress));
    } catch (CancellationException e) {
      return new PassResult(false, RenderStatistics.ZERO);
    }
    List<Crop> buckets = order.apply(buckets(settings.window()));
    RenderQueue queue = new RenderQueue(buckets, progress);
    List<BucketRenderer> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(threads(), buckets.size()); i++) {
      workers.add(new BucketRenderer(settings, scene, poses, sampler(), film, target, queue));
    }
    double start = seconds();
    CompiledKernel.begin();
    try {
      crew.run(workers, queue, progress);
    } finally {
      CompiledKernel.end();
    }
    RenderStatistics statistics = statistics(workers);
    double threadSeconds = (seconds() - start) * workers.size();
    if (statistics.samples() > 0) {
      double left = (double) settings.samples() * settings.window().pixels() - film.totalSamples();
      KernelUpgrade.passed(scene, threadSeconds, left * threadSeconds / statistics.samples());
    }
    return new PassResult(queue.isExhausted(), statistics);
  }

  private Sampler sampler() {
    return samplers.apply(settings.seed());
  }

  private void requireOwn(Film film) {
    if (!film.window().equals(settings.window()) || film.hasAlpha() != hasAlpha) {
      throw new IllegalArgumentException(
          "film: expected the window "
              + settings.window()
              + (hasAlpha ? " with" : " without")
              + " alpha, found "
              + film.window()
              + (film.hasAlpha() ? " with" : " without"));
    }
    // Compares references first: the methods that compare records are made at run time, which
    // takes milliseconds at the start of a command.
    if (film.poses() != scene.poses().size()) {
      throw new IllegalArgumentException(
          "film: expected " + scene.poses().size() + " poses, found " + film.poses());
    }
    if (!Objects.equals(film.layers(), layers)) {
      throw new IllegalArgumentException("film: expected " + layers + ", found " + film.layers());
    }
  }

  private int threads() {
    return PilotRows.threads(settings);
  }

  private List<Crop> buckets(RenderSettings.Crop window) {
    int size = settings.bucketSize();
    List<Crop> buckets = new ArrayList<>();
    for (long y = 0; y < window.height(); y += size) {
      for (long x = 0; x < window.width(); x += size) {
        buckets.add(
            new Crop(
                window.x() + (int) x,
                window.y() + (int) y,
                (int) Math.min(size, window.width() - x),
                (int) Math.min(size, window.height() - y)));
      }
    }
    return buckets;
  }

  private static double seconds() {
    return System.nanoTime() * 1e-9;
  }

  private static RenderStatistics statistics(List<BucketRenderer> workers) {
    return workers.stream()
        .map(BucketRenderer::statistics)
        .reduce(RenderStatistics.ZERO, RenderStatistics::plus);
  }

  RendererInside inside() {
    return new Inside();
  }

  /** Does what the program does with a renderer and other programs do not need. */
  private final class Inside extends RendererInside {
    @Override
    public FilmRenderer with(
        Function<Scene, Integrator> others, LongFunction<Sampler> otherSamplers) {
      IntegratorSource source = IntegratorSource.of(settings, scene, others);
      return new FilmRenderer(settings, scene, source, otherSamplers, order, crew);
    }

    @Override
    public Optional<GuideReport> plan(Progress progress) throws InterruptedException {
      try {
        integrators.get(pilot(progress));
      } catch (CancellationException e) {
        return Optional.empty();
      }
      return guiding();
    }

    @Override
    public Optional<GuideReport> guiding() {
      return integrators.guiding();
    }
  }
}
