package io.github.lumbre.render;

import io.github.lumbre.image.Image;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RayTracer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Renders scenes: divides the film into buckets, which threads take from a queue. Immutable and
 * reusable; the number of threads, the size of the buckets and the order of work do not change a
 * bit of the picture.
 */
public final class BucketRenderer {
  private final RenderSettings settings;

  public BucketRenderer(RenderSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /** Renders without anybody listening. */
  public Image render(Scene scene) throws InterruptedException {
    return render(scene, Progress.NONE).image();
  }

  /**
   * Renders.
   *
   * @throws InterruptedException if the calling thread is interrupted; all workers have ended then
   * @throws RenderException if a worker failed
   */
  public RenderResult render(Scene scene, Progress progress) throws InterruptedException {
    return render(scene, integratorFor(scene), progress);
  }

  RenderResult render(Scene scene, Integrator integrator, Progress progress)
      throws InterruptedException {
    RenderSettings.Crop window = settings.window();
    boolean hasAlpha = settings.transparent() || scene.camera().leavesBlanks();
    Film film = new Film(window.width(), window.height(), hasAlpha);
    List<Bucket> buckets = buckets(window);
    RenderQueue queue = new RenderQueue(buckets, progress);
    progress.started((long) window.width() * window.height() * settings.samples());

    List<BucketWorker> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(threads(), buckets.size()); i++) {
      workers.add(new BucketWorker(settings, scene, integrator, film, queue));
    }
    run(workers, queue);
    return new RenderResult(film.develop(), queue.isExhausted(), statistics(workers));
  }

  private Integrator integratorFor(Scene scene) {
    return switch (settings.mode()) {
      case PATH -> new PathTracer(scene, settings.maxTraceDepth());
      case RAY ->
          new RayTracer(scene, settings.reflectionTraceDepth(), settings.refractionTraceDepth());
    };
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

  private static void run(List<BucketWorker> workers, RenderQueue queue)
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
      for (Future<?> future : futures) {
        future.get();
      }
    } catch (ExecutionException e) {
      throw new RenderException("rendering failed: " + e.getCause(), e.getCause());
    } finally {
      queue.stop();
      pool.shutdown();
      awaitEnd(threads);
    }
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
