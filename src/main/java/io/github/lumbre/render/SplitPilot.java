package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;

/**
 * The pilot render of {@code --split auto}. It renders pixels that are spread over the full frame
 * with 1, 2, 4 and 8 branches, and measures error times rays, until more branches are not better.
 *
 * <p>Its work is fixed, and each row of pixels is one thread's. Sums are taken in a fixed order,
 * and cost is counted in rays. The choice is therefore a function of the scene, the settings that
 * samples depend on, and the seed alone. It is the same for any crop, threads and number of
 * samples. The random numbers are not those of the picture. Immutable and stateless.
 */
final class SplitPilot {
  /** The largest number of branches tried. */
  static final int MOST = 8;

  /** The largest number of pixels rendered. */
  static final int MOST_PIXELS = 1024;

  /** The pixels of the frame for each pixel of the pilot, in small frames. */
  private static final int SHARE = 16;

  /** Samples of a pixel in each of two independent sets. */
  private static final int SAMPLES = 8;

  /**
   * How many times better the first split, and each further doubling, must be. The pilot has fewer
   * samples than most pictures and overrates splitting: by up to 1.3 times in a test.
   */
  private static final double FIRST_GAIN = 1.25;

  private static final double NEXT_GAIN = 1.05;

  /** Part of the denominator of relative errors, as in {@code relmse}. */
  private static final double FLOOR = .01;

  /** The largest relative error of a pixel, so that one firefly does not decide. */
  private static final double LARGEST = 4;

  private static final long SEED = 0x73706c6974206f6eL;
  private static final long OTHER_SEED = 0x6f72206e6f742069L;

  private final RenderSettings settings;
  private final Scene scene;
  private final int threads;
  private final int columns;
  private final int rows;

  private SplitPilot(RenderSettings settings, Scene scene, int threads) {
    this.settings = settings;
    this.scene = scene;
    this.threads = threads;
    double pixels = (double) settings.width() * settings.height();
    double wanted = Math.max(1, Math.min(MOST_PIXELS, pixels / SHARE));
    double side = Math.sqrt(wanted * settings.aspect());
    columns = (int) Math.max(1, Math.min(Math.min(settings.width(), wanted), side));
    rows = (int) Math.max(1, Math.min(settings.height(), wanted / columns));
  }

  /**
   * Returns what the pilot of some settings chooses.
   *
   * @param scene framed for the settings
   * @param threads number of threads to start; 0 renders in the calling thread, which then cannot
   *     be interrupted
   * @throws InterruptedException if the calling thread is interrupted; all threads have then ended
   * @throws RenderException if a path failed
   */
  static SplitReport choose(RenderSettings settings, Scene scene, int threads)
      throws InterruptedException {
    return findsLight(settings, scene)
        ? new SplitPilot(settings, scene, threads).choose()
        : new SplitReport(1, 1, 0);
  }

  /** Returns what the pilot chooses, rendered by the calling thread without interruption. */
  static SplitReport choose(RenderSettings settings, Scene scene) {
    try {
      return choose(settings, scene, 0);
    } catch (InterruptedException e) {
      throw new AssertionError("no thread to wait for", e);
    }
  }

  /** Returns whether branches could find light. */
  private static boolean findsLight(RenderSettings settings, Scene scene) {
    return settings.mode() == RenderSettings.Mode.PATH
        && settings.maxTraceDepth() > 0
        && !(scene.emitters().isEmpty() && scene.environments().isEmpty())
        && scene.primitives().stream().anyMatch(Primitive::scatters);
  }

  private SplitReport choose() throws InterruptedException {
    List<Pixel> whole = render(1);
    double[] squares = squares(whole);
    long pilotRays = rays(whole);
    double unsplit = error(whole, squares) * pilotRays;
    double best = unsplit;
    int branches = 1;
    for (int tried = 2; tried <= MOST && best > 0; tried *= 2) {
      List<Pixel> split = render(tried);
      pilotRays += rays(split);
      double product = error(split, squares) * rays(split);
      if (product * (branches == 1 ? FIRST_GAIN : NEXT_GAIN) >= best) {
        break;
      }
      best = product;
      branches = tried;
    }
    return new SplitReport(branches, branches == 1 ? 1 : unsplit / best, pilotRays);
  }

  /** The means of two independent sets of samples of a pixel, and the rays of all. */
  private record Pixel(Rgb first, Rgb second, long rays) {}

  /** Renders the pilot's pixels, row by row. */
  private List<Pixel> render(int branches) throws InterruptedException {
    Integrator integrator = Integrator.of(scene, settings.toBuilder().split(branches).build());
    List<Pixel> pixels = new ArrayList<>();
    if (threads == 0) {
      IntStream.range(0, rows).forEach(row -> pixels.addAll(row(integrator, row)));
      return pixels;
    }
    ExecutorService pool =
        Executors.newFixedThreadPool(
            Math.min(threads, rows),
            task -> {
              Thread thread = new Thread(task, "lumbre-pilot");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<Callable<List<Pixel>>> tasks = new ArrayList<>();
      IntStream.range(0, rows).forEach(row -> tasks.add(() -> row(integrator, row)));
      for (Future<List<Pixel>> row : pool.invokeAll(tasks)) {
        pixels.addAll(row.get());
      }
      return pixels;
    } catch (ExecutionException e) {
      throw Crew.failure(e.getCause());
    } finally {
      pool.shutdownNow();
      awaitEnd(pool);
    }
  }

  /** Waits for the threads, which end with their row, and restores the interrupt status. */
  private static void awaitEnd(ExecutorService pool) {
    boolean interrupted = Thread.interrupted();
    while (!pool.isTerminated()) {
      try {
        pool.awaitTermination(1, TimeUnit.SECONDS);
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private List<Pixel> row(Integrator integrator, int row) {
    Sampler first = new SobolSampler(settings.seed() ^ SEED);
    Sampler second = new SobolSampler(settings.seed() ^ OTHER_SEED);
    RenderContext context = new RenderContext();
    int y = (int) ((2L * row + 1) * settings.height() / (2L * rows));
    List<Pixel> pixels = new ArrayList<>();
    for (int column = 0; column < columns; column++) {
      int x = (int) ((2L * column + 1) * settings.width() / (2L * columns));
      long before = context.rays() + context.shadowRays();
      Rgb one = mean(integrator, context, first, x, y);
      Rgb other = mean(integrator, context, second, x, y);
      pixels.add(new Pixel(one, other, context.rays() + context.shadowRays() - before));
    }
    return pixels;
  }

  private Rgb mean(Integrator integrator, RenderContext context, Sampler sampler, int x, int y) {
    CameraRay ray = new CameraRay();
    Rgb sum = Rgb.BLACK;
    for (int number = 0; number < SAMPLES; number++) {
      context.startSample();
      if (CameraSamples.start(scene, settings, sampler, x, y, number, ray)) {
        Rgb radiance = integrator.radiance(ray, sampler, context);
        sum = SampleLimit.isRejected(radiance) ? sum : sum.plus(radiance);
      }
    }
    return sum.times(1. / SAMPLES);
  }

  /**
   * Returns the square of the radiance around each pixel. A pixel does not count itself: if it did,
   * a low mean would make its own error large.
   */
  private double[] squares(List<Pixel> pixels) {
    double[] squares = new double[pixels.size()];
    for (int i = 0; i < squares.length; i++) {
      int x = i % columns;
      int y = i / columns;
      Rgb sum = Rgb.BLACK;
      int count = 0;
      for (int v = Math.max(0, y - 1); v <= Math.min(rows - 1, y + 1); v++) {
        for (int u = Math.max(0, x - 1); u <= Math.min(columns - 1, x + 1); u++) {
          if (u != x || v != y) {
            Pixel near = pixels.get(v * columns + u);
            sum = sum.plus(near.first()).plus(near.second());
            count += 2;
          }
        }
      }
      squares[i] = count == 0 ? 0 : square(sum) / ((double) count * count);
    }
    return squares;
  }

  private static double error(List<Pixel> pixels, double[] squares) {
    double error = 0;
    for (int i = 0; i < squares.length; i++) {
      Pixel pixel = pixels.get(i);
      double difference = square(pixel.first().plus(pixel.second().times(-1)));
      error += Math.min(LARGEST, difference / (squares[i] + FLOOR));
    }
    return error;
  }

  private static double square(Rgb c) {
    return (c.r() * c.r() + c.g() * c.g() + c.b() * c.b()) / 3;
  }

  private static long rays(List<Pixel> pixels) {
    return pixels.stream().mapToLong(Pixel::rays).sum();
  }
}
