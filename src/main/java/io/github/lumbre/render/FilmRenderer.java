package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.LongFunction;
import java.util.function.UnaryOperator;

/**
 * Adds samples of one scene to films, a pass at a time: between passes the caller may look at the
 * film, keep it, stop, or give some pixels more samples than others. Each pass divides the film
 * into buckets, which threads take from a queue.
 *
 * <p>Immutable; several threads may use it at once, each with a film of its own. A sample is a
 * function of scene, seed, pixel and number, and films add exactly: so neither the passes nor the
 * threads nor the buckets change a bit of the sums.
 */
public final class FilmRenderer implements PassRenderer {
  /**
   * Which samples a scene, its settings and a seed have: raised whenever any of them changes in any
   * bit, by whatever change of the program. Films of other revisions are not gone on with.
   */
  public static final int REVISION = 2;

  /** Samples per pixel that an adaptive render gives to all pixels before it distributes others. */
  public static final int ADAPTIVE_PILOT = AdaptiveSchedule.PILOT;

  private static final long SECONDS_PER_LOOK = 5;

  private final RenderSettings settings;
  private final Scene scene;
  private final Integrator integrator;
  private final LongFunction<Sampler> samplers;
  private final UnaryOperator<List<Bucket>> order;
  private final boolean hasAlpha;

  /**
   * @param settings whose number of samples is not used here
   */
  public FilmRenderer(RenderSettings settings, Scene scene) {
    this(settings, scene, Integrator.of(scene, settings));
  }

  FilmRenderer(RenderSettings settings, Scene scene, Integrator integrator) {
    this(settings, scene, integrator, SobolSampler::new);
  }

  /**
   * Renders in another way than the settings ask for. A film of it does not go together with those
   * of other ways.
   *
   * @param samplers makes the random numbers of a seed, for each thread its own
   */
  @SuppressWarnings("exports") // internal
  public FilmRenderer(
      RenderSettings settings, Scene scene, Integrator integrator, LongFunction<Sampler> samplers) {
    this(settings, scene, integrator, samplers, UnaryOperator.identity());
  }

  private FilmRenderer(
      RenderSettings settings,
      Scene scene,
      Integrator integrator,
      LongFunction<Sampler> samplers,
      UnaryOperator<List<Bucket>> order) {
    this.samplers = Objects.requireNonNull(samplers, "samplers");
    this.order = order;
    this.settings = Objects.requireNonNull(settings, "settings");
    this.scene = Objects.requireNonNull(scene, "scene");
    this.integrator = Objects.requireNonNull(integrator, "integrator");
    hasAlpha = settings.transparent() || scene.camera().leavesBlanks();
  }

  /**
   * Returns the same, but for the order in which the threads take the buckets of a pass: rows from
   * the top unless told otherwise.
   */
  FilmRenderer inOrder(UnaryOperator<List<Bucket>> newOrder) {
    return new FilmRenderer(settings, scene, integrator, samplers, newOrder);
  }

  /** Tells whether this one's films have alpha. */
  public boolean hasAlpha() {
    return hasAlpha;
  }

  /** Returns an empty film of the settings' window. */
  public Film newFilm() {
    return newFilm(0);
  }

  /**
   * Returns an empty film of the settings' window, whose samples begin at a number other than 0:
   * films of the same window with numbers that follow on each other add up to one.
   */
  public Film newFilm(int firstSample) {
    return new Film(settings.window(), hasAlpha, firstSample);
  }

  /** Returns what decides on the passes over a new film, or one whose passes it went on with. */
  @Override
  public Schedule schedule() {
    return schedule(settings.samples());
  }

  /**
   * Returns what decides on the passes over a film, with a number of samples instead of the
   * settings'.
   *
   * @param goal samples per pixel, in the mean if the settings are adaptive
   */
  public Schedule schedule(int goal) {
    return settings.adaptive() ? new AdaptiveSchedule(goal) : new EvenSchedule(goal);
  }

  /**
   * Adds samples until each pixel has so many; see {@link #addSamples(Film, SampleTarget,
   * Progress)}.
   */
  public PassResult addSamples(Film film, int samples, Progress progress)
      throws InterruptedException {
    return addSamples(film, (x, y) -> samples, progress);
  }

  /**
   * Adds samples until each pixel has as many as it is to have; pixels that have more keep them.
   * Each pixel's samples follow on those that it has, all at once, so a pass that was cancelled is
   * made up for by another with the same target.
   *
   * @param film of the settings' window and with alpha just if this one's films have it; no other
   *     thread may use it meanwhile
   * @param progress hears of samples and buckets, not of the start
   * @throws InterruptedException if the calling thread is interrupted; all workers have ended then,
   *     and the film holds what they did
   * @throws RenderException if a worker failed
   */
  @Override
  public PassResult addSamples(Film film, SampleTarget target, Progress progress)
      throws InterruptedException {
    requireOwn(film);
    List<Bucket> buckets = order.apply(buckets(settings.window()));
    RenderQueue queue = new RenderQueue(buckets, progress);
    List<BucketWorker> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(threads(), buckets.size()); i++) {
      workers.add(new BucketWorker(settings, scene, integrator, sampler(), film, target, queue));
    }
    run(workers, queue, progress);
    return new PassResult(queue.isExhausted(), statistics(workers));
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
  }

  private int threads() {
    return settings.threads() == 0
        ? Runtime.getRuntime().availableProcessors()
        : settings.threads();
  }

  private List<Bucket> buckets(RenderSettings.Crop window) {
    int size = settings.bucketSize();
    List<Bucket> buckets = new ArrayList<>();
    for (long y = 0; y < window.height(); y += size) {
      for (long x = 0; x < window.width(); x += size) {
        buckets.add(
            new Bucket(
                window.x() + (int) x,
                window.y() + (int) y,
                (int) Math.min(size, window.width() - x),
                (int) Math.min(size, window.height() - y)));
      }
    }
    return buckets;
  }

  private static void run(List<BucketWorker> workers, RenderQueue queue, Progress progress)
      throws InterruptedException {
    List<Thread> threads = new ArrayList<>();
    ExecutorService pool =
        Executors.newFixedThreadPool(
            workers.size(),
            task -> {
              Thread thread = new Thread(task, "lumbre-render-" + (threads.size() + 1));
              thread.setDaemon(true);
              threads.add(thread);
              return thread;
            });
    try {
      List<Future<?>> futures = new ArrayList<>();
      workers.forEach(worker -> futures.add(pool.submit(worker)));
      Watchdog watchdog = new Watchdog(workers, seconds(), progress);
      for (Future<?> future : futures) {
        await(future, watchdog);
      }
    } catch (ExecutionException e) {
      throw new RenderException("rendering failed: " + e.getCause(), e.getCause());
    } finally {
      queue.stop();
      pool.shutdown();
      awaitEnd(threads);
    }
  }

  private static void await(Future<?> future, Watchdog watchdog)
      throws InterruptedException, ExecutionException {
    while (true) {
      try {
        future.get(SECONDS_PER_LOOK, TimeUnit.SECONDS);
        return;
      } catch (TimeoutException e) {
        watchdog.look(seconds());
      }
    }
  }

  private static double seconds() {
    return System.nanoTime() * 1e-9;
  }

  /** Waits for the threads, which end within a moment, and keeps an interruption for later. */
  private static void awaitEnd(List<Thread> threads) {
    boolean interrupted = Thread.interrupted();
    for (Thread thread : threads) {
      while (thread.isAlive()) {
        try {
          thread.join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private static RenderStatistics statistics(List<BucketWorker> workers) {
    return workers.stream()
        .map(BucketWorker::statistics)
        .reduce(RenderStatistics.ZERO, RenderStatistics::plus);
  }
}
